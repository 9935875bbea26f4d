// How much is measured.
#pragma once

#include <cstdint>
#include <vector>

namespace bench {

/// quick: that everything runs, with small flocks; usual: every figure; large: ten million boids as well.
enum class Effort { quick, usual, large };

using Counts = std::vector<std::int64_t>;

/// The counts of boids for a quick run, or for one that is not.
inline Counts counts(Effort effort, const Counts& quick, const Counts& usual) {
  return effort == Effort::quick ? quick : usual;
}

inline int repeats(Effort effort, int usual = 5) {
  return effort == Effort::quick ? 2 : usual;
}

}  // namespace bench
