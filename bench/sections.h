// What is measured, one function a section; each prints what it finds and returns it.
#pragma once

#include "contest.h"
#include "effort.h"

namespace bench {

/// Our engine against every yardstick, in turns, one thread.
Json measure_yardsticks(Effort effort);
/// The number of boids against time.
Json measure_sizes(Effort effort);
/// The number of neighbours in reach against time.
Json measure_neighbours(Effort effort);
/// One instruction set after the other; the hashes have to be equal.
Json measure_instruction_sets(Effort effort);
/// One thread, two, ... all; the hashes have to be equal.
Json measure_threads(Effort effort);
/// Grid, tree and all pairs on three spreads of the boids.
Json measure_indexes(Effort effort);
/// Many neighbours in reach, all over the space: the sparse and the dense path.
Json measure_dense(Effort effort);
/// The whole flock inside one radius: the sparse and the dense path.
Json measure_clumps(Effort effort);
/// What hunters, obstacles, food and drifting colours cost.
Json measure_living(Effort effort);
/// How many boids can be stepped sixty times a second.
Json measure_sixty(Effort effort);

/// The machine, the compiler, the flags and the date.
Json describe_machine();

}  // namespace bench
