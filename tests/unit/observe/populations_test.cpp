// How many there are of each flock: measured, written and plotted.
#include <gtest/gtest.h>
#include <sturnus/measure.h>
#include <sturnus/render.h>

#include <algorithm>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef two_flocks() {
  ScenarioDef scenario = bare(2);
  scenario.flocks[0].name = "prey";
  scenario.flocks[0].body_radius = 1;
  scenario.flocks.push_back(scenario.flocks[0]);
  scenario.flocks[1].name = "hunters";
  scenario.flocks[1].max_speed = 5;
  scenario.flocks[1].hunt = Hunt{.prey = {"prey"}, .sight = 100, .weight = 0};
  return scenario;
}

const std::vector<Placed> boids = {{{0, 0}, {}}, {{50, 0}, {}}, {{90, 0}, {}}, {{51, 0}, {}, 1}};

TEST(Populations, AreMeasuredForEachFlockAndFallWhereSomebodyIsEaten) {
  Simulation simulation = world_of(two_flocks(), boids);
  EXPECT_EQ(measure(simulation.view()).populations, (std::vector<std::size_t>{3, 1}));
  simulation.step();
  EXPECT_EQ(measure(simulation.view()).populations, (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(simulation.report().eaten, 1u);
}

TEST(Populations, AreTheLastColumnsOfSeveralFlocksOnly) {
  const ScenarioDef several = two_flocks();
  const Simulation simulation = world_of(several, boids);
  EXPECT_TRUE(measures_header(several).ends_with(",largest_cluster,population.prey,population.hunters"));
  EXPECT_TRUE(measures_line(measure(simulation.view())).ends_with(",3,1"));
  const ScenarioDef one = bare(2);
  EXPECT_TRUE(measures_header(one).ends_with(",largest_cluster"));
  const Simulation alone = world_of(one, {{{0, 0}, {}}, {{5, 0}, {}}});
  const std::string line = measures_line(measure(alone.view()));
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), 9);
}

TEST(Populations, HaveAPanelWhereTheyChange) {
  const ScenarioDef scenario = two_flocks();
  Simulation simulation = world_of(scenario, boids);
  std::vector<Measures> rows = {measure(simulation.view())};
  rows.push_back(rows.front());
  rows.back().step = 1;
  const int without = plot_measures(rows, scenario, ThemeName::dark).height;
  rows.back().populations = {2, 1};
  EXPECT_GT(plot_measures(rows, scenario, ThemeName::dark).height, without);
}

}  // namespace
}  // namespace sturnus::test
