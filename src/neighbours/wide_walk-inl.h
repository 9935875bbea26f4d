// The walk of a plan over the candidates of a batch. Included once for every instruction set.
#if defined(STURNUS_WIDE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_WALK_INL_H
#undef STURNUS_WIDE_WALK_INL_H
#else
#define STURNUS_WIDE_WALK_INL_H
#endif

#include <algorithm>
#include <cassert>

#include "neighbours/wide_list-inl.h"
#include "neighbours/wide_plan-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// What one walk of a plan needs.
template <int D, class ThePlan>
struct Walk {
  // Not an aggregate, whose last members would be cleared for nothing.
  HWY_INLINE Walk(const WideBatch& of, std::size_t first, const Filters& its_filters)
      : batch(of), boids(*of.boids), targets(Load<D>(of, first, ThePlan::has_options)), filters(its_filters) {
    const Floats d;
    for (std::size_t f = 0; f < ThePlan::filters; ++f) {
      listed[f].count = 0;
      outer[f] = ThePlan::has_options ? hn::Load(d, filters.outer[f])
                                      : hn::Set(d, of.program->filters[of.filter + f].outer_squared);
    }
  }

  const WideBatch& batch;
  const Boids boids;
  const Targets<D> targets;
  const Filters& filters;
  Lanes outer[ThePlan::filters];  ///< how far each lane looks, squared
  Shifts shifts;
  Listed listed[ThePlan::filters];  ///< who may pass each of them
};

template <int f, int D, class ThePlan>
HWY_INLINE Lanes_mask Passes(const Walk<D, ThePlan>& walk, const Targets<D>& targets, Lanes outer,
                             const Seen<D>& seen, const Boids& boids, std::size_t candidate) {
  if constexpr (ThePlan::has_options)
    return PassesFilter<D>(walk.filters, f, targets, seen, boids, candidate);
  return hn::Lt(seen.distance_squared, outer);
}

// Lists a candidate for one of the smaller filters where some lane has it near enough, without a branch.
template <int f, Wraps wraps, int D>
HWY_INLINE void ListNear(const Seen<D>& seen, Lanes outer, std::uint32_t candidate, std::uint32_t span,
                         Listed* listed, std::size_t& count) {
  assert(count < listed_at_once);
  listed[f].slot[count] = candidate;
  if (wraps == Wraps::by_span) listed[f].span[count] = span;
  count += hn::CountTrue(Floats(), hn::Lt(seen.distance_squared, outer)) == 0 ? 0 : 1;
}

// The rows of a filter, for those who are listed; from the largest filter on these list who comes near enough
// for the smaller ones. A function of its own, with all that it needs in registers. `doubles`: what fades is
// summed in double.
template <int f, int D, Wraps wraps, bool doubles, class ThePlan>
HWY_NOINLINE void WalkListed(Walk<D, ThePlan>& walk, Running<ThePlan>& sums, Wholes<ThePlan>& doubled) {
  constexpr bool lists = f + 1 == ThePlan::filters;
  const Boids boids = walk.boids;
  const Targets<D> targets = walk.targets;
  const Lanes outer = walk.outer[f];
  const Lanes outer_0 = walk.outer[0];
  const Lanes outer_1 = walk.outer[ThePlan::filters > 1 ? 1 : 0];
  std::size_t near_0 = 0, near_1 = 0;
  Running<ThePlan> running;
  Wholes<ThePlan> own_wholes;
  Wholes<ThePlan>* const wholes = doubles ? &own_wholes : nullptr;
  CopyRows<D, ThePlan, f>(sums, &doubled, running, wholes);
  const std::uint32_t* const slots = walk.listed[f].slot;
  const std::size_t count = walk.listed[f].count;
  for (std::size_t i = 0; i < count; ++i) {
    // Read once more for the lanes below: there it is spread over them on the way.
    const std::uint32_t candidate = static_cast<const volatile std::uint32_t&>(slots[i]);
    std::uint32_t span = 0;
    Lanes shift[3];
    if constexpr (wraps == Wraps::by_span) {
      span = walk.listed[f].span[i];
      for (std::size_t axis = 0; axis < D; ++axis)
        shift[axis] = hn::Set(Floats(), walk.shifts.shift[span][axis]);
    }
    const Seen<D> seen = Look<D, wraps>(targets, boids, walk.batch.image, shift, candidate);
    if constexpr (lists && f > 0) ListNear<0, wraps>(seen, outer_0, candidate, span, walk.listed, near_0);
    if constexpr (lists && f > 1) ListNear<1, wraps>(seen, outer_1, candidate, span, walk.listed, near_1);
    auto mask = Passes<f>(walk, targets, outer, seen, boids, candidate);
    if constexpr (!ThePlan::template adds_nothing_to_itself<f>())
      mask = NotSelf(mask, slots[i], targets.slots);
    AddRows<ThePlan, f>(boids, seen, mask, candidate, running, wholes);
  }
  walk.listed[f].count = 0;
  if constexpr (lists && f > 0) walk.listed[0].count = near_0;
  if constexpr (lists && f > 1) walk.listed[1].count = near_1;
  CopyRows<D, ThePlan, f>(running, wholes, sums, doubles ? &doubled : nullptr);
}

template <int D, Wraps wraps, class ThePlan, int f>
HWY_INLINE void WalkFrom(Walk<D, ThePlan>& walk, Running<ThePlan>& running, Wholes<ThePlan>& wholes) {
  if constexpr (f >= 0) {
    if (ThePlan::template fades_in<f>() && !walk.batch.few)
      WalkListed<f, D, wraps, ThePlan::template fades_in<f>()>(walk, running, wholes);
    else
      WalkListed<f, D, wraps, false>(walk, running, wholes);
    WalkFrom<D, wraps, ThePlan, f - 1>(walk, running, wholes);
  }
}

// All who are listed, for all filters.
template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkLists(Walk<D, ThePlan>& walk, Running<ThePlan>& running, Wholes<ThePlan>& wholes) {
  WalkFrom<D, wraps, ThePlan, ThePlan::filters - 1>(walk, running, wholes);
  walk.shifts.span = 0;
}

// A few candidates are summed in float alone, many in double piece by piece.
template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkSpans(Walk<D, ThePlan>& walk, std::size_t first) {
  constexpr int last = ThePlan::filters - 1;
  const bool few = walk.batch.few;
  const std::size_t at_once = few ? listed_at_once : candidates_in_float;
  Running<ThePlan> running;
  Wholes<ThePlan> wholes;
  Clear<D, ThePlan>(walk.batch, running);
  if (!few) Clear<D, ThePlan>(wholes);
  const LaneBox box = BoxAround<D>(walk.targets, *walk.batch.box);
  const Lanes outer = hn::MaxOfLanes(Floats(), walk.outer[last]);
  std::size_t left = at_once;
  for (const Span& span : walk.batch.spans) {
    if (wraps == Wraps::by_span) SetShift(span, *walk.batch.image, walk.shifts);
    for (std::size_t at = span.begin; at < span.end;) {
      const std::size_t end = std::min<std::size_t>(span.end, at + left);
      constexpr auto list = wraps == Wraps::no ? List<D, wraps> : ListApart<D, wraps>;
      list(walk.boids, box, outer, walk.shifts, at, end, walk.listed[last]);
      left -= end - at;
      at = end;
      if (left != 0) continue;
      WalkLists<D, wraps>(walk, running, wholes);
      if (wraps == Wraps::by_span) SetShift(span, *walk.batch.image, walk.shifts);
      if (!few) Fold<D, ThePlan>(running, wholes);
      left = at_once;
    }
    if (wraps == Wraps::by_span && ++walk.shifts.span == spans_at_once)
      WalkLists<D, wraps>(walk, running, wholes);
  }
  WalkLists<D, wraps>(walk, running, wholes);
  if (!few) Fold<D, ThePlan>(running, wholes);
  Store<D, ThePlan>(walk.batch, first, running, few ? nullptr : &wholes);
}

// Whether every span says over which end of the space its boids are seen.
HWY_INLINE bool SpansTell(std::span<const Span> spans) {
  return std::none_of(spans.begin(), spans.end(), [](const Span& span) {
    return std::find(span.seam.begin(), span.seam.end(), Seam::unknown) != span.seam.end();
  });
}

template <int D, class ThePlan>
HWY_NOINLINE void SumBatchBy(const WideBatch& batch) {
  const bool spans_tell = batch.image->wraps && SpansTell(batch.spans);
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    Filters filters;
    if constexpr (ThePlan::has_options) FillFilters(batch, first, ThePlan::filters, filters);
    Walk<D, ThePlan> walk(batch, first, filters);
    if (!batch.image->wraps) {
      WalkSpans<D, Wraps::no>(walk, first);
    } else if (spans_tell) {
      WalkSpans<D, Wraps::by_span>(walk, first);
    } else {
      WalkSpans<D, Wraps::by_comparison>(walk, first);
    }
  }
}

// One row of a program, whatever stands in it.
template <int D>
HWY_INLINE void SumRow(const WideBatch& batch) {
  using enum WideAddend;
  switch (batch.program->rows[batch.row].addend) {
    case fades:
      return SumBatchBy<D, Plan<1, true, fades>>(batch);
    case constant:
      return SumBatchBy<D, Plan<1, true, constant>>(batch);
    case heading:
      return SumBatchBy<D, Plan<1, true, heading>>(batch);
    case velocity:
      return SumBatchBy<D, Plan<1, true, velocity>>(batch);
    case grows:
      return SumBatchBy<D, Plan<1, true, grows>>(batch);
    case colour:
      return SumBatchBy<D, Plan<1, true, colour>>(batch);
  }
}

// Any program: row by row, each as a plan of its own.
template <int D>
HWY_NOINLINE void SumBatchAny(const WideBatch& batch) {
  WideBatch one = batch;
  for (one.row = 0; one.row < batch.program->row_count; ++one.row) {
    one.filter = batch.program->rows[one.row].filter;
    SumRow<D>(one);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
