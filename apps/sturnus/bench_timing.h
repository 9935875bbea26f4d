// The clocks of `sturnus bench`: steps a simulation and says what the steps took.
#pragma once

#include <sturnus/simulation.h>

#include <array>
#include <optional>
#include <vector>

#include "interrupts.h"

namespace program {

/// Adds up the CPU time of each thread in each phase.
class PhaseClock : public sturnus::StepWatch {
 public:
  using Seconds = std::array<double, 3>;  ///< by phase

  explicit PhaseClock(int threads) : parts_(static_cast<std::size_t>(threads)) {}
  void begin(sturnus::Phase phase, int part) override;
  void end(sturnus::Phase phase, int part) override;
  void looked_at(std::uint64_t pairs, int part) override;

  /// Of each phase the busiest thread's time since the last call: what the phase would last on cores of one's
  /// own.
  Seconds take_busiest();
  /// Candidate pairs since the last call.
  std::uint64_t take_pairs();

 private:
  // Each on a cache line of its own, so that no thread waits for another's notes.
  struct alignas(64) Part {
    Seconds began{}, spent{};
    std::uint64_t pairs = 0;
  };
  std::vector<Part> parts_;
};

/// How long to measure.
struct BenchLength {
  std::uint64_t warm_up = 5, steps = 10, repeats = 5;

  std::uint64_t all_steps() const { return warm_up + steps * repeats; }
};

/// What the repeats took; one entry for each, in nanoseconds for each boid and step.
struct BenchTimes {
  std::vector<double> wall, cpu;
  PhaseClock::Seconds phases{};  ///< over all repeats
  double candidates = 0;         ///< of a boid in a step, on average over all repeats
};

/// Warms up and measures; nothing when it was interrupted.
std::optional<BenchTimes> measure_steps(sturnus::Simulation& flock, const BenchLength& length,
                                        const Interrupts& interrupts);

}  // namespace program
