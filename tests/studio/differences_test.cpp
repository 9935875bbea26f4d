// What changed between two readings of a scenario, and that setting it leads from one to the other.
#include "session/differences.h"

#include <gtest/gtest.h>
#include <sturnus/files.h>
#include <sturnus/parameters.h>

namespace studio {
namespace {

using sturnus::ScenarioDef;

ScenarioDef shipped(const char* name) {
  return *sturnus::load_scenario(name);
}

void set(ScenarioDef& scenario, const char* path, const char* value) {
  const auto status = sturnus::set_parameter(scenario, path, sturnus::parse_value(value));
  ASSERT_TRUE(status) << status.error();
}

TEST(StudioDifferences, AScenarioDoesNotDifferFromItself) {
  for (const sturnus::ShippedScenario& one : sturnus::shipped_scenarios()) {
    const ScenarioDef scenario = shipped(one.name);
    const Differences found = differences(scenario, scenario);
    EXPECT_TRUE(found.set.empty()) << one.name << ": " << found.set.front().path;
    EXPECT_TRUE(found.is_all) << one.name;
  }
}

TEST(StudioDifferences, FindsExactlyWhatWasSet) {
  const ScenarioDef before = shipped("ucsd");
  ScenarioDef after = before;
  set(after, "flock.birds.separation.weight", "0.25");
  set(after, "flock.birds.cohesion.on", "false");
  set(after, "space.boundary.strength", "1");
  after.title = "Another title";
  const Differences found = differences(before, after);
  const std::vector<Difference> expected = {{"flock.birds.cohesion.on", "false"},
                                            {"flock.birds.separation.weight", "0.25"},
                                            {"space.boundary.strength", "1"}};
  EXPECT_EQ(found.set, expected);
  EXPECT_TRUE(found.is_all);
}

TEST(StudioDifferences, WhatComesOrGoesIsMoreThanParameters) {
  const ScenarioDef before = shipped("ucsd");
  ScenarioDef more = before;
  more.flocks.push_back(more.flocks[0]);
  more.flocks[1].name = "others";
  EXPECT_FALSE(differences(before, more).is_all);
  EXPECT_FALSE(differences(more, before).is_all);
  ScenarioDef with_event = before;
  with_event.run.events.push_back({10, sturnus::EraseBoids{{0, 0}, 5}});
  EXPECT_FALSE(differences(before, with_event).is_all);
}

TEST(StudioDifferences, AreSetInAnOrderThatIsRightAtAllTimes) {
  const ScenarioDef before = shipped("ucsd");  // speeds from 5 to 10
  ScenarioDef after = before;
  after.flocks[0].max_speed = 20;
  after.flocks[0].min_speed = 15;
  World world(std::move(*sturnus::open_simulation(before, 1)), std::size_t{64} << 20);
  ASSERT_TRUE(set_all(world, {{"flock.birds.min_speed", "15"}, {"flock.birds.max_speed", "20"}}, "reload"));
  EXPECT_EQ(to_toml(world.simulation().scenario()), to_toml(after));
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(to_toml(world.simulation().scenario()), to_toml(before)) << "more than one deed";
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(to_toml(world.simulation().scenario()), to_toml(after));
}

TEST(StudioDifferences, AreOneDeedAlsoWhereATermComes) {
  const ScenarioDef before = shipped("ucsd");
  World world(std::move(*sturnus::open_simulation(before, 1)), std::size_t{64} << 20);
  ASSERT_TRUE(set_all(world,
                      {{"flock.birds.cohesion.weight", "7"},
                       {"flock.birds.noise.turn", "3"},
                       {"flock.birds.separation.weight", "2"}},
                      "reload"));
  const std::string after = to_toml(world.simulation().scenario());
  ASSERT_TRUE(world.undo());
  EXPECT_EQ(to_toml(world.simulation().scenario()), to_toml(before));
  EXPECT_FALSE(world.undo());
  ASSERT_TRUE(world.redo());
  EXPECT_EQ(to_toml(world.simulation().scenario()), after);
}

TEST(StudioDifferences, AreNotSetByHalves) {
  const ScenarioDef before = shipped("ucsd");
  World world(std::move(*sturnus::open_simulation(before, 1)), std::size_t{64} << 20);
  const auto status =
      set_all(world, {{"flock.birds.cohesion.weight", "7"}, {"flock.birds.count", "3"}}, "reload");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().find("count"), std::string::npos) << status.error();
  EXPECT_EQ(to_toml(world.simulation().scenario()), to_toml(before));
}

}  // namespace
}  // namespace studio
