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

// Boids that stand one after the other: where, and how far the longest way among them is.
template <int D>
struct Going {
  Bounds<D> bounds;
  Lanes longest;
};

template <int D>
HWY_INLINE Going<D> GoingFrom(const Motion<D>& motion, std::size_t begin, std::size_t end) {
  const Floats d;
  Going<D> going{NoBounds<D>(), hn::Zero(d)};
  for (std::size_t first = begin; first < end; first += width) {
    const std::size_t count = std::min<std::size_t>(width, end - first);
    const LaneVec<D> from = LoadSomeVec<D>(motion.state.position, first, count);
    Widen(going.bounds, from, AreSoundPlaces(from));
    const Lanes way = WayOf(motion, from, first, count);
    going.longest = hn::Max(going.longest, hn::IfThenElseZero(hn::Le(way, hn::Set(d, 1e30f)), way));
  }
  return going;
}

// The obstacles that one of them may be as near to as he goes.
template <int D>
HWY_INLINE void SelectFor(const Motion<D>& motion, const Going<D>& going, float body,
                          const ObstacleColumns& from, ObstacleColumns& to) {
  const float longest = hn::GetLane(hn::MaxOfLanes(Floats(), going.longest));
  Select<D>(from, motion.image, BoxOf(going.bounds), body + longest, to);
}

// Sweeps those of a register who may be near one of the obstacles.
template <int D>
HWY_INLINE void KeepOutLanes(Motion<D>& motion, const ObstacleColumns& near, float body, std::size_t first,
                             std::size_t count) {
  const Floats d;
  const LaneVec<D> from = LoadSomeVec<D>(motion.state.position, first, count);
  const Lanes reach = hn::Add(WayOf(motion, from, first, count), hn::Set(d, 1.0001f * body));
  auto may = hn::FirstN(d, 0);
  for (std::size_t k = 0; k < near.count; ++k)
    may = hn::Or(may, LookAt<D>(near, k, motion.image, from, reach).near);
  if (hn::AllFalse(d, may)) return;
  HWY_ALIGN float is_near[width];
  hn::Store(hn::IfThenElseZero(may, hn::Set(d, 1.0f)), d, is_near);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (is_near[lane] != 0) keep_out(motion, first + lane, first + lane + 1);
  }
}

// From the obstacles near all to those near a register; where there are many, each boid asks their index.
template <int D>
HWY_INLINE void KeepOut(Motion<D>& motion, std::size_t begin, std::size_t end) {
  const ObstacleColumns& all = motion.scratch.obstacles.columns();
  if (AreTooMany(all, end - begin)) return keep_out(motion, begin, end);
  float body = 0;
  for (const FlockModel& flock : motion.model.flocks) body = std::max(body, flock.body_radius);
  ObstacleColumns& block = motion.part.block_obstacles;
  ObstacleColumns& near = motion.part.near_obstacles;
  block.fit(all.count);
  near.fit(all.count);
  SelectFor(motion, GoingFrom(motion, begin, end), body, all, block);
  if (block.count > many_for_block) return keep_out(motion, begin, end);
  for (std::size_t first = begin; block.count > 0 && first < end; first += width) {
    const std::size_t count = std::min<std::size_t>(width, end - first);
    SelectFor(motion, GoingFrom(motion, first, first + count), body, block, near);
    if (near.count > many_for_group) {
      keep_out(motion, first, first + count);
    } else if (near.count > 0) {
      KeepOutLanes(motion, near, body, first, count);
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
