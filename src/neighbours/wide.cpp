// The wide kernel, compiled once for every instruction set that the compiler knows; Highway picks one at run
// time.
#include "neighbours/wide.h"

#include <algorithm>
#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbours/wide.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "neighbours/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// What lies in the lanes: the boids that are steered.
template <int D>
struct Targets {
  Lanes position[3], velocity[3];
  Lanes speed;
  std::size_t first = 0;  ///< slot in lane 0
};

// One candidate as all lanes see it.
template <int D>
struct Seen {
  Lanes offset[3];
  Lanes distance_squared;
};

// Where the space wraps: the nearest image by comparison, as the plain kernel finds it; or by one
// subtraction, where the span says over which end its boids are seen. For all who are near both give the same
// bits.
enum class Wraps { no, by_span, by_comparison };

template <int D, Wraps wraps>
HWY_INLINE Seen<D> Look(const Targets<D>& targets, const WideBatch& batch, const Lanes* shift,
                        std::size_t candidate) {
  const Floats d;
  Seen<D> seen;
  for (std::size_t axis = 0; axis < D; ++axis) {
    Lanes o = hn::Sub(hn::Set(d, batch.boids->position[axis][candidate]), targets.position[axis]);
    if (wraps == Wraps::by_span) o = hn::Sub(o, shift[axis]);
    if (wraps == Wraps::by_comparison) {
      const Lanes half = hn::Set(d, batch.image.half[axis]);
      const Lanes size = hn::Set(d, batch.image.size[axis]);
      const auto above = hn::Gt(o, half);
      const auto below = hn::Lt(o, hn::Neg(half));
      o = hn::IfThenElse(above, hn::Sub(o, size), hn::IfThenElse(below, hn::Add(o, size), o));
    }
    seen.offset[axis] = o;
  }
  seen.distance_squared = hn::Mul(seen.offset[0], seen.offset[0]);
  for (std::size_t axis = 1; axis < D; ++axis)
    seen.distance_squared = hn::Add(seen.distance_squared, hn::Mul(seen.offset[axis], seen.offset[axis]));
  return seen;
}

// The filters of a batch, lane by lane where flocks stand mixed.
struct Filters {
  std::size_t count = 0;
  bool has_rings = false, has_views = false, asks_flocks = false;
  HWY_ALIGN float outer[WideProgram::most][width];
  HWY_ALIGN float inner[WideProgram::most][width];
  HWY_ALIGN float cosine[WideProgram::most][width];  ///< -infinity: sees all round
  /// 1 where the lane looks at a flock; the last is for the hidden.
  HWY_ALIGN float looks[WideProgram::most][65][width];
};

HWY_INLINE void FillFilter(const WideBatch& batch, std::size_t first, std::size_t f, Filters& filters) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (std::size_t lane = 0; lane < width; ++lane) {
    const std::size_t slot = std::min<std::size_t>(first + lane, batch.targets.end - 1);
    const WideProgram& program = batch.programs[batch.boids->flock[slot]];
    const WideFilter& filter = program.filters[f];
    filters.outer[f][lane] = filter.outer_squared;
    filters.inner[f][lane] = filter.inner_squared;
    filters.cosine[f][lane] = filter.sees_all ? -infinity : filter.cos_half_view;
    filters.has_rings |= filter.inner_squared > 0;
    filters.has_views |= !filter.sees_all;
    const bool steered = (batch.boids->flock_bit(slot) & batch.steered) != 0;
    filters.asks_flocks |=
        batch.boids->hidden != nullptr || (steered && (batch.boids->flocks & ~filter.flocks) != 0);
    for (std::uint64_t left = batch.boids->flocks; left != 0; left &= left - 1) {
      const auto flock = static_cast<std::size_t>(std::countr_zero(left));
      filters.looks[f][flock][lane] = (filter.flocks >> flock & 1) != 0 ? 1.0f : 0.0f;
    }
    filters.looks[f][64][lane] = 0;
  }
}

HWY_INLINE void FillFilters(const WideBatch& batch, std::size_t first, Filters& filters) {
  const auto flock = static_cast<std::size_t>(std::countr_zero(batch.steered));
  filters.count = batch.programs[flock].filter_count;
  filters.has_rings = filters.has_views = filters.asks_flocks = false;
  for (std::size_t f = 0; f < filters.count; ++f) FillFilter(batch, first, f, filters);
}

template <int D>
HWY_INLINE Lanes_mask Passes(const Filters& filters, std::size_t f, const Targets<D>& targets,
                             const Seen<D>& seen, const Boids& boids, std::size_t candidate) {
  const Floats d;
  auto mask = hn::Lt(seen.distance_squared, hn::Load(d, filters.outer[f]));
  if (filters.has_rings) mask = hn::And(mask, hn::Ge(seen.distance_squared, hn::Load(d, filters.inner[f])));
  if (filters.has_views) {
    Lanes along = hn::Mul(targets.velocity[0], seen.offset[0]);
    for (std::size_t axis = 1; axis < D; ++axis)
      along = hn::Add(along, hn::Mul(targets.velocity[axis], seen.offset[axis]));
    const Lanes cosine = hn::Load(d, filters.cosine[f]);
    const Lanes least = hn::Mul(hn::Mul(cosine, targets.speed), hn::Sqrt(seen.distance_squared));
    const auto sees_all = hn::Lt(cosine, hn::Set(d, -2.0f));
    mask = hn::And(mask, hn::Or(hn::Ge(along, least), sees_all));
  }
  if (filters.asks_flocks) {
    const std::size_t flock = boids.is_hidden(candidate) ? 64 : boids.flock[candidate];
    mask = hn::And(mask, hn::Gt(hn::Load(d, filters.looks[f][flock]), hn::Zero(d)));
  }
  return mask;
}

// As in the plain kernel: near boids push no harder than at the least distance, coincident ones not at all.
template <int D>
HWY_INLINE void Push(const Seen<D>& seen, bool fades, Lanes* values) {
  const Floats d;
  const Lanes least = hn::Set(d, std::numeric_limits<float>::min());
  const Lanes squared = hn::Max(seen.distance_squared, least);
  const Lanes scale = hn::Div(hn::Set(d, 1.0f), fades ? squared : hn::Sqrt(squared));
  for (std::size_t axis = 0; axis < D; ++axis) values[axis] = hn::Mul(seen.offset[axis], scale);
}

template <int D>
HWY_INLINE void AddPush(Lanes* part, Lanes_mask mask, const Seen<D>& seen, bool fades) {
  Lanes values[3];
  Push<D>(seen, fades, values);
  for (std::size_t axis = 0; axis < D; ++axis) part[axis] = AddWhere(mask, part[axis], values[axis]);
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
        part[axis] = AddFinite(mask, part[axis], seen.offset[axis]);
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
    AddDoubled(whole[axis], hn::IfThenElseZero(mask, values[axis]));
}

// The sums of one register's lanes, by row and filter of the program.
struct Sums {
  Lanes value[WideProgram::most][3];
  Counts count[WideProgram::most];
};

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

// Whoever is his own candidate is left out.
template <bool with_self>
HWY_INLINE Lanes_mask NotSelf(Lanes_mask mask, std::size_t candidate, std::size_t first) {
  if (!with_self) return mask;
  const Floats d;
  const float own = static_cast<float>(static_cast<std::int64_t>(candidate - first));
  return hn::And(mask, hn::Ne(hn::Iota(d, 0.0f), hn::Set(d, own)));
}

template <int D>
HWY_INLINE Targets<D> Load(const WideBatch& batch, std::size_t first) {
  Targets<D> targets;
  targets.first = first;
  const std::size_t count = std::min<std::size_t>(width, batch.targets.end - first);
  for (std::size_t axis = 0; axis < D; ++axis) {
    targets.position[axis] = LoadSome(batch.boids->position[axis] + first, count);
    targets.velocity[axis] = LoadSome(batch.boids->velocity[axis] + first, count);
  }
  targets.speed = hn::Sqrt(Squared<D>(targets.velocity));
  return targets;
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
    const float size = walk.batch.image.size[axis];
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
      masks[f] = Passes<D>(walk.filters, f, walk.targets, seen, walk.boids, candidate);
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

template <int D, class ThePlan, int r>
HWY_INLINE void ClearWhole(Wholes<ThePlan>& wholes) {
  if constexpr (r < ThePlan::rows) {
    for (std::size_t axis = 0; axis < D; ++axis) wholes.sum[r][axis] = ZeroDoubled();
  }
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
HWY_INLINE void FoldAll(Running<ThePlan>& running, Wholes<ThePlan>& wholes) {
  FoldRow<D, ThePlan, 0>(running, wholes);
  FoldRow<D, ThePlan, 1>(running, wholes);
  FoldRow<D, ThePlan, 2>(running, wholes);
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
}

template <int D, Wraps wraps, class ThePlan>
HWY_INLINE void WalkFew(Walk<D, ThePlan>& walk, Sums& sums) {
  Running<ThePlan> running;
  ClearRow<D, ThePlan, 0>(running);
  ClearRow<D, ThePlan, 1>(running);
  ClearRow<D, ThePlan, 2>(running);
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
  ClearRow<D, ThePlan, 0>(running);
  ClearRow<D, ThePlan, 1>(running);
  ClearRow<D, ThePlan, 2>(running);
  ClearWhole<D, ThePlan, 0>(wholes);
  ClearWhole<D, ThePlan, 1>(wholes);
  ClearWhole<D, ThePlan, 2>(wholes);
  std::size_t left = candidates_in_float;
  for (const Span& span : walk.batch.spans) {
    if (wraps == Wraps::by_span) SetShift(span, walk);
    for (std::size_t at = span.begin; at < span.end;) {
      const std::size_t end = std::min<std::size_t>(span.end, at + left);
      WalkSpan<D, wraps, ThePlan>(walk, at, end, running, &wholes);
      left -= end - at;
      at = end;
      if (left != 0) continue;
      FoldAll<D, ThePlan>(running, wholes);
      left = candidates_in_float;
    }
  }
  FoldAll<D, ThePlan>(running, wholes);
  Finish<D, ThePlan>(running, &wholes, sums);
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

HWY_INLINE void StoreSums(const WideBatch& batch, std::size_t first, const WideProgram& program,
                          const Sums& sums) {
  const Floats d;
  const Lanes_mask steered = Steered(batch, first);
  for (std::size_t r = 0; r < program.row_count; ++r) {
    const WideRow row = program.rows[r];
    StoreRow(batch, first, row.row, steered, sums.value[r], sums.count[row.filter]);
  }
  const Lanes nothing[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::uint64_t left = program.empty_rows; left != 0; left &= left - 1)
    StoreRow(batch, first, static_cast<std::size_t>(std::countr_zero(left)), steered, nothing,
             hn::Zero(hn::RebindToSigned<Floats>()));
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
  const bool spans_tell = batch.image.wraps && SpansTell(batch.spans);
  const WideProgram& program = batch.programs[std::countr_zero(batch.steered)];
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    Filters filters;
    if constexpr (ThePlan::has_options) FillFilters(batch, first, filters);
    Walk<D, ThePlan> walk(batch, first, filters);
    for (std::size_t f = 0; f < ThePlan::filters; ++f)
      walk.outer[f] = hn::Set(d, program.filters[f].outer_squared);
    Sums sums;
    if (!batch.image.wraps) {
      WalkAll<D, Wraps::no, ThePlan>(walk, sums);
    } else if (spans_tell) {
      WalkAll<D, Wraps::by_span, ThePlan>(walk, sums);
    } else {
      WalkAll<D, Wraps::by_comparison, ThePlan>(walk, sums);
    }
    StoreSums(batch, first, program, sums);
  }
}

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
  const WideProgram& program = batch.programs[std::countr_zero(batch.steered)];
  AnySums running;
  ClearAny(running, sums);
  std::size_t seen_so_far = 0;
  for (const Span span : batch.spans) {
    for (std::size_t candidate = span.begin; candidate < span.end; ++candidate) {
      const Seen<D> seen = Look<D, wraps>(targets, batch, nullptr, candidate);
      Lanes_mask masks[WideProgram::most];
      for (std::size_t f = 0; f < program.filter_count; ++f) {
        masks[f] = Passes<D>(filters, f, targets, seen, *batch.boids, candidate);
        if (candidate - targets.first < width) masks[f] = NotSelf<true>(masks[f], candidate, targets.first);
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
  const WideProgram& program = batch.programs[std::countr_zero(batch.steered)];
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    Filters filters;
    FillFilters(batch, first, filters);
    const Targets<D> targets = Load<D>(batch, first);
    Sums sums;
    if (batch.image.wraps) {
      WalkAny<D, Wraps::by_comparison>(batch, targets, filters, sums);
    } else {
      WalkAny<D, Wraps::no>(batch, targets, filters, sums);
    }
    StoreSums(batch, first, program, sums);
  }
}

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

bool HasOptions(const WideBatch& batch, const WideProgram& program) {
  if (batch.is_mixed || batch.boids->hidden != nullptr) return true;
  for (std::size_t f = 0; f < program.filter_count; ++f) {
    const WideFilter& filter = program.filters[f];
    if (filter.inner_squared > 0 || !filter.sees_all) return true;
    if ((batch.boids->flocks & ~filter.flocks) != 0) return true;
  }
  return false;
}

template <class... Plans>
struct PlanList {
  template <int D>
  static bool Sum(const WideBatch& batch, const WideProgram& program) {
    return ((Fits<Plans>(program) && (SumBatchBy<D, Plans>(batch), true)) || ...);
  }
};

// The programs that have plans; every other one runs as any program does.
using enum WideAddend;
#ifdef STURNUS_FEW_PLANS
using SimplePlans = PlanList<Plan<2, false, fades, velocity, grows>>;
using PlansWithOptions = PlanList<Plan<2, true, grows, velocity, grows>>;
#else
using SimplePlans =
    PlanList<Plan<2, false, fades, velocity, grows>, Plan<1, false, fades, velocity, grows>,
             Plan<2, false, grows, velocity, grows>, Plan<1, false, fades>, Plan<1, false, grows>,
             Plan<1, false, velocity, grows>, Plan<1, false, velocity, grows, grows>>;
using PlansWithOptions = PlanList<Plan<2, true, fades, velocity, grows>, Plan<2, true, grows, velocity, grows>,
                                  Plan<3, true, fades, heading, fades>>;
#endif

template <int D>
void SumBatch(const WideBatch& batch) {
  const WideProgram& program = batch.programs[std::countr_zero(batch.steered)];
  const bool done = HasOptions(batch, program) ? PlansWithOptions::Sum<D>(batch, program)
                                               : SimplePlans::Sum<D>(batch, program);
  if (!done) SumBatchAny<D>(batch);
}

void SumBatch2(const WideBatch& batch) {
  SumBatch<2>(batch);
}
void SumBatch3(const WideBatch& batch) {
  SumBatch<3>(batch);
}

template <int D>
Box BoxOf(const Boids& boids, Span batch) {
  const Floats d;
  Box box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float* column = boids.position[axis];
    Lanes low = hn::Set(d, column[batch.begin]);
    Lanes high = low;
    for (std::size_t first = batch.begin; first < batch.end; first += width) {
      const Lanes at = LoadSome(column + first, std::min<std::size_t>(width, batch.end - first));
      low = hn::Min(low, at);
      high = hn::Max(high, at);
    }
    box.low[axis] = hn::GetLane(hn::MinOfLanes(d, low));
    box.high[axis] = hn::GetLane(hn::MaxOfLanes(d, high));
  }
  return box;
}

Box BoxOf2(const Boids& boids, Span batch) {
  return BoxOf<2>(boids, batch);
}
Box BoxOf3(const Boids& boids, Span batch) {
  return BoxOf<3>(boids, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sturnus {

HWY_EXPORT(SumBatch2);
HWY_EXPORT(SumBatch3);
HWY_EXPORT(BoxOf2);
HWY_EXPORT(BoxOf3);

template <>
void wide_sums<2>(const WideBatch& batch) {
  HWY_DYNAMIC_DISPATCH(SumBatch2)(batch);
}
template <>
void wide_sums<3>(const WideBatch& batch) {
  HWY_DYNAMIC_DISPATCH(SumBatch3)(batch);
}
template <>
Box wide_box<2>(const Boids& boids, Span batch) {
  return HWY_DYNAMIC_DISPATCH(BoxOf2)(boids, batch);
}
template <>
Box wide_box<3>(const Boids& boids, Span batch) {
  return HWY_DYNAMIC_DISPATCH(BoxOf3)(boids, batch);
}

}  // namespace sturnus
#endif
