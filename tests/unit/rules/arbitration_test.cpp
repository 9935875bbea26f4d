// How terms share the acceleration, the cap on it, and the speed limits.
#include <gtest/gtest.h>

#include "rules/rules.h"
#include "support.h"

namespace sturnus::test {
namespace {

using V = Vec<2>;

V arbitrated(Arbitration arbitration, float max, std::initializer_list<V> terms) {
  Arbiter<2> arbiter(arbitration, max);
  for (const V& term : terms) {
    if (!arbiter.is_done()) arbiter.add(term);
  }
  return arbiter.result();
}

TEST(Weighted, IsTheCappedSum) {
  EXPECT_EQ(arbitrated(Arbitration::weighted, 10, {{{1, 2}}, {{2, 2}}}), (V{{3, 4}}));
  const V capped_sum = arbitrated(Arbitration::weighted, 1, {{{1, 2}}, {{2, 2}}});
  EXPECT_NEAR(capped_sum[0], 0.6, 1e-6);
  EXPECT_NEAR(capped_sum[1], 0.8, 1e-6);
  EXPECT_EQ(arbitrated(Arbitration::weighted, 1, {}), V{});
}

TEST(Budget, GrantsInOrderAndScalesTheOneThatDoesNotFit) {
  // 3 of 5 granted, then 2 of the 4 along y, then nothing is left.
  EXPECT_EQ(arbitrated(Arbitration::budget, 5, {{{3, 0}}, {{0, 4}}, {{-9, 0}}}), (V{{3, 2}}));
  EXPECT_EQ(arbitrated(Arbitration::budget, 20, {{{3, 0}}, {{0, 4}}, {{-9, 0}}}), (V{{-6, 4}}));
  EXPECT_EQ(arbitrated(Arbitration::budget, 5, {{{0, 0}}, {{0, 5}}, {{1, 0}}}), (V{{0, 5}}));
  EXPECT_EQ(arbitrated(Arbitration::budget, 0, {{{3, 0}}}), V{});
  // What is granted counts by length, even where it cancels.
  EXPECT_EQ(arbitrated(Arbitration::budget, 5, {{{3, 0}}, {{-2, 0}}, {{9, 0}}}), (V{{1, 0}}));
}

TEST(First, IsTheFirstThatIsNotZero) {
  EXPECT_EQ(arbitrated(Arbitration::first, 10, {{{0, 0}}, {{0, 2}}, {{5, 0}}}), (V{{0, 2}}));
  EXPECT_EQ(arbitrated(Arbitration::first, 1, {{{0, 2}}, {{5, 0}}}), (V{{0, 1}}));
  EXPECT_EQ(arbitrated(Arbitration::first, 1, {{{0, 0}}, {{0, 0}}}), V{});
}

// Separation pushes left, cohesion up (its ring leaves the near one out), cruise right.
ScenarioDef three_terms(Arbitration arbitration) {
  ScenarioDef scenario = bare();
  FlockDef& flock = scenario.flocks.front();
  flock.arbitration = arbitration;
  flock.separation = {{.weight = 2, .radius = 3, .strength = Strength::constant, .order = 1}};
  flock.cohesion = {{.weight = 3, .radius = 10, .inner = 3, .strength = Strength::constant, .order = 2}};
  flock.cruise = Cruise{.speed = 5, .weight = 1, .order = 3};
  flock.max_acceleration = 4;
  return scenario;
}
const std::vector<Placed> crossing = {{{0, 0}, {1, 0}}, {{1, 0}}, {{0, 5}}};

TEST(Priorities, TiesGoByTheirPlaceInTheFile) {
  const Point budget = felt_by(three_terms(Arbitration::budget), crossing);
  EXPECT_NEAR(budget[0], -2, 1e-6);
  EXPECT_NEAR(budget[1], 2, 1e-6);
  const Point first = felt_by(three_terms(Arbitration::first), crossing);
  EXPECT_NEAR(first[0], -2, 1e-6);
  EXPECT_NEAR(first[1], 0, 1e-6);
}

TEST(Priorities, LowNumbersComeFirst) {
  ScenarioDef scenario = three_terms(Arbitration::first);
  scenario.flocks.front().cruise->priority = -1;
  EXPECT_NEAR(felt_by(scenario, crossing)[0], 4, 1e-6);
  scenario.flocks.front().cruise->priority = 5;
  scenario.flocks.front().separation.front().priority = 4;
  EXPECT_NEAR(felt_by(scenario, crossing)[1], 3, 1e-6);
}

TEST(Cap, ShortensTheSumAndNothingElse) {
  ScenarioDef scenario = three_terms(Arbitration::weighted);  // (-2 + 4, 3): length sqrt(13)
  scenario.flocks.front().max_acceleration = 100;
  const Point free = felt_by(scenario, crossing);
  EXPECT_NEAR(free[0], 2, 1e-6);
  EXPECT_NEAR(free[1], 3, 1e-6);
  scenario.flocks.front().max_acceleration = 1;
  const Point capped_sum = felt_by(scenario, crossing);
  EXPECT_NEAR(length_of(capped_sum), 1, 1e-6);
  EXPECT_NEAR(capped_sum[1] / capped_sum[0], 1.5, 1e-5);
  scenario.space.min = {-1, -1000};
  scenario.space.boundary = {BoundaryKind::turn, {3}, 7};  // comes after the cap
  const Point turned = felt_by(scenario, crossing);
  EXPECT_NEAR(turned[0], capped_sum[0] + 7, 1e-5);
  EXPECT_NEAR(turned[1], capped_sum[1], 1e-5);
}

TEST(Cap, HoldsForWhatOverflowsWhenSquared) {
  const V huge = capped(V{{3e30f, 4e30f}}, 5);
  EXPECT_NEAR(huge[0], 3, 1e-5);
  EXPECT_NEAR(huge[1], 4, 1e-5);
  EXPECT_EQ(capped(V{{1, 1}}, FlockModel::infinity_f), (V{{1, 1}}));
  EXPECT_EQ(capped(V{}, 0), V{});
}

TEST(SpeedLimits, KeepTheHeading) {
  EXPECT_EQ(limited(V{{3, 4}}, 0, 10), (V{{3, 4}}));
  EXPECT_EQ(limited(V{{30, 40}}, 0, 10), (V{{6, 8}}));
  EXPECT_EQ(limited(V{{3, 4}}, 10, 20), (V{{6, 8}}));
  EXPECT_EQ(limited(V{{3, 4}}, 5, 5), (V{{3, 4}}));
}

TEST(SpeedLimits, ABoidAtRestStaysAtRest) {
  EXPECT_EQ(limited(V{}, 5, 10), V{});
}

TEST(SpeedLimits, HoldForWhatOverflowsWhenSquared) {
  const V huge = limited(V{{-3e30f, 4e30f}}, 1, 5);
  EXPECT_NEAR(huge[0], -3, 1e-5);
  EXPECT_NEAR(huge[1], 4, 1e-5);
}

}  // namespace
}  // namespace sturnus::test
