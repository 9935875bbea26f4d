// Lists of neighbours: nearest first, ties by id, nobody hidden.
#include "neighbours/query.h"

#include <gtest/gtest.h>

#include "worlds.h"

namespace sturnus::test {
namespace {

// A line of boids at x = 0, 1, 2, ... 9 of a world of [0, 10], the one at 3 hidden.
RandomWorld line(bool wraps) {
  RandomWorld world;
  world.wraps = wraps;
  world.reach = 3;
  world.max = {10, 10, 0};
  for (std::uint64_t i = 0; i < 10; ++i) {
    world.position[0].push_back(static_cast<float>(i));
    world.position[1].push_back(0);
    world.hidden.push_back(i == 3 ? 1 : 0);
    world.ids.push_back(i);
  }
  return world;
}

std::vector<std::uint64_t> nearest_ids(RandomWorld world, float x, std::size_t k, float radius) {
  const auto index = make_grid();
  std::vector<std::uint32_t> order;
  index->build(world.cloud(), world.reach, Workers(1), order);
  world.reorder_as(order);
  const Neighbourhood among{index.get(), world.cloud(), world.image(), world.ids};
  std::vector<std::uint64_t> ids;
  for (const Found& found : nearest<2>(among, {{x, 0}}, k, radius)) ids.push_back(found.id);
  return ids;
}

using Ids = std::vector<std::uint64_t>;

TEST(Nearest, NearestFirstAndTiesById) {
  EXPECT_EQ(nearest_ids(line(false), 5, 3, 3), (Ids{5, 4, 6}));
  EXPECT_EQ(nearest_ids(line(false), 5.6f, 2, 3), (Ids{6, 5}));
}

TEST(Nearest, FewerWhereThereAreFewer) {
  EXPECT_EQ(nearest_ids(line(false), 5, 99, 1.5f), (Ids{5, 4, 6}));
  EXPECT_EQ(nearest_ids(line(false), 5, 99, 1), (Ids{5}));  // the edge is open
  EXPECT_EQ(nearest_ids(line(false), 5, 0, 3), Ids{});
}

TEST(Nearest, LooksOverTheSeamAndPastTheHidden) {
  EXPECT_EQ(nearest_ids(line(true), 0, 3, 2.5f), (Ids{0, 1, 9}));
  EXPECT_EQ(nearest_ids(line(false), 0, 3, 2.5f), (Ids{0, 1, 2}));
  EXPECT_EQ(nearest_ids(line(false), 3, 2, 2.5f), (Ids{2, 4}));
}

TEST(Offset, TakesTheNearestImageByComparison) {
  const Wrapping image{true, {10, 10, 0}, {5, 5, 0}};
  EXPECT_EQ(offset<2>({{1, 1}}, {{9, 2}}, image), (Vec<2>{{-2, 1}}));
  EXPECT_EQ(offset<2>({{9, 2}}, {{1, 1}}, image), (Vec<2>{{2, -1}}));
  EXPECT_EQ(offset<2>({{0, 0}}, {{5, 0}}, image), (Vec<2>{{5, 0}}));  // exactly half stays
  EXPECT_EQ(offset<2>({{5, 0}}, {{0, 0}}, image), (Vec<2>{{-5, 0}}));
  EXPECT_EQ(offset<2>({{1, 1}}, {{9, 2}}, {}), (Vec<2>{{8, 1}}));
}

}  // namespace
}  // namespace sturnus::test
