// A register of boids, and the few operations on it that Highway has no word for. Included once for every
// instruction set.
#if defined(STURNUS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_LANES_INL_H
#undef STURNUS_LANES_INL_H
#else
#define STURNUS_LANES_INL_H
#endif

#include <array>

#include <hwy/highway.h>

#include "neighbours/index.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, batch_size>;
using Lanes = hn::Vec<Floats>;
using Counts = hn::Vec<hn::RebindToSigned<Floats>>;
using Lanes_mask = hn::Mask<Floats>;
constexpr std::size_t width = hn::MaxLanes(Floats());

// sum + value where the mask holds. A sum that began at +0 is never -0, so that adding +0 elsewhere changes
// nothing; with mask registers not adding is cheaper.
HWY_INLINE Lanes AddWhere(Lanes_mask mask, Lanes sum, Lanes value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(mask, hn::Add(sum, value), sum);
#else
  return hn::Add(sum, hn::IfThenElseZero(mask, value));
#endif
}

// sum - value where the mask holds.
HWY_INLINE Lanes SubtractWhere(Lanes_mask mask, Lanes sum, Lanes value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(mask, hn::Sub(sum, value), sum);
#else
  return hn::Sub(sum, hn::IfThenElseZero(mask, value));
#endif
}

// The same for finite values. A product with 1 or 0 is exact, so that the fused operation rounds like the
// difference; it runs where sums alone would queue.
HWY_INLINE Lanes SubtractFinite(Lanes_mask mask, Lanes sum, Lanes value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(mask, hn::NegMulAdd(hn::Set(Floats(), 1.0f), value, sum), sum);
#elif HWY_TARGET <= HWY_AVX2
  return hn::NegMulAdd(hn::IfThenElseZero(mask, hn::Set(Floats(), 1.0f)), value, sum);
#else
  return SubtractWhere(mask, sum, value);
#endif
}

// Counts where the mask holds.
HWY_INLINE Counts CountWhere(Lanes_mask mask, Counts count) {
  const hn::RebindToSigned<Floats> d;
  const auto counted = hn::RebindMask(d, mask);
#if HWY_TARGET <= HWY_AVX3
  return hn::IfThenElse(counted, hn::Add(count, hn::Set(d, 1)), count);
#else
  return hn::Sub(count, hn::VecFromMask(d, counted));
#endif
}

// A bit for each lane of the mask.
HWY_INLINE std::uint32_t BitsOf(Lanes_mask mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(Floats(), mask, bytes.data());
  return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

template <int D>
HWY_INLINE Lanes Squared(const Lanes* vector) {
  Lanes sum = hn::Mul(vector[0], vector[0]);
  for (std::size_t axis = 1; axis < D; ++axis) sum = hn::Add(sum, hn::Mul(vector[axis], vector[axis]));
  return sum;
}

// The first `count` values of a column, the first of them in the lanes beyond.
HWY_INLINE Lanes LoadSome(const float* column, std::size_t count) {
  const Floats d;
  if (count == width) return hn::LoadU(d, column);
  HWY_ALIGN float values[width];
  for (std::size_t i = 0; i < width; ++i) values[i] = column[i < count ? i : 0];
  return hn::Load(d, values);
}

// A register of floats as doubles; one by one where registers hold no doubles, as Highway has it for the
// browser.
#if !HWY_HAVE_FLOAT64 || HWY_TARGET == HWY_SCALAR
struct Doubled {
  double value[width];
};
HWY_INLINE Doubled ZeroDoubled() {
  return {};
}
HWY_INLINE void AddDoubled(Doubled& sum, Lanes values) {
  HWY_ALIGN float lanes[width];
  hn::Store(values, Floats(), lanes);
  for (std::size_t i = 0; i < width; ++i) sum.value[i] += double{lanes[i]};
}
HWY_INLINE void SubtractDoubled(Doubled& sum, Lanes values) {
  AddDoubled(sum, hn::Neg(values));
}
HWY_INLINE Lanes Rounded(const Doubled& sum) {
  HWY_ALIGN float lanes[width];
  for (std::size_t i = 0; i < width; ++i) lanes[i] = static_cast<float>(sum.value[i]);
  return hn::Load(Floats(), lanes);
}
#else
using Doubles = hn::Repartition<double, Floats>;
using HalfFloats = hn::Half<Floats>;
struct Doubled {
  hn::Vec<Doubles> low, high;
};
HWY_INLINE Doubled ZeroDoubled() {
  return {hn::Zero(Doubles()), hn::Zero(Doubles())};
}
HWY_INLINE void AddDoubled(Doubled& sum, Lanes values) {
  const Doubles d;
  const HalfFloats half;
  sum.low = hn::Add(sum.low, hn::PromoteTo(d, hn::LowerHalf(half, values)));
  sum.high = hn::Add(sum.high, hn::PromoteTo(d, hn::UpperHalf(half, values)));
}
HWY_INLINE void SubtractDoubled(Doubled& sum, Lanes values) {
  const Doubles d;
  const HalfFloats half;
  sum.low = hn::Sub(sum.low, hn::PromoteTo(d, hn::LowerHalf(half, values)));
  sum.high = hn::Sub(sum.high, hn::PromoteTo(d, hn::UpperHalf(half, values)));
}
HWY_INLINE Lanes Rounded(const Doubled& sum) {
  const HalfFloats half;
  return hn::Combine(Floats(), hn::DemoteTo(half, sum.high), hn::DemoteTo(half, sum.low));
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
