// Programs of rows that the compiler knows, whose sums stay in registers. Included once for every instruction
// set.
#if defined(STURNUS_WIDE_PLAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_PLAN_INL_H
#undef STURNUS_WIDE_PLAN_INL_H
#else
#define STURNUS_WIDE_PLAN_INL_H
#endif

#include <algorithm>

#include "neighbours/wide_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// A program whose rows are known to the compiler, so that its sums stay in registers; row r belongs to filter
// min(r, filters - 1).
template <int filter_count, bool with_options, WideAddend... list>
struct Plan {
  static constexpr WideAddend addends[] = {list...};
  static constexpr std::size_t rows = sizeof...(list);
  static constexpr int filters = filter_count;
  static constexpr bool has_options = with_options;
  static constexpr int filter_of(int row) { return row < filters ? row : filters - 1; }
};

// Whether a program is what a plan says.
template <class ThePlan>
bool Fits(const WideProgram& program) {
  if (program.row_count != ThePlan::rows || program.filter_count != ThePlan::filters) return false;
  for (std::size_t r = 0; r < ThePlan::rows; ++r) {
    const WideRow& row = program.rows[r];
    if (row.addend != ThePlan::addends[r] || row.filter != ThePlan::filter_of(static_cast<int>(r)))
      return false;
  }
  return true;
}

// What one walk of a plan needs.
template <int D, class ThePlan>
struct Walk {
  // Not an aggregate, whose last members would be cleared for nothing.
  HWY_INLINE Walk(const WideBatch& of, std::size_t first, const Filters& its_filters)
      : batch(of), boids(*of.boids), targets(Load<D>(of, first)), filters(its_filters) {}

  const WideBatch& batch;
  const Boids boids;
  const Targets<D> targets;
  const Filters& filters;
  Lanes outer[ThePlan::filters];
  Lanes shift[3];  ///< of the span at hand
};

template <int D, class ThePlan>
HWY_INLINE void SetShift(const Span& span, Walk<D, ThePlan>& walk) {
  const Floats d;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float size = walk.batch.image->size[axis];
    const Seam seam = span.seam[axis];
    walk.shift[axis] = hn::Set(d, seam == Seam::low ? size : seam == Seam::high ? -size : 0.0f);
  }
}

// One filter of a plan, written out for each: a loop here would keep its arrays in memory.
template <int D, bool with_self, class ThePlan, int f>
HWY_INLINE void Pass(const Walk<D, ThePlan>& walk, const Seen<D>& seen, std::size_t candidate,
                     Lanes_mask* masks, Counts* count) {
  if constexpr (f < ThePlan::filters) {
    if constexpr (ThePlan::has_options) {
      masks[f] = PassesFilter<D>(walk.filters, f, walk.targets, seen, walk.boids, candidate);
    } else {
      masks[f] = hn::Lt(seen.distance_squared, walk.outer[f]);
    }
    masks[f] = NotSelf<with_self>(masks[f], candidate, walk.targets.first);
    count[f] = CountWhere(masks[f], count[f]);
  }
}

// The sums of a plan while it walks; small enough for registers, which larger arrays are not.
template <class ThePlan>
struct Running {
  Lanes part[ThePlan::rows][3];
  Counts count[ThePlan::filters];
};
template <class ThePlan>
struct Wholes {
  Doubled sum[ThePlan::rows][3];
};

template <int D, class ThePlan, int r>
HWY_INLINE void AddRow(const Walk<D, ThePlan>& walk, const Seen<D>& seen, const Lanes_mask* masks,
                       std::size_t candidate, Running<ThePlan>& running, Wholes<ThePlan>* wholes) {
  if constexpr (r < ThePlan::rows) {
    const Lanes_mask mask = masks[ThePlan::filter_of(r)];
    if (ThePlan::addends[r] == WideAddend::fades && wholes != nullptr) {
      AddFading<D>(wholes->sum[r], mask, seen);
    } else {
      AddTo<D>(running.part[r], ThePlan::addends[r], mask, seen, walk.boids, candidate);
    }
  }
}

template <int D, Wraps wraps, bool with_self, class ThePlan>
HWY_INLINE void WalkRange(const Walk<D, ThePlan>& walk, std::size_t begin, std::size_t end,
                          Running<ThePlan>& running, Wholes<ThePlan>* wholes) {
  for (std::size_t candidate = begin; candidate < end; ++candidate) {
    const Seen<D> seen = Look<D, wraps>(walk.targets, walk.batch, walk.shift, candidate);
    Lanes_mask masks[ThePlan::filters];
    Pass<D, with_self, ThePlan, 0>(walk, seen, candidate, masks, running.count);
    Pass<D, with_self, ThePlan, 1>(walk, seen, candidate, masks, running.count);
    Pass<D, with_self, ThePlan, 2>(walk, seen, candidate, masks, running.count);
    AddRow<D, ThePlan, 0>(walk, seen, masks, candidate, running, wholes);
    AddRow<D, ThePlan, 1>(walk, seen, masks, candidate, running, wholes);
    AddRow<D, ThePlan, 2>(walk, seen, masks, candidate, running, wholes);
    AddRow<D, ThePlan, 3>(walk, seen, masks, candidate, running, wholes);
  }
}

// Candidates [begin, end), among whom may be the targets themselves.
template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkSpan(const Walk<D, ThePlan>& walk, std::size_t begin, std::size_t end,
                         Running<ThePlan>& running, Wholes<ThePlan>* wholes) {
  const std::size_t self = std::clamp(walk.targets.first, begin, end);
  const std::size_t others = std::clamp(walk.targets.first + width, begin, end);
  WalkRange<D, wraps, false, ThePlan>(walk, begin, self, running, wholes);
  WalkRange<D, wraps, true, ThePlan>(walk, self, others, running, wholes);
  WalkRange<D, wraps, false, ThePlan>(walk, others, end, running, wholes);
}

// Each row and filter written out again, for the sake of registers.
template <int D, class ThePlan, int r>
HWY_INLINE void ClearRow(Running<ThePlan>& running) {
  const Floats d;
  if constexpr (r < ThePlan::filters) running.count[r] = hn::Zero(hn::RebindToSigned<Floats>());
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < D; ++axis) running.part[r][axis] = hn::Zero(d);
  }
}

template <int D, class ThePlan>
HWY_INLINE void Clear(Running<ThePlan>& running) {
  ClearRow<D, ThePlan, 0>(running);
  ClearRow<D, ThePlan, 1>(running);
  ClearRow<D, ThePlan, 2>(running);
  ClearRow<D, ThePlan, 3>(running);
}

template <int D, class ThePlan, int r>
HWY_INLINE void ClearWhole(Wholes<ThePlan>& wholes) {
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < D; ++axis) wholes.sum[r][axis] = ZeroDoubled();
  }
}

template <int D, class ThePlan>
HWY_INLINE void Clear(Wholes<ThePlan>& wholes) {
  ClearWhole<D, ThePlan, 0>(wholes);
  ClearWhole<D, ThePlan, 1>(wholes);
  ClearWhole<D, ThePlan, 2>(wholes);
  ClearWhole<D, ThePlan, 3>(wholes);
}

template <int D, class ThePlan, int r>
HWY_INLINE void FoldRow(Running<ThePlan>& running, Wholes<ThePlan>& wholes) {
  const Floats d;
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      AddDoubled(wholes.sum[r][axis], running.part[r][axis]);
      running.part[r][axis] = hn::Zero(d);
    }
  }
}

template <int D, class ThePlan>
HWY_INLINE void Fold(Running<ThePlan>& running, Wholes<ThePlan>& wholes) {
  FoldRow<D, ThePlan, 0>(running, wholes);
  FoldRow<D, ThePlan, 1>(running, wholes);
  FoldRow<D, ThePlan, 2>(running, wholes);
  FoldRow<D, ThePlan, 3>(running, wholes);
}

template <int D, class ThePlan, int r>
HWY_INLINE void FinishRow(const Running<ThePlan>& running, const Wholes<ThePlan>* wholes, Sums& sums) {
  if constexpr (r < ThePlan::filters) sums.count[r] = running.count[r];
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < D; ++axis)
      sums.value[r][axis] = wholes == nullptr ? running.part[r][axis] : Rounded(wholes->sum[r][axis]);
    for (std::size_t axis = D; axis < 3; ++axis) sums.value[r][axis] = hn::Zero(Floats());
  }
}

template <int D, class ThePlan>
HWY_INLINE void Finish(const Running<ThePlan>& running, const Wholes<ThePlan>* wholes, Sums& sums) {
  FinishRow<D, ThePlan, 0>(running, wholes, sums);
  FinishRow<D, ThePlan, 1>(running, wholes, sums);
  FinishRow<D, ThePlan, 2>(running, wholes, sums);
  FinishRow<D, ThePlan, 3>(running, wholes, sums);
}

template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkFew(Walk<D, ThePlan>& walk, Sums& sums) {
  Running<ThePlan> running;
  Clear<D, ThePlan>(running);
  Wholes<ThePlan>* const none = nullptr;
  for (const Span& span : walk.batch.spans) {
    if (wraps == Wraps::by_span) SetShift(span, walk);
    WalkSpan<D, wraps, ThePlan>(walk, span.begin, span.end, running, none);
  }
  Finish<D, ThePlan>(running, none, sums);
}

template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkMany(Walk<D, ThePlan>& walk, Sums& sums) {
  Running<ThePlan> running;
  Wholes<ThePlan> wholes;
  Clear<D, ThePlan>(running);
  Clear<D, ThePlan>(wholes);
  std::size_t left = candidates_in_float;
  for (const Span& span : walk.batch.spans) {
    if (wraps == Wraps::by_span) SetShift(span, walk);
    for (std::size_t at = span.begin; at < span.end;) {
      const std::size_t end = std::min<std::size_t>(span.end, at + left);
      WalkSpan<D, wraps, ThePlan>(walk, at, end, running, &wholes);
      left -= end - at;
      at = end;
      if (left != 0) continue;
      Fold<D, ThePlan>(running, wholes);
      left = candidates_in_float;
    }
  }
  Fold<D, ThePlan>(running, wholes);
  Finish<D, ThePlan>(running, &wholes, sums);
}

template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkAll(Walk<D, ThePlan>& walk, Sums& sums) {
  walk.batch.few ? WalkFew<D, wraps, ThePlan>(walk, sums) : WalkMany<D, wraps, ThePlan>(walk, sums);
}

// Whether every span says over which end of the space its boids are seen.
HWY_INLINE bool SpansTell(std::span<const Span> spans) {
  return std::none_of(spans.begin(), spans.end(), [](const Span& span) {
    return std::find(span.seam.begin(), span.seam.end(), Seam::unknown) != span.seam.end();
  });
}

template <int D, class ThePlan>
HWY_NOINLINE void SumBatchBy(const WideBatch& batch) {
  const Floats d;
  const bool spans_tell = batch.image->wraps && SpansTell(batch.spans);
  const WideProgram& program = *batch.program;
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    Filters filters;
    if constexpr (ThePlan::has_options) FillFilters(batch, first, filters);
    Walk<D, ThePlan> walk(batch, first, filters);
    for (std::size_t f = 0; f < ThePlan::filters; ++f)
      walk.outer[f] = hn::Set(d, program.filters[f].outer_squared);
    Sums sums;
    if (!batch.image->wraps) {
      WalkAll<D, Wraps::no, ThePlan>(walk, sums);
    } else if (spans_tell) {
      WalkAll<D, Wraps::by_span, ThePlan>(walk, sums);
    } else {
      WalkAll<D, Wraps::by_comparison, ThePlan>(walk, sums);
    }
    StoreSums(batch, first, program, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
