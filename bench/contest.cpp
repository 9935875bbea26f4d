// Turns, and what is told of them.
#include "contest.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "clock.h"

namespace bench {

void take_turns(std::vector<Contender>& contenders, const Turns& turns) {
  const double begun = wall_seconds();
  for (int turn = 0; turn < turns.repeats; ++turn) {
    if (turn >= 2 && wall_seconds() - begun > turns.budget) return;
    for (Contender& contender : contenders) {
      contender.before();
      const double before = cpu_seconds();
      contender.work();
      contender.seconds.push_back(cpu_seconds() - before);
    }
  }
}

double least(std::vector<double> values) {
  return *std::min_element(values.begin(), values.end());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Json timing(const std::vector<double>& seconds, std::int64_t boids, int steps) {
  const double by_step = 1.0 / steps;
  const double by_boid = by_step / static_cast<double>(boids);
  return {
      {"ns_per_boid", {{"min", 1e9 * by_boid * least(seconds)}, {"median", 1e9 * by_boid * median(seconds)}}},
      {"ms_per_step", {{"min", 1e3 * by_step * least(seconds)}, {"median", 1e3 * by_step * median(seconds)}}},
      {"repeats", seconds.size()},
      {"steps_per_repeat", steps}};
}

int steps_in_turn(std::int64_t boids) {
  return static_cast<int>(std::clamp<std::int64_t>(200'000 / boids, 1, 20));
}

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

void say(const char* pattern, ...) {
  std::va_list values;
  va_start(values, pattern);
  std::vprintf(pattern, values);
  va_end(values);
  std::putchar('\n');
  std::fflush(stdout);
}

}  // namespace bench
