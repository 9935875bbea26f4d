// Steps between two looks at the clocks.
#include "bench_timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>
#include <utility>

namespace program {
namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void add(PhaseClock::Seconds& sum, const PhaseClock::Seconds& more) {
  for (std::size_t phase = 0; phase < sum.size(); ++phase) sum[phase] += more[phase];
}

double total(const PhaseClock::Seconds& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

bool warm_up(sturnus::Simulation& flock, std::uint64_t steps, const Interrupts& interrupts) {
  for (std::uint64_t step = 0; step < steps && !interrupts.asked(); ++step) flock.step();
  return !interrupts.asked();
}

// One repeat, appended to the times.
bool add_repeat(sturnus::Simulation& flock, PhaseClock& clock, std::uint64_t steps,
                const Interrupts& interrupts, BenchTimes& times) {
  double boid_steps = 0;
  PhaseClock::Seconds phases{};
  const double wall = wall_seconds(), own = thread_seconds();
  for (std::uint64_t step = 0; step < steps; ++step) {
    if (interrupts.asked()) return false;
    boid_steps += static_cast<double>(flock.view().size());
    flock.step();
    add(phases, clock.take_busiest());
  }
  const double cpu = flock.threads() == 1 ? thread_seconds() - own : total(phases);
  times.wall.push_back(1e9 * (wall_seconds() - wall) / std::max(boid_steps, 1.0));
  times.candidates += static_cast<double>(clock.take_pairs()) / std::max(boid_steps, 1.0);
  times.cpu.push_back(1e9 * cpu / std::max(boid_steps, 1.0));
  add(times.phases, phases);
  return true;
}

}  // namespace

void PhaseClock::begin(sturnus::Phase phase, int part) {
  parts_[static_cast<std::size_t>(part)].began[static_cast<std::size_t>(phase)] = thread_seconds();
}

void PhaseClock::end(sturnus::Phase phase, int part) {
  Part& own = parts_[static_cast<std::size_t>(part)];
  const auto which = static_cast<std::size_t>(phase);
  own.spent[which] += thread_seconds() - own.began[which];
}

void PhaseClock::looked_at(std::uint64_t pairs, int part) {
  parts_[static_cast<std::size_t>(part)].pairs += pairs;
}

std::uint64_t PhaseClock::take_pairs() {
  std::uint64_t sum = 0;
  for (Part& part : parts_) sum += std::exchange(part.pairs, 0);
  return sum;
}

PhaseClock::Seconds PhaseClock::take_busiest() {
  Seconds busiest{};
  for (Part& part : parts_) {
    for (std::size_t phase = 0; phase < busiest.size(); ++phase)
      busiest[phase] = std::max(busiest[phase], part.spent[phase]);
    part.spent = {};
  }
  return busiest;
}

std::optional<BenchTimes> measure_steps(sturnus::Simulation& flock, const BenchLength& length,
                                        const Interrupts& interrupts) {
  if (!warm_up(flock, length.warm_up, interrupts)) return {};
  PhaseClock clock(flock.threads());
  flock.watch(&clock);
  BenchTimes times;
  bool goes_on = true;
  for (std::uint64_t repeat = 0; repeat < length.repeats && goes_on; ++repeat)
    goes_on = add_repeat(flock, clock, length.steps, interrupts, times);
  flock.watch(nullptr);
  times.candidates /= static_cast<double>(std::max<std::size_t>(times.wall.size(), 1));
  if (!goes_on) return {};
  return times;
}

}  // namespace program
