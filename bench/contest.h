// Several that do the same work, timed in turns so that a slow minute of the machine hits all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bench {

using Json = nlohmann::ordered_json;

struct Contender {
  std::string name;
  std::function<void()> work;            ///< timed
  std::function<void()> before = [] {};  ///< not timed
  std::vector<double> seconds = {};      ///< of each turn
};

/// How long the turns may go on: at least two of each, at most `repeats`, none begun after `budget` seconds.
struct Turns {
  int repeats = 5;
  double budget = 60;  ///< seconds on the wall
};

/// One turn each, then again, by the CPU time of this thread.
void take_turns(std::vector<Contender>& contenders, const Turns& turns);

double least(std::vector<double> values);
double median(std::vector<double> values);

/// Least and median as JSON, by boid and by step; each turn was that many steps of that many boids.
Json timing(const std::vector<double>& seconds, std::int64_t boids, int steps);

/// Steps in one turn, so that a turn of few boids is long enough for the clock.
int steps_in_turn(std::int64_t boids);

/// A hash as people write it.
std::string hex(std::uint64_t hash);

/// Prints a line to standard output at once.
[[gnu::format(printf, 1, 2)]] void say(const char* pattern, ...);

}  // namespace bench
