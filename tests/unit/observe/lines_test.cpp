// Paths and walls in draw lists: what stands for which, once each.
#include "observe/lines.h"

#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

std::vector<Segment> drawn(const ScenarioDef& scenario) {
  const Simulation simulation = start(scenario);
  DrawList list;
  SceneColours colours;
  colours.obstacle = {1, 2, 3, 255};
  add_lines(simulation.view(), colours, list);
  return list.segments;
}

ScenarioDef one_flock(int dimensions) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks[0].max_speed = 5;
  return scenario;
}

TEST(LineDrawing, PathsAreThinnerThanWallsAndLoopsAreClosed) {
  ScenarioDef scenario = one_flock(2);
  FollowPath path;
  path.points = {{0, 0}, {10, 0}, {10, 20}};
  scenario.flocks[0].follow_path = path;
  ASSERT_EQ(drawn(scenario).size(), 2u);
  EXPECT_EQ(drawn(scenario)[1].to, (Vec<3>{{10, 20, 0}}));
  const float width = drawn(scenario)[0].width;
  scenario.flocks[0].follow_path->loop = true;
  ASSERT_EQ(drawn(scenario).size(), 3u);
  EXPECT_EQ(drawn(scenario)[2].from, (Vec<3>{{10, 20, 0}}));
  EXPECT_EQ(drawn(scenario)[2].to, (Vec<3>{}));
  FollowWall wall;
  wall.points = {{0, 0}, {0, 30}};
  scenario.flocks[0].follow_path.reset();
  scenario.flocks[0].follow_wall = wall;
  ASSERT_EQ(drawn(scenario).size(), 1u);
  EXPECT_GT(drawn(scenario)[0].width, width);
  EXPECT_EQ(drawn(scenario)[0].layer, Layer::below);
}

TEST(LineDrawing, WhatSeveralFlocksFollowIsDrawnOnceAndWhatIsOffNotAtAll) {
  ScenarioDef scenario = one_flock(2);
  FollowPath path;
  path.points = {{0, 0}, {10, 0}};
  scenario.flocks[0].follow_path = path;
  scenario.flocks.push_back(scenario.flocks[0]);
  scenario.flocks[1].name = "others";
  EXPECT_EQ(drawn(scenario).size(), 1u);
  scenario.flocks[1].follow_path->points[1] = {0, 10};
  EXPECT_EQ(drawn(scenario).size(), 2u);
  scenario.flocks[1].follow_path->on = false;
  EXPECT_EQ(drawn(scenario).size(), 1u);
}

TEST(LineDrawing, InSpaceAWallHasFootTopAndPosts) {
  ScenarioDef scenario = one_flock(3);
  FollowWall wall;
  wall.points = {{0, 0}, {10, 0}, {10, 20}};
  scenario.flocks[0].follow_wall = wall;
  const std::vector<Segment> lines = drawn(scenario);
  ASSERT_EQ(lines.size(), 2u + 2u + 3u);
  const Extent extent = extent_of(scenario);
  EXPECT_EQ(double{lines[0].from[2]}, extent.min[2]);
  EXPECT_EQ(double{lines[2].from[2]}, extent.max[2]);
}

}  // namespace
}  // namespace sturnus::test
