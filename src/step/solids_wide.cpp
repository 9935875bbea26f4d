// Solid obstacles for many boids at a time: most have none near, and only the others are swept.
#include "step/motion.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step/solids_wide.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "step/near_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// The way of each lane in this step (length), a little more for the sake of rounding.
template <int D>
HWY_INLINE Lanes WayOf(const Motion<D>& motion, const LaneVec<D>& from, std::size_t first,
                       std::size_t count) {
  const LaneVec<D> to = LoadSomeVec<D>(motion.scratch.previous_position, first, count);
  return hn::Mul(hn::Set(Floats(), 1.0001f), Length(Offset(from, to, motion.image)));
}

// The obstacles that somebody of the stretch may be as near to as he goes.
template <int D>
HWY_INLINE void SelectFor(Motion<D>& motion, float body, std::size_t begin, std::size_t end) {
  const Floats d;
  Bounds<D> bounds = NoBounds<D>();
  Lanes longest = hn::Zero(d);
  for (std::size_t first = begin; first < end; first += width) {
    const std::size_t count = std::min<std::size_t>(width, end - first);
    const LaneVec<D> from = LoadSomeVec<D>(motion.state.position, first, count);
    Widen(bounds, from, AreSoundPlaces(from));
    const Lanes way = WayOf(motion, from, first, count);
    longest = hn::Max(longest, hn::IfThenElseZero(hn::Le(way, hn::Set(d, 1e30f)), way));
  }
  const ObstacleColumns& all = motion.scratch.obstacles.columns();
  motion.part.near_obstacles.fit(all.count);
  Select<D>(all, motion.image, BoxOf(bounds), body + hn::GetLane(hn::MaxOfLanes(d, longest)),
            motion.part.near_obstacles);
}

template <int D>
HWY_INLINE void KeepOut(Motion<D>& motion, std::size_t begin, std::size_t end) {
  const Floats d;
  float body = 0;
  for (const FlockModel& flock : motion.model.flocks) body = std::max(body, flock.body_radius);
  SelectFor(motion, body, begin, end);
  const ObstacleColumns& near = motion.part.near_obstacles;
  for (std::size_t first = begin; near.count > 0 && first < end; first += width) {
    const std::size_t count = std::min<std::size_t>(width, end - first);
    const LaneVec<D> from = LoadSomeVec<D>(motion.state.position, first, count);
    const Lanes reach = hn::Add(WayOf(motion, from, first, count), hn::Set(d, 1.0001f * body));
    auto may = hn::FirstN(d, 0);
    for (std::size_t k = 0; k < near.count; ++k)
      may = hn::Or(may, LookAt<D>(near, k, motion.image, from, reach).near);
    if (hn::AllFalse(d, may)) continue;
    HWY_ALIGN float is_near[width];
    hn::Store(hn::IfThenElseZero(may, hn::Set(d, 1.0f)), d, is_near);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (is_near[lane] != 0) keep_out(motion, first + lane, first + lane + 1);
    }
  }
}

void KeepOut2(Motion<2>& motion, std::size_t begin, std::size_t end) {
  KeepOut(motion, begin, end);
}
void KeepOut3(Motion<3>& motion, std::size_t begin, std::size_t end) {
  KeepOut(motion, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sturnus {

HWY_EXPORT(KeepOut2);
HWY_EXPORT(KeepOut3);

template <>
void keep_out_wide<2>(Motion<2>& motion, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(KeepOut2)(motion, begin, end);
}
template <>
void keep_out_wide<3>(Motion<3>& motion, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(KeepOut3)(motion, begin, end);
}

}  // namespace sturnus
#endif
