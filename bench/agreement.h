// Whether two programs made the same step: a speed without the same result is worth nothing.
#pragma once

#include "contest.h"
#include "yardsticks/yardstick.h"

namespace bench {

/// How far two flocks are apart after one step from the same start.
struct Agreement {
  std::size_t boids = 0;
  std::size_t off = 0;  ///< boids whose velocity or place differs by more than a ten-thousandth
  double largest = 0;   ///< difference of all the others, as a share
};

/// Compares velocities as a share of the speed, and places as a share of the longest way of one step (at
/// least the rounding of a place).
Agreement compare(const Numbers& numbers, const Flock& one, const Flock& other);

/// Compares, and throws a Failure unless all but one boid in a thousand agree. A neighbour just on the rim of
/// a radius may count for one program and not for the other; nothing else may differ. Also tries the
/// comparison itself: against the start it has to find every boid off.
Json agreed(const Numbers& numbers, const std::string& who, const Flock& start, const Flock& ours,
            const Flock& theirs);

}  // namespace bench
