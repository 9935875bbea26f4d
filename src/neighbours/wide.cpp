// The wide kernel, compiled once for every instruction set that the compiler knows; Highway picks one at run
// time.
#include "neighbours/wide.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbours/wide.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "neighbours/wide_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

bool HasOptions(const WideBatch& batch, const WideProgram& program) {
  if (batch.is_mixed || batch.boids->hidden != nullptr) return true;
  for (std::size_t f = 0; f < program.filter_count; ++f) {
    const WideFilter& filter = program.filters[f];
    if (filter.inner_squared > 0 || !filter.sees_all) return true;
    if ((batch.near & ~filter.flocks) != 0) return true;
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

// The programs that have plans of their own: those of the course systems and of the benchmarks. Every other
// one is summed row by row, which takes these up to 2.3 times as long.
using enum WideAddend;
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128  // machines without any of the others
using SimplePlans = PlanList<>;
using PlansWithOptions = PlanList<>;
#elif defined(STURNUS_FEW_PLANS)
using SimplePlans = PlanList<Plan<2, false, fades, velocity, grows>>;
using PlansWithOptions = PlanList<Plan<3, true, fades, velocity, grows>>;
#else
using SimplePlans = PlanList<Plan<2, false, fades, velocity, grows>, Plan<1, false, fades, velocity, grows>,
                             Plan<3, false, fades, velocity, grows>, Plan<2, false, grows, velocity, grows>,
                             Plan<1, false, fades>, Plan<1, false, grows>, Plan<1, false, velocity, grows>,
                             Plan<1, false, velocity, grows, grows>>;
using PlansWithOptions =
    PlanList<Plan<2, true, fades, velocity, grows>, Plan<2, true, grows, velocity, grows>,
             Plan<3, true, fades, velocity, grows>, Plan<3, true, fades, heading, fades>,
             Plan<3, true, fades, constant, velocity, grows>>;
#endif

template <int D>
void SumBatch(const WideBatch& batch) {
  const WideProgram& program = *batch.program;
  if (program.row_count == 0) return StoreNothing(batch);
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
