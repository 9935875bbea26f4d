// Obstacles in draw lists: what stands for which kind, and the images across a seam.
#include "observe/obstacles.h"

#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

DrawList drawn(const ScenarioDef& scenario) {
  const Simulation simulation = start(scenario);
  DrawList list;
  SceneColours colours;
  colours.obstacle = {1, 2, 3, 255};
  add_obstacles(simulation.view(), colours, list);
  return list;
}

ScenarioDef world(int dimensions, BoundaryKind boundary) {
  ScenarioDef scenario;
  const auto axes = static_cast<std::size_t>(dimensions);
  scenario.space.dimensions = dimensions;
  scenario.space.min = Coordinates(axes, 0.0);
  scenario.space.max = Coordinates(axes, 100.0);
  scenario.space.boundary.kind = boundary;
  scenario.flocks.front().count = 1;
  return scenario;
}

TEST(ObstacleDrawing, InThePlaneIsDiscsRectanglesAndLines) {
  ScenarioDef scenario = world(2, BoundaryKind::bounce);
  scenario.obstacles = {{{{50, 50, 5}}, {{10, 10, 20, 30}}, {{0, 40, 0, 1}}, {}}};
  const DrawList list = drawn(scenario);
  ASSERT_EQ(list.rings.size(), 2u);  // the disc and its rim
  EXPECT_EQ(list.rings[0].radius, 5);
  EXPECT_EQ(list.rings[0].width, 0);
  EXPECT_EQ(list.rings[1].colour, (Rgba{1, 2, 3, 255}));
  ASSERT_EQ(list.boxes.size(), 1u);
  EXPECT_EQ(list.boxes[0].high, (Vec<3>{{20, 30, 0}}));
  ASSERT_EQ(list.segments.size(), 1u);
  EXPECT_EQ(list.segments[0].from[1], 40);
  EXPECT_EQ(list.segments[0].to[1], 40);
}

TEST(ObstacleDrawing, InSpaceIsBallsFacesAndOutlines) {
  ScenarioDef scenario = world(3, BoundaryKind::bounce);
  scenario.obstacles = {{{{50, 50, 50, 5}}, {{10, 10, 10, 20, 30, 40}}, {{0, 40, 0, 0, 1, 0}}, {}}};
  const DrawList list = drawn(scenario);
  ASSERT_EQ(list.glyphs.size(), 1u);
  EXPECT_EQ(list.glyphs[0].kind, GlyphKind::ball);
  EXPECT_EQ(list.glyphs[0].size, 10);
  EXPECT_EQ(list.facets.size(), 12u);
  EXPECT_EQ(list.segments.size(), 4u);
}

TEST(ObstacleDrawing, ShowsTheImagesThatReachIntoAWrappedSpace) {
  ScenarioDef scenario = world(2, BoundaryKind::wrap);
  scenario.obstacles = {{{{2, 50, 5}, {98, 97, 5}, {50, 50, 5}}, {}, {}, {}}};
  EXPECT_EQ(drawn(scenario).rings.size(), 2u * (2 + 4 + 1));
}

}  // namespace
}  // namespace sturnus::test
