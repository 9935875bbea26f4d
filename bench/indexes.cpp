// Grid, tree and all pairs: which index for which flock.
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

using sturnus::IndexKind;

const std::vector<std::pair<const char*, IndexKind>> kinds = {
    {"grid", IndexKind::grid}, {"tree", IndexKind::tree}, {"all pairs", IndexKind::all_pairs}};

// Above this many boids all pairs are hopeless.
constexpr std::int64_t most_in_pairs = 30'000;

Json with_each_index(int dimensions, std::int64_t boids, Spread spread, Effort effort) {
  const int steps = steps_in_turn(boids);
  std::vector<sturnus::Simulation> simulations;
  simulations.reserve(kinds.size());
  std::vector<Contender> contenders;
  for (const auto& [name, kind] : kinds) {
    if (kind == IndexKind::all_pairs && boids > most_in_pairs) continue;
    simulations.push_back(spread_flock(dimensions, boids, spread, kind));
    sturnus::Simulation* mine = &simulations.back();
    mine->step();
    contenders.push_back({name, [mine, steps] { mine->run(static_cast<std::uint64_t>(steps)); }});
  }
  take_turns(contenders, {repeats(effort), 2});

  Json rows = Json::array();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    Json row = {{"dimensions", dimensions},
                {"boids", boids},
                {"spread", name_of(spread)},
                {"index", contenders[i].name}};
    row.update(timing(contenders[i].seconds, boids, steps));
    row["step"] = simulations[i].step_number();
    row["hash"] = hex(simulations[i].hash());
    say("%dD %8lld boids  %-8s %-10s %9.1f ns a boid  hash %s", dimensions, static_cast<long long>(boids),
        name_of(spread), contenders[i].name.c_str(), row["ns_per_boid"]["median"].get<double>(),
        hex(simulations[i].hash()).c_str());
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Json measure_indexes(Effort effort) {
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const Spread spread : {Spread::uniform, Spread::clumped, Spread::lost}) {
      for (const std::int64_t boids : counts(effort, {1000}, {300, 1000, 3000, 10'000, 30'000, 100'000})) {
        for (const Json& row : with_each_index(dimensions, boids, spread, effort)) out.push_back(row);
      }
    }
  }
  return out;
}

}  // namespace bench
