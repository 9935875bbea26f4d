// How many boids can be stepped sixty times a second, by the rules of scenario quadtree: the question that
// its project answered with 150 without a tree and 5000 with one.
#include <algorithm>

#include "agreement.h"
#include "clock.h"
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

constexpr double frame = 1.0 / 60;  // seconds

// How long a step took, and the state of our engine that it was made of or compared with.
struct Pace {
  double seconds = 0;
  std::uint64_t hash = 0;
};

// Somebody who can step a flock of any size.
struct Stepper {
  const char* name;
  std::function<Pace(std::int64_t boids, Effort effort)> pace;
};

// On the wall others on the machine count too, so the best of several steps is taken.
double best_of_steps(const std::function<void()>& step, Effort effort) {
  std::vector<double> seconds;
  for (int i = 0; i < repeats(effort, 10); ++i) {
    const double before = wall_seconds();
    step();
    seconds.push_back(wall_seconds() - before);
  }
  return least(seconds);
}

// The flock after its first second, when it has begun to form groups.
sturnus::Simulation settled(std::int64_t boids, const char* index, int threads, Effort effort) {
  auto simulation = opened(quadtree_case(boids), threads);
  simulation.run(effort == Effort::quick ? 2 : 60);
  if (const auto done = simulation.push(sturnus::SetParameter{"index.kind", index}); !done)
    throw Failure{done.error()};
  return simulation;
}

Stepper ours(const char* name, const char* index, int threads) {
  return {name, [=](std::int64_t boids, Effort effort) {
            auto simulation = settled(boids, index, threads, effort);
            simulation.step();
            const double seconds = best_of_steps([&] { simulation.step(); }, effort);
            return Pace{seconds, simulation.hash()};
          }};
}

Stepper yardstick(const char* name, std::unique_ptr<Yardstick> (*make)(const Numbers&, const Flock&)) {
  return {name, [=](std::int64_t boids, Effort effort) {
            auto simulation = settled(boids, "grid", 1, effort);
            const Numbers numbers = numbers_of(simulation.scenario());
            const Flock start = flock_of(simulation.view());
            const auto theirs = make(numbers, start);
            theirs->step();
            simulation.step();
            agreed(numbers, name, start, flock_of(simulation.view()), theirs->flock());
            return Pace{best_of_steps([&] { theirs->step(); }, effort), simulation.hash()};
          }};
}

// The largest count whose step fits into a frame, to four in a hundred, and the time of that step.
Json largest(const Stepper& stepper, Effort effort) {
  const std::int64_t most = effort == Effort::quick ? 400 : 1'000'000;
  std::int64_t fits = 0;
  std::int64_t too_many = 0;
  Pace best;
  for (std::int64_t boids = 200; too_many == 0 || (too_many - fits) * 25 > fits;) {
    const Pace pace = stepper.pace(boids, effort);
    if (pace.seconds < frame) {
      fits = boids;
      best = pace;
    } else {
      too_many = boids;
    }
    if (fits == most || too_many == 1) break;
    boids = too_many == 0 ? std::min(most, boids * 2) : (fits + too_many) / 2;
  }
  say("60 steps a second: %-34s %7lld boids, %.1f ms a step  hash %s", stepper.name,
      static_cast<long long>(fits), 1e3 * best.seconds, hex(best.hash).c_str());
  return {{"who", stepper.name},
          {"boids", fits},
          {"is_at_least", fits == most},
          {"ms_per_step", 1e3 * best.seconds},
          {"hash", hex(best.hash)}};
}

}  // namespace

Json measure_sixty(Effort effort) {
  Json out = Json::array();
  for (const Stepper& stepper :
       {yardstick("all pairs, array of structs", make_naive),
        yardstick("pointer quadtree", make_pointer_tree), ours("sturnus, all pairs", "all-pairs", 1),
        ours("sturnus, tree", "tree", 1), ours("sturnus, grid", "grid", 1),
        ours("sturnus, grid, all cores", "grid", 0)}) {
    out.push_back(largest(stepper, effort));
  }
  return out;
}

}  // namespace bench
