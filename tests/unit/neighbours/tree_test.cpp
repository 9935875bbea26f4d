// The tree on worlds of every kind: whom it finds, in which order boids stand, how deep it goes, how it cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "worlds.h"

namespace sturnus::test {
namespace {

/// A world of `count` boids whose coordinates are given one by one.
RandomWorld world_of(int dimensions, bool wraps, int count, const std::function<float(int)>& coordinate) {
  RandomWorld world;
  world.dimensions = dimensions;
  world.wraps = wraps;
  world.reach = 2;
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    world.min[axis] = -5;
    world.max[axis] = 11;
  }
  for (int i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < world.axes(); ++axis) world.position[axis].push_back(coordinate(i));
    world.hidden.push_back(0);
    world.ids.push_back(static_cast<std::uint64_t>(i));
  }
  return world;
}

/// The tree of a world, which then stands in the tree's order.
struct Grown {
  RandomWorld world;
  std::unique_ptr<NeighbourIndex> tree;
  std::vector<std::uint32_t> order;

  explicit Grown(RandomWorld of, int leaf_size = 16, int depth = 16, int threads = 1)
      : world(std::move(of)), tree(make_tree(leaf_size, depth)) {
    tree->build(world.cloud(), world.reach, Workers(threads), order);
    world.reorder_as(order);
  }
  std::array<float, 3> place(std::size_t i) const {
    std::array<float, 3> at{};
    for (std::size_t axis = 0; axis < world.axes(); ++axis) at[axis] = world.position[axis][i];
    return at;
  }
  std::vector<Span> spans(const std::array<float, 3>& low, const std::array<float, 3>& high) const {
    std::vector<Span> spans;
    tree->spans(low, high, world.reach, spans);
    return spans;
  }
  /// How often each slot is in a span around a boid.
  std::vector<int> times(std::size_t i) const {
    std::vector<int> times(world.size());
    for (const Span span : spans(place(i), place(i))) {
      for (std::uint32_t slot = span.begin; slot < span.end; ++slot) ++times[slot];
    }
    return times;
  }
  std::vector<Span> batches() const {
    std::vector<Span> batches;
    tree->batches(batches);
    return batches;
  }
  std::vector<IndexBox> boxes() const {
    std::vector<IndexBox> boxes;
    tree->boxes(boxes);
    return boxes;
  }
  bool is_near(std::size_t i, std::size_t j) const {
    float sum = 0;
    for (std::size_t axis = 0; axis < world.axes(); ++axis) {
      const Vec<2> from{{world.position[axis][i], 0}};
      const Vec<2> to{{world.position[axis][j], 0}};
      Wrapping image{world.wraps, {}, {}};
      image.size[0] = world.image().size[axis];
      image.half[0] = world.image().half[axis];
      const float one = offset(from, to, image)[0];
      sum += one * one;
    }
    return sum <= world.reach * world.reach;
  }
};

void expect_all_found(const Grown& grown, const std::string& name) {
  for (std::size_t i = 0; i < grown.world.size(); ++i) {
    const auto times = grown.times(i);
    for (std::size_t j = 0; j < grown.world.size(); ++j) {
      ASSERT_LE(times[j], 1) << name;
      ASSERT_TRUE(times[j] == 1 || !grown.is_near(i, j)) << name << ": " << i << " misses " << j;
    }
  }
}

struct Kind {
  const char* name;
  int count;
  std::function<float(int)> coordinate;
};

std::vector<Kind> kinds(std::mt19937& random) {
  const auto unit = [&random] { return static_cast<float>(random() % 65536) / 65536; };
  const auto uniform = [=](int) { return -5 + 16 * unit(); };
  return {{"uniform", 300, uniform},
          {"clumped", 300, [=](int i) { return static_cast<float>(i % 7) * 2 - 5 + 0.01f * unit(); }},
          {"one point", 300, [](int) { return 3.3f; }},
          {"on the border", 100, [](int i) { return i % 2 == 0 ? -5.0f : std::nextafter(11.0f, 0.0f); }},
          {"empty", 0, uniform},
          {"one boid", 1, uniform}};
}

std::vector<Kind> lost_kinds(std::mt19937& random) {
  const auto unit = [&random] { return static_cast<float>(random() % 65536) / 65536; };
  const auto lost = [=](float where) {
    return [=](int i) { return i == 17 ? where : i == 30 ? -where : -5 + 16 * unit(); };
  };
  return {{"a million away", 200, lost(1e6f)},
          {"1e15 away", 200, lost(1e15f)},
          {"half of them lost", 200, [=](int i) { return unit() * (i % 2 == 0 ? 1.0f : 1e12f); }},
          {"one point and far apart", 200, [=](int i) { return i < 150 ? 1.0f : 1e9f * unit(); }}};
}

TEST(Tree, FindsEverybodyNearInWorldsOfEveryKind) {
  std::mt19937 random(7);
  for (const int dimensions : {2, 3}) {
    for (const bool wraps : {false, true}) {
      auto all = kinds(random);
      if (!wraps) {
        for (Kind& kind : lost_kinds(random)) all.push_back(std::move(kind));
      }
      for (const Kind& kind : all) {
        const auto world = world_of(dimensions, wraps, kind.count, kind.coordinate);
        for (const int leaf_size : {1, 16}) {
          for (const int depth : {0, 3, 40}) expect_all_found(Grown(world, leaf_size, depth), kind.name);
        }
      }
    }
  }
}

bool are_equal(const std::vector<Span>& one, const std::vector<Span>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](Span a, Span b) { return a.begin == b.begin && a.end == b.end; });
}

RandomWorld crowd(int dimensions, int count) {
  std::mt19937 random(3);
  return world_of(dimensions, false, count,
                  [&](int) { return -5 + 16 * static_cast<float>(random() % 9973) / 9973; });
}

TEST(Tree, IsTheSameForAnyNumberOfThreads) {
  for (const int dimensions : {2, 3}) {
    RandomWorld world = crowd(dimensions, 30000);
    for (std::size_t i = 0; i < world.size(); i += 97) world.hidden[i] = 1;
    const Grown one(world, 16, 16, 1);
    for (const int threads : {2, 7}) {
      const Grown other(world, 16, 16, threads);
      EXPECT_EQ(one.order, other.order);
      EXPECT_TRUE(are_equal(one.batches(), other.batches()));
      EXPECT_TRUE(are_equal(one.spans({1, 1, 1}, {2, 2, 2}), other.spans({1, 1, 1}, {2, 2, 2})));
    }
  }
}

TEST(Tree, KeepsNothingOfTheCloudBefore) {
  Grown kept(crowd(3, 5000));
  for (const int count : {700, 0, 3000}) {
    const Grown fresh(crowd(2, count));
    kept.world = crowd(2, count);
    kept.tree->build(kept.world.cloud(), kept.world.reach, Workers(1), kept.order);
    EXPECT_EQ(kept.order, fresh.order);
    EXPECT_TRUE(are_equal(kept.batches(), fresh.batches()));
    EXPECT_EQ(kept.boxes().size(), fresh.boxes().size());
    EXPECT_TRUE(are_equal(kept.spans({0, 0, 0}, {3, 3, 0}), fresh.spans({0, 0, 0}, {3, 3, 0})));
  }
}

TEST(Tree, TiesKeepTheOrderThatWasAndHiddenBoidsComeLast) {
  RandomWorld world = world_of(2, false, 1000, [](int i) { return i % 2 == 0 ? 1.0f : 9.0f; });
  world.hidden[10] = world.hidden[11] = world.hidden[500] = 1;
  world.position[0][500] = std::numeric_limits<float>::quiet_NaN();
  const Grown grown(world);
  std::vector<std::uint32_t> expected(1000);
  std::iota(expected.begin(), expected.end(), 0u);
  const auto place_in_line = [](std::uint32_t i) {
    return std::pair(i == 10 || i == 11 || i == 500 ? 2u : i % 2, i);
  };
  std::sort(expected.begin(), expected.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place_in_line(a) < place_in_line(b); });
  EXPECT_EQ(grown.order, expected);
  for (const Span batch : grown.batches()) EXPECT_LE(batch.end, 997u);
  for (const Span span : grown.spans({-5, -5, 0}, {11, 11, 0})) EXPECT_LE(span.end, 997u);
}

TEST(Tree, IsNeverDeeperThanItsLimit) {
  for (const int dimensions : {2, 3}) {
    for (const int depth : {0, 1, 2}) {
      const Grown grown(crowd(dimensions, 5000), 1, depth);
      EXPECT_EQ(grown.boxes().size(), std::size_t{1} << (depth * dimensions));
      for (const IndexBox& box : grown.boxes()) EXPECT_EQ(box.max[0] - box.min[0], std::ldexp(16.0f, -depth));
    }
  }
}

TEST(Tree, ALeafHoldsNoMoreBoidsThanAsked) {
  const Grown grown(crowd(2, 2000), 5, 40);
  std::size_t found = 0;
  for (const IndexBox& box : grown.boxes()) {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < grown.world.size(); ++i) {
      const auto at = grown.place(i);
      inside += box.min[0] <= at[0] && at[0] < box.max[0] && box.min[1] <= at[1] && at[1] < box.max[1];
    }
    EXPECT_LE(inside, 5u);
    found += inside;
  }
  EXPECT_EQ(found, grown.world.size());
}

TEST(Tree, AStrayDoesNotMakeAllCellsHuge) {
  for (const int dimensions : {2, 3}) {
    for (const float far : {1e6f, 1e15f}) {
      RandomWorld world = crowd(dimensions, 10000);
      for (std::size_t axis = 0; axis < world.axes(); ++axis) world.position[axis][4321] = far;
      world.reach = 0.2f;
      const Grown grown(world);
      const auto times = grown.times(100);
      EXPECT_LT(std::accumulate(times.begin(), times.end(), 0), 200) << far;
    }
  }
}

TEST(Tree, ATinyClumpInAHugeWorldIsDivided) {
  RandomWorld world = crowd(2, 10000);
  world.min = {-1e6f, -1e6f, 0};
  world.max = {1e6f, 1e6f, 0};
  world.reach = 0.2f;
  const Grown grown(world, 16, 16);
  const auto times = grown.times(100);
  EXPECT_LT(std::accumulate(times.begin(), times.end(), 0), 200);
}

TEST(Tree, EndsSoonWhereManyAreAtOnePoint) {
  const Grown grown(world_of(2, false, 200000, [](int) { return 0.7f; }), 1, 40);
  EXPECT_EQ(grown.boxes().size(), 1u);
  EXPECT_EQ(grown.batches().size(), 200000u / batch_size);
  EXPECT_EQ(grown.spans({0.7f, 0.7f, 0}, {0.7f, 0.7f, 0}).size(), 1u);
}

TEST(Tree, BatchesAreWellFilledAndEndWhereTheLineJumps) {
  for (const int dimensions : {2, 3}) {
    EXPECT_LT(Grown(crowd(dimensions, 20000)).batches().size(), 20000u / 12) << dimensions;
    // Clumps of 200, far apart.
    std::mt19937 random(5);
    const Grown clumps(world_of(dimensions, false, 2000, [&](int i) {
      return 100 * static_cast<float>(i / 200) + static_cast<float>(random() % 1000) / 1000;
    }));
    for (const Span batch : clumps.batches()) {
      const auto first = clumps.world.ids[batch.begin] / 200;
      for (std::uint32_t i = batch.begin; i < batch.end; ++i) EXPECT_EQ(clumps.world.ids[i] / 200, first);
    }
  }
}

}  // namespace
}  // namespace sturnus::test
