// What a neighbour adds to the lanes' sums, and where the sums go. Included once for every instruction set.
#if defined(STURNUS_WIDE_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_SUMS_INL_H
#undef STURNUS_WIDE_SUMS_INL_H
#else
#define STURNUS_WIDE_SUMS_INL_H
#endif

#include <bit>
#include <limits>

#include "neighbours/wide_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// Where a candidate pushes, minus what the plain kernel adds: near boids push no harder than at the least
// distance, coincident ones not at all.
template <int D>
HWY_INLINE void Push(const Seen<D>& seen, bool fades, Lanes* values) {
  const Floats d;
  const Lanes least = hn::Set(d, std::numeric_limits<float>::min());
  const Lanes squared = hn::Max(seen.distance_squared, least);
  const Lanes scale = hn::Div(hn::Set(d, 1.0f), fades ? squared : hn::Sqrt(squared));
  for (std::size_t axis = 0; axis < D; ++axis) values[axis] = hn::Mul(seen.away[axis], scale);
}

template <int D>
HWY_INLINE void AddPush(Lanes* part, Lanes_mask mask, const Seen<D>& seen, bool fades) {
  Lanes values[3];
  Push<D>(seen, fades, values);
  for (std::size_t axis = 0; axis < D; ++axis) part[axis] = SubtractWhere(mask, part[axis], values[axis]);
}

template <int D>
HWY_INLINE void AddColumns(Lanes* part, Lanes_mask mask, const std::array<const float*, 3>& columns,
                           std::size_t candidate) {
  const Floats d;
  for (std::size_t axis = 0; axis < D; ++axis)
    part[axis] = AddWhere(mask, part[axis], hn::Set(d, columns[axis][candidate]));
}

template <int D>
HWY_INLINE void AddTo(Lanes* part, WideAddend addend, Lanes_mask mask, const Seen<D>& seen,
                      const Boids& boids, std::size_t candidate) {
  switch (addend) {
    case WideAddend::fades:
      return AddPush<D>(part, mask, seen, true);
    case WideAddend::constant:
      return AddPush<D>(part, mask, seen, false);
    case WideAddend::grows:
      for (std::size_t axis = 0; axis < D; ++axis)
        part[axis] = SubtractFinite(mask, part[axis], seen.away[axis]);
      return;
    case WideAddend::velocity:
      return AddColumns<D>(part, mask, boids.velocity, candidate);
    case WideAddend::heading:
      return AddColumns<D>(part, mask, boids.heading, candidate);
    case WideAddend::colour:
      return AddColumns<3>(part, mask, boids.colour, candidate);
  }
}

// With many candidates, what fades with distance goes into the doubles at once: see `few_candidates`.
template <int D>
HWY_INLINE void AddFading(Doubled* whole, Lanes_mask mask, const Seen<D>& seen) {
  Lanes values[3];
  Push<D>(seen, true, values);
  for (std::size_t axis = 0; axis < D; ++axis)
    SubtractDoubled(whole[axis], hn::IfThenElseZero(mask, values[axis]));
}

// Which lanes hold boids that are steered here.
HWY_INLINE Lanes_mask Steered(const WideBatch& batch, std::size_t first) {
  const Floats d;
  const std::size_t count = std::min<std::size_t>(width, batch.targets.end - first);
  if (!batch.is_mixed) return hn::FirstN(d, count);
  HWY_ALIGN float is_steered[width] = {};
  for (std::size_t i = 0; i < count; ++i) {
    is_steered[i] = (batch.boids->flock_bit(first + i) & batch.steered) != 0 ? 1.0f : 0.0f;
  }
  return hn::Gt(hn::Load(d, is_steered), hn::Zero(d));
}

HWY_INLINE void StoreRow(const WideBatch& batch, std::size_t first, std::size_t row, Lanes_mask steered,
                         const Lanes* values, Counts count) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  auto* to = reinterpret_cast<std::int32_t*>(batch.sums->count(row, first));
  if (!batch.is_mixed) {  // the columns have room beyond the last boid
    for (std::size_t axis = 0; axis < 3; ++axis)
      hn::StoreU(values[axis], d, batch.sums->value(row, axis, first));
    hn::StoreU(count, di, to);
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    hn::BlendedStore(values[axis], steered, d, batch.sums->value(row, axis, first));
  hn::BlendedStore(count, hn::RebindMask(di, steered), di, to);
}

// What is nobody's sum.
HWY_INLINE void StoreEmpty(const WideBatch& batch, std::size_t first, Lanes_mask steered) {
  const Floats d;
  const Lanes nothing[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::uint64_t left = batch.program->empty_rows; left != 0; left &= left - 1)
    StoreRow(batch, first, static_cast<std::size_t>(std::countr_zero(left)), steered, nothing,
             hn::Zero(hn::RebindToSigned<Floats>()));
}

// For boids who look at nobody of those who are near.
HWY_INLINE void StoreNothing(const WideBatch& batch) {
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width)
    StoreEmpty(batch, first, Steered(batch, first));
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
