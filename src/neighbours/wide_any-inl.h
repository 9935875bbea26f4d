// Any program of rows. Included once for every instruction set.
#if defined(STURNUS_WIDE_ANY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_ANY_INL_H
#undef STURNUS_WIDE_ANY_INL_H
#else
#define STURNUS_WIDE_ANY_INL_H
#endif

#include "neighbours/wide_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// Any program, row by row: slower, since the sums pass through memory for each candidate.
struct AnySums {
  Lanes part[WideProgram::most][3];
  Doubled whole[WideProgram::most][3];
};

HWY_INLINE void FoldAny(std::size_t rows, AnySums& running) {
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      AddDoubled(running.whole[r][axis], running.part[r][axis]);
      running.part[r][axis] = hn::Zero(Floats());
    }
  }
}

HWY_INLINE void ClearAny(AnySums& running, Sums& sums) {
  for (std::size_t r = 0; r < WideProgram::most; ++r) {
    sums.count[r] = hn::Zero(hn::RebindToSigned<Floats>());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      running.part[r][axis] = hn::Zero(Floats());
      running.whole[r][axis] = ZeroDoubled();
    }
  }
}

template <int D>
HWY_INLINE void AddAny(const WideBatch& batch, const WideProgram& program, const Lanes_mask* masks,
                       const Seen<D>& seen, std::size_t candidate, AnySums& running) {
  for (std::size_t r = 0; r < program.row_count; ++r) {
    const WideRow row = program.rows[r];
    if (row.addend == WideAddend::fades && !batch.few) {
      AddFading<D>(running.whole[r], masks[row.filter], seen);
    } else {
      AddTo<D>(running.part[r], row.addend, masks[row.filter], seen, *batch.boids, candidate);
    }
  }
}

template <int D, Wraps wraps>
HWY_INLINE void WalkAny(const WideBatch& batch, const Targets<D>& targets, const Filters& filters,
                        Sums& sums) {
  const WideProgram& program = *batch.program;
  AnySums running;
  ClearAny(running, sums);
  std::size_t seen_so_far = 0;
  for (const Span span : batch.spans) {
    for (std::size_t candidate = span.begin; candidate < span.end; ++candidate) {
      const Seen<D> seen = Look<D, wraps>(targets, *batch.boids, batch.image, nullptr, candidate);
      Lanes_mask masks[WideProgram::most];
      for (std::size_t f = 0; f < program.filter_count; ++f) {
        masks[f] = PassesFilter<D>(filters, f, targets, seen, *batch.boids, candidate);
        masks[f] = NotSelf(masks[f], static_cast<std::uint32_t>(candidate), targets.slots);
        sums.count[f] = CountWhere(masks[f], sums.count[f]);
      }
      AddAny<D>(batch, program, masks, seen, candidate, running);
      if (!batch.few && ++seen_so_far % candidates_in_float == 0) FoldAny(program.row_count, running);
    }
  }
  FoldAny(program.row_count, running);
  for (std::size_t r = 0; r < program.row_count; ++r) {
    for (std::size_t axis = 0; axis < 3; ++axis) sums.value[r][axis] = Rounded(running.whole[r][axis]);
  }
}

template <int D>
HWY_NOINLINE void SumBatchAny(const WideBatch& batch) {
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    Filters filters;
    FillFilters(batch, first, filters);
    const Targets<D> targets = Load<D>(batch, first, filters.has_views);
    Sums sums;
    if (batch.image->wraps) {
      WalkAny<D, Wraps::by_comparison>(batch, targets, filters, sums);
    } else {
      WalkAny<D, Wraps::no>(batch, targets, filters, sums);
    }
    StoreSums(batch, first, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
