// Time against the number of boids, the number of neighbours and the instruction set.
#include <sturnus/isa.h>

#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

// One simulation by itself, after one step that sorts what the start had in no order.
Json alone(const sturnus::ScenarioDef& def, Effort effort) {
  const std::int64_t boids = def.boid_count();
  auto simulation = opened(def);
  const int steps = steps_in_turn(boids);
  simulation.step();
  std::vector<Contender> contenders = {
      {"sturnus", [&] { simulation.run(static_cast<std::uint64_t>(steps)); }}};
  take_turns(contenders, {repeats(effort), 20});
  const auto& seconds = contenders[0].seconds;
  Json out = {{"dimensions", def.space.dimensions}, {"boids", boids}};
  out.update(timing(seconds, boids, steps));
  out["step"] = simulation.step_number();
  out["hash"] = hex(simulation.hash());
  return out;
}

void print(const Json& row, const std::string& what) {
  say("%dD %9lld boids  %-8s %8.1f ns a boid  %9.3f ms a step  hash %s", row["dimensions"].get<int>(),
      row["boids"].get<long long>(), what.c_str(), row["ns_per_boid"]["median"].get<double>(),
      row["ms_per_step"]["median"].get<double>(), row["hash"].get<std::string>().c_str());
}

const std::vector<std::pair<const char*, sturnus::Isa>> instruction_sets = {{"scalar", sturnus::Isa::plain},
                                                                            {"sse4", sturnus::Isa::sse4},
                                                                            {"avx2", sturnus::Isa::avx2},
                                                                            {"avx512", sturnus::Isa::avx512},
                                                                            {"neon", sturnus::Isa::neon}};

// The same flock once for each instruction set that the machine has.
Json on_each_instruction_set(int dimensions, std::int64_t boids, Effort effort) {
  std::vector<sturnus::Simulation> simulations;
  simulations.reserve(instruction_sets.size());
  std::vector<Contender> contenders;
  for (const auto& [name, isa] : instruction_sets) {
    if (!sturnus::use_isa(isa)) continue;
    simulations.push_back(opened(base_case(dimensions, boids)));
    sturnus::Simulation* mine = &simulations.back();
    mine->step();
    contenders.push_back({name, [mine] { mine->step(); }, [chosen = isa] { sturnus::use_isa(chosen); }});
  }
  take_turns(contenders, {repeats(effort), 20});
  sturnus::use_isa(sturnus::Isa::best);

  Json rows = Json::array();
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    if (simulations[i].hash() != simulations[0].hash()) {
      throw Failure{"the instruction set " + contenders[i].name + " leads to another state than " +
                    contenders[0].name};
    }
    Json row = {{"dimensions", dimensions}, {"boids", boids}, {"instruction_set", contenders[i].name}};
    row.update(timing(contenders[i].seconds, boids, 1));
    row["step"] = simulations[i].step_number();
    row["hash"] = hex(simulations[i].hash());
    print(row, contenders[i].name);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Json measure_sizes(Effort effort) {
  Counts sizes = counts(effort, {500, 2000}, {1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000});
  if (effort == Effort::large) sizes.push_back(10'000'000);
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const std::int64_t boids : sizes) {
      out.push_back(alone(base_case(dimensions, boids), effort));
      print(out.back(), "k 20");
    }
  }
  return out;
}

Json measure_neighbours(Effort effort) {
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const std::int64_t neighbours : counts(effort, {5, 40}, {5, 10, 20, 40, 80, 160, 320})) {
      auto def = base_case(dimensions, effort == Effort::quick ? 3000 : 100'000);
      reach_neighbours(def, static_cast<double>(neighbours), 0.5);
      Json row = alone(def, effort);
      row["neighbours"] = neighbours;
      print(row, "k " + std::to_string(neighbours));
      out.push_back(row);
    }
  }
  return out;
}

Json measure_instruction_sets(Effort effort) {
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const Json& row :
         on_each_instruction_set(dimensions, effort == Effort::quick ? 2000 : 100'000, effort)) {
      out.push_back(row);
    }
  }
  return out;
}

}  // namespace bench
