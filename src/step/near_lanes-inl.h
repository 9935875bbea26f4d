// Who of a register of boids may be near an obstacle: whoever is not has nothing to ask. Included once for
// every instruction set.
#if defined(STURNUS_NEAR_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_NEAR_LANES_INL_H
#undef STURNUS_NEAR_LANES_INL_H
#else
#define STURNUS_NEAR_LANES_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "neighbours/kernel.h"
#include "step/lane_vec-inl.h"
#include "world/obstacle_columns.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

static_assert(width <= ObstacleColumns::spare);

// Where more obstacles than these are near a block or a group of boids, each boid asks the obstacles' index,
// as the plain loop does: a boid has few of them near, lanes would ask about all. By measurement; both ways
// end in the same bits. Wide registers, which also pack in one instruction what they keep, stand more.
constexpr std::size_t many_for_block = (width < 16 ? 64 : 256) * width;
constexpr std::size_t many_for_group = (width < 16 ? 8 : 16) * width;

// Whether even ruling them out for so many boids costs more than that.
inline bool AreTooMany(const ObstacleColumns& obstacles, std::size_t boids) {
  return obstacles.count > many_for_block + 2 * width * boids;
}

template <int D>
HWY_INLINE Lanes_mask AreSoundPlaces(const LaneVec<D>& places) {
  const Floats d;
  auto sound = hn::FirstN(d, width);
  for (int axis = 0; axis < D; ++axis)
    sound = hn::And(sound, hn::Le(hn::Abs(places.at[axis]), hn::Set(d, 1e15f)));
  return sound;
}

// Places in the lanes, the least and the largest on every axis.
template <int D>
struct Bounds {
  LaneVec<D> low, high;
};

template <int D>
HWY_INLINE Bounds<D> NoBounds() {
  const Lanes infinite = hn::Set(Floats(), FlockModel::infinity_f);
  Bounds<D> none;
  for (int axis = 0; axis < D; ++axis) {
    none.low.at[axis] = infinite;
    none.high.at[axis] = hn::Neg(infinite);
  }
  return none;
}

template <int D>
HWY_INLINE void Widen(Bounds<D>& bounds, const LaneVec<D>& places, Lanes_mask mask) {
  for (int axis = 0; axis < D; ++axis) {
    const Lanes at = places.at[axis];
    bounds.low.at[axis] = hn::IfThenElse(mask, hn::Min(bounds.low.at[axis], at), bounds.low.at[axis]);
    bounds.high.at[axis] = hn::IfThenElse(mask, hn::Max(bounds.high.at[axis], at), bounds.high.at[axis]);
  }
}

template <int D>
HWY_INLINE Bounds<D> BoundsOf(const LaneVec<D>& places, Lanes_mask mask) {
  Bounds<D> bounds = NoBounds<D>();
  Widen(bounds, places, mask);
  return bounds;
}

template <int D>
HWY_INLINE Box BoxOf(const Bounds<D>& bounds) {
  const Floats d;
  Box box;
  for (int axis = 0; axis < D; ++axis) {
    box.low[static_cast<std::size_t>(axis)] = hn::GetLane(hn::MinOfLanes(d, bounds.low.at[axis]));
    box.high[static_cast<std::size_t>(axis)] = hn::GetLane(hn::MaxOfLanes(d, bounds.high.at[axis]));
  }
  return box;
}

// Writes a register, the wanted values first; there is room for it.
HWY_INLINE void Append(const std::vector<float>& from, std::size_t first, Lanes_mask wanted,
                       std::vector<float>& to, std::size_t count) {
  const Floats d;
  hn::StoreU(hn::Compress(hn::LoadU(d, from.data() + first), wanted), d, to.data() + count);
}

// Takes those obstacles whose boxes may be within a reach (length) of that box.
template <int D>
HWY_INLINE void Select(const ObstacleColumns& from, const Wrapping& image, const Box& box, float reach,
                       ObstacleColumns& to) {
  const Floats d;
  to.count = 0;
  if (!(box.low[0] <= box.high[0])) return;
  for (std::size_t first = 0; first < from.count; first += width) {
    auto near = hn::FirstN(d, std::min<std::size_t>(width, from.count - first));
    for (std::size_t axis = 0; axis < D; ++axis) {
      const float low = box.low[axis], high = box.high[axis];
      const float room = 0.5f * (high - low) + 1.0001f * reach + 1e-5f * (std::abs(low) + std::abs(high));
      Lanes o =
          hn::Abs(hn::Sub(hn::LoadU(d, from.at[axis].data() + first), hn::Set(d, low + 0.5f * (high - low))));
      if (image.wraps) o = hn::Min(o, hn::Abs(hn::Sub(hn::Set(d, image.size[axis]), o)));
      const Lanes most = hn::Add(hn::LoadU(d, from.extent[axis].data() + first), hn::Set(d, room));
      near = hn::AndNot(hn::Gt(o, most), near);
    }
    if (hn::AllFalse(d, near)) continue;
    for (std::size_t axis = 0; axis < D; ++axis) {
      Append(from.at[axis], first, near, to.at[axis], to.count);
      Append(from.extent[axis], first, near, to.extent[axis], to.count);
    }
    Append(from.radius, first, near, to.radius, to.count);
    Append(from.number, first, near, to.number, to.count);
    to.count += hn::CountTrue(d, near);
  }
}

// The k-th obstacle as the lanes see it.
template <int D>
struct SeenObstacle {
  LaneVec<D> offset;
  Lanes distance_squared;
  float radius = 0;  // infinite where it is no sphere
  Lanes_mask near;   // the lanes that may be within their reach of it
};

template <int D>
HWY_INLINE SeenObstacle<D> LookAt(const ObstacleColumns& obstacles, std::size_t k, const Wrapping& image,
                                  const LaneVec<D>& from, Lanes reach) {
  const Floats d;
  SeenObstacle<D> seen;
  std::array<float, 3> place{};
  for (std::size_t axis = 0; axis < D; ++axis) place[axis] = obstacles.at[axis][k];
  seen.offset = Offset(from, Everywhere<D>(place), image);
  seen.distance_squared = Squared<D>(seen.offset.at);
  seen.radius = obstacles.radius[k];
  const Lanes most = hn::Add(hn::Set(d, seen.radius), reach);
  seen.near = hn::Not(hn::Gt(seen.distance_squared, hn::Mul(most, most)));
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Lanes side = hn::Add(hn::Set(d, obstacles.extent[axis][k]), reach);
    seen.near = hn::AndNot(hn::Gt(hn::Abs(seen.offset.at[axis]), side), seen.near);
  }
  return seen;
}

// Whether two images of a sphere may be as near as that, so that the offset to one does not say all.
HWY_INLINE bool IsAmbiguous(const Wrapping& image, int dimensions, float radius, float reach) {
  bool is = false;
  for (std::size_t axis = 0; image.wraps && axis < static_cast<std::size_t>(dimensions); ++axis)
    is = is || !(radius + reach < 0.49f * image.size[axis]);
  return is;
}

// Who may meet a sphere, made thicker, straight ahead. Sums of squares in float are off by less than a
// millionth; here they may be off by ten times as much. At rest or nearly so nothing is ruled out.
template <int D>
HWY_INLINE Lanes_mask MayMeet(const SeenObstacle<D>& seen, const LaneVec<D>& velocity, float thicker) {
  const Floats d;
  const float size = seen.radius + thicker;
  const Lanes size_squared = hn::Set(d, size * size);
  const Lanes speed_squared = Squared<D>(velocity.at);
  Lanes along = hn::Mul(seen.offset.at[0], velocity.at[0]);
  for (int axis = 1; axis < D; ++axis)
    along = hn::Add(along, hn::Mul(seen.offset.at[axis], velocity.at[axis]));
  const Lanes all = hn::Mul(seen.distance_squared, speed_squared);
  const Lanes aside = hn::Sub(all, hn::Mul(along, along));
  const Lanes room = hn::Add(hn::Mul(size_squared, speed_squared), hn::Mul(all, hn::Set(d, 1e-5f)));
  const auto is_behind = hn::And(hn::Lt(along, hn::Zero(d)), hn::Gt(seen.distance_squared, size_squared));
  const auto misses = hn::Or(hn::Gt(aside, room), is_behind);
  return hn::Not(hn::And(misses, hn::Gt(speed_squared, hn::Set(d, 1e-30f))));
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
