// Separation, alignment and cohesion against numbers worked out on paper.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

testing::AssertionResult near(const Point& found, const Point& expected) {
  if (distance(found, expected) <= 1e-6 * (1 + length_of(expected))) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "(" << found[0] << ", " << found[1] << ", " << found[2]
                                     << ") is not (" << expected[0] << ", " << expected[1] << ", "
                                     << expected[2] << ")";
}

ScenarioDef with(const Separation& term, int dimensions = 2) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks.front().separation = {term};
  return scenario;
}
ScenarioDef with(const Alignment& term, int dimensions = 2) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks.front().alignment = {term};
  return scenario;
}
ScenarioDef with(const Cohesion& term, int dimensions = 2) {
  ScenarioDef scenario = bare(dimensions);
  scenario.flocks.front().cohesion = {term};
  return scenario;
}

// (3, 4) is 5 away: o/d = (0.6, 0.8), o/d² = (0.12, 0.16). (-2, 0) is 2 away: o/d² = (-0.5, 0).
const std::vector<Placed> three = {{{0, 0}}, {{3, 4}}, {{-2, 0}}};

TEST(Separation, EveryStrengthAndCombination) {
  const auto felt = [](Strength strength, Combine combine) {
    return felt_by(with(Separation{.strength = strength, .combine = combine}), three);
  };
  EXPECT_TRUE(near(felt(Strength::fades, Combine::sum), {0.38f, -0.16f}));
  EXPECT_TRUE(near(felt(Strength::fades, Combine::mean), {0.19f, -0.08f}));
  EXPECT_TRUE(near(felt(Strength::constant, Combine::sum), {0.4f, -0.8f}));
  EXPECT_TRUE(near(felt(Strength::constant, Combine::mean), {0.2f, -0.4f}));
  EXPECT_TRUE(near(felt(Strength::grows, Combine::sum), {-1, -4}));
  EXPECT_TRUE(near(felt(Strength::grows, Combine::mean), {-0.5f, -2}));
  EXPECT_TRUE(
      near(felt_by(with(Separation{.weight = 2.5, .strength = Strength::grows}), three), {-2.5f, -10}));
}

TEST(Separation, InThreeDimensions) {
  // (2, 3, 6) is 7 away: o/d² = (2, 3, 6)/49.
  EXPECT_TRUE(
      near(felt_by(with(Separation{}, 3), {{{0, 0, 0}}, {{2, 3, 6}}}), {-2 / 49.f, -3 / 49.f, -6 / 49.f}));
}

TEST(Ring, TheOuterEdgeIsOpenUnlessClosed) {
  const std::vector<Placed> on_edge = {{{0, 0}}, {{12, 0}}};
  EXPECT_TRUE(near(felt_by(with(Separation{.radius = 12, .edge = Edge::open}), on_edge), {}));
  EXPECT_TRUE(near(felt_by(with(Separation{.radius = 12, .edge = Edge::closed}), on_edge), {-1 / 12.f, 0}));
  const std::vector<Placed> beyond = {{{0, 0}}, {{std::nextafter(12.0f, 13.0f), 0}}};
  EXPECT_TRUE(near(felt_by(with(Separation{.radius = 12, .edge = Edge::closed}), beyond), {}));
  const std::vector<Placed> within = {{{0, 0}}, {{std::nextafter(12.0f, 11.0f), 0}}};
  EXPECT_TRUE(near(felt_by(with(Separation{.radius = 12, .edge = Edge::open}), within), {-1 / 12.f, 0}));
}

TEST(Ring, TheInnerEdgeIsClosed) {
  const Separation ring{.radius = 12, .inner = 5};
  EXPECT_TRUE(near(felt_by(with(ring), {{{0, 0}}, {{3, 4}}}), {-0.12f, -0.16f}));
  EXPECT_TRUE(near(felt_by(with(ring), {{{0, 0}}, {{4.99f, 0}}}), {}));
  EXPECT_TRUE(near(felt_by(with(ring), {{{0, 0}}, {{0, 0}}}), {}));
}

TEST(Ring, RadiusZeroMeansNobodyNotEvenAtTheSamePoint) {
  for (const Edge edge : {Edge::open, Edge::closed}) {
    const std::vector<Placed> boids = {{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}, {{1, 0}, {0, 1}}};
    EXPECT_TRUE(near(felt_by(with(Separation{.radius = 0, .edge = edge}), boids), {}));
    EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .radius = 0, .edge = edge}), boids), {}));
    EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .radius = 0, .edge = edge}), boids), {}));
  }
}

TEST(Coincident, CountInNAndHaveNoDirection) {
  const std::vector<Placed> boids = {{{0, 0}, {1, 0}}, {{0, 0}, {3, 0}}, {{2, 0}, {0, 0}}};
  EXPECT_TRUE(near(felt_by(with(Separation{.combine = Combine::mean}), boids), {-0.25f, 0}));
  EXPECT_TRUE(near(felt_by(with(Separation{.strength = Strength::constant, .combine = Combine::mean}), boids),
                   {-0.5f, 0}));
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1}), boids), {1, 0}));
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .strength = Strength::fades}), boids), {0.25f, 0}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1}), boids), {0.5f, 0}));  // (3 + 0)/2 - 1
}

// Nearer than the root of the least normal float the push grows no more, and never overflows.
TEST(Coincident, NearOnesPushNoHarderThanFromTheLeastDistance) {
  const float least = std::numeric_limits<float>::min();
  const Point felt = felt_by(with(Separation{}), {{{0, 0}}, {{1e-30f, 0}}});
  EXPECT_FLOAT_EQ(felt[0], -1e-30f / least);
  EXPECT_EQ(felt[1], 0);
}

const std::vector<Placed> moving = {{{0, 0}, {1, 0}}, {{3, 4}, {0, 2}}, {{-2, 0}, {4, 0}}};

TEST(Alignment, AverageMinusOwnOrTheAverage) {
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1}), moving), {1, 1}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .relative = false}), moving), {2, 1}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 0.25}), moving), {0.25f, 0.25f}));
}

TEST(Alignment, CountingItselfDividesByOneMore) {
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .count_self = true}), moving), {2 / 3.f, 2 / 3.f}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .relative = false, .count_self = true}), moving),
                   {5 / 3.f, 2 / 3.f}));
}

TEST(Alignment, OfHeadings) {
  // Headings (0, 1) and (1, 0) average (0.5, 0.5); its own is (1, 0).
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .match = Match::heading}), moving), {-0.5f, 0.5f}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .match = Match::heading, .relative = false}), moving),
                   {0.5f, 0.5f}));
  const std::vector<Placed> one_rests = {{{0, 0}, {1, 0}}, {{1, 0}, {0, 5}}, {{2, 0}, {0, 0}}};
  EXPECT_TRUE(
      near(felt_by(with(Alignment{.weight = 1, .match = Match::heading, .relative = false}), one_rests),
           {0, 0.5f}));  // the heading of a boid at rest is zero and counts
}

TEST(Alignment, AloneItFeelsNothingButItsOwnUncomparedSelf) {
  const std::vector<Placed> alone = {{{0, 0}, {1, 2}}};
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1}), alone), {}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .relative = false}), alone), {}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .count_self = true}), alone), {}));
  EXPECT_TRUE(
      near(felt_by(with(Alignment{.weight = 1, .relative = false, .count_self = true}), alone), {1, 2}));
}

TEST(Cohesion, EveryStrengthAndCombination) {
  const std::vector<Placed> boids = {{{0, 0}}, {{4, 0}}, {{0, 2}}};
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1}), boids), {2, 1}));
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .count_self = true}), boids), {4 / 3.f, 2 / 3.f}));
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .combine = Combine::sum}), boids), {4, 2}));
  EXPECT_TRUE(
      near(felt_by(with(Cohesion{.weight = 1, .strength = Strength::fades}), boids), {0.125f, 0.25f}));
  EXPECT_TRUE(
      near(felt_by(with(Cohesion{.weight = 1, .strength = Strength::constant}), boids), {0.5f, 0.5f}));
}

TEST(Cohesion, TakesTheNearestImageInAWrappedSpace) {
  ScenarioDef scenario = with(Cohesion{.weight = 1, .radius = 5});
  scenario.space.min = {0, 0};
  scenario.space.max = {100, 50};
  scenario.space.boundary.kind = BoundaryKind::wrap;
  EXPECT_TRUE(near(felt_by(scenario, {{{1, 1}}, {{98, 49}}}), {-3, -2}));
}

TEST(Whose, OwnAllOrNamed) {
  ScenarioDef scenario = bare();
  scenario.flocks[0].name = "fish";
  for (const char* name : {"crabs", "eels"}) {
    scenario.flocks.push_back(scenario.flocks[0]);
    scenario.flocks.back().name = name;
  }
  const std::vector<Placed> boids = {{{0, 0}}, {{1, 0}}, {{2, 0}, {}, 1}, {{4, 0}, {}, 2}};
  const auto felt = [&](const Whose& of) {
    scenario.flocks[0].cohesion = {{.weight = 1, .combine = Combine::sum, .of = of}};
    return felt_by(scenario, boids);
  };
  EXPECT_TRUE(near(felt({Whose::Kind::own, {}}), {1, 0}));
  EXPECT_TRUE(near(felt({Whose::Kind::all, {}}), {7, 0}));
  EXPECT_TRUE(near(felt({Whose::Kind::named, {"crabs"}}), {2, 0}));
  EXPECT_TRUE(near(felt({Whose::Kind::named, {"eels", "fish"}}), {5, 0}));
  EXPECT_EQ(Separation{}.of.kind, Whose::Kind::all);
  EXPECT_EQ(Alignment{}.of.kind, Whose::Kind::own);
  EXPECT_EQ(Cohesion{}.of.kind, Whose::Kind::own);
}

Point at_degrees(double degrees) {
  const double radians = degrees * 3.14159265358979 / 180;
  return {static_cast<float>(std::cos(radians)), static_cast<float>(std::sin(radians))};
}

TEST(FieldOfView, SeesWithinHalfTheAngleOnBothSides) {
  ScenarioDef scenario = with(Cohesion{.weight = 1});
  scenario.flocks.front().field_of_view = 120;
  const auto sees = [&](double degrees, const Point& velocity) {
    return length_of(felt_by(scenario, {{{0, 0}, velocity}, {at_degrees(degrees)}})) > 0.5;
  };
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(side * 59.9, {2, 0}));
    EXPECT_FALSE(sees(side * 60.1, {2, 0}));
    EXPECT_FALSE(sees(side * 180, {2, 0}));
    EXPECT_TRUE(sees(90 + side * 59.9, {0, 0.5f}));
    EXPECT_FALSE(sees(90 + side * 60.1, {0, 0.5f}));
    EXPECT_TRUE(sees(side * 180, {0, 0}));  // at rest it sees all round
  }
}

TEST(FieldOfView, OfATermGoesBeforeTheFlocks) {
  ScenarioDef scenario = with(Cohesion{.weight = 1, .field_of_view = 360.0});
  scenario.flocks.front().field_of_view = 90;
  const std::vector<Placed> behind = {{{0, 0}, {1, 0}}, {{-2, 0}}};
  EXPECT_TRUE(near(felt_by(scenario, behind), {-2, 0}));
  scenario.flocks.front().cohesion.front().field_of_view.reset();
  EXPECT_TRUE(near(felt_by(scenario, behind), {}));
}

TEST(FieldOfView, SeesWhoIsAtTheSamePoint) {
  ScenarioDef scenario = with(Alignment{.weight = 1});
  scenario.flocks.front().field_of_view = 10;
  EXPECT_TRUE(near(felt_by(scenario, {{{0, 0}, {1, 0}}, {{0, 0}, {0, 3}}}), {-1, 3}));
}

TEST(Terms, SwitchedOffOrOfNobodyFeelNothing) {
  EXPECT_TRUE(near(felt_by(with(Separation{.on = false}), three), {}));
  EXPECT_TRUE(near(felt_by(with(Separation{.sample = 0}), three), {}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .on = false}), moving), {}));
}

TEST(Terms, SeveralOfAKindAddUp) {
  ScenarioDef scenario = with(Cohesion{.weight = 1, .radius = 3});
  scenario.flocks.front().cohesion.push_back({.weight = -0.5, .radius = 10, .inner = 3});
  EXPECT_TRUE(near(felt_by(scenario, {{{0, 0}}, {{2, 0}}, {{0, 8}}}), {2, -4}));
}

TEST(WholePopulation, IsEverybodyElseHoweverFar) {
  const std::vector<Placed> boids = {{{0, 0}, {1, 0}}, {{900, 0}, {0, 2}}, {{-300, 600}, {4, 0}}};
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .radius = infinity}), boids), {300, 300}));
  EXPECT_TRUE(
      near(felt_by(with(Cohesion{.weight = 1, .radius = infinity, .count_self = true}), boids), {200, 200}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .radius = infinity}), boids), {1, 1}));
  EXPECT_TRUE(near(felt_by(with(Alignment{.weight = 1, .radius = infinity, .match = Match::heading}), boids),
                   {-0.5f, 0.5f}));
  EXPECT_TRUE(
      near(felt_by(with(Separation{.radius = infinity, .strength = Strength::grows}), boids), {-600, -600}));
  EXPECT_TRUE(near(felt_by(with(Cohesion{.weight = 1, .radius = infinity}), {boids[0]}), {}));
}

}  // namespace
}  // namespace sturnus::test
