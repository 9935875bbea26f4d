// Avoiding obstacles: the roots of the line through a sphere, its cases, the first of several, the form of CS
// 184; against references in double that solve the textbook formulas.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sturnus/steering.h>

#include "support.h"

namespace sturnus::test {
namespace {

using Doubles = std::array<double, 3>;

double dot(const Doubles& a, const Doubles& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Doubles sum(const Doubles& a, const Doubles& b, double factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Doubles unit_of(const Doubles& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? Doubles{v[0] / size, v[1] / size, v[2] / size} : Doubles{};
}
Doubles doubles(const Point& v) {
  return {v[0], v[1], v[2]};
}
void expect_near(const Point& found, const Doubles& expected, double within = 2e-6) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(found[axis], expected[axis], within) << "axis " << axis;
}

// ---- one boid and one sphere ----

TEST(DistanceToSphere, IsTheSmallerRootOfTheQuadratic) {
  EXPECT_FLOAT_EQ(distance_to_sphere({10, 0, 0}, {2, 0, 0}, 3).value(), 7);
  EXPECT_FLOAT_EQ(distance_to_sphere({10, 3, 0}, {1, 0, 0}, 5).value(), 6);   // 10 - sqrt(25 - 9)
  EXPECT_FLOAT_EQ(distance_to_sphere({3, 4, 12}, {0, 0, 1}, 13).value(), 0);  // on the surface, going in
}

TEST(DistanceToSphere, HasTheCasesOfTheLecture) {
  EXPECT_TRUE(distance_to_sphere({10, 0, 0}, {1, 0, 0}, 3)) << "hit";
  EXPECT_FLOAT_EQ(distance_to_sphere({10, 3, 0}, {1, 0, 0}, 3).value(), 10) << "skim: a tangent counts";
  EXPECT_FLOAT_EQ(distance_to_sphere({1, 2, 0}, {1, 0, 0}, 3).value(), 0) << "inside";
  EXPECT_FLOAT_EQ(distance_to_sphere({-1, 2, 0}, {1, 0, 0}, 3).value(), 0) << "inside, on the way out";
  EXPECT_FALSE(distance_to_sphere({10, 3.001f, 0}, {1, 0, 0}, 3)) << "miss";
  EXPECT_FALSE(distance_to_sphere({-10, 0, 0}, {1, 0, 0}, 3)) << "behind";
  EXPECT_FALSE(distance_to_sphere({1, 0, 0}, {0, 0, 0}, 3)) << "at rest";
}

TEST(AvoidSphere, PushesSidewaysAwayFromTheCentre) {
  EXPECT_EQ(avoid_sphere({10, 2, 0}, {3, 0, 0}, 5, 20), (Vector{0, -1, 0}));
  EXPECT_EQ(avoid_sphere({10, 0, -2}, {3, 0, 0}, 5, 20), (Vector{0, 0, 1}));
  EXPECT_EQ(avoid_sphere({1, 2, 0}, {3, 0, 0}, 5, 20), (Vector{0, -1, 0})) << "inside, the same way";
}

TEST(AvoidSphere, LooksNoFartherThanItShould) {
  EXPECT_EQ(avoid_sphere({10, 0, 1}, {1, 0, 0}, 1, 10), (Vector{0, 0, -1}));
  EXPECT_EQ(avoid_sphere({10, 0, 1}, {1, 0, 0}, 1, 9.999f), Vector{});
}

TEST(AvoidSphere, AimedAtTheCentreTakesAFixedPerpendicular) {
  EXPECT_EQ(avoid_sphere({10, 0, 0}, {1, 0, 0}, 2, 20), avoid_sphere({7, 0, 0}, {1, 0, 0}, 2, 20));
  for (const Vector& v :
       {Vector{1, 0, 0}, Vector{0, -2, 0}, Vector{3, 4, 0}, Vector{1, 2, 3}, Vector{0, 0, 1}}) {
    const Vector to_centre = {10 * v[0], 10 * v[1], 10 * v[2]};
    const Doubles force = doubles(avoid_sphere(to_centre, v, 2, 100));
    EXPECT_NEAR(dot(force, force), 1, 1e-6);
    EXPECT_NEAR(dot(force, doubles(v)), 0, 1e-6);
  }
}

struct Case {
  Point to_centre, velocity;
  float radius, ahead;
};

Case random_case() {
  const auto some = [] { return static_cast<float>(*rc::gen::inRange(-10000, 10000)) / 1000.0f; };
  return {{some(), some(), some()}, {some(), some(), some()}, std::abs(some()) + 0.01f, 2 * std::abs(some())};
}

RC_GTEST_PROP(AvoidSphere, AgreesWithTheTextbook, ()) {
  const Case one = random_case();
  const Doubles d = unit_of(doubles(one.velocity));
  RC_PRE(dot(d, d) > 0);
  const Doubles c = doubles(one.to_centre);
  // O = 0: a = D.D, b = 2 (O - C).D, c = |O - C|^2 - R^2
  const double b = -2 * dot(c, d), rest = dot(c, c) - double{one.radius} * double{one.radius};
  const double discriminant = b * b - 4 * rest;
  const double near = (-b - std::sqrt(std::max(0.0, discriminant))) / 2;
  const bool inside = rest < 0;
  const double t = inside ? 0 : near;
  RC_PRE(std::abs(discriminant) > 1e-3 && std::abs(rest) > 1e-3 && std::abs(t - double{one.ahead}) > 1e-3);
  const bool hits = inside || (discriminant >= 0 && near > 0 && near <= double{one.ahead});
  const Vector found = avoid_sphere(one.to_centre, one.velocity, one.radius, one.ahead);
  RC_ASSERT(hits == (found != Vector{}));
  if (!hits) return;
  RC_ASSERT(std::abs(double{distance_to_sphere(one.to_centre, one.velocity, one.radius).value()} - t) < 1e-4);
  const Doubles e = sum({}, d, dot(c, d));
  const Doubles away = sum(e, c, -1);
  RC_PRE(dot(away, away) > 1e-4);
  const Doubles expected = unit_of(away);
  for (std::size_t axis = 0; axis < 3; ++axis)
    RC_ASSERT(std::abs(double{found[axis]} - expected[axis]) < 1e-3);
}

RC_GTEST_PROP(AvoidSphere, TurnsWithTheWorld, ()) {
  const Case one = random_case();
  // Aimed at the very centre the perpendicular is fixed, not turned.
  const Doubles d = unit_of(doubles(one.velocity)), c = doubles(one.to_centre);
  RC_PRE(dot(c, c) - dot(c, d) * dot(c, d) > 1e-2);
  const auto turned = [](const Point& v) { return Point{-v[1], v[0], v[2]}; };
  const Vector plain = avoid_sphere(one.to_centre, one.velocity, one.radius, one.ahead);
  const Vector other = avoid_sphere(turned(one.to_centre), turned(one.velocity), one.radius, one.ahead);
  const Vector expected = turned(plain);
  for (std::size_t axis = 0; axis < 3; ++axis) RC_ASSERT(std::abs(other[axis] - expected[axis]) < 1e-5f);
}

// ---- in the engine ----

ScenarioDef with_spheres(const std::vector<Coordinates>& spheres, ObstacleForm form = ObstacleForm::sweep) {
  ScenarioDef scenario = bare(static_cast<int>(spheres.front().size()) - 1);
  scenario.obstacles = {{spheres, {}, {}, {}}};
  scenario.flocks.front().avoid_obstacles =
      AvoidObstacles{.weight = 2, .look_ahead = 20, .clearance = 1, .form = form, .radius = 6};
  scenario.flocks.front().body_radius = 0.5;
  return scenario;
}

TEST(AvoidObstacles, AddsBodyAndClearanceToTheRadius) {
  expect_near(felt_by(with_spheres({{10, 4.4, 3}}), {{{0, 0}, {1, 0}}}), {0, -2, 0});
  expect_near(felt_by(with_spheres({{10, 4.6, 3}}), {{{0, 0}, {1, 0}}}), {0, 0, 0});
}

TEST(AvoidObstacles, TakesTheFirstOfSeveralWhateverTheirOrder) {
  const Coordinates near = {10, 1, 3}, far = {14, -1, 3};
  expect_near(felt_by(with_spheres({near, far}), {{{0, 0}, {1, 0}}}), {0, -2, 0});
  expect_near(felt_by(with_spheres({far, near}), {{{0, 0}, {1, 0}}}), {0, -2, 0});
  expect_near(felt_by(with_spheres({far}), {{{0, 0}, {1, 0}}}), {0, 2, 0});
}

TEST(AvoidObstacles, ATieGoesToTheLowerNumber) {
  expect_near(felt_by(with_spheres({{10, 1, 3}, {10, -1, 3}}), {{{0, 0}, {1, 0}}}), {0, -2, 0});
  expect_near(felt_by(with_spheres({{10, -1, 3}, {10, 1, 3}}), {{{0, 0}, {1, 0}}}), {0, 2, 0});
}

TEST(AvoidObstacles, SeesTheNearestImage) {
  ScenarioDef scenario = with_spheres({{-995, 1, 3}});
  const Placed boid{{990, 0}, {1, 0}};
  expect_near(felt_by(scenario, {boid}), {0, 0, 0});
  scenario.space.boundary.kind = BoundaryKind::wrap;
  expect_near(felt_by(scenario, {boid}), {0, -2, 0}, 1e-4);
}

TEST(AvoidObstacles, WhoIsAtRestFeelsNothing) {
  expect_near(felt_by(with_spheres({{1, 0, 3}}), {{{0, 0}, {0, 0}}}), {0, 0, 0});
}

TEST(AvoidObstacles, BoxesAndPlanesPushAlongTheNormalOfTheirFace) {
  ScenarioDef scenario = with_spheres({{900, 900, 1}});
  scenario.obstacles = {{{}, {{10, -5, 14, 5}}, {}, {}}};
  expect_near(felt_by(scenario, {{{0, 0}, {1, 0}}}), {-2, 0, 0});
  expect_near(felt_by(scenario, {{{12, -16}, {0, 1}}}), {0, -2, 0});
  expect_near(felt_by(scenario, {{{0, 7}, {1, 0}}}), {0, 0, 0});
  scenario.obstacles = {{{}, {}, {{10, 0, -3, 0}}, {}}};
  expect_near(felt_by(scenario, {{{0, 0}, {1, 1}}}), {-2, 0, 0});
  expect_near(felt_by(scenario, {{{0, 0}, {-1, 0}}}), {0, 0, 0});
  expect_near(felt_by(scenario, {{{12, 0}, {-1, 0}}}), {-2, 0, 0});  // behind it is inside
}

// CS 184: unit(p - C) - heading over those whose surface is near, averaged.
Doubles heading_reference(const Point& p, const Point& v, const std::vector<Coordinates>& spheres,
                          double radius) {
  Doubles total{};
  int count = 0;
  for (const Coordinates& sphere : spheres) {
    Doubles away = doubles(p);
    for (std::size_t axis = 0; axis + 1 < sphere.size(); ++axis) away[axis] -= sphere[axis];
    if (std::sqrt(dot(away, away)) - sphere.back() > radius) continue;
    total = sum(sum(total, unit_of(away), 1), unit_of(doubles(v)), -1);
    ++count;
  }
  return count == 0 ? Doubles{} : sum({}, total, 2.0 / count);
}

RC_GTEST_PROP(AvoidObstacles, TheHeadingFormAgreesWithItsReference, ()) {
  const int axes = *rc::gen::inRange(2, 4);
  // Whole fiftieths as floats, which is how the engine keeps obstacles: beside a centre their rounding shows.
  const auto some = [] { return double{static_cast<float>(*rc::gen::inRange(-1000, 1000)) / 50.0f}; };
  std::vector<Coordinates> spheres;
  for (int n = *rc::gen::inRange(1, 12); n > 0; --n) {
    Coordinates sphere;
    for (int axis = 0; axis < axes; ++axis) sphere.push_back(some());
    sphere.push_back(0.5 + std::abs(some()) / 4);
    spheres.push_back(sphere);
  }
  Placed boid;
  for (int axis = 0; axis < axes; ++axis) {
    boid.position[static_cast<std::size_t>(axis)] = static_cast<float>(some());
    boid.velocity[static_cast<std::size_t>(axis)] = static_cast<float>(some());
  }
  const Point found = felt_by(with_spheres(spheres, ObstacleForm::heading), {boid});
  const Doubles expected = heading_reference(boid.position, boid.velocity, spheres, 6);
  for (std::size_t axis = 0; axis < 3; ++axis)
    RC_ASSERT(std::abs(double{found[axis]} - expected[axis]) < 2e-5);
}

TEST(AvoidObstacles, TheHeadingFormAveragesAndHasAnEdge) {
  const std::vector<Coordinates> two = {{8, 0, 2}, {0, -8, 2}};
  expect_near(felt_by(with_spheres(two, ObstacleForm::heading), {{{0, 0}, {1, 0}}}), {2 * -1.5, 2 * 0.5, 0});
  expect_near(felt_by(with_spheres({{8.01, 0, 2}}, ObstacleForm::heading), {{{0, 0}, {1, 0}}}), {0, 0, 0});
}

TEST(AvoidObstacles, TheHeadingFormLeavesABoxByTheNearestWay) {
  ScenarioDef scenario = with_spheres({{900, 900, 1}}, ObstacleForm::heading);
  scenario.obstacles = {{{}, {{3, 4, 9, 9}}, {}, {}}};
  expect_near(felt_by(scenario, {{{0, 0}, {0, 1}}}), {2 * -0.6, 2 * (-0.8 - 1), 0});
}

TEST(AvoidObstacles, CanBeSwitchedOff) {
  ScenarioDef scenario = with_spheres({{10, 1, 3}});
  scenario.flocks.front().avoid_obstacles->on = false;
  expect_near(felt_by(scenario, {{{0, 0}, {1, 0}}}), {0, 0, 0});
}

}  // namespace
}  // namespace sturnus::test
