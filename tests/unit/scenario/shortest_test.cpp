// The shortest scenario shows a flock: polarisation above 0.7 within 600 steps, at both sizes and in 2D and
// 3D.
#include <gtest/gtest.h>

#include <cstdio>

#include "support.h"

namespace sturnus::test {
namespace {

/// Steps until the polarisation is above 0.7, or 601.
int steps_to_order(int count, int dimensions) {
  std::string text = "[[flock]]\ncount = " + std::to_string(count) + "\n";
  if (dimensions == 3) text += "[space]\ndimensions = 3\n";
  Simulation simulation = start(take(parse_scenario(text, "shortest.toml")), 2);
  int steps = 0;
  for (; steps <= 600 && order_of(simulation.view()) <= 0.7; ++steps) simulation.step();
  std::printf("%d boids in %dD: polarisation %.3f after %d steps\n", count, dimensions,
              order_of(simulation.view()), steps);
  EXPECT_EQ(simulation.report().quarantined, 0u);
  return steps;
}

TEST(ShortestScenario, FlocksWithThreeHundredIn2D) {
  EXPECT_LE(steps_to_order(300, 2), 600);
}
TEST(ShortestScenario, FlocksWithThreeHundredIn3D) {
  EXPECT_LE(steps_to_order(300, 3), 600);
}
TEST(ShortestScenario, FlocksWithThreeThousandIn2D) {
  EXPECT_LE(steps_to_order(3000, 2), 600);
}
TEST(ShortestScenario, FlocksWithThreeThousandIn3D) {
  EXPECT_LE(steps_to_order(3000, 3), 600);
}

}  // namespace
}  // namespace sturnus::test
