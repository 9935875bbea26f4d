// The reference of CGRA 354, "Boids continued" against cases small enough for paper, one or two rules at a
// time.
#include <cmath>
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

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

}  // namespace
}  // namespace reference
