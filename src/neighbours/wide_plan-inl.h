// Programs of rows that the compiler knows, whose sums stay in registers. Included once for every instruction
// set.
#if defined(STURNUS_WIDE_PLAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_PLAN_INL_H
#undef STURNUS_WIDE_PLAN_INL_H
#else
#define STURNUS_WIDE_PLAN_INL_H
#endif

#include "neighbours/wide_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// A program whose rows are known to the compiler, so that its sums stay in registers; row r belongs to filter
// min(r, filters - 1).
template <int filter_count, bool with_options, WideAddend... list>
struct Plan {
  static constexpr std::size_t rows = sizeof...(list);
  static constexpr WideAddend addends[rows] = {list...};
  static constexpr int filters = filter_count;
  static_assert(filters <= 3 && rows <= 4 && filters <= rows, "what walks a plan is written out for so many");
  static constexpr bool has_options = with_options;
  static constexpr int filter_of(int row) { return row < filters ? row : filters - 1; }
  /// Numbers in the sum of a row.
  template <int D>
  static constexpr std::size_t components(std::size_t row) {
    return addends[row] == WideAddend::colour ? 3 : D;
  }
  /// Whether a row of the filter fades with distance.
  template <int f>
  static constexpr bool fades_in() {
    for (std::size_t r = 0; r < rows; ++r)
      if (filter_of(static_cast<int>(r)) == f && addends[r] == WideAddend::fades) return true;
    return false;
  }
  /// Whether a boid that passes the filter for itself, as all do, adds nothing but its count.
  template <int f>
  static constexpr bool adds_nothing_to_itself() {
    for (std::size_t r = 0; r < rows; ++r) {
      const bool pushes = addends[r] == WideAddend::fades || addends[r] == WideAddend::constant;
      if (filter_of(static_cast<int>(r)) == f && !pushes) return false;
    }
    return !has_options;
  }
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

// Here and below each row is written out, for the sake of registers.
template <class ThePlan, int f, int r, int D>
HWY_INLINE void AddRow(const Boids& boids, const Seen<D>& seen, Lanes_mask mask, std::size_t candidate,
                       Running<ThePlan>& running, Wholes<ThePlan>* wholes) {
  if constexpr (r < ThePlan::rows && ThePlan::filter_of(r) == f) {
    if (ThePlan::addends[r] == WideAddend::fades && wholes != nullptr) {
      AddFading<D>(wholes->sum[r], mask, seen);
    } else {
      AddTo<D>(running.part[r], ThePlan::addends[r], mask, seen, boids, candidate);
    }
  }
}

// What a candidate adds to the rows of a filter, for the lanes that look at it.
template <class ThePlan, int f, int D>
HWY_INLINE void AddRows(const Boids& boids, const Seen<D>& seen, Lanes_mask mask, std::size_t candidate,
                        Running<ThePlan>& running, Wholes<ThePlan>* wholes) {
  running.count[f] = CountWhere(mask, running.count[f]);
  AddRow<ThePlan, f, 0>(boids, seen, mask, candidate, running, wholes);
  AddRow<ThePlan, f, 1>(boids, seen, mask, candidate, running, wholes);
  AddRow<ThePlan, f, 2>(boids, seen, mask, candidate, running, wholes);
  AddRow<ThePlan, f, 3>(boids, seen, mask, candidate, running, wholes);
}

// The sums of a filter's rows, from one place to another.
template <int D, class ThePlan, int f, int r>
HWY_INLINE void CopyRow(const Running<ThePlan>& from, const Wholes<ThePlan>* from_wholes,
                        Running<ThePlan>& to, Wholes<ThePlan>* to_wholes) {
  if constexpr (r < ThePlan::rows && ThePlan::filter_of(r) == f) {
    for (std::size_t axis = 0; axis < ThePlan::template components<D>(r); ++axis) {
      to.part[r][axis] = from.part[r][axis];
      if (ThePlan::addends[r] == WideAddend::fades && to_wholes != nullptr)
        to_wholes->sum[r][axis] = from_wholes->sum[r][axis];
    }
  }
}

template <int D, class ThePlan, int f>
HWY_INLINE void CopyRows(const Running<ThePlan>& from, const Wholes<ThePlan>* from_wholes,
                         Running<ThePlan>& to, Wholes<ThePlan>* to_wholes) {
  to.count[f] = from.count[f];
  CopyRow<D, ThePlan, f, 0>(from, from_wholes, to, to_wholes);
  CopyRow<D, ThePlan, f, 1>(from, from_wholes, to, to_wholes);
  CopyRow<D, ThePlan, f, 2>(from, from_wholes, to, to_wholes);
  CopyRow<D, ThePlan, f, 3>(from, from_wholes, to, to_wholes);
}

template <int D, class ThePlan, int r>
HWY_INLINE void ClearRow(const WideBatch& batch, Running<ThePlan>& running) {
  const Floats d;
  if constexpr (r < ThePlan::filters) {
    // Who is his own candidate, and adds nothing, is counted all the same.
    const bool counts_itself = ThePlan::template adds_nothing_to_itself<r>() &&
                               batch.program->filters[batch.filter + r].outer_squared > 0;
    running.count[r] = hn::Set(hn::RebindToSigned<Floats>(), counts_itself ? -1 : 0);
  }
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < ThePlan::template components<D>(r); ++axis)
      running.part[r][axis] = hn::Zero(d);
  }
}

template <int D, class ThePlan>
HWY_INLINE void Clear(const WideBatch& batch, Running<ThePlan>& running) {
  ClearRow<D, ThePlan, 0>(batch, running);
  ClearRow<D, ThePlan, 1>(batch, running);
  ClearRow<D, ThePlan, 2>(batch, running);
  ClearRow<D, ThePlan, 3>(batch, running);
}

template <int D, class ThePlan, int r>
HWY_INLINE void ClearWhole(Wholes<ThePlan>& wholes) {
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < ThePlan::template components<D>(r); ++axis)
      wholes.sum[r][axis] = ZeroDoubled();
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
    for (std::size_t axis = 0; axis < ThePlan::template components<D>(r); ++axis) {
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
HWY_INLINE void StoreRowOf(const WideBatch& batch, std::size_t first, Lanes_mask steered,
                           const Running<ThePlan>& running, const Wholes<ThePlan>* wholes) {
  if constexpr (r < ThePlan::rows) {
    Lanes value[3];
    for (std::size_t axis = 0; axis < ThePlan::template components<D>(r); ++axis)
      value[axis] = wholes == nullptr ? running.part[r][axis] : Rounded(wholes->sum[r][axis]);
    for (std::size_t axis = ThePlan::template components<D>(r); axis < 3; ++axis)
      value[axis] = hn::Zero(Floats());
    StoreRow(batch, first, batch.program->rows[batch.row + r].row, steered, value,
             running.count[ThePlan::filter_of(r)]);
  }
}

template <int D, class ThePlan>
HWY_INLINE void Store(const WideBatch& batch, std::size_t first, const Running<ThePlan>& running,
                      const Wholes<ThePlan>* wholes) {
  const Lanes_mask steered = Steered(batch, first);
  StoreRowOf<D, ThePlan, 0>(batch, first, steered, running, wholes);
  StoreRowOf<D, ThePlan, 1>(batch, first, steered, running, wholes);
  StoreRowOf<D, ThePlan, 2>(batch, first, steered, running, wholes);
  StoreRowOf<D, ThePlan, 3>(batch, first, steered, running, wholes);
  StoreEmpty(batch, first, steered);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
