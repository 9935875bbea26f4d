// The reference of "Flocking Simulation" (CS 184) against cases small enough for paper, one or two rules at a
// time.
#include <cmath>
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

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

}  // namespace
}  // namespace reference
