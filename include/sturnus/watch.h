// Who looks on while a step is made: the times of its parts are measured from outside, since the library has
// no clock.
#pragma once

#include <cstdint>

namespace sturnus {

/// The parts of a step. `sort`: bad numbers, the neighbour index, the order of storage. `neighbours`: the
/// sums over neighbours. `motion`: from sums to accelerations, velocities and places.
enum class Phase : std::uint8_t { sort, neighbours, motion };

/// Is told when a thread begins and ends a stretch of a phase; a phase may have many stretches. Called on the
/// thread that does the work, by several at once with different `part` (0 to threads - 1).
class StepWatch {
 public:
  virtual ~StepWatch() = default;
  virtual void begin(Phase phase, int part) = 0;
  virtual void end(Phase phase, int part) = 0;
  /// So many candidate pairs there were since the last call with this `part`: a boid and one whom the index
  /// names as maybe near. Neighbours that come in whole cells are not among them.
  virtual void looked_at(std::uint64_t pairs, int part) {
    static_cast<void>(pairs);
    static_cast<void>(part);
  }
};

}  // namespace sturnus
