// Our engine against every yardstick: the same flock, the same rules, the same thread, in turns.
#include "agreement.h"
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

struct Rival {
  const char* name;
  std::unique_ptr<Yardstick> (*make)(const Numbers&, const Flock&);
  const char* flags;
  Counts boids;
};

std::vector<Rival> rivals(Effort effort) {
  return {
      {"all pairs", make_naive, BENCH_NAIVE_FLAGS, counts(effort, {2000}, {10'000})},
      {"scalar grid", make_scalar_grid, BENCH_FLAGS, counts(effort, {2000}, {10'000, 100'000, 1'000'000})},
      {"nanoflann", make_nanoflann, BENCH_FLAGS, counts(effort, {2000}, {100'000, 1'000'000})},
      {"pointer tree", make_pointer_tree, BENCH_FLAGS, counts(effort, {2000}, {10'000, 100'000})}};
}

Json meet(const Rival& rival, int dimensions, std::int64_t boids, Effort effort) {
  const auto def = base_case(dimensions, boids);
  const Numbers numbers = numbers_of(def);
  auto ours = opened(def);
  const Flock start = flock_of(ours.view());
  const auto theirs = rival.make(numbers, start);
  ours.step();
  theirs->step();
  const Json agreement = agreed(numbers, rival.name, start, flock_of(ours.view()), theirs->flock());

  const int steps = steps_in_turn(boids * 10);
  std::vector<Contender> contenders(2);
  contenders[0] = {"sturnus", [&] { ours.run(static_cast<std::uint64_t>(steps)); }};
  contenders[1] = {rival.name, [&] {
                     for (int i = 0; i < steps; ++i) theirs->step();
                   }};
  take_turns(contenders, {repeats(effort, boids > 300'000 ? 5 : 7), 60});

  const auto& mine = contenders[0].seconds;
  const auto& other = contenders[1].seconds;
  Json out = {
      {"yardstick", rival.name},
      {"dimensions", dimensions},
      {"boids", boids},
      {"flags", rival.flags},
      {"ours", timing(mine, boids, steps)},
      {"theirs", timing(other, boids, steps)},
      {"ratio", {{"of_medians", median(other) / median(mine)}, {"of_minima", least(other) / least(mine)}}},
      {"agreement", agreement},
      {"step", ours.step_number()},
      {"hash", hex(ours.hash())}};
  const double by_boid = 1e9 / (static_cast<double>(boids) * steps);
  say("%dD %8lld boids  sturnus %7.1f ns  %-12s %8.1f ns a boid (medians)  %6.1fx  hash %s", dimensions,
      static_cast<long long>(boids), median(mine) * by_boid, rival.name, median(other) * by_boid,
      median(other) / median(mine), hex(ours.hash()).c_str());
  return out;
}

}  // namespace

Json measure_yardsticks(Effort effort) {
  Json out = Json::array();
  for (const Rival& rival : rivals(effort)) {
    for (const int dimensions : {2, 3}) {
      for (const std::int64_t boids : rival.boids) out.push_back(meet(rival, dimensions, boids, effort));
    }
  }
  return out;
}

}  // namespace bench
