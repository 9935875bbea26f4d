// The candidates of a batch in lists, over which a kernel walks without a pause: only those who may be near
// somebody in the lanes, in their order. Included once for every instruction set.
#if defined(STURNUS_WIDE_LIST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_LIST_INL_H
#undef STURNUS_WIDE_LIST_INL_H
#else
#define STURNUS_WIDE_LIST_INL_H
#endif

#include <algorithm>
#include <cassert>

#include "neighbours/wide_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// So many candidates are listed before they are walked, of so many spans.
constexpr std::size_t listed_at_once = 512;
constexpr std::size_t spans_at_once = 64;

// Slots of candidates in their order, and over which seams they are seen: the number of their span, where
// that tells.
struct Listed {
  std::size_t count;
  std::uint32_t slot[listed_at_once + batch_size];
  std::uint32_t span[listed_at_once + batch_size];
};

// What a seam adds to the way from a candidate, span by span.
struct Shifts {
  std::uint32_t span = 0;  ///< the span at hand
  float shift[spans_at_once][3];
};

HWY_INLINE void SetShift(const Span& span, const Wrapping& image, Shifts& shifts) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float size = image.size[axis];
    const Seam seam = span.seam[axis];
    shifts.shift[shifts.span][axis] = seam == Seam::low ? size : seam == Seam::high ? -size : 0.0f;
  }
}

// The box of the boids in the lanes, in all lanes.
struct LaneBox {
  Lanes low[3], high[3];
};

template <int D>
HWY_INLINE LaneBox BoxAround(const Targets<D>& targets, const Box& batch) {
  const Floats d;
  LaneBox box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const bool is_batch = width == batch_size;
    const Lanes at = targets.position[axis];
    box.low[axis] = is_batch ? hn::Set(d, batch.low[axis]) : hn::MinOfLanes(d, at);
    box.high[axis] = is_batch ? hn::Set(d, batch.high[axis]) : hn::MaxOfLanes(d, at);
  }
  return box;
}

// How far candidates are from a box at least, squared. Found by the operations that find it for a boid in the
// box; rounding keeps order, so that nobody in it finds less.
template <int D, Wraps wraps>
HWY_INLINE Lanes FromBox(const LaneBox& box, const Lanes* at, const float* shift) {
  const Floats d;
  Lanes gap[3];
  for (std::size_t axis = 0; axis < D; ++axis) {
    Lanes below = hn::Sub(box.low[axis], at[axis]);
    Lanes above = hn::Sub(at[axis], box.high[axis]);
    if (wraps == Wraps::by_span) {
      below = hn::Add(below, hn::Set(d, shift[axis]));
      above = hn::Sub(above, hn::Set(d, shift[axis]));
    }
    gap[axis] = hn::Max(hn::Max(below, above), hn::Zero(d));
  }
  return Squared<D>(gap);
}

// Stores those of the slots from `first` on that the mask holds for, one after the other, and maybe something
// behind them; returns how many.
HWY_INLINE std::size_t StoreWhere(Lanes_mask mask, std::size_t first, std::uint32_t* to) {
#if HWY_TARGET <= HWY_AVX3
  const hn::RebindToSigned<Floats> d;
  const auto slots = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<std::int32_t>(first)));
  hn::StoreU(hn::Compress(slots, hn::RebindMask(d, mask)), d, reinterpret_cast<std::int32_t*>(to));
  return hn::CountTrue(Floats(), mask);
#else
  const std::uint32_t bits = BitsOf(mask);
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < width; ++lane) {
    to[count] = static_cast<std::uint32_t>(first + lane);
    count += bits >> lane & 1;
  }
  return count;
#endif
}

// Adds the candidates [begin, end) that may be near somebody in the box: all of them where only a comparison
// finds the nearest image.
template <int D, Wraps wraps>
HWY_INLINE void List(const Boids& boids, const LaneBox& box, Lanes outer, const Shifts& shifts,
                     std::size_t begin, std::size_t end, Listed& listed) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  std::size_t count = listed.count;
  for (std::size_t first = begin; first < end; first += width) {
    assert(count + width <= std::size(listed.slot));
    auto near = hn::FirstN(d, std::min(width, end - first));
    if (wraps != Wraps::by_comparison) {
      Lanes at[3];
      for (std::size_t axis = 0; axis < D; ++axis)
        at[axis] = LoadSome(boids.position[axis] + first, std::min(width, boids.count - first));
      near = hn::And(near, hn::Lt(FromBox<D, wraps>(box, at, shifts.shift[shifts.span]), outer));
    }
    if (wraps == Wraps::by_span)
      hn::StoreU(hn::Set(di, static_cast<std::int32_t>(shifts.span)), di,
                 reinterpret_cast<std::int32_t*>(listed.span + count));
    count += StoreWhere(near, first, listed.slot + count);
  }
  listed.count = count;
}

// The same where it is rarer, compiled once for all plans.
template <int D, Wraps wraps>
HWY_NOINLINE void ListApart(const Boids& boids, const LaneBox& box, Lanes outer, const Shifts& shifts,
                            std::size_t begin, std::size_t end, Listed& listed) {
  List<D, wraps>(boids, box, outer, shifts, begin, end, listed);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
