// Tests of the five references against cases small enough for paper: each document's rules ("Animation:
// Boids", prog06, "Boids continued", "Boids Simulation with QuadTree Optimization", "Flocking Simulation"),
// one or two at a time.

#include "reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <vector>

namespace reference {

void PrintTo(Vec a, std::ostream* out) {
  *out << '(' << a.x << ", " << a.y << ", " << a.z << ')';
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Boid {
  Vec position, velocity;
};

Boids boids(std::initializer_list<Boid> list) {
  Boids all;
  for (const Boid& boid : list) {
    all.position.push_back(boid.position);
    all.velocity.push_back(boid.velocity);
  }
  return all;
}

/// Paper has no rounding; double's is far below 1e-12 of any number here.
testing::AssertionResult near(Vec actual, Vec expected) {
  if (length(actual - expected) <= 1e-12 * (1 + length(expected))) return testing::AssertionSuccess();
  return testing::AssertionFailure() << testing::PrintToString(actual) << " is not "
                                     << testing::PrintToString(expected);
}

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

// --- prog06. Box [-0.5, 0.5]². ---

/// The weights alone: no cap on the update or the speed.
Prog06Parameters prog06_only(double separation, double alignment, double cohesion) {
  Prog06Parameters parameters;
  parameters.separation_weight = separation;
  parameters.alignment_weight = alignment;
  parameters.cohesion_weight = cohesion;
  parameters.max_update = infinity;
  parameters.max_speed = infinity;
  return parameters;
}

TEST(Prog06, SeparationIsASumOverTheSquaredDistance) {  // (S1-6)
  // (-0.2, 0) / 0.04 + (0, -0.25) / 0.0625 = (-5, -4); times 0.1 = (-0.5, -0.4).
  const Boids flock = boids({{{0, 0}, {0.01, 0}}, {{0.2, 0}, {}}, {{0, 0.25}, {}}});
  const Step step = prog06(flock, prog06_only(0.1, 0, 0));
  EXPECT_TRUE(near(step.next.velocity[0], {-0.49, -0.4}));
  EXPECT_TRUE(near(step.next.position[0], {-0.49, -0.4}));  // moved by the new velocity (S1-10)
}

TEST(Prog06, SeparationHasAClosedEdge) {
  // d = R = 0.25: -0.25 / 0.0625 = -4; times 0.1 = -0.4. A little farther: nothing.
  Prog06Parameters parameters = prog06_only(0.1, 0, 0);
  parameters.radius = 0.25;
  const Step on = prog06(boids({{{0, 0}, {}}, {{0.25, 0}, {}}}), parameters);
  EXPECT_TRUE(near(on.next.velocity[0], {-0.4, 0}));
  EXPECT_TRUE(on.exempt[0]);
  const Step outside = prog06(boids({{{0, 0}, {}}, {{0.2501, 0}, {}}}), parameters);
  EXPECT_TRUE(near(outside.next.velocity[0], {0, 0}));
  EXPECT_FALSE(outside.exempt[0]);
}

TEST(Prog06, AlignmentHearsTheWholePopulation) {  // (S1-8)
  // Mean of (0.03, 0) and (0, 0.04) is (0.015, 0.02), minus own (0.005, 0.02); times 0.3 = (0.0015, 0.006).
  // Both others are farther away than R.
  const Boids flock = boids({{{-0.4, -0.4}, {0.01, 0}}, {{0.4, 0.4}, {0.03, 0}}, {{0.4, -0.4}, {0, 0.04}}});
  EXPECT_TRUE(near(prog06(flock, prog06_only(0, 0.3, 0)).next.velocity[0], {0.0115, 0.006}));
}

TEST(Prog06, CohesionSeeksTheCentreOfTheWholePopulation) {  // (S1-9)
  // Mean of (0.4, 0.4) and (0.4, -0.2) is (0.4, 0.1), minus own (-0.4, -0.4) = (0.8, 0.5).
  const Boids flock = boids({{{-0.4, -0.4}, {}}, {{0.4, 0.4}, {}}, {{0.4, -0.2}, {}}});
  EXPECT_TRUE(near(prog06(flock, prog06_only(0, 0, 1)).next.velocity[0], {0.8, 0.5}));
}

TEST(Prog06, UpdateIsCappedAsAWhole) {  // (S1-12)
  // (0.3, 0.4) has the length 0.5, more than 0.02: (0.012, 0.016) is left.
  Prog06Parameters parameters = prog06_only(0, 0, 1);
  parameters.max_update = 0.02;
  const Boids far = boids({{{0, 0}, {}}, {{0.3, 0.4}, {}}});
  EXPECT_TRUE(near(prog06(far, parameters).next.velocity[0], {0.012, 0.016}));
  // (0.006, 0.008) has the length 0.01 and passes.
  const Boids close = boids({{{0, 0}, {}}, {{0.006, 0.008}, {}}});
  EXPECT_TRUE(near(prog06(close, parameters).next.velocity[0], {0.006, 0.008}));
}

TEST(Prog06, AllRulesActOnTheOldState) {  // (S1-10)
  // 0.2 apart, weights 1/1000 of the assignment's. Separation -0.2 / 0.04 * 0.0001 = -0.0005,
  // alignment (0.03 - 0.01) * 0.0003 = 0.000006, cohesion 0.2 * 0.001 = 0.0002: together -0.000294.
  const Boids flock = boids({{{0, 0}, {0.01, 0}}, {{0.2, 0}, {0.03, 0}}});
  const Step step = prog06(flock, prog06_only(0.0001, 0.0003, 0.001));
  EXPECT_TRUE(near(step.next.velocity[0], {0.009706, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {0.030294, 0}));
  EXPECT_TRUE(near(step.next.position[1], {0.230294, 0}));
}

TEST(Prog06, NudgeComesAfterTheCap) {  // (S1-13)
  // Cohesion -0.6 is capped to -0.02, and the nudge makes it -0.04. Separation is out of reach.
  const Boids flock = boids({{{0.6, 0}, {}}, {{0, 0}, {}}});
  const Step step = prog06(flock);
  EXPECT_TRUE(near(step.next.velocity[0], {-0.04, 0}));
  EXPECT_TRUE(near(step.next.position[0], {0.56, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {0.02, 0}));
}

TEST(Prog06, NudgeIsStrictAndPerAxis) {
  const auto nudged = [](Vec p) { return prog06(boids({{p, {}}})).next.velocity[0]; };
  EXPECT_TRUE(near(nudged({0.5, -0.5}), {0, 0}));
  EXPECT_TRUE(near(nudged({-0.6, 0.7}), {0.02, -0.02}));
  EXPECT_TRUE(near(nudged({0.51, 0, 3}), {-0.02, 0}));  // no walls in z
}

TEST(Prog06, SpeedIsCapped) {  // (S1-14)
  // (0.06, 0.08) has the length 0.1, twice the limit. Outside, the nudge comes first: 0.05 - 0.02 = 0.03.
  EXPECT_TRUE(near(prog06(boids({{{0, 0}, {0.06, 0.08}}})).next.velocity[0], {0.03, 0.04}));
  EXPECT_TRUE(near(prog06(boids({{{0.6, 0}, {0.05, 0}}})).next.velocity[0], {0.03, 0}));
  EXPECT_TRUE(near(prog06(boids({{{0.6, 0}, {-0.05, 0}}})).next.velocity[0], {-0.05, 0}));
}

TEST(Prog06, ALoneBoidFliesStraight) {
  const Step step = prog06(boids({{{0.1, 0.2}, {0.01, 0.02}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {0.01, 0.02}));
  EXPECT_TRUE(near(step.next.position[0], {0.11, 0.22}));
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Prog06, CoincidentBoidsDoNotPush) {
  const Step step = prog06(boids({{{0.1, 0.1}, {0.01, 0}}, {{0.1, 0.1}, {0.01, 0}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {0.01, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {0.01, 0}));
}

TEST(Prog06, ExemptIsWhereRoundingDecides) {
  const auto exempt = [](Vec p) -> bool { return prog06(boids({{p, {}}, {{0, 0}, {}}})).exempt[0]; };
  EXPECT_FALSE(exempt({0.1, 0.1}));
  EXPECT_TRUE(exempt({0.4000003, 0}));
  EXPECT_FALSE(exempt({0.400001, 0}));
  EXPECT_TRUE(exempt({-0.4999995, 0}));
  EXPECT_TRUE(exempt({0, 0.5000005}));
  EXPECT_FALSE(exempt({0, 0.500002}));
  EXPECT_TRUE(exempt({1e-20, 0}));
}

// --- CGRA 354, "Boids continued". Wrapped cube [-20, 20)³; accelerations appear as changes of velocity
// times 60. ---

VuwParameters vuw_only(double avoidance, double alignment, double cohesion) {
  VuwParameters parameters;
  parameters.avoidance_weight = avoidance;
  parameters.alignment_weight = alignment;
  parameters.cohesion_weight = cohesion;
  parameters.min_speed = 0;
  parameters.max_speed = infinity;
  return parameters;
}

/// The acceleration that boid 0 felt.
Vec vuw_acceleration(const Boids& flock, const VuwParameters& parameters) {
  return 60.0 * (vuw_core(flock, parameters).next.velocity[0] - flock.velocity[0]);
}

TEST(VuwCore, AvoidanceIsASumOverTheSquaredDistance) {  // (S2-12)
  // (-0.5, 0, 0) / 0.25 + (0, 0, -2) / 4 = (-2, 0, -0.5); times 4 = (-8, 0, -2). The second is exactly on the
  // closed edge of 2; the third lies just beyond it.
  const Boids flock = boids(
      {{{0, 0, 0}, {5, 0, 0}}, {{0.5, 0, 0}, {5, 0, 0}}, {{0, 0, 2}, {5, 0, 0}}, {{0, 2.001, 0}, {5, 0, 0}}});
  EXPECT_TRUE(near(vuw_acceleration(flock, vuw_only(4, 0, 0)), {-8, 0, -2}));
  EXPECT_TRUE(vuw_core(flock).exempt[0]);
}

TEST(VuwCore, CohesionCountsTheBoidItself) {  // (S2-14)
  // ((1, 1, 0) + (4, 1, 0) + (1, 5, 0)) / 3 = (2, 7/3, 0), minus own (1, 4/3, 0); times 0.6 = (0.6, 0.8, 0).
  const Boids flock = boids({{{1, 1, 0}, {}}, {{4, 1, 0}, {}}, {{1, 5, 0}, {}}});
  EXPECT_TRUE(near(vuw_acceleration(flock, vuw_only(0, 0, 0.6)), {0.6, 0.8, 0}));
}

TEST(VuwCore, AlignmentCountsTheBoidItself) {  // (S2-15)
  // ((5, 0, 0) + (8, 0, 0) + (5, 6, 0)) / 3 = (6, 2, 0), minus own (1, 2, 0). (3, 4, 0) is 5 away: a closed
  // edge.
  const Boids flock = boids(
      {{{0, 0, 0}, {5, 0, 0}}, {{1, 0, 0}, {8, 0, 0}}, {{3, 4, 0}, {5, 6, 0}}, {{0, 0, 5.001}, {9, 9, 9}}});
  EXPECT_TRUE(near(vuw_acceleration(flock, vuw_only(0, 1, 0)), {1, 2, 0}));
}

TEST(VuwCore, TheOldVelocityMovesTheBoid) {  // (S2-1, S2-3, S2-11)
  // 1 apart: avoidance -1 * 4, cohesion 0.5 * 0.6, alignment (6.5 - 5) * 1, together -2.2; position by 5
  // / 60.
  const Step step = vuw_core(boids({{{0, 0, 0}, {5, 0, 0}}, {{1, 0, 0}, {8, 0, 0}}}));
  EXPECT_TRUE(near(step.next.position[0], {5.0 / 60, 0, 0}));
  EXPECT_TRUE(near(step.next.velocity[0], {5 - 2.2 / 60, 0, 0}));
  EXPECT_TRUE(near(step.next.velocity[1], {8, 0, 0}));  // 8 + 2.2 / 60, limited
  EXPECT_FALSE(step.exempt[0]);
}

TEST(VuwCore, ALoneBoidIsNotSteeredToTheOrigin) {
  const Step step = vuw_core(boids({{{10, -3, 7}, {0, 6, 0}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {0, 6, 0}));
  EXPECT_TRUE(near(step.next.position[0], {10, -2.9, 7}));
}

TEST(VuwCore, OtherFlocksAreAvoidedOnly) {  // (S2-18)
  // The other flock's boid at 1 gives avoidance -1 * 4; own flock's at (0, 4, 0) gives cohesion 2 * 0.6,
  // alignment 1.
  Boids flock = boids({{{0, 0, 0}, {5, 0, 0}}, {{1, 0, 0}, {9, 9, 9}}, {{0, 4, 0}, {7, 0, 0}}});
  flock.flock = {0, 1, 0};
  EXPECT_TRUE(near(vuw_acceleration(flock, vuw_only(4, 1, 0.6)), {-3, 1.2, 0}));
  EXPECT_EQ(vuw_core(flock).next.flock, flock.flock);
}

TEST(VuwCore, NeighboursAreSeenAcrossTheSeam) {
  // 19.5 and -19.5 are 1 apart through the seam: avoidance -1 * 4 and cohesion +0.5 * 0.6 = -3.7, on each
  // axis.
  const VuwParameters parameters = vuw_only(4, 0, 0.6);
  const Boids x = boids({{{19.5, 0, 0}, {}}, {{-19.5, 0, 0}, {}}});
  const Boids y = boids({{{0, -19.5, 0}, {}}, {{0, 19.5, 0}, {}}});
  const Boids z = boids({{{0, 0, 19.5}, {}}, {{0, 0, -19.5}, {}}});
  EXPECT_TRUE(near(vuw_acceleration(x, parameters), {-3.7, 0, 0}));
  EXPECT_TRUE(near(vuw_acceleration(y, parameters), {0, 3.7, 0}));
  EXPECT_TRUE(near(vuw_acceleration(z, parameters), {0, 0, -3.7}));
}

TEST(VuwCore, PositionsWrapByFlooredModulo) {  // (S2-17)
  const auto moved = [](Vec p, Vec v) { return vuw_core(boids({{p, v}})).next.position[0]; };
  EXPECT_TRUE(near(moved({19.95, 0, 0}, {6, 0, 0}), {-19.95, 0, 0}));   // 19.95 + 0.1 = 20.05
  EXPECT_TRUE(near(moved({0, -19.95, 0}, {0, -6, 0}), {0, 19.95, 0}));  // C's fmod alone would stay outside
  EXPECT_TRUE(near(moved({0, 0, 21}, {}), {0, 0, -19}));
  EXPECT_TRUE(near(moved({-61, 0, 0}, {}), {19, 0, 0}));      // -41 mod 40 = 39
  EXPECT_EQ(moved({20, -20, 20}, {}), (Vec{-20, -20, -20}));  // exactly max is min
  const double just_below = std::nextafter(-20.0, -infinity);
  EXPECT_EQ(moved({just_below, 0, 0}, {}).x, -20);  // and so is what rounds to it: 40 - 4e-15 is 40
}

TEST(VuwCore, SpeedIsSensible) {  // (S2-9)
  const auto limited = [](Vec v) { return vuw_core(boids({{{}, v}})).next; };
  EXPECT_TRUE(near(limited({12, 0, 0}).velocity[0], {8, 0, 0}));
  EXPECT_TRUE(near(limited({12, 0, 0}).position[0], {0.2, 0, 0}));  // moved before the limit: 12 / 60
  EXPECT_TRUE(near(limited({0, 0.6, -0.8}).velocity[0], {0, 2.4, -3.2}));
  EXPECT_TRUE(near(limited({}).velocity[0], {}));
}

TEST(VuwCore, CoincidentBoidsCountButDoNotPush) {
  // Cohesion ((0) + (0) + (3)) / 3 = 1, times 0.6; avoidance zero, with 3 out of its reach.
  const Boids flock = boids({{{0, 0, 0}, {}}, {{0, 0, 0}, {}}, {{3, 0, 0}, {}}});
  EXPECT_TRUE(near(vuw_acceleration(flock, vuw_only(4, 0, 0.6)), {0.6, 0, 0}));
}

TEST(VuwCore, ARadiusOfZeroMeansNobody) {
  VuwParameters parameters = vuw_only(4, 1, 0.6);
  parameters.neighbour_radius = 0;
  EXPECT_TRUE(near(vuw_acceleration(boids({{{}, {5, 0, 0}}, {{}, {7, 0, 0}}}), parameters), {}));
}

TEST(VuwCore, ExemptIsWhereRoundingDecides) {
  const auto exempt = [](Vec p, VuwParameters parameters = {}) -> bool {
    return vuw_core(boids({{p, {6, 0, 0}}, {{18, 0, 0}, {6, 0, 0}}}), parameters).exempt[0];
  };
  EXPECT_FALSE(exempt({17, 0, 0}));
  EXPECT_TRUE(exempt({18, 1.999999, 0}));
  EXPECT_FALSE(exempt({18, 1.99999, 0}));
  EXPECT_TRUE(exempt({18, 0, 5.000004}));
  EXPECT_TRUE(exempt({-17.000006, 0, 0}));  // 4.999994 across the seam, where float32 rounds at 40
  EXPECT_FALSE(exempt({-16.9999, 0, 0}));
  EXPECT_TRUE(exempt({19.90001, 0, 0}));  // moves to 20.00001
  VuwParameters wide;
  wide.neighbour_radius = 30;
  EXPECT_TRUE(exempt({-2.00001, 0, 0}, wide));  // 20.00001 away, either way round
  EXPECT_FALSE(exempt({-2.1, 0, 0}, wide));
}

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

// --- CS 184, "Flocking Simulation". Wrapped [0, 800) x [0, 600). At the speed 2.5 the cruise term is zero.
// ---

TEST(Cs184, SeparationIsAMeanWithinTheInnerDisk) {  // (S4-2, S4-3, S4-4)
  // (-10, 0) / 100 and (0, -8) / 64: mean (-0.05, -0.0625), times 3 = (-0.15, -0.1875), shorter than 0.3.
  const Boids flock = boids({{{400, 300}, {2.5, 0}}, {{410, 300}, {2.5, 0}}, {{400, 308}, {2.5, 0}}});
  const Step step = cs184(flock);
  EXPECT_TRUE(near(step.next.velocity[0], {2.35, -0.1875}));
  EXPECT_TRUE(near(step.next.position[0], {402.35, 299.8125}));  // moved by the new velocity (S4-8)
  EXPECT_FALSE(step.exempt[0]);
}

TEST(Cs184, AlignmentIsTheMeanHeadingInTheMiddleRing) {  // (S4-1)
  // Headings (0, 1), (1, 0) and, at rest, (0, 0): mean (1/3, 1/3), times 0.06 = (0.02, 0.02). Own is not
  // taken away.
  const Boids flock =
      boids({{{400, 300}, {2.5, 0}}, {{420, 300}, {0, 4}}, {{400, 280}, {3, 0}}, {{380, 300}, {}}});
  EXPECT_TRUE(near(cs184(flock).next.velocity[0], {2.52, 0.02}));
}

TEST(Cs184, CohesionIsAMeanInTheOuterRing) {
  // (40, 0) / 1600 = 0.025 and (0, 50) / 2500 = 0.02: mean (0.0125, 0.01), times 2 = (0.025, 0.02).
  const Boids flock = boids({{{400, 300}, {2.5, 0}}, {{440, 300}, {2.5, 0}}, {{400, 350}, {2.5, 0}}});
  EXPECT_TRUE(near(cs184(flock).next.velocity[0], {2.525, 0.02}));
}

TEST(Cs184, RingsOwnTheirInnerEdge) {
  const auto beside = [](double distance) {
    return cs184(boids({{{400, 300}, {2.5, 0}}, {{400 + distance, 300}, {0, 2.5}}})).next.velocity[0];
  };
  EXPECT_TRUE(near(beside(11.99), {2.5 - 3 / 11.99, 0}));
  EXPECT_TRUE(near(beside(12), {2.5, 0.06}));
  EXPECT_TRUE(near(beside(27.99), {2.5, 0.06}));
  EXPECT_TRUE(near(beside(28), {2.5 + 2.0 / 28, 0}));
  EXPECT_TRUE(near(beside(59.99), {2.5 + 2 / 59.99, 0}));
  EXPECT_TRUE(near(beside(60), {2.5, 0}));
}

TEST(Cs184, CruiseSeeksItsSpeed) {  // (S4-5)
  const auto cruising = [](Vec v) { return cs184(boids({{{400, 300}, v}})).next.velocity[0]; };
  EXPECT_TRUE(near(cruising({3, 0}), {2.95, 0}));   // (2.5 - 3) * 0.1
  EXPECT_TRUE(near(cruising({0, 0.5}), {0, 0.7}));  // (2.5 - 0.5) * 0.1
  EXPECT_TRUE(near(cruising({1.5, -2}), {1.5, -2}));
  EXPECT_TRUE(near(cruising({}), {}));
}

TEST(Cs184, AccelerationIsLimitedWithCruiseInside) {  // (S4-7)
  // Separation -1 * 3 = -3, cruise (2.5 - 4) * 0.1 = -0.15; the limit leaves -0.3 of both.
  const Boids flock = boids({{{400, 300}, {4, 0}}, {{401, 300}, {4, 0}}});
  EXPECT_TRUE(near(cs184(flock).next.velocity[0], {3.7, 0}));
}

TEST(Cs184, SpeedHasALimit) {
  // Cruise (2.5 - 5) * 0.1 = -0.25 leaves 4.75, limited to 4.
  const Step step = cs184(boids({{{400, 300}, {3, 4}}}));
  EXPECT_TRUE(near(step.next.velocity[0], {2.4, 3.2}));
  EXPECT_TRUE(near(step.next.position[0], {402.4, 303.2}));
}

TEST(Cs184, NeighboursAreSeenAcrossTheSeam) {  // (S4-19)
  // 794.5 and 5.5 are 11 apart through the seam: separation 3 / 11 each way. Then the position wraps or does
  // not.
  const Step x = cs184(boids({{{794.5, 300}, {2.5, 0}}, {{5.5, 300}, {2.5, 0}}}));
  EXPECT_TRUE(near(x.next.velocity[0], {2.5 - 3.0 / 11, 0}));
  EXPECT_TRUE(near(x.next.velocity[1], {2.5 + 3.0 / 11, 0}));
  EXPECT_TRUE(near(x.next.position[0], {797 - 3.0 / 11, 300}));
  const Step y = cs184(boids({{{400, 5.5}, {2.5, 0}}, {{400, 594.5}, {2.5, 0}}}));
  EXPECT_TRUE(near(y.next.velocity[0], {2.5, 3.0 / 11}));
  EXPECT_TRUE(near(y.next.velocity[1], {2.5, -3.0 / 11}));
}

TEST(Cs184, UnitsComeOutOnTheOppositeSide) {
  const auto moved = [](Vec p, Vec v) { return cs184(boids({{p, v}})).next.position[0]; };
  EXPECT_TRUE(near(moved({799, 300}, {2.5, 0}), {1.5, 300}));
  EXPECT_TRUE(near(moved({400, 1}, {0, -2.5}), {400, 598.5}));
  EXPECT_TRUE(near(moved({1, 599}, {-1.5, 2}), {799.5, 1}));
  EXPECT_EQ(moved({797.5, 300}, {2.5, 0}), (Vec{0, 300}));  // exactly max is min
}

TEST(Cs184, CoincidentBoidsCountButDoNotPush) {
  // Mean of (0, 0) and (-0.1, 0) is (-0.05, 0), times 3.
  const Boids flock = boids({{{400, 300}, {2.5, 0}}, {{400, 300}, {2.5, 0}}, {{410, 300}, {2.5, 0}}});
  EXPECT_TRUE(near(cs184(flock).next.velocity[0], {2.35, 0}));
}

TEST(Cs184, ExemptIsWhereRoundingDecides) {
  const auto exempt = [](Vec p, Vec v = {2.5, 0}) -> bool {
    return cs184(boids({{p, v}, {{780, 300}, {2.5, 0}}})).exempt[0];
  };
  EXPECT_FALSE(exempt({400, 100}));
  EXPECT_TRUE(exempt({768.00001, 300}));
  EXPECT_TRUE(exempt({780, 328.00002}));
  EXPECT_TRUE(exempt({720.00005, 300}));
  EXPECT_FALSE(exempt({720.0001, 300}));
  EXPECT_TRUE(exempt({8.00005, 300}));  // 28 across the seam, where float32 rounds at 800
  EXPECT_FALSE(exempt({8.0002, 300}));
  EXPECT_TRUE(exempt({797.5005, 100}));         // moves to 800.0005
  EXPECT_TRUE(exempt({400, 100}, {1e-20, 0}));  // a heading, or at rest?
}

// --- What holds for all five. ---

TEST(References, AnEmptyWorldStaysEmpty) {
  for (const Step& step : {ucsd({}), prog06({}), vuw_core({}), quadtree({}), cs184({})}) {
    EXPECT_TRUE(step.next.position.empty());
    EXPECT_TRUE(step.exempt.empty());
  }
}

TEST(References, ALoneBoidFeelsNoNeighbourTerm) {
  const Boids lone = boids({{{250, 250}, {5, 0}}});
  EXPECT_TRUE(near(ucsd(lone).next.velocity[0], {5, 0}));
  EXPECT_TRUE(near(quadtree(lone).next.velocity[0], {5, 0}));
  EXPECT_TRUE(near(cs184(boids({{{250, 250}, {2.5, 0}}})).next.velocity[0], {2.5, 0}));
}

}  // namespace
}  // namespace reference
