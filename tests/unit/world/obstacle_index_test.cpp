// The obstacle index: whatever is asked, nobody in reach is left out, in the order of the obstacles.
#include "world/obstacle_index.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <set>

namespace sturnus {
namespace {

struct World {
  Model model;
  std::vector<Obstacle> obstacles;
};

World random_world(int dimensions, BoundaryKind boundary, unsigned seed, std::size_t count, float largest) {
  std::mt19937 draw(seed);
  std::uniform_real_distribution<float> place(-50, 50), part(0, 1);
  World world;
  world.model.dimensions = dimensions;
  world.model.boundary = boundary;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    world.model.min[axis] = -50;
    world.model.max[axis] = 50;
    world.model.size[axis] = 100;
  }
  for (std::size_t i = 0; i < count; ++i) {
    Obstacle obstacle;
    const bool may_be_plane = boundary != BoundaryKind::wrap;
    obstacle.kind = i % 7 == 3                    ? ObstacleKind::box
                    : i % 31 == 5 && may_be_plane ? ObstacleKind::plane
                                                  : ObstacleKind::sphere;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      obstacle.at[axis] = place(draw);
      if (obstacle.kind == ObstacleKind::box) obstacle.half[axis] = 0.1f + largest * part(draw);
      if (obstacle.kind == ObstacleKind::plane) obstacle.normal[axis] = axis == 0 ? 1.0f : 0.0f;
    }
    if (obstacle.kind == ObstacleKind::sphere) obstacle.radius = 0.1f + largest * part(draw);
    world.obstacles.push_back(obstacle);
  }
  return world;
}

// The distance to the nearest image's surface, by trying them all.
template <int D>
double distance(const World& world, const Obstacle& obstacle, const Vec<D>& at) {
  double least = 1e30;
  const int images = world.model.wraps() ? 1 : 0;
  for (int x = -images; x <= images; ++x) {
    for (int y = -images; y <= images; ++y) {
      for (int z = D == 3 ? -images : 0; z <= (D == 3 ? images : 0); ++z) {
        const int shift[] = {x, y, z};
        Place<D> o = place_of<D>(obstacle.at) - place_of(at);
        for (int axis = 0; axis < D; ++axis) o[axis] += 100.0 * shift[axis];
        double found = surface(obstacle, o, 0).distance;
        if (obstacle.kind == ObstacleKind::box && found > 0) found = length(way_to_box(obstacle, o));
        least = std::min(least, found);
      }
    }
  }
  return least;
}

template <int D>
void expect_all_in_reach(const World& world, float reach, unsigned seed) {
  ObstacleIndex index;
  index.fit(world.model, world.obstacles, reach);
  std::mt19937 draw(seed);
  // Boids may be outside of a space that does not wrap.
  const float far = world.model.wraps() ? 50.0f : 70.0f;
  std::uniform_real_distribution<float> place(-far, far);
  for (int question = 0; question < 50; ++question) {
    Vec<D> at;
    for (int axis = 0; axis < D; ++axis) at[axis] = place(draw);
    const double asked = question % 5 == 0 ? 2.0 * reach : double{reach} * (question % 3) / 2;
    std::vector<std::size_t> found;
    index.visit(at, asked, [&](const Obstacle& obstacle) {
      const std::size_t from = found.empty() ? 0 : found.back() + 1;
      std::size_t number = from;
      while (number < world.obstacles.size() && !(world.obstacles[number] == obstacle)) ++number;
      RC_ASSERT(number < world.obstacles.size());  // in order, and each once
      found.push_back(number);
    });
    const std::set<std::size_t> seen(found.begin(), found.end());
    for (std::size_t number = 0; number < world.obstacles.size(); ++number) {
      if (distance(world, world.obstacles[number], at) <= asked) RC_ASSERT(seen.count(number) == 1);
    }
  }
}

RC_GTEST_PROP(ObstacleIndex, LeavesOutNobodyInReach, ()) {
  const auto boundary = *rc::gen::element(BoundaryKind::wrap, BoundaryKind::bounce, BoundaryKind::open);
  const unsigned seed = *rc::gen::inRange(0u, 100000u);
  const auto count = *rc::gen::inRange<std::size_t>(0, 90);
  const auto largest = *rc::gen::element(0.5f, 5.0f, 40.0f);
  const auto reach = *rc::gen::element(0.0f, 0.3f, 4.0f, 30.0f, 300.0f);
  expect_all_in_reach<2>(random_world(2, boundary, seed, count, largest), reach, seed);
  expect_all_in_reach<3>(random_world(3, boundary, seed, count, largest), reach, seed);
}

TEST(ObstacleIndex, AsksFewOfMany) {
  const World world = random_world(3, BoundaryKind::wrap, 1, 5000, 1.0f);
  ObstacleIndex index;
  index.fit(world.model, world.obstacles, 5);
  std::size_t asked = 0;
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<float>(i % 10) * 10.0f - 50.0f, y = static_cast<float>(i) - 50.0f;
    index.visit(Vec<3>{{x, y, 0.3f}}, 5, [&](const Obstacle&) { ++asked; });
  }
  EXPECT_LT(asked / 100, 60u);
  EXPECT_GT(asked, 0u);
}

TEST(ObstacleIndex, FollowsWhatChanges) {
  World world = random_world(2, BoundaryKind::open, 2, 3, 1.0f);
  ObstacleIndex index;
  const auto count = [&](double reach) {
    int sum = 0;
    index.visit(Vec<2>{}, reach, [&](const Obstacle&) { ++sum; });
    return sum;
  };
  index.fit(world.model, world.obstacles, 1000);
  EXPECT_EQ(count(1000), 3);
  world.obstacles.pop_back();
  index.fit(world.model, world.obstacles, 1000);
  EXPECT_EQ(count(1000), 2);
  index.forget();
  EXPECT_TRUE(index.empty());
  index.fit(world.model, {}, 1000);
  EXPECT_EQ(count(1000), 0);
}

}  // namespace
}  // namespace sturnus
