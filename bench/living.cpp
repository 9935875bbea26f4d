// A living world: what hunters, obstacles, food and drifting colours cost a flock that would do without.
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

using sturnus::ScenarioDef;

constexpr int steps = 10;  // in a turn
constexpr const char* alone = "the flock alone";

// A world and its boids, who may grow fewer on the way.
struct World {
  World(std::string what, const ScenarioDef& def) : name(std::move(what)), simulation(opened(def)) {
    simulation.run(steps);
  }
  std::string name;
  sturnus::Simulation simulation;
};

std::string living_name(int dimensions) {
  return dimensions == 3 ? "bench-living-3d" : "bench-living-2d";
}

std::vector<std::unique_ptr<World>> worlds(int dimensions, std::int64_t boids) {
  std::vector<std::unique_ptr<World>> out;
  ScenarioDef living = scenario(living_name(dimensions), boids);
  out.push_back(std::make_unique<World>(alone, base_case(dimensions, boids)));
  out.push_back(std::make_unique<World>("with hunters, obstacles and food", living));
  living.flocks[0].colour.start = "random";
  living.flocks[0].colour.averaging = 0.1;
  living.flocks[0].colour.noise = 0.01;
  out.push_back(std::make_unique<World>("and with colours that drift", living));
  return out;
}

Json row_of(const World& world, int dimensions, std::int64_t boids, const std::vector<double>& seconds,
            const std::vector<double>& base) {
  Json row = {{"dimensions", dimensions}, {"boids", boids}, {"world", world.name}};
  row.update(timing(seconds, boids, steps));
  row["ratio"] = {{"of_minima", least(seconds) / least(base)},
                  {"of_medians", median(seconds) / median(base)}};
  row["step"] = world.simulation.step_number();
  row["hash"] = hex(world.simulation.hash());
  say("%dD %8lld boids  %-34s %8.2f ns, median  %.2fx  hash %s", dimensions, static_cast<long long>(boids),
      world.name.c_str(), row["ns_per_boid"]["median"].get<double>(),
      row["ratio"]["of_medians"].get<double>(), row["hash"].get<std::string>().c_str());
  return row;
}

}  // namespace

Json measure_living(Effort effort) {
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    // The living worlds have one size, at which so many boids stand as in the base case.
    const std::int64_t boids = effort == Effort::quick ? 2000 : 100'000;
    const auto all = worlds(dimensions, boids);
    std::vector<Contender> contenders;
    for (const auto& world : all)
      contenders.push_back({world->name, [&world] { world->simulation.run(steps); }});
    take_turns(contenders, {repeats(effort, 9), 60});
    for (std::size_t i = 0; i < all.size(); ++i)
      out.push_back(row_of(*all[i], dimensions, boids, contenders[i].seconds, contenders[0].seconds));
  }
  return out;
}

}  // namespace bench
