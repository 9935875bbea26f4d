// One run from its first step to its last: the steps, their time, and the measures taken on the way.
#pragma once

#include <sturnus/measure.h>
#include <sturnus/simulation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace program {

/// What a run was, once it is over.
struct Course {
  std::uint64_t steps = 0;   ///< done in this run
  double seconds = 0;        ///< wall time of the steps alone, without measures and files
  double boid_steps = 0;     ///< boids, summed over the steps
  bool interrupted = false;  ///< by Ctrl-C
  std::vector<sturnus::Measures> rows;

  /// Nanoseconds for each boid and step; NaN when there was none.
  double nanoseconds() const;
};

/// Steps a flock. `measured`: at the first state, every `run.measure.every` steps, and at the last.
Course follow(sturnus::Simulation& flock, std::uint64_t steps, bool measured, bool with_progress);

/// Says what a flock met besides flocking: boids in quarantine, events that named a boid that was not there.
void tell_report(const sturnus::Simulation& flock);

/// Header and rows, as a CSV file has them.
std::string measures_csv(const sturnus::ScenarioDef& scenario, const std::vector<sturnus::Measures>& rows);

}  // namespace program
