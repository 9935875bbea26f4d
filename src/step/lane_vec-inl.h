// Vectors in lanes, one boid in each. Included once for every instruction set.
#if defined(STURNUS_LANE_VEC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_LANE_VEC_INL_H
#undef STURNUS_LANE_VEC_INL_H
#else
#define STURNUS_LANE_VEC_INL_H
#endif

#include "neighbours/lanes-inl.h"
#include "neighbours/offset.h"
#include "sturnus/view.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

template <int D>
struct LaneVec {
  Lanes at[D];
};

template <int D>
HWY_INLINE LaneVec<D> Zeros() {
  LaneVec<D> v;
  for (int axis = 0; axis < D; ++axis) v.at[axis] = hn::Zero(Floats());
  return v;
}

template <int D>
HWY_INLINE LaneVec<D> Scaled(const LaneVec<D>& v, Lanes factor) {
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::Mul(v.at[axis], factor);
  return out;
}

template <int D>
HWY_INLINE LaneVec<D> Sum(const LaneVec<D>& a, const LaneVec<D>& b) {
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::Add(a.at[axis], b.at[axis]);
  return out;
}

template <int D>
HWY_INLINE LaneVec<D> Difference(const LaneVec<D>& a, const LaneVec<D>& b) {
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::Sub(a.at[axis], b.at[axis]);
  return out;
}

template <int D>
HWY_INLINE LaneVec<D> Select(Lanes_mask mask, const LaneVec<D>& yes, const LaneVec<D>& no) {
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::IfThenElse(mask, yes.at[axis], no.at[axis]);
  return out;
}

template <int D>
HWY_INLINE Lanes Length(const LaneVec<D>& v) {
  return hn::Sqrt(Squared<D>(v.at));
}

template <int D>
HWY_INLINE LaneVec<D> Heading(const LaneVec<D>& v) {
  const Floats d;
  const Lanes size = Length(v);
  const auto moves = hn::Gt(size, hn::Zero(d));
  return Select(moves, Scaled(v, hn::Div(hn::Set(d, 1.0f), size)), Zeros<D>());
}

template <int D>
HWY_INLINE LaneVec<D> LoadVec(const Columns& columns, std::size_t first) {
  LaneVec<D> v;
  for (int axis = 0; axis < D; ++axis)
    v.at[axis] = hn::LoadU(Floats(), columns[static_cast<std::size_t>(axis)].data() + first);
  return v;
}

// The first `count` of them, the first in the lanes beyond.
template <int D>
HWY_INLINE LaneVec<D> LoadSomeVec(const Columns& columns, std::size_t first, std::size_t count) {
  LaneVec<D> v;
  for (int axis = 0; axis < D; ++axis)
    v.at[axis] = LoadSome(columns[static_cast<std::size_t>(axis)].data() + first, count);
  return v;
}

// To - from, as `offset` has it.
template <int D>
HWY_INLINE LaneVec<D> Offset(const LaneVec<D>& from, const LaneVec<D>& to, const Wrapping& image) {
  const Floats d;
  LaneVec<D> o = Difference(to, from);
  if (!image.wraps) return o;
  for (int axis = 0; axis < D; ++axis) {
    const Lanes half = hn::Set(d, image.half[static_cast<std::size_t>(axis)]);
    const Lanes size = hn::Set(d, image.size[static_cast<std::size_t>(axis)]);
    const Lanes v = o.at[axis];
    const auto above = hn::Gt(v, half);
    const auto below = hn::Lt(v, hn::Neg(half));
    o.at[axis] = hn::IfThenElse(above, hn::Sub(v, size), hn::IfThenElse(below, hn::Add(v, size), v));
  }
  return o;
}

template <int D>
HWY_INLINE LaneVec<D> Everywhere(const std::array<float, 3>& place) {
  LaneVec<D> v;
  for (int axis = 0; axis < D; ++axis) v.at[axis] = hn::Set(Floats(), place[static_cast<std::size_t>(axis)]);
  return v;
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
