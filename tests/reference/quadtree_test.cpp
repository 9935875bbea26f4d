// The reference of "Boids Simulation with QuadTree Optimization" against cases small enough for paper, one or
// two rules at a time.
#include <cmath>
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

// --- "Boids Simulation with QuadTree Optimization". World 1600 x 900, margin 100. ---

/// One factor alone, at any speed.
QuadtreeParameters quadtree_only(double separation, double alignment, double cohesion) {
  QuadtreeParameters parameters;
  parameters.separation_factor = separation;
  parameters.alignment_factor = alignment;
  parameters.cohesion_factor = cohesion;
  parameters.min_speed = 0;
  parameters.max_speed = infinity;
  return parameters;
}

TEST(Quadtree, SeparationIsASumAddedOnce) {  // (S3-2)
  // (-10, 0) + (0, -20) = (-10, -20); times 0.002 = (-0.02, -0.04). The third is exactly 50 away: an open
  // edge.
  const Boids flock =
      boids({{{800, 450}, {4, 0}}, {{810, 450}, {4, 0}}, {{800, 470}, {4, 0}}, {{850, 450}, {4, 0}}});
  const Step step = quadtree(flock, quadtree_only(0.002, 0, 0));
  EXPECT_TRUE(near(step.next.velocity[0], {3.98, -0.04}));
  EXPECT_TRUE(near(step.next.position[0], {803.98, 449.96}));  // moved by the new velocity (S3-12)
}

TEST(Quadtree, AlignmentTurnsToTheMeanVelocity) {  // (S3-3)
  // Mean of (5, 0) and (4, 2) is (4.5, 1), minus own (0.5, 1); times 0.09 = (0.045, 0.09). (950, 450) is
  // exactly at 150.
  const Boids flock =
      boids({{{800, 450}, {4, 0}}, {{900, 450}, {5, 0}}, {{800, 460}, {4, 2}}, {{950, 450}, {9, 9}}});
  EXPECT_TRUE(near(quadtree(flock, quadtree_only(0, 0.09, 0)).next.velocity[0], {4.045, 0.09}));
}

TEST(Quadtree, CohesionPullsToTheMeanPosition) {  // (S3-4)
  // Mean of (900, 450) and (800, 470) is (850, 460), minus own (50, 10); times 0.0009 = (0.045, 0.009).
  const Boids flock = boids({{{800, 450}, {4, 0}}, {{900, 450}, {5, 0}}, {{800, 470}, {4, 2}}});
  EXPECT_TRUE(near(quadtree(flock, quadtree_only(0, 0, 0.0009)).next.velocity[0], {4.045, 0.009}));
}

TEST(Quadtree, AllRulesActOnTheOldState) {
  // 40 apart, side by side, so each sees the other: -40 * 0.002 + 40 * 0.0009 = -0.044 in y, 1 * 0.09 in x.
  const Step step = quadtree(boids({{{800, 400}, {4, 0}}, {{800, 440}, {5, 0}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {4.09, -0.044}));
  EXPECT_TRUE(near(step.next.velocity[1], {4.91, 0.044}));
  EXPECT_TRUE(near(step.next.position[1], {804.91, 440.044}));
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Quadtree, TheAngleLimitIsMeasuredFromTheHeading) {  // (S3-5)
  // Left behind: (-10, 18) lies 180 - atan(1.8) = 119.05 degrees from the heading and is seen, (-10, 17)
  // 120.47 and is not. Seen, separation gives (10, -18) * 0.002 = (0.02, -0.036).
  const QuadtreeParameters parameters = quadtree_only(0.002, 0, 0);
  const auto seeing = [&](Vec other) {
    return quadtree(boids({{{800, 450}, {4, 0}}, {other, {4, 0}}}), parameters).next.velocity[0];
  };
  EXPECT_TRUE(near(seeing({790, 468}), {4.02, -0.036}));
  EXPECT_TRUE(near(seeing({790, 467}), {4, 0}));
  EXPECT_TRUE(near(seeing({790, 432}), {4.02, 0.036}));  // the same on the right
  EXPECT_TRUE(near(seeing({790, 433}), {4, 0}));
  EXPECT_TRUE(near(seeing({790, 450}), {4, 0}));
}

TEST(Quadtree, TheAngleLimitAppliesToBothRanges) {
  // Straight behind: neither alignment nor cohesion hears it; the one in front does: 5 - 4 = 1, 0.09 and
  // 0.0009 * 100.
  const Step step =
      quadtree(boids({{{800, 450}, {4, 0}}, {{900, 450}, {5, 0}}}), quadtree_only(0, 0.09, 0.0009));
  EXPECT_TRUE(near(step.next.velocity[0], {4 + 0.09 + 0.09, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {5, 0}));
}

TEST(Quadtree, AFieldOf360SeesStraightBehind) {
  QuadtreeParameters parameters = quadtree_only(0.002, 0, 0);
  parameters.field_of_view = 360;
  const Step step = quadtree(boids({{{800, 450}, {4, 0}}, {{790, 450}, {4, 0}}}), parameters);
  EXPECT_TRUE(near(step.next.velocity[0], {4.02, 0}));
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Quadtree, ABoidAtRestSeesAllRound) {
  // Both at rest, 10 apart: (-10, 0) * 0.002 and back, whichever side the other is on.
  const Step step = quadtree(boids({{{800, 450}, {}}, {{810, 450}, {}}}), quadtree_only(0.002, 0, 0));
  EXPECT_TRUE(near(step.next.velocity[0], {-0.02, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {0.02, 0}));
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Quadtree, ACoincidentBoidIsSeen) {
  // Mean of (6, 0) and (4, 2) is (5, 1), minus own (1, 1); times 0.09.
  const Boids flock = boids({{{800, 450}, {4, 0}}, {{800, 450}, {6, 0}}, {{810, 450}, {4, 2}}});
  const Step step = quadtree(flock, quadtree_only(0, 0.09, 0));
  EXPECT_TRUE(near(step.next.velocity[0], {4.09, 0.09}));
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Quadtree, EdgesTurnTheBoid) {  // (S3-11)
  const auto turned = [](Vec p) { return quadtree(boids({{p, {4, 1}}})).next.velocity[0]; };
  EXPECT_TRUE(near(turned({1501, 450}), {3.8, 1}));
  EXPECT_TRUE(near(turned({99, 450}), {4.2, 1}));
  EXPECT_TRUE(near(turned({800, 801}), {4, 0.8}));
  EXPECT_TRUE(near(turned({800, 99}), {4, 1.2}));
  EXPECT_TRUE(near(turned({1600, 0}), {3.8, 1.2}));
  EXPECT_TRUE(near(turned({100, 100}), {4, 1}));  // the lines themselves: strict
  EXPECT_TRUE(near(turned({1500, 800}), {4, 1}));
}

TEST(Quadtree, SpeedIsKeptBetweenThreeAndSix) {  // (S3-19)
  const auto limited = [](Vec p, Vec v) { return quadtree(boids({{p, v}})).next.velocity[0]; };
  EXPECT_TRUE(near(limited({800, 450}, {6, 8}), {3.6, 4.8}));
  EXPECT_TRUE(near(limited({800, 450}, {-0.6, 0.8}), {-1.8, 2.4}));
  EXPECT_TRUE(near(limited({800, 450}, {}), {}));
  EXPECT_TRUE(
      near(limited({50, 450}, {5.9, 0}), {6, 0}));  // 5.9 + 0.2 = 6.1: the turn comes before the limit
}

TEST(Quadtree, ExemptIsWhereRoundingDecides) {
  const auto exempt = [](Vec p, Vec v) -> bool {
    return quadtree(boids({{{800, 450}, v}, {p, {4, 0}}})).exempt[0];
  };
  EXPECT_FALSE(exempt({790, 468}, {4, 0}));
  EXPECT_TRUE(exempt({790, 450 + 17.3205}, {4, 0}));   // tan(60 degrees) = 1.7320508
  EXPECT_FALSE(exempt({790, 450 + 17.33}, {4, 0}));    // 0.0002 rad off
  EXPECT_FALSE(exempt({700, 450 + 173.205}, {4, 0}));  // on the view's edge, but 200 away
  EXPECT_TRUE(exempt({850.00004, 450}, {4, 0}));
  EXPECT_TRUE(exempt({800, 599.9999}, {4, 0}));
  EXPECT_TRUE(exempt({790, 450}, {1e-20, 0}));
  EXPECT_TRUE(quadtree(boids({{{100.001, 450}, {4, 0}}})).exempt[0]);
  EXPECT_TRUE(quadtree(boids({{{800, 800.0005}, {4, 0}}})).exempt[0]);
  EXPECT_FALSE(quadtree(boids({{{800, 800.002}, {4, 0}}})).exempt[0]);
}

}  // namespace
}  // namespace reference
