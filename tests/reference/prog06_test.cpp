// The reference of prog06 against cases small enough for paper, one or two rules at a time.
#include <cmath>
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

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

}  // namespace
}  // namespace reference
