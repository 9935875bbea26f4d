// The flocks that are measured.
#include "flocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace bench {
namespace {

using sturnus::ScenarioDef;
using sturnus::Simulation;

constexpr double radius = 10;
constexpr double usual_neighbours = 20;

// Numbers that are the same with every standard library.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32;
  }

 private:
  std::mt19937 engine_{20};
};

std::array<double, 3> in_ball(Dice& dice, std::size_t axes) {
  for (;;) {
    std::array<double, 3> at{};
    double squared = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      at[axis] = dice.between(-1, 1);
      squared += at[axis] * at[axis];
    }
    if (squared <= 1) return at;
  }
}

// Where boid number i is, and where the clump is that it belongs to.
class Places {
 public:
  Places(const ScenarioDef& scenario, Spread spread)
      : extent_(sturnus::extent_of(scenario)), spread_(spread), axes_(extent_.min.size()) {
    const auto boids = static_cast<double>(scenario.boid_count());
    const double share = boids / usual_neighbours;
    ball_ = radius * (axes_ == 3 ? std::cbrt(share) : std::sqrt(share));
  }

  std::array<double, 3> next(std::int64_t i) {
    if (spread_ == Spread::lost && i % 100 == 0) return anywhere();
    if (spread_ == Spread::clumped && i % 200 == 0) middle_ = anywhere();
    const auto offset = in_ball(dice_, axes_);
    std::array<double, 3> at = middle_;
    for (std::size_t axis = 0; axis < axes_; ++axis)
      at[axis] += offset[axis] * (spread_ == Spread::lost ? ball_ : radius);
    return at;
  }

 private:
  std::array<double, 3> anywhere() {
    std::array<double, 3> at{};
    for (std::size_t axis = 0; axis < axes_; ++axis)
      at[axis] = dice_.between(extent_.min[axis], extent_.max[axis]);
    return at;
  }

  sturnus::Extent extent_;
  Spread spread_;
  std::size_t axes_;
  double ball_;
  std::array<double, 3> middle_{};
  Dice dice_;
};

sturnus::State spread_state(const ScenarioDef& scenario, Spread spread) {
  sturnus::State state;
  state.dimensions = static_cast<int>(scenario.space.dimensions);
  const auto boids = static_cast<std::size_t>(scenario.boid_count());
  Places places(scenario, spread);
  Dice dice;
  for (std::size_t i = 0; i < boids; ++i) {
    state.id.push_back(i);
    const auto at = places.next(static_cast<std::int64_t>(i));
    const auto velocity = in_ball(dice, static_cast<std::size_t>(state.dimensions));
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(state.dimensions); ++axis) {
      state.position[axis].push_back(static_cast<float>(at[axis]));
      state.velocity[axis].push_back(static_cast<float>(velocity[axis] * 1.5));
    }
  }
  state.flock.assign(boids, 0);
  state.quarantined.assign(boids, 0);
  state.next_id = boids;
  return state;
}

Simulation checked(sturnus::Result<Simulation> result) {
  if (!result) throw Failure{result.error()};
  return std::move(*result);
}

std::array<float, 3> floats(const sturnus::Coordinates& from) {
  std::array<float, 3> out{};
  std::transform(from.begin(), from.end(), out.begin(),
                 [](double value) { return static_cast<float>(value); });
  return out;
}

}  // namespace

ScenarioDef scenario(const std::string& name, std::int64_t boids) {
  auto loaded = sturnus::load_scenario(name);
  if (!loaded) throw Failure{loaded.error()};
  loaded->flocks[0].count = boids;
  return std::move(*loaded);
}

ScenarioDef base_case(int dimensions, std::int64_t boids) {
  return scenario(dimensions == 3 ? "bench-3d" : "bench-2d", boids);
}

void reach_neighbours(ScenarioDef& scenario, double neighbours, double share) {
  const double ratio = neighbours / usual_neighbours;
  const double reach = radius * (scenario.space.dimensions == 3 ? std::cbrt(ratio) : std::sqrt(ratio));
  sturnus::FlockDef& flock = scenario.flocks[0];
  flock.alignment[0].radius = reach;
  flock.cohesion[0].radius = reach;
  flock.separation[0].radius = reach * share;
}

ScenarioDef quadtree_case(std::int64_t boids) {
  ScenarioDef out = scenario("quadtree", boids);
  out.flocks[0].noise.reset();
  return out;
}

const char* name_of(Spread spread) {
  switch (spread) {
    case Spread::uniform:
      return "uniform";
    case Spread::clumped:
      return "clumped";
    case Spread::lost:
      return "lost";
  }
  return "";
}

Simulation spread_flock(int dimensions, std::int64_t boids, Spread spread, sturnus::IndexKind index) {
  ScenarioDef def = base_case(dimensions, boids);
  def.index.kind = index;
  if (spread == Spread::uniform) return opened(def);
  if (spread == Spread::lost) {
    def.space.boundary.kind = sturnus::BoundaryKind::open;
    def.space.min.assign(static_cast<std::size_t>(dimensions), -5e5);
    def.space.max.assign(static_cast<std::size_t>(dimensions), 5e5);
    def.space.per_boid.reset();
  }
  sturnus::SimulationOptions options{1, {}};
  options.tables.emplace("made", spread_state(def, spread));
  def.run.initial = "made";
  return checked(Simulation::create(def, options));
}

Simulation opened(const ScenarioDef& scenario, int threads) {
  return checked(sturnus::open_simulation(scenario, threads));
}

Numbers numbers_of(const ScenarioDef& scenario) {
  const sturnus::FlockDef& flock = scenario.flocks[0];
  const sturnus::Extent extent = sturnus::extent_of(scenario);
  const auto number = [](double value) { return static_cast<float>(value); };
  Numbers out;
  out.dimensions = static_cast<int>(scenario.space.dimensions);
  out.min = floats(extent.min);
  out.max = floats(extent.max);
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) out.size[axis] = out.max[axis] - out.min[axis];
  out.radius = number(flock.cohesion[0].radius);
  out.separation_radius = number(flock.separation[0].radius);
  out.separation = number(flock.separation[0].weight);
  out.alignment = number(flock.alignment[0].weight);
  out.cohesion = number(flock.cohesion[0].weight);
  out.max_acceleration = number(flock.max_acceleration);
  out.min_speed = number(flock.min_speed);
  out.max_speed = number(flock.max_speed);
  out.dt = number(scenario.time.dt);
  if (scenario.space.boundary.kind == sturnus::BoundaryKind::turn) {
    out.course = Course::sighted;
    out.cos_half_view = number(std::cos(flock.field_of_view / 360.0 * std::numbers::pi));
    out.margin = number(scenario.space.boundary.margin[0]);
    out.turn = number(scenario.space.boundary.strength);
  }
  return out;
}

Flock flock_of(const sturnus::View& view) {
  Flock out;
  const sturnus::State& state = view.state();
  const auto slots = view.slots_by_id();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(view.dimensions()); ++axis) {
    out.position[axis].reserve(slots.size());
    out.velocity[axis].reserve(slots.size());
    for (const std::uint32_t slot : slots) {
      out.position[axis].push_back(state.position[axis][slot]);
      out.velocity[axis].push_back(state.velocity[axis][slot]);
    }
  }
  return out;
}

}  // namespace bench
