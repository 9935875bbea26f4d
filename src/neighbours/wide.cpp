// The wide kernel, compiled once for every instruction set that the compiler knows; Highway picks one at run
// time.
#include "neighbours/wide.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbours/wide.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, batch_size>;
using Lanes = hn::Vec<Floats>;
using Lanes_mask = hn::Mask<Floats>;
constexpr std::size_t width = hn::MaxLanes(Floats());

// What lies in the lanes: the boids that are steered.
template <int D>
struct Targets {
  Lanes position[3], velocity[3];
  Lanes speed;
  Lanes active;  // 0 where a lane steers nobody
};

// A register of floats as doubles.
#if HWY_TARGET == HWY_SCALAR
struct Doubled {
  double value;
};
HWY_INLINE Doubled LoadDoubled(const double* from) {
  return {*from};
}
HWY_INLINE void StoreDoubled(const Doubled& sum, double* to) {
  *to = sum.value;
}
HWY_INLINE void AddDoubled(Doubled& sum, Lanes values) {
  sum.value += static_cast<double>(hn::GetLane(values));
}
#else
using Doubles = hn::Repartition<double, Floats>;
using HalfFloats = hn::Half<Floats>;
struct Doubled {
  hn::Vec<Doubles> low, high;
};

HWY_INLINE Doubled LoadDoubled(const double* from) {
  const Doubles d;
  return {hn::LoadU(d, from), hn::LoadU(d, from + width / 2)};
}

HWY_INLINE void StoreDoubled(const Doubled& sum, double* to) {
  const Doubles d;
  hn::StoreU(sum.low, d, to);
  hn::StoreU(sum.high, d, to + width / 2);
}

HWY_INLINE void AddDoubled(Doubled& sum, Lanes values) {
  const Doubles d;
  const HalfFloats half;
  sum.low = hn::Add(sum.low, hn::PromoteTo(d, hn::LowerHalf(half, values)));
  sum.high = hn::Add(sum.high, hn::PromoteTo(d, hn::UpperHalf(half, values)));
}
#endif

// The sums of one register's lanes: float parts that are folded into doubles.
template <int D>
struct Sums {
  Lanes part[WideProgram::most][3];
  Lanes count[WideProgram::most];  // of each filter
  double whole[WideProgram::most][3][width];
};

// One candidate as all lanes see it.
template <int D>
struct Seen {
  Lanes offset[3];
  Lanes distance_squared;
};

template <int D, bool wraps>
HWY_INLINE Seen<D> Look(const Targets<D>& targets, const WideBatch& batch, std::size_t candidate) {
  const Floats d;
  Seen<D> seen;
  for (std::size_t axis = 0; axis < D; ++axis) {
    Lanes o = hn::Sub(hn::Set(d, batch.boids->position[axis][candidate]), targets.position[axis]);
    if (wraps) {
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

template <int D>
HWY_INLINE Lanes_mask Passes(const WideFilter& filter, const Targets<D>& targets, const Seen<D>& seen) {
  const Floats d;
  auto mask = hn::Lt(seen.distance_squared, hn::Set(d, filter.outer_squared));
  if (filter.inner_squared > 0)
    mask = hn::And(mask, hn::Ge(seen.distance_squared, hn::Set(d, filter.inner_squared)));
  if (!filter.sees_all) {
    Lanes along = hn::Mul(targets.velocity[0], seen.offset[0]);
    for (std::size_t axis = 1; axis < D; ++axis)
      along = hn::Add(along, hn::Mul(targets.velocity[axis], seen.offset[axis]));
    const Lanes least =
        hn::Mul(hn::Mul(hn::Set(d, filter.cos_half_view), targets.speed), hn::Sqrt(seen.distance_squared));
    mask = hn::And(mask, hn::Ge(along, least));
  }
  return mask;
}

template <int D>
HWY_INLINE void Accumulate(Lanes* part, Lanes_mask mask, const Lanes* values) {
  for (std::size_t axis = 0; axis < D; ++axis)
    part[axis] = hn::Add(part[axis], hn::IfThenElseZero(mask, values[axis]));
}

template <int D>
HWY_INLINE void AddColumns(Lanes* part, Lanes_mask mask, const std::array<const float*, 3>& columns,
                           std::size_t candidate) {
  const Floats d;
  for (std::size_t axis = 0; axis < D; ++axis)
    part[axis] = hn::Add(part[axis], hn::IfThenElseZero(mask, hn::Set(d, columns[axis][candidate])));
}

// Coincident boids feel no direction: the plain kernel's rule, with its least distance.
template <int D>
HWY_INLINE void Push(Lanes_mask mask, const Seen<D>& seen, bool fades, Lanes* values) {
  const Floats d;
  const Lanes least = hn::Set(d, std::numeric_limits<float>::min());
  mask = hn::And(mask, hn::Ge(seen.distance_squared, least));
  const Lanes scale =
      hn::Div(hn::Set(d, 1.0f), fades ? seen.distance_squared : hn::Sqrt(seen.distance_squared));
  for (std::size_t axis = 0; axis < D; ++axis)
    values[axis] = hn::IfThenElseZero(mask, hn::Mul(seen.offset[axis], scale));
}

// What fades with distance goes into the doubles at once: see `candidates_in_float`.
template <int D>
HWY_INLINE void AddFading(Doubled* whole, Lanes_mask mask, const Seen<D>& seen) {
  Lanes values[3];
  Push<D>(mask, seen, true, values);
  for (std::size_t axis = 0; axis < D; ++axis) AddDoubled(whole[axis], values[axis]);
}

template <int D>
HWY_INLINE void AddConstant(Lanes* part, Lanes_mask mask, const Seen<D>& seen) {
  Lanes values[3];
  Push<D>(mask, seen, false, values);
  for (std::size_t axis = 0; axis < D; ++axis) part[axis] = hn::Add(part[axis], values[axis]);
}

template <int D>
HWY_INLINE void AddTo(Lanes* part, WideAddend addend, Lanes_mask mask, const Seen<D>& seen,
                      const Boids& boids, std::size_t candidate) {
  switch (addend) {
    case WideAddend::fades:
      return;  // by AddFading
    case WideAddend::constant:
      return AddConstant<D>(part, mask, seen);
    case WideAddend::grows:
      return Accumulate<D>(part, mask, seen.offset);
    case WideAddend::velocity:
      return AddColumns<D>(part, mask, boids.velocity, candidate);
    case WideAddend::heading:
      return AddColumns<D>(part, mask, boids.heading, candidate);
    case WideAddend::colour:
      return AddColumns<3>(part, mask, boids.colour, candidate);
  }
}

// A program whose rows are known to the compiler, so that its sums stay in registers: three rows whose
// filters have no inner radius, see all round and look at everybody. `filter_of` row by row.
template <WideAddend first, WideAddend second, WideAddend third, int filter_count>
struct Plan {
  static constexpr WideAddend addends[3] = {first, second, third};
  static constexpr int filters = filter_count;
  static constexpr int filter_of(int row) { return row < filters ? row : filters - 1; }
};

template <int D, bool with_self>
HWY_INLINE Lanes_mask NotSelf(Lanes_mask mask, std::size_t candidate, std::size_t first) {
  if (!with_self) return mask;
  const Floats d;
  const float own = static_cast<float>(static_cast<std::int64_t>(candidate - first));
  return hn::And(mask, hn::Ne(hn::Iota(d, 0.0f), hn::Set(d, own)));
}

// One filter of a plan, written out for each: a loop here would keep its arrays in memory.
template <int D, bool with_self, class ThePlan, int f>
HWY_INLINE void Pass(const Seen<D>& seen, const Lanes* outer, std::size_t candidate, std::size_t first,
                     Lanes_mask* masks, Lanes* count) {
  if constexpr (f < ThePlan::filters) {
    const Floats d;
    masks[f] = NotSelf<D, with_self>(hn::Lt(seen.distance_squared, outer[f]), candidate, first);
    count[f] = hn::Add(count[f], hn::IfThenElseZero(masks[f], hn::Set(d, 1.0f)));
  }
}

template <int D, class ThePlan, int r>
HWY_INLINE void AddRow(const Seen<D>& seen, const Lanes_mask* masks, const Boids& boids,
                       std::size_t candidate, Lanes* part, Doubled* whole) {
  const Lanes_mask mask = masks[ThePlan::filter_of(r)];
  if constexpr (ThePlan::addends[r] == WideAddend::fades) {
    AddFading<D>(whole, mask, seen);
  } else {
    AddTo<D>(part, ThePlan::addends[r], mask, seen, boids, candidate);
  }
}

// Candidates [begin, end). `first` is the slot in lane 0 where the targets themselves are among them, so that
// nobody is his own neighbour.
template <int D, bool wraps, bool with_self, class ThePlan>
HWY_INLINE void WalkPlan(const WideBatch& batch, const Targets<D>& targets, std::size_t begin,
                         std::size_t end, std::size_t first, Sums<D>& sums) {
  const Floats d;
  const Boids boids = *batch.boids;
  Lanes outer[ThePlan::filters], count[ThePlan::filters], part[3][D];
  for (int f = 0; f < ThePlan::filters; ++f) {
    outer[f] = hn::Set(d, batch.program->filters[static_cast<std::size_t>(f)].outer_squared);
    count[f] = sums.count[f];
  }
  Doubled whole[3][D];
  for (int r = 0; r < 3; ++r) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      part[r][axis] = sums.part[r][axis];
      whole[r][axis] = LoadDoubled(sums.whole[r][axis]);
    }
  }
  for (std::size_t candidate = begin; candidate < end; ++candidate) {
    const Seen<D> seen = Look<D, wraps>(targets, batch, candidate);
    Lanes_mask masks[ThePlan::filters];
    Pass<D, with_self, ThePlan, 0>(seen, outer, candidate, first, masks, count);
    Pass<D, with_self, ThePlan, 1>(seen, outer, candidate, first, masks, count);
    Pass<D, with_self, ThePlan, 2>(seen, outer, candidate, first, masks, count);
    AddRow<D, ThePlan, 0>(seen, masks, boids, candidate, part[0], whole[0]);
    AddRow<D, ThePlan, 1>(seen, masks, boids, candidate, part[1], whole[1]);
    AddRow<D, ThePlan, 2>(seen, masks, boids, candidate, part[2], whole[2]);
  }
  for (int f = 0; f < ThePlan::filters; ++f) sums.count[f] = count[f];
  for (int r = 0; r < 3; ++r) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      sums.part[r][axis] = part[r][axis];
      if (ThePlan::addends[r] == WideAddend::fades) StoreDoubled(whole[r][axis], sums.whole[r][axis]);
    }
  }
}

// The same for any program.
struct AnyPlan {};

template <int D, bool wraps, bool with_self>
HWY_INLINE void WalkAny(const WideBatch& batch, const Targets<D>& targets, std::size_t begin, std::size_t end,
                        std::size_t first, Sums<D>& sums) {
  const Floats d;
  const WideProgram& program = *batch.program;
  const Lanes one = hn::Set(d, 1.0f);
  for (std::size_t candidate = begin; candidate < end; ++candidate) {
    const Seen<D> seen = Look<D, wraps>(targets, batch, candidate);
    Lanes_mask masks[WideProgram::most];
    for (std::size_t f = 0; f < program.filters.size(); ++f) {
      const WideFilter& filter = program.filters[f];
      masks[f] = Passes<D>(filter, targets, seen);
      if (batch.checked == 0 || (batch.checked & ~filter.flocks) != 0) {
        const bool is_looked_at = (batch.boids->flock_bit[candidate] & filter.flocks) != 0;
        masks[f] = hn::And(masks[f], hn::Gt(hn::Set(d, is_looked_at ? 1.0f : 0.0f), hn::Zero(d)));
      }
      masks[f] = NotSelf<D, with_self>(masks[f], candidate, first);
      sums.count[f] = hn::Add(sums.count[f], hn::IfThenElseZero(masks[f], one));
    }
    for (std::size_t r = 0; r < program.rows.size(); ++r) {
      const WideRow& row = program.rows[r];
      if (row.addend == WideAddend::fades) {
        Doubled whole[D];
        for (std::size_t axis = 0; axis < D; ++axis) whole[axis] = LoadDoubled(sums.whole[r][axis]);
        AddFading<D>(whole, masks[row.filter], seen);
        for (std::size_t axis = 0; axis < D; ++axis) StoreDoubled(whole[axis], sums.whole[r][axis]);
      } else {
        AddTo<D>(sums.part[r], row.addend, masks[row.filter], seen, *batch.boids, candidate);
      }
    }
  }
}

template <int D, bool wraps, bool with_self, class ThePlan>
HWY_INLINE void Walk(const WideBatch& batch, const Targets<D>& targets, std::size_t begin, std::size_t end,
                     std::size_t first, Sums<D>& sums) {
  if constexpr (std::is_same_v<ThePlan, AnyPlan>) {
    WalkAny<D, wraps, with_self>(batch, targets, begin, end, first, sums);
  } else {
    WalkPlan<D, wraps, with_self, ThePlan>(batch, targets, begin, end, first, sums);
  }
}

template <int D>
HWY_INLINE void Fold(std::size_t rows, Sums<D>& sums) {
  const Floats d;
  HWY_ALIGN float part[width];
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hn::Store(sums.part[r][axis], d, part);
      for (std::size_t i = 0; i < width; ++i) sums.whole[r][axis][i] += static_cast<double>(part[i]);
      sums.part[r][axis] = hn::Zero(d);
    }
  }
}

// All candidates in their order, cut where sums are folded and where the targets themselves stand.
template <int D, bool wraps, class ThePlan>
HWY_INLINE void WalkAll(const WideBatch& batch, const Targets<D>& targets, std::size_t first, Sums<D>& sums) {
  std::uint32_t left = candidates_in_float;
  const std::size_t rows = batch.program->rows.size();
  for (const Span span : batch.spans) {
    for (std::size_t at = span.begin; at < span.end;) {
      const bool is_self = at >= first && at < first + width;
      std::size_t end = std::min<std::size_t>(span.end, at + left);
      if (at < first) end = std::min(end, first);
      if (is_self) end = std::min(end, first + width);
      if (is_self) {
        Walk<D, wraps, true, ThePlan>(batch, targets, at, end, first, sums);
      } else {
        Walk<D, wraps, false, ThePlan>(batch, targets, at, end, first, sums);
      }
      left -= static_cast<std::uint32_t>(end - at);
      at = end;
      if (left == 0) {
        Fold<D>(rows, sums);
        left = candidates_in_float;
      }
    }
  }
  Fold<D>(rows, sums);
}

template <int D>
HWY_INLINE Targets<D> Load(const WideBatch& batch, std::size_t first) {
  const Floats d;
  Targets<D> targets;
  HWY_ALIGN float values[width];
  const std::size_t count = std::min<std::size_t>(width, batch.targets.end - first);
  const auto load = [&](const float* column) HWY_ATTR {
    for (std::size_t i = 0; i < width; ++i) values[i] = column[first + std::min(i, count - 1)];
    return hn::Load(d, values);
  };
  for (std::size_t axis = 0; axis < D; ++axis) {
    targets.position[axis] = load(batch.boids->position[axis]);
    targets.velocity[axis] = load(batch.boids->velocity[axis]);
  }
  Lanes squared = hn::Mul(targets.velocity[0], targets.velocity[0]);
  for (std::size_t axis = 1; axis < D; ++axis)
    squared = hn::Add(squared, hn::Mul(targets.velocity[axis], targets.velocity[axis]));
  targets.speed = hn::Sqrt(squared);
  return targets;
}

template <int D>
HWY_INLINE void StoreSums(const WideBatch& batch, std::size_t first, const Sums<D>& sums) {
  const Floats d;
  HWY_ALIGN float counts[WideProgram::most][width];
  for (std::size_t f = 0; f < batch.program->filters.size(); ++f) hn::Store(sums.count[f], d, counts[f]);
  const std::size_t count = std::min<std::size_t>(width, batch.targets.end - first);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t slot = first + i;
    if (batch.boids->flock[slot] != batch.flock || batch.boids->flock_bit[slot] == 0) continue;
    NeighbourSum* own = batch.sums + slot * batch.most_rows;
    for (std::size_t r = 0; r < batch.program->rows.size(); ++r) {
      const WideRow& row = batch.program->rows[r];
      for (std::size_t axis = 0; axis < 3; ++axis)
        own[row.row].value[axis] = static_cast<float>(sums.whole[r][axis][i]);
      own[row.row].count = static_cast<std::uint32_t>(counts[row.filter][i]);
    }
  }
}

template <int D, class ThePlan>
HWY_NOINLINE void SumBatchBy(const WideBatch& batch) {
  const Floats d;
  for (std::size_t first = batch.targets.begin; first < batch.targets.end; first += width) {
    const Targets<D> targets = Load<D>(batch, first);
    Sums<D> sums;
    for (std::size_t r = 0; r < batch.program->rows.size(); ++r) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sums.part[r][axis] = hn::Zero(d);
        for (std::size_t i = 0; i < width; ++i) sums.whole[r][axis][i] = 0;
      }
    }
    for (std::size_t f = 0; f < batch.program->filters.size(); ++f) sums.count[f] = hn::Zero(d);
    if (batch.image.wraps) {
      WalkAll<D, true, ThePlan>(batch, targets, first, sums);
    } else {
      WalkAll<D, false, ThePlan>(batch, targets, first, sums);
    }
    StoreSums<D>(batch, first, sums);
  }
}

// Whether a program is what a plan says.
template <class ThePlan>
bool Fits(const WideProgram& program) {
  if (program.rows.size() != 3 || program.filters.size() != static_cast<std::size_t>(ThePlan::filters))
    return false;
  for (int r = 0; r < 3; ++r) {
    const WideRow& row = program.rows[static_cast<std::size_t>(r)];
    if (row.addend != ThePlan::addends[r] || row.filter != ThePlan::filter_of(r)) return false;
  }
  return true;
}

bool AreSimple(const WideBatch& batch) {
  for (const WideFilter& filter : batch.program->filters) {
    if (filter.inner_squared > 0 || !filter.sees_all) return false;
    if (batch.checked == 0 || (batch.checked & ~filter.flocks) != 0) return false;
  }
  return true;
}

template <int D>
void SumBatch(const WideBatch& batch) {
  using enum WideAddend;
  const WideProgram& program = *batch.program;
  if (AreSimple(batch)) {
    if (Fits<Plan<fades, velocity, grows, 2>>(program))
      return SumBatchBy<D, Plan<fades, velocity, grows, 2>>(batch);
    if (Fits<Plan<fades, velocity, grows, 3>>(program))
      return SumBatchBy<D, Plan<fades, velocity, grows, 3>>(batch);
    if (Fits<Plan<fades, velocity, grows, 1>>(program))
      return SumBatchBy<D, Plan<fades, velocity, grows, 1>>(batch);
    if (Fits<Plan<grows, velocity, grows, 2>>(program))
      return SumBatchBy<D, Plan<grows, velocity, grows, 2>>(batch);
  }
  SumBatchBy<D, AnyPlan>(batch);
}

void SumBatch2(const WideBatch& batch) {
  SumBatch<2>(batch);
}
void SumBatch3(const WideBatch& batch) {
  SumBatch<3>(batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sturnus {

HWY_EXPORT(SumBatch2);
HWY_EXPORT(SumBatch3);

template <>
void wide_sums<2>(const WideBatch& batch) {
  HWY_DYNAMIC_DISPATCH(SumBatch2)(batch);
}
template <>
void wide_sums<3>(const WideBatch& batch) {
  HWY_DYNAMIC_DISPATCH(SumBatch3)(batch);
}

}  // namespace sturnus
#endif
