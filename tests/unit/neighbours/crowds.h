// Random crowds for the dense path: worlds in which whole cells lie inside a ring, and flocks whose rows are
// plain sums beside rows that are not.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "neighbours/passes.h"
#include "scene.h"

namespace sturnus::test {

/// Many numbers from one drawn seed: rapidcheck is asked for what a person wants to see, not for every boid.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  float share() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }  ///< [0, 1)
  float between(float low, float high) { return low + (high - low) * share(); }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }

 private:
  std::mt19937 engine_;
};

using Corner = std::array<float, 3>;

enum class Gathering { uniform, crowd, tiny, clumps, points, lattice };
inline constexpr Gathering every_gathering[] = {Gathering::uniform, Gathering::crowd,  Gathering::tiny,
                                                Gathering::clumps,  Gathering::points, Gathering::lattice};
inline constexpr Gathering dense_gatherings[] = {Gathering::crowd, Gathering::clumps, Gathering::points};

/// A crowd of one or more flocks, sorted into a grid of the given fineness.
struct CrowdScene : Scene {
  int fineness = 1;

  Cloud cloud() const {
    Cloud cloud = world.cloud();
    cloud.fineness = fineness;
    return cloud;
  }
};

/// Where a crowd of this kind has its middle, and how far a boid stands from it, in reaches.
inline Corner gathering_place(Gathering kind, const RandomWorld& world, const Corner& middle, Dice& dice) {
  Corner at{};
  const auto clump = static_cast<float>(dice.below(3));
  const std::uint32_t point = dice.below(7);
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    const float span = world.max[axis] - world.min[axis];
    switch (kind) {
      case Gathering::uniform:
        at[axis] = world.min[axis] + span * dice.share();
        break;
      case Gathering::crowd:
        at[axis] = middle[axis] + world.reach * dice.between(-1.25f, 1.25f);
        break;
      case Gathering::tiny:
        at[axis] = middle[axis] + world.reach * dice.between(-0.2f, 0.2f);
        break;
      case Gathering::clumps:
        at[axis] = middle[axis] + world.reach * (0.9f * clump + dice.between(-0.25f, 0.25f));
        break;
      case Gathering::points:
        at[axis] = middle[axis] + world.reach * 0.7f * static_cast<float>((point >> axis) % 4);
        break;
      case Gathering::lattice:  // on the edges of cells, and exactly on the radius
        at[axis] = world.min[axis] + world.reach / 4 * static_cast<float>(dice.below(9));
        break;
    }
  }
  return at;
}

inline void place_boids(Gathering kind, int count, Dice& dice, RandomWorld& world) {
  Corner middle{};
  // A crowd in a wrapped space may stand over its corner.
  const bool on_the_seam = dice.below(2) == 0;
  for (std::size_t axis = 0; axis < world.axes(); ++axis)
    middle[axis] =
        world.min[axis] + (world.max[axis] - world.min[axis]) * (on_the_seam ? 0.0f : dice.share());
  for (int i = 0; i < count; ++i) {
    const Corner at = gathering_place(kind, world, middle, dice);
    for (std::size_t axis = 0; axis < world.axes(); ++axis) {
      world.position[axis].push_back(world.wraps ? wrapped(at[axis], world.min[axis], world.max[axis])
                                                 : at[axis]);
    }
    world.hidden.push_back(0);
    world.ids.push_back(static_cast<std::uint64_t>(i));
  }
}

/// One is lost, and one more is lost farther than any sum can bear.
inline void lose_two(Dice& dice, RandomWorld& world) {
  if (world.wraps || world.size() < 3) return;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    if (dice.below(2) == 0) world.position[axis][0] = 1e6f;
    if (dice.below(2) == 0) world.position[axis][1] = dice.below(2) == 0 ? 1e15f : -1e15f;
  }
}

inline RandomWorld crowded_world(int dimensions, bool wraps, int most, Dice& dice) {
  RandomWorld world;
  world.dimensions = dimensions;
  world.wraps = wraps;
  world.reach = *rc::gen::element(0.5f, 1.0f, 1.37f, 20.0f);
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    world.min[axis] = eighths(-80, 80);
    // At its narrowest a wrapped space is three reaches and the room for rounding wide.
    world.max[axis] = world.min[axis] + world.reach * *rc::gen::element(3.01f, 3.01f, 4.0f, 5.3f);
  }
  const bool is_dense = *rc::gen::arbitrary<bool>();
  const Gathering kind = is_dense ? dense_gatherings[dice.below(3)] : every_gathering[dice.below(6)];
  place_boids(kind, *rc::gen::inRange(most / 4, most), dice, world);
  if (*rc::gen::inRange(0, 3) == 0) lose_two(dice, world);
  if (*rc::gen::inRange(0, 3) == 0)
    for (auto& hidden : world.hidden) hidden = dice.below(10) == 0 ? 1 : 0;
  return world;
}

/// Sorts the world into a grid.
inline std::unique_ptr<NeighbourIndex> sorted_into_grid(RandomWorld& world, int fineness) {
  auto grid = make_grid();
  Cloud cloud = world.cloud();
  cloud.fineness = fineness;
  std::vector<std::uint32_t> order;
  grid->build(cloud, world.reach, Workers(1), order);
  world.reorder_as(order);
  cloud = world.cloud();
  cloud.fineness = fineness;
  grid->build(cloud, world.reach, Workers(1), order);
  return grid;
}

inline NeighbourRow crowd_row(Quantity quantity, float reach, std::uint64_t flocks) {
  NeighbourRow row;
  row.quantity = quantity;
  row.strength = Strength::grows;
  const float outer = reach * *rc::gen::element(0.6f, 1.0f, 1.0f, 1.0f);
  const float inner = outer * *rc::gen::element(0.0f, 0.0f, 0.0f, 0.4f);
  row.outer_squared = outer * outer;
  row.inner_squared = inner * inner;
  if (*rc::gen::arbitrary<bool>())
    row.outer_squared = std::nextafter(row.outer_squared, FlockModel::infinity_f);
  row.flocks =
      *rc::gen::inRange<std::uint64_t>(0, 4) == 0 ? *rc::gen::inRange<std::uint64_t>(0, flocks + 1) : flocks;
  return row;
}

/// A row of each quantity, and sometimes one that cannot be summed by cells.
inline FlockModel crowd_flock(float reach, std::uint64_t flocks) {
  FlockModel flock;
  for (const Quantity quantity :
       {Quantity::offset, Quantity::velocity, Quantity::heading, Quantity::colour}) {
    if (*rc::gen::inRange(0, 3) != 0) flock.rows.push_back(crowd_row(quantity, reach, flocks));
  }
  if (*rc::gen::arbitrary<bool>()) {
    flock.rows.push_back(crowd_row(Quantity::offset, reach / 2, flocks));
    flock.rows.back().strength = Strength::fades;
  }
  if (*rc::gen::inRange(0, 3) == 0 && !flock.rows.empty()) {
    flock.rows.front().sees_all = false;
    flock.rows.front().cos_half_view = -0.5f;
  }
  if (*rc::gen::inRange(0, 3) == 0 && flock.rows.size() > 1) {  // two rows with one filter
    flock.rows[1].inner_squared = flock.rows[0].inner_squared;
    flock.rows[1].outer_squared = flock.rows[0].outer_squared;
    flock.rows[1].flocks = flock.rows[0].flocks;
  }
  for (const NeighbourRow& row : flock.rows)
    flock.reach_squared = std::max(flock.reach_squared, row.outer_squared);
  return flock;
}

inline Model crowd_model(const RandomWorld& world) {
  Model model;
  model.dimensions = world.dimensions;
  model.boundary = world.wraps ? BoundaryKind::wrap : BoundaryKind::open;
  model.min = world.min;
  model.max = world.max;
  model.size = world.image().size;
  model.reach = world.reach;
  const int flocks = *rc::gen::element(1, 1, 2, 3);
  for (int i = 0; i < flocks; ++i) {
    model.flocks.push_back(crowd_flock(world.reach, (std::uint64_t{1} << flocks) - 1));
    model.most_rows = std::max(model.most_rows, model.flocks.back().rows.size());
  }
  return model;
}

inline void fill_columns(Dice& dice, CrowdScene& scene) {
  for (std::size_t i = 0; i < scene.world.size(); ++i) {
    float squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.velocity[axis].push_back(dice.between(-2, 2));
      scene.colour[axis].push_back(dice.share());
      if (axis < scene.world.axes()) squared += scene.velocity[axis][i] * scene.velocity[axis][i];
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      scene.heading[axis].push_back(scene.velocity[axis][i] / std::sqrt(squared));
    scene.flock.push_back(
        static_cast<std::uint8_t>(dice.below(static_cast<std::uint32_t>(scene.model.flocks.size()))));
  }
}

inline CrowdScene crowd_scene(int dimensions, bool wraps, int most = 1200) {
  Dice dice(*rc::gen::arbitrary<std::uint32_t>());
  CrowdScene scene;
  scene.fineness = *rc::gen::element(1, 2, 4, 4, 7, 7, 12);
  scene.world = crowded_world(dimensions, wraps, most, dice);
  scene.model = crowd_model(scene.world);
  scene.index = sorted_into_grid(scene.world, scene.fineness);
  fill_columns(dice, scene);
  return scene;
}

}  // namespace sturnus::test
