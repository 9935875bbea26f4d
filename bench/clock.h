// The clocks of the benchmarks; the library itself has none.
#pragma once

#include <ctime>

namespace bench {

inline double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds that this thread has computed; others on the machine don't count.
inline double cpu_seconds() {
  return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

/// Seconds on the wall.
inline double wall_seconds() {
  return seconds_of(CLOCK_MONOTONIC);
}

}  // namespace bench
