// The reference of "Animation: Boids" (UCSD CSE 167) against cases small enough for paper, one or two rules
// at a time.
#include <cmath>
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

// --- UCSD CSE 167, "Animation: Boids". World 1280 x 720, margins 200 and 160, so (600, 360) is far from any
// edge. ---

UcsdParameters ucsd_only(double separation, double alignment, double cohesion) {
  UcsdParameters parameters;
  parameters.separation_weight = separation;
  parameters.alignment_weight = alignment;
  parameters.cohesion_weight = cohesion;
  return parameters;
}

TEST(Ucsd, SeparationIsTheMeanOffset) {  // (S0-5)
  // ((-10, 0) + (0, -20)) / 2 = (-5, -10); times 0.02 = (-0.1, -0.2).
  const Boids flock = boids({{{600, 360}, {6, 0}}, {{610, 360}, {6, 0}}, {{600, 380}, {6, 0}}});
  const Step step = ucsd(flock, ucsd_only(0.02, 0, 0));
  EXPECT_TRUE(near(step.next.velocity[0], {5.9, -0.2}));
  EXPECT_TRUE(near(step.next.position[0], {605.9, 359.8}));  // moved by the new velocity (S0-2)
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Ucsd, SeparationHasAnOpenEdge) {
  const UcsdParameters parameters = ucsd_only(0.02, 0, 0);
  const Step on = ucsd(boids({{{600, 360}, {6, 0}}, {{630, 360}, {6, 0}}}), parameters);
  EXPECT_TRUE(near(on.next.velocity[0], {6, 0}));
  EXPECT_TRUE(on.exempt[0]);
  // d = 29: -29 * 0.02 = -0.58.
  const Step inside = ucsd(boids({{{600, 360}, {6, 0}}, {{629, 360}, {6, 0}}}), parameters);
  EXPECT_TRUE(near(inside.next.velocity[0], {5.42, 0}));
  EXPECT_FALSE(inside.exempt[0]);
}

TEST(Ucsd, CohesionPullsToTheMeanPosition) {  // (S0-6)
  // Mean of (700, 360) and (600, 400) is (650, 380), so F_c = (50, 20); times 0.001 = (0.05, 0.02).
  // The third neighbour is exactly 150 away, and the edge is open.
  const Boids flock =
      boids({{{600, 360}, {6, 0}}, {{700, 360}, {6, 0}}, {{600, 400}, {6, 0}}, {{600, 510}, {6, 0}}});
  EXPECT_TRUE(near(ucsd(flock, ucsd_only(0, 0, 0.001)).next.velocity[0], {6.05, 0.02}));
}

TEST(Ucsd, AlignmentTurnsToTheMeanVelocity) {  // (S0-7)
  // Mean of (8, 0) and (6, 4) is (7, 2), so F_a = (1, 2); times 0.03 = (0.03, 0.06).
  const Boids flock = boids({{{600, 360}, {6, 0}}, {{700, 360}, {8, 0}}, {{600, 400}, {6, 4}}});
  EXPECT_TRUE(near(ucsd(flock, ucsd_only(0, 0.03, 0)).next.velocity[0], {6.03, 0.06}));
}

TEST(Ucsd, AllRulesActOnTheOldState) {  // (S0-2, S0-4, S0-8)
  // 20 apart: -20 * 0.02 + 20 * 0.001 + (8 - 6) * 0.03 = -0.4 + 0.02 + 0.06 = -0.32, and +0.32 for the other.
  const Step step = ucsd(boids({{{600, 360}, {6, 0}}, {{620, 360}, {8, 0}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {5.68, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {8.32, 0}));
  EXPECT_TRUE(near(step.next.position[1], {628.32, 360}));
}

TEST(Ucsd, BoundaryTurnsInsideTheMargins) {  // (S0-9)
  const auto turned = [](Vec p) { return ucsd(boids({{p, {6, 1}}})).next.velocity[0]; };
  EXPECT_TRUE(near(turned({199, 360}), {6.5, 1}));
  EXPECT_TRUE(near(turned({1081, 360}), {5.5, 1}));
  EXPECT_TRUE(near(turned({600, 159}), {6, 1.5}));
  EXPECT_TRUE(near(turned({600, 561}), {6, 0.5}));
  EXPECT_TRUE(near(turned({1100, 600}), {5.5, 0.5}));
  EXPECT_TRUE(near(turned({200, 160}), {6, 1}));  // the lines themselves: strict
  EXPECT_TRUE(near(turned({1080, 560}), {6, 1}));
}

TEST(Ucsd, SpeedIsKeptBetweenFiveAndTen) {  // (S0-10)
  const auto limited = [](Vec p, Vec v) { return ucsd(boids({{p, v}})).next.velocity[0]; };
  EXPECT_TRUE(near(limited({600, 360}, {12, 16}), {6, 8}));
  EXPECT_TRUE(near(limited({600, 360}, {0.3, -0.4}), {3, -4}));
  EXPECT_TRUE(near(limited({600, 360}, {0, 0}), {0, 0}));
  EXPECT_TRUE(
      near(limited({100, 360}, {9.8, 0}), {10, 0}));  // 9.8 + 0.5 = 10.3: the turn comes before the limit
}

TEST(Ucsd, CoincidentBoidsCountButDoNotPush) {
  // ((0, 0) + (-10, 0)) / 2 = (-5, 0); times 0.02 = (-0.1, 0).
  const Boids flock = boids({{{600, 360}, {6, 0}}, {{600, 360}, {6, 0}}, {{610, 360}, {6, 0}}});
  EXPECT_TRUE(near(ucsd(flock, ucsd_only(0.02, 0, 0)).next.velocity[0], {5.9, 0}));
}

TEST(Ucsd, ExemptIsWhereRoundingDecides) {
  const auto exempt = [](Vec p, Vec v) -> bool {
    return ucsd(boids({{p, v}, {{640, 360}, {6, 0}}})).exempt[0];
  };
  EXPECT_FALSE(exempt({600, 360}, {6, 0}));
  EXPECT_TRUE(exempt({490.0001, 360}, {6, 0}));  // 149.9999 from a visual radius of 150
  EXPECT_FALSE(exempt({490.001, 360}, {6, 0}));
  EXPECT_TRUE(exempt({200.001, 360}, {6, 0}));  // 0.001 from a turn line, in a world of 1280
  EXPECT_FALSE(exempt({200.01, 360}, {6, 0}));
  EXPECT_TRUE(exempt({400, 560.0005}, {6, 0}));
  EXPECT_TRUE(exempt({150, 360}, {-0.5, 0}));  // -0.5 + 0.5: no direction is left to speed up in
  EXPECT_FALSE(exempt({400, 360}, {0, 0}));    // nobody near, nothing to round
}

}  // namespace
}  // namespace reference
