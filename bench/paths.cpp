// Dense flocks: neighbours one by one (sparse), those well inside a radius together (dense), or as the engine
// chooses.
#include <algorithm>
#include <cmath>

#include "agreement.h"
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

using sturnus::ScenarioDef;
using sturnus::SumPath;

const std::vector<std::pair<const char*, SumPath>> paths = {
    {"sparse", SumPath::sparse}, {"dense", SumPath::dense}, {"auto", SumPath::automatic}};

// The same flock on every path.
class Race {
 public:
  /// `what` names the case; paths in `slow` are left out.
  Race(ScenarioDef def, Json what, const std::vector<std::string>& slow) : what_(std::move(what)) {
    simulations_.reserve(paths.size());
    for (const auto& [name, path] : paths) {
      if (std::find(slow.begin(), slow.end(), name) != slow.end()) continue;
      def.index.path = path;
      simulations_.push_back(opened(def));
      sturnus::Simulation* mine = &simulations_.back();
      contenders_.push_back({name, [mine] { mine->step(); }});
    }
  }

  void run(Effort effort) {
    if (contenders_.empty()) return;
    check_first_step();
    take_turns(contenders_, {repeats(effort), 12});
  }

  Json rows() const {
    Json rows = Json::array();
    for (std::size_t i = 0; i < contenders_.size(); ++i) rows.push_back(row(i));
    return rows;
  }

  /// The paths whose next, larger flock would take more than `limit` seconds a step, if time grows by
  /// `growth`.
  std::vector<std::string> slow(double growth, double limit) const {
    std::vector<std::string> out;
    for (const auto& path : paths) {
      const auto mine = std::find_if(contenders_.begin(), contenders_.end(),
                                     [&](const Contender& one) { return one.name == path.first; });
      if (mine == contenders_.end() || least(mine->seconds) * growth > limit) out.emplace_back(path.first);
    }
    return out;
  }

 private:
  // Every path has to make the same step.
  void check_first_step() {
    const Flock start = flock_of(simulations_[0].view());
    for (auto& simulation : simulations_) simulation.step();
    const Flock first = flock_of(simulations_[0].view());
    for (std::size_t i = 1; i < simulations_.size(); ++i) {
      agreed(numbers_of(simulations_[0].scenario()), "the path " + contenders_[i].name, start, first,
             flock_of(simulations_[i].view()));
    }
  }

  Json row(std::size_t i) const {
    Json row = what_;
    row["path"] = contenders_[i].name;
    row.update(timing(contenders_[i].seconds, what_["boids"], 1));
    row["step"] = simulations_[i].step_number();
    row["hash"] = hex(simulations_[i].hash());
    say("%dD %8lld boids  k %-6.0f %-30s %-6s %10.3f ms a step  hash %s", what_["dimensions"].get<int>(),
        what_["boids"].get<long long>(), what_["neighbours"].get<double>(),
        what_["separation"].get<std::string>().c_str(), contenders_[i].name.c_str(),
        row["ms_per_step"]["median"].get<double>(), row["hash"].get<std::string>().c_str());
    return row;
  }

  Json what_;
  std::vector<sturnus::Simulation> simulations_;
  std::vector<Contender> contenders_;
};

void append(Json& rows, const Json& more) {
  for (const Json& row : more) rows.push_back(row);
}

void separate(ScenarioDef& def, sturnus::Strength strength, double radius) {
  def.flocks[0].separation[0].strength = strength;
  def.flocks[0].separation[0].radius = radius;
}

// How the boids of a clump keep their distance.
struct Distance {
  const char* name;
  sturnus::Strength strength;
  double seen;  ///< boids inside the radius of separation; infinity: all
};

// Everybody within the radius of everybody, and nobody fast enough to leave.
ScenarioDef clump(int dimensions, std::int64_t boids, const Distance& distance) {
  constexpr double ball = 4;
  ScenarioDef def = base_case(dimensions, boids);
  sturnus::FlockDef& flock = def.flocks[0];
  def.space.boundary.kind = sturnus::BoundaryKind::open;
  flock.start.region = sturnus::StartRegion::ball;
  flock.start.radius = ball;
  flock.start.min_speed = flock.min_speed = 0.01;
  flock.start.max_speed = flock.max_speed = 0.02;
  const double share = std::min(1.0, distance.seen / static_cast<double>(boids));
  const double radius = ball * (dimensions == 3 ? std::cbrt(share) : std::sqrt(share));
  separate(def, distance.strength, std::isfinite(distance.seen) ? radius : flock.cohesion[0].radius);
  return def;
}

const std::vector<Distance> distances = {{"linear", sturnus::Strength::grows, sturnus::infinity},
                                         {"1/d of 50 boids", sturnus::Strength::fades, 50},
                                         {"1/d of all boids", sturnus::Strength::fades, sturnus::infinity}};

}  // namespace

Json measure_dense(Effort effort) {
  const std::int64_t boids = effort == Effort::quick ? 3000 : 100'000;
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const bool is_linear : {false, true}) {
      for (const std::int64_t neighbours : counts(effort, {60}, {300, 1000, 3000, 10'000})) {
        ScenarioDef def = base_case(dimensions, boids);
        reach_neighbours(def, static_cast<double>(neighbours), is_linear ? 1.0 : 0.2);
        separate(def, is_linear ? sturnus::Strength::grows : sturnus::Strength::fades,
                 def.flocks[0].separation[0].radius);
        Race race(def,
                  {{"dimensions", dimensions},
                   {"boids", boids},
                   {"neighbours", neighbours},
                   {"separation", is_linear ? "linear at r" : "1/d at r/5"}},
                  {});
        race.run(effort);
        append(out, race.rows());
      }
    }
  }
  return out;
}

Json measure_clumps(Effort effort) {
  constexpr double growth = 10;  // from one count to the next, for whoever looks at all pairs
  constexpr double limit = 3;    // seconds
  Json out = Json::array();
  for (const int dimensions : {2, 3}) {
    for (const Distance& distance : distances) {
      std::vector<std::string> slow;
      for (const std::int64_t boids : counts(effort, {600}, {2000, 6000, 20'000, 60'000, 200'000})) {
        Race race(clump(dimensions, boids, distance),
                  {{"dimensions", dimensions},
                   {"boids", boids},
                   {"neighbours", boids - 1},
                   {"separation", distance.name}},
                  slow);
        race.run(effort);
        append(out, race.rows());
        slow = race.slow(growth, limit);
      }
    }
  }
  return out;
}

}  // namespace bench
