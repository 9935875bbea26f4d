// One thread, two, ... all: on the wall, and by what the busiest thread of each phase computes.
#include <sturnus/watch.h>

#include <algorithm>
#include <thread>

#include "clock.h"
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

// Adds up the CPU time of each thread in each phase. Every part writes only to its own line of memory.
class PhaseTimes : public sturnus::StepWatch {
 public:
  explicit PhaseTimes(int threads) : parts_(static_cast<std::size_t>(threads)) {}

  void begin(sturnus::Phase phase, int part) override { at(phase, part).begun = cpu_seconds(); }
  void end(sturnus::Phase phase, int part) override {
    Stretch& stretch = at(phase, part);
    stretch.seconds += cpu_seconds() - stretch.begun;
    stretch.was_told = true;
  }

  void clear() { std::fill(parts_.begin(), parts_.end(), Part{}); }

  /// The busiest thread of a phase.
  double busiest(std::size_t phase) const {
    double out = 0;
    for (const Part& part : parts_) out = std::max(out, part.phases[phase].seconds);
    return out;
  }

  /// The sum of the busiest threads, phase by phase: no step can be shorter on the wall.
  double critical() const { return busiest(0) + busiest(1) + busiest(2); }

  /// How many threads have told of their work in the sums over neighbours.
  int told() const {
    return static_cast<int>(std::count_if(parts_.begin(), parts_.end(),
                                          [](const Part& part) { return part.phases[1].was_told; }));
  }

 private:
  struct Stretch {
    double begun = 0, seconds = 0;
    bool was_told = false;
  };
  struct alignas(128) Part {
    std::array<Stretch, 3> phases;
  };

  Stretch& at(sturnus::Phase phase, int part) {
    return parts_.at(static_cast<std::size_t>(part)).phases[static_cast<std::size_t>(phase)];
  }

  std::vector<Part> parts_;
};

struct Team {
  Team(int dimensions, std::int64_t boids, int count)
      : threads(count), simulation(opened(base_case(dimensions, boids), count)), times(count) {
    simulation.step();
    simulation.watch(&times);
  }

  void step() {
    times.clear();
    const double before = wall_seconds();
    simulation.step();
    wall.push_back(wall_seconds() - before);
    critical.push_back(times.critical());
    for (std::size_t phase = 0; phase < 3; ++phase) phases[phase].push_back(times.busiest(phase));
  }

  int threads;
  sturnus::Simulation simulation;
  PhaseTimes times;
  std::vector<double> wall, critical;
  std::array<std::vector<double>, 3> phases;
};

Json row_of(const Team& team, const Team& single, int dimensions, std::int64_t boids) {
  Json out = {
      {"dimensions", dimensions},
      {"boids", boids},
      {"threads", team.threads},
      {"threads_told", team.times.told()},
      {"wall_ms", {{"min", 1e3 * least(team.wall)}, {"median", 1e3 * median(team.wall)}}},
      {"busiest_cpu_ms", {{"min", 1e3 * least(team.critical)}, {"median", 1e3 * median(team.critical)}}},
      {"phases_ms",
       {{"sort", 1e3 * median(team.phases[0])},
        {"neighbours", 1e3 * median(team.phases[1])},
        {"motion", 1e3 * median(team.phases[2])}}},
      {"speedup",
       {{"wall_of_minima", least(single.wall) / least(team.wall)},
        {"cpu_of_medians", median(single.critical) / median(team.critical)},
        {"cpu_of_minima", least(single.critical) / least(team.critical)}}},
      {"repeats", team.wall.size()},
      {"step", team.simulation.step_number()},
      {"hash", hex(team.simulation.hash())}};
  say("%dD %8lld boids  %2d threads (%d told)  wall %8.2f ms, best  busiest %8.2f ms CPU, median  %.2fx  "
      "hash %s",
      dimensions, static_cast<long long>(boids), team.threads, team.times.told(), 1e3 * least(team.wall),
      1e3 * median(team.critical), median(single.critical) / median(team.critical),
      hex(team.simulation.hash()).c_str());
  return out;
}

// One, two, four ... and all.
std::vector<int> team_sizes() {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> out;
  for (int threads = 1; threads < all; threads *= 2) out.push_back(threads);
  out.push_back(all);
  return out;
}

}  // namespace

Json measure_threads(Effort effort) {
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const std::int64_t boids : counts(effort, {5000}, {100'000, 1'000'000})) {
      std::vector<std::unique_ptr<Team>> teams;
      for (const int threads : team_sizes())
        teams.push_back(std::make_unique<Team>(dimensions, boids, threads));
      for (int turn = 0; turn < repeats(effort, 10); ++turn) {
        for (const auto& team : teams) team->step();
      }
      for (const auto& team : teams) {
        if (team->simulation.hash() != teams[0]->simulation.hash()) {
          throw Failure{std::to_string(team->threads) + " threads lead to another state than one"};
        }
        out.push_back(row_of(*team, *teams[0], dimensions, boids));
      }
    }
  }
  return out;
}

}  // namespace bench
