// sturnus-parts: the parts of a run under Google Benchmark, through the public interface.
#include <benchmark/benchmark.h>
#include <sturnus/isa.h>
#include <sturnus/watch.h>

#include <utility>
#include <vector>

#include "clock.h"
#include "flocks.h"

namespace bench {
namespace {

void count_boids(benchmark::State& state, std::int64_t boids) {
  state.SetItemsProcessed(state.iterations() * boids);
}

// Arguments: dimensions, boids, instruction set.
void whole_step(benchmark::State& state) {
  sturnus::use_isa(static_cast<sturnus::Isa>(state.range(2)));
  auto simulation = opened(base_case(static_cast<int>(state.range(0)), state.range(1)));
  simulation.step();
  for (auto _ : state) simulation.step();
  state.SetLabel(sturnus::isa_in_use());
  count_boids(state, state.range(1));
  sturnus::use_isa(sturnus::Isa::best);
}

// Adds up what one phase of the steps takes on the one thread.
class OnePhase : public sturnus::StepWatch {
 public:
  explicit OnePhase(sturnus::Phase phase) : phase_(phase) {}
  void begin(sturnus::Phase phase, int) override {
    if (phase == phase_) begun_ = cpu_seconds();
  }
  void end(sturnus::Phase phase, int) override {
    if (phase == phase_) seconds_ += cpu_seconds() - begun_;
  }
  double take() { return std::exchange(seconds_, 0); }

 private:
  sturnus::Phase phase_;
  double begun_ = 0, seconds_ = 0;
};

// Arguments: dimensions, boids.
void phase_of_step(benchmark::State& state, sturnus::Phase phase) {
  auto simulation = opened(base_case(static_cast<int>(state.range(0)), state.range(1)));
  simulation.step();
  OnePhase watch(phase);
  simulation.watch(&watch);
  for (auto _ : state) {
    simulation.step();
    state.SetIterationTime(watch.take());
  }
  count_boids(state, state.range(1));
}

void hash(benchmark::State& state) {
  const auto simulation = opened(base_case(static_cast<int>(state.range(0)), state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(simulation.hash());
  count_boids(state, state.range(1));
}

void spawn(benchmark::State& state) {
  const auto def = base_case(static_cast<int>(state.range(0)), state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(opened(def).view().size());
  count_boids(state, state.range(1));
}

void snapshot_and_restore(benchmark::State& state) {
  auto simulation = opened(base_case(static_cast<int>(state.range(0)), state.range(1)));
  for (auto _ : state) simulation.restore(simulation.snapshot());
  count_boids(state, state.range(1));
}

void load(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(scenario("quadtree", 1000).flocks.size());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"dimensions", "boids"})->Unit(benchmark::kMicrosecond);
  for (const int dimensions : {2, 3}) {
    for (const int boids : {1000, 10'000, 100'000}) benchmark->Args({dimensions, boids});
  }
}

// Those that the machine has.
std::vector<sturnus::Isa> instruction_sets_here() {
  using sturnus::Isa;
  std::vector<Isa> out;
  for (const Isa isa : {Isa::plain, Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon}) {
    if (sturnus::use_isa(isa)) out.push_back(isa);
  }
  sturnus::use_isa(Isa::best);
  return out;
}

void instruction_sets(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"dimensions", "boids", "isa"})->Unit(benchmark::kMicrosecond);
  for (const int dimensions : {2, 3}) {
    for (const int boids : {1000, 10'000, 100'000}) {
      for (const sturnus::Isa isa : instruction_sets_here()) {
        benchmark->Args({dimensions, boids, static_cast<int>(isa)});
      }
    }
  }
}

BENCHMARK(whole_step)->Apply(instruction_sets);
BENCHMARK_CAPTURE(phase_of_step, sort, sturnus::Phase::sort)->Apply(sizes)->UseManualTime();
BENCHMARK_CAPTURE(phase_of_step, neighbours, sturnus::Phase::neighbours)->Apply(sizes)->UseManualTime();
BENCHMARK_CAPTURE(phase_of_step, motion, sturnus::Phase::motion)->Apply(sizes)->UseManualTime();
BENCHMARK(hash)->Apply(sizes);
BENCHMARK(spawn)->Apply(sizes);
BENCHMARK(snapshot_and_restore)->Apply(sizes);
BENCHMARK(load)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bench

BENCHMARK_MAIN();
