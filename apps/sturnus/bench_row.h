// The figures of one case of `sturnus bench`, and what has to hold between cases.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace program {

/// The least and the middle one of several figures.
struct Spread {
  double min = 0, median = 0;
};
/// Of at least one figure.
Spread spread_of(std::vector<double> figures);

/// One case: a scenario at one number of boids, on so many threads and one instruction set.
struct BenchRow {
  std::size_t group = 0;  ///< rows of one group differ in threads and instruction set alone
  std::string scenario, index, path;
  std::size_t boids = 0;
  int threads = 1;
  std::string isa;

  Spread wall;  ///< nanoseconds for each boid and step
  /// The same in CPU time: of the one thread; of several, the busiest one's in each phase.
  Spread cpu;
  std::array<double, 3> share{};  ///< of sort, neighbours and motion in the CPU time, 0 to 1
  double candidates = 0;          ///< of a boid in a step, on average: whom the index names as maybe near
  double neighbours = 0;          ///< of a boid, on average, at the end; NaN where that means nothing

  std::uint64_t peak_memory = 0;  ///< bytes
  bool is_own_peak = false;       ///< or the largest of all cases so far
  double bytes_per_boid = 0;      ///< what the case added to the memory

  std::uint64_t steps = 0;  ///< done at the end
  std::uint64_t hash = 0;   ///< of the state there

  /// CPU time on one thread, since others may use the machine; wall time on several, who wait for each other.
  const Spread& time() const { return threads == 1 ? cpu : wall; }
  const char* clock() const { return threads == 1 ? "CPU" : "wall"; }
  /// By the fastest repeat.
  double steps_per_second() const;
  double candidate_pairs_per_second() const;
  double neighbour_pairs_per_second() const;
};

/// A state's hash as all commands print it.
std::string hash_digits(std::uint64_t hash);

/// Which two rows of a group end in different states, as a sentence; empty when none do.
std::string disagreement(const std::vector<BenchRow>& rows);

}  // namespace program
