// Grid and tree find exactly the neighbours that all pairs find, on random worlds and on those that are hard.
#include "neighbours/index.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "neighbours/query.h"
#include "support.h"
#include "worlds.h"

namespace sturnus::test {
namespace {

using Sets = std::map<std::uint64_t, std::set<std::uint64_t>>;

template <int D>
Vec<D> place_of(const RandomWorld& world, std::size_t i) {
  Vec<D> v;
  for (int axis = 0; axis < D; ++axis) v[axis] = world.position[static_cast<std::size_t>(axis)][i];
  return v;
}

/// By definition: every pair that is no farther apart than the reach, its edge included.
template <int D>
Sets true_sets(const RandomWorld& world) {
  Sets sets;
  for (std::size_t j = 0; j < world.size(); ++j) {
    if (world.hidden[j] != 0) continue;
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Vec<D> o = offset(place_of<D>(world, j), place_of<D>(world, i), world.image());
      if (world.hidden[i] == 0 && dot(o, o) <= world.reach * world.reach)
        sets[world.ids[j]].insert(world.ids[i]);
    }
  }
  return sets;
}

/// What an index finds. Every span must lie in the cloud, and no boid may be in two.
template <int D>
Sets found_sets(RandomWorld world, NeighbourIndex& index) {
  std::vector<std::uint32_t> order;
  index.build(world.cloud(), world.reach, Workers(1), order);
  RC_ASSERT(order.empty() || order.size() == world.size());
  world.reorder_as(order);
  Sets sets;
  std::vector<Span> spans;
  for (std::size_t j = 0; j < world.size(); ++j) {
    if (world.hidden[j] != 0) continue;
    const auto place = place_of<D>(world, j);
    std::array<float, 3> at{};
    std::copy(place.at.begin(), place.at.end(), at.begin());
    index.spans(at, at, world.reach, spans);
    std::vector<int> times(world.size());
    for (const Span span : spans) {
      RC_ASSERT(span.begin <= span.end && span.end <= world.size());
      for (std::uint32_t i = span.begin; i < span.end; ++i) {
        ++times[i];
        const Vec<D> o = offset(place, place_of<D>(world, i), world.image());
        if (world.hidden[i] == 0 && dot(o, o) <= world.reach * world.reach)
          sets[world.ids[j]].insert(world.ids[i]);
      }
    }
    RC_ASSERT(std::all_of(times.begin(), times.end(), [](int n) { return n <= 1; }));
  }
  return sets;
}

Sets true_sets(const RandomWorld& world) {
  return world.dimensions == 3 ? true_sets<3>(world) : true_sets<2>(world);
}
Sets found_sets(const RandomWorld& world, NeighbourIndex& index) {
  return world.dimensions == 3 ? found_sets<3>(world, index) : found_sets<2>(world, index);
}

void expect_equal_sets(const RandomWorld& world) {
  const Sets truth = true_sets(world);
  Index wanted;
  wanted.kind = IndexKind::tree;
  wanted.leaf_size = *rc::gen::inRange(1, 20);
  wanted.depth_limit = *rc::gen::inRange(0, 20);
  RC_ASSERT(found_sets(world, *make_index(wanted, world.cloud(), world.reach)) == truth);
  wanted.kind = IndexKind::grid;
  RC_ASSERT(found_sets(world, *make_index(wanted, world.cloud(), world.reach)) == truth);
  wanted.kind = IndexKind::all_pairs;
  RC_ASSERT(found_sets(world, *make_index(wanted, world.cloud(), world.reach)) == truth);
}

RC_GTEST_PROP(NeighbourIndex, FindsTheSameSetsInOpenWorlds, ()) {
  for (int i = 0; i < 20; ++i) expect_equal_sets(random_world(false));
}
RC_GTEST_PROP(NeighbourIndex, FindsTheSameSetsInWrappedWorlds, ()) {
  for (int i = 0; i < 20; ++i) expect_equal_sets(random_world(true));
}

/// From a boid to the nearest place of a box, over the seam where that is shorter.
double distance_to(const RandomWorld& world, const IndexBox& box, std::size_t i) {
  double sum = 0;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    const double at = world.position[axis][i];
    double gap = infinity;
    for (const int turns : {-1, 0, 1}) {
      if (turns != 0 && !world.wraps) continue;
      const double image = at + turns * (double{world.max[axis]} - double{world.min[axis]});
      gap = std::min(gap, std::max({box.min[axis] - image, image - box.max[axis], 0.0}));
    }
    sum += gap * gap;
  }
  return std::sqrt(sum);
}

/// The box of some boids.
IndexBox box_around(const RandomWorld& world, std::initializer_list<std::size_t> boids) {
  IndexBox box;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    box.min[axis] = box.max[axis] = world.position[axis][*boids.begin()];
    for (const std::size_t i : boids) {
      box.min[axis] = std::min(box.min[axis], world.position[axis][i]);
      box.max[axis] = std::max(box.max[axis], world.position[axis][i]);
    }
  }
  return box;
}

void expect_batches(const RandomWorld& world, const NeighbourIndex& index) {
  std::vector<Span> batches;
  index.batches(batches);
  std::vector<int> times(world.size());
  for (const Span batch : batches) {
    RC_ASSERT(batch.begin < batch.end && batch.end <= world.size());
    RC_ASSERT(batch.end - batch.begin <= batch_size);
    for (std::uint32_t i = batch.begin; i < batch.end; ++i) ++times[i];
  }
  for (std::size_t i = 0; i < world.size(); ++i)
    RC_ASSERT(times[i] == 1 || (times[i] == 0 && world.hidden[i] != 0));
}

void expect_all_near_a_box(const RandomWorld& world, const NeighbourIndex& index) {
  if (world.size() == 0) return;
  const auto count = static_cast<int>(world.size());
  const auto one = static_cast<std::size_t>(*rc::gen::inRange(0, count));
  const auto other = static_cast<std::size_t>(*rc::gen::inRange(0, count));
  const IndexBox box = box_around(world, {one, other});
  std::vector<Span> spans;
  index.spans(box.min, box.max, world.reach, spans);
  std::vector<int> times(world.size());
  for (const Span span : spans) {
    for (std::uint32_t i = span.begin; i < span.end; ++i) ++times[i];
  }
  for (std::size_t i = 0; i < world.size(); ++i) {
    RC_ASSERT(times[i] <= 1);
    const bool is_near = distance_to(world, box, i) <= double{world.reach} * (1 - 1e-6);
    RC_ASSERT(times[i] == 1 || world.hidden[i] != 0 || !is_near);
  }
}

void expect_batches_and_boxes(RandomWorld world) {
  for (const IndexKind kind : {IndexKind::grid, IndexKind::tree, IndexKind::all_pairs}) {
    Index wanted;
    wanted.kind = kind;
    wanted.leaf_size = *rc::gen::inRange(1, 40);
    const auto index = make_index(wanted, world.cloud(), world.reach);
    std::vector<std::uint32_t> order;
    index->build(world.cloud(), world.reach, Workers(1), order);
    world.reorder_as(order);
    expect_batches(world, *index);
    for (int i = 0; i < 5; ++i) expect_all_near_a_box(world, *index);
  }
}

RC_GTEST_PROP(NeighbourIndex, BatchesHoldAllOnceAndBoxesMissNobodyInOpenWorlds, ()) {
  for (int i = 0; i < 10; ++i) expect_batches_and_boxes(random_world(false));
}
RC_GTEST_PROP(NeighbourIndex, BatchesHoldAllOnceAndBoxesMissNobodyInWrappedWorlds, ()) {
  for (int i = 0; i < 10; ++i) expect_batches_and_boxes(random_world(true));
}

// The real thing: the scenario's own indexes, on one step of every boundary and dimension.
std::map<std::uint64_t, Point> velocities_with(ScenarioDef scenario, const State& state, const Index& index) {
  scenario.index = index;
  Simulation simulation = world_from(scenario, state);
  simulation.step();
  std::map<std::uint64_t, Point> out;
  for (std::size_t i = 0; i < simulation.view().size(); ++i) {
    out[simulation.view().id(i)] = simulation.view().velocity(i);
  }
  return out;
}

RC_GTEST_PROP(NeighbourIndex, MakesTheSameStepToRounding, ()) {
  ScenarioDef scenario;
  scenario.space.dimensions = *rc::gen::inRange(2, 4);
  scenario.space.per_boid = *rc::gen::element(3.0, 300.0, 3e6);
  scenario.space.boundary.kind =
      *rc::gen::element(BoundaryKind::open, BoundaryKind::wrap, BoundaryKind::turn, BoundaryKind::bounce);
  scenario.seed = *rc::gen::inRange(0, 1000000);
  FlockDef& flock = scenario.flocks.front();
  flock.count = *rc::gen::inRange(0, 120);
  flock.field_of_view = *rc::gen::element(360.0, 200.0);
  flock.separation.front().sample = *rc::gen::element(1.0, 0.5);
  flock.cohesion.front().edge = Edge::closed;
  const State state = start(scenario).view().state();
  const auto exact = velocities_with(scenario, state, {.kind = IndexKind::all_pairs});
  const auto grid = velocities_with(scenario, state, {.kind = IndexKind::grid});
  const auto tree = velocities_with(scenario, state,
                                    {.kind = IndexKind::tree,
                                     .leaf_size = *rc::gen::inRange(1, 20),
                                     .depth_limit = *rc::gen::inRange(0, 20)});
  for (const auto& [id, velocity] : exact) {
    RC_ASSERT(distance(velocity, grid.at(id)) <= 1e-5 * flock.max_speed);
    RC_ASSERT(distance(velocity, tree.at(id)) <= 1e-5 * flock.max_speed);
  }
}

TEST(NeighbourIndex, NarrowWrappedSpacesFallBackToAllPairs) {
  RandomWorld world;
  world.wraps = true;
  world.max = {10, 10, 0};
  EXPECT_TRUE(may_divide(world.cloud(), 3.33f));
  EXPECT_FALSE(may_divide(world.cloud(), 3.34f));
  world.wraps = false;
  EXPECT_TRUE(may_divide(world.cloud(), 100));
}

TEST(NeighbourIndex, OneFarAwayDoesNotMakeAllCellsHuge) {
  RandomWorld world;
  world.max = {100, 100, 0};
  for (int i = 0; i < 2000; ++i) {
    world.position[0].push_back(static_cast<float>(i % 45) * 2);
    world.position[1].push_back(static_cast<float>(i / 45) * 2);
    world.hidden.push_back(0);
    world.ids.push_back(static_cast<std::uint64_t>(i));
  }
  world.position[0].back() = world.position[1].back() = 1e6f;
  const auto index = make_grid();
  std::vector<std::uint32_t> order;
  index->build(world.cloud(), 2, Workers(1), order);
  std::vector<Span> spans;
  index->spans({44, 44, 0}, {44, 44, 0}, 2, spans);
  std::size_t looked_at = 0;
  for (const Span span : spans) looked_at += span.end - span.begin;
  EXPECT_LT(looked_at, 100u);
}

TEST(NeighbourIndex, BoxesHoldTheirBoids) {
  RandomWorld world;
  world.max = {8, 8, 0};
  world.position = {std::vector<float>{0.5f, 7.5f, 7.6f}, std::vector<float>{0.5f, 7.5f, 7.4f}, {}};
  world.hidden = {0, 0, 0};
  world.ids = {0, 1, 2};
  for (const IndexKind kind : {IndexKind::grid, IndexKind::tree}) {
    const auto index = make_index({.kind = kind, .leaf_size = 1, .depth_limit = 10}, world.cloud(), 1);
    std::vector<std::uint32_t> order;
    index->build(world.cloud(), 1, Workers(1), order);
    std::vector<IndexBox> boxes;
    index->boxes(boxes);
    ASSERT_GE(boxes.size(), 2u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                              [&](const IndexBox& box) {
                                bool inside = true;
                                for (std::size_t axis = 0; axis < 2; ++axis) {
                                  const float at = world.position[axis][i];
                                  inside = inside && box.min[axis] <= at && at <= box.max[axis];
                                }
                                return inside;
                              }))
          << "boid " << i;
    }
  }
}

TEST(NeighbourIndex, TreeStopsAtItsDepthWhereAllAreAtOnePoint) {
  RandomWorld world;
  world.max = {1, 1, 0};
  world.position = {std::vector<float>(100, 0.3f), std::vector<float>(100, 0.3f), {}};
  world.hidden = std::vector<std::uint8_t>(100, 0);
  for (std::uint64_t id = 0; id < 100; ++id) world.ids.push_back(id);
  const auto index = make_tree(1, 40);
  std::vector<std::uint32_t> order;
  index->build(world.cloud(), 0.01f, Workers(1), order);
  std::vector<Span> spans;
  index->spans({0.3f, 0.3f, 0}, {0.3f, 0.3f, 0}, 0.01f, spans);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans.front().end - spans.front().begin, 100u);
}

}  // namespace
}  // namespace sturnus::test
