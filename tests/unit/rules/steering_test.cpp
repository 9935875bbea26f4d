// Flow fields, leader following, avoidance, hiding and queuing, as plain functions for one agent.
#include <vector>

#include "vectors.h"

namespace sturnus::test {
namespace {

TEST(FlowFollowing, WishesTheVelocityThatStandsWhereItWillBe) {
  const auto shear = [](const Vector& place) { return Vector{place[1], 0, 0}; };
  // Will be at y = 3 + 2·0.5 = 4: (4, 0) - (1, 2).
  expect_close(follow_flow(shear, 0.5f, {7, 3, 0}, {1, 2, 0}), {3, -2, 0});
}

// What is linear on every axis is met exactly by linear interpolation: a + bx + cy + dz + exy + ... too.
RC_GTEST_PROP(FlowGrids, AreExactForWhatIsLinearOnEveryAxis, ()) {
  const std::array<std::size_t, 3> points = {3, 4, *rc::gen::element<std::size_t>(1, 5)};
  const auto value = [&](double x, double y, double z) {
    if (points[2] == 1) z = 0;
    return std::array<double, 3>{1 + 2 * x - y + x * y, z * x - 3 * z, x * y * z + 0.5};
  };
  const Vector first = {-1, 2, 3}, spacing = {0.5f, 2, 1};
  std::vector<Vector> velocities;
  for (std::size_t k = 0; k < points[2]; ++k)
    for (std::size_t j = 0; j < points[1]; ++j)
      for (std::size_t i = 0; i < points[0]; ++i) {
        const auto v = value(-1 + 0.5 * double(i), 2 + 2 * double(j), 3 + double(k));
        velocities.push_back({float(v[0]), float(v[1]), float(v[2])});
      }
  const FlowGrid grid{velocities, points, first, spacing};
  const float x = -1 + 1.0f * float(*rc::gen::inRange(0, 101)) / 100;
  const float y = 2 + 6.0f * float(*rc::gen::inRange(0, 101)) / 100;
  const float z = 3 + 4.0f * float(*rc::gen::inRange(0, 101)) / 100;
  const auto expected = value(x, y, z);
  expect_close(grid({x, y, z}), {float(expected[0]), float(expected[1]), float(expected[2])}, 1e-3);
  expect_close(grid({-100, y, z}), grid({-1, y, z}));  // beyond the edge: what stands on it
  expect_close(grid({1e15f, 1e15f, 1e15f}), velocities.back());
}

TEST(Vortex, IsARigidDiscWithinItsCoreAndFadesOutside) {
  expect_close(vortex({4, 0, 9}, 3, 4), {0, 3, 0});
  expect_close(vortex({0, 2, 0}, 3, 4), {-1.5f, 0, 0});
  expect_close(vortex({8, 0, 0}, 3, 4), {0, 1.5f, 0});
  expect_close(vortex({0, 0, 0}, 3, 4), {0, 0, 0});
  expect_close(vortex({0, 0, 0}, 3, 0), {0, 0, 0});
  expect_close(vortex({4, 0, 0}, -3, 4), {0, -3, 0});
}

TEST(LeaderFollowing, ArrivesBehindAndKeepsOutOfTheWay) {
  const Vector leader_velocity = {0, 2, 0};
  // The leader is 10 up; behind it is 7 up: full speed.
  expect_close(follow_leader({0, 10, 0}, leader_velocity, 3, 1, {1, 0, 0}, 2, 4), {-1, 2, 0});
  expect_close(follow_leader({0, 3, 0}, leader_velocity, 3, 1, {0, 0, 0}, 2, 4), {0, 0, 0});  // there
  // One ahead of the leader and half to its right: aside, to the right.
  expect_close(follow_leader({-0.5f, -1, 0}, leader_velocity, 3, 1, {0, 0, 0}, 2, 4), {2, 0, 0});
  expect_close(follow_leader({0, -1, 0}, leader_velocity, 3, 1, {0, 0, 0}, 2, 4), {-2, 0, 0});  // left
  // Wide of it, or far ahead: no need to.
  EXPECT_LT(follow_leader({-1.5f, -1, 0}, leader_velocity, 3, 1, {0, 0, 0}, 2, 4)[1], 0);
  EXPECT_LT(follow_leader({0, -5, 0}, leader_velocity, 3, 1, {0, 0, 0}, 2, 4)[1], 0);
}

TEST(NearestApproach, IsWhereTheGapIsLeast) {
  EXPECT_FLOAT_EQ(*nearest_approach_time({10, 1, 0}, {-1, 0, 0}, {1, 0, 0}), 5);
  EXPECT_FALSE(nearest_approach_time({10, 1, 0}, {1, 0, 0}, {1, 0, 0}));  // alike
  EXPECT_FALSE(nearest_approach_time({10, 1, 0}, {2, 0, 0}, {1, 0, 0}));  // apart
  EXPECT_FALSE(nearest_approach_time({0, 0, 0}, {2, 0, 0}, {1, 0, 0}));   // now
  EXPECT_FALSE(nearest_approach_time({10, 1, 0}, {0, 0, 0}, {0, 0, 0}));  // at rest
}

RC_GTEST_PROP(NearestApproach, HasNoNearerMoment, ()) {
  const Vector o = any_vector(3, 10), a = any_vector(3, 2), b = any_vector(3, 2);
  const auto time = nearest_approach_time(o, a, b);
  const auto gap = [&](double t) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::pow(double{o[i]} + (double{a[i]} - double{b[i]}) * t, 2);
    return std::sqrt(sum);
  };
  const double best = time ? double{*time} : 0;
  for (int k = 0; k < 200; ++k) RC_ASSERT(gap(best) <= gap(best * k / 100 + (time ? 0 : k * 0.1)) + 1e-4);
}

TEST(Sidestep, IsAcrossTheHeadingAndAway) {
  // Will be 1 to the left (y) when nearest: step to the right.
  expect_close(sidestep({10, 1, 0}, {-1, 0, 0}, 5, {1, 0, 0}), {0, -1, 0});
  expect_close(sidestep({10, -1, 0}, {-1, 0, 0}, 5, {1, 0, 0}), {0, 1, 0});
  // Head-on, both to their right.
  expect_close(sidestep({10, 0, 0}, {-1, 0, 0}, 5, {1, 0, 0}), {0, -1, 0});
  expect_close(sidestep({-10, 0, 0}, {1, 0, 0}, 5, {-1, 0, 0}), {0, 1, 0});
  expect_close(sidestep({5, 2, 0}, {0, 0, 0}, 0, {0, 0, 0}), {-0.9284767f, -0.3713907f, 0});  // at rest
}

RC_GTEST_PROP(Sidestep, IsAUnitVectorThatTurnsAndMirrorsWithTheWorld, ()) {
  const Vector o = any_vector(2, 10), a = any_vector(2, 2), b = any_vector(2, 2);
  RC_PRE(size_of(o) > 0.5 && size_of(b) > 0.1);
  const double angle = *rc::gen::inRange(0, 628) / 100.0;
  const Vector felt = sidestep(o, a, 1, b);
  RC_ASSERT(std::abs(size_of(felt) - 1) < 1e-5);
  RC_ASSERT(std::abs(double{felt[0]} * double{b[0]} + double{felt[1]} * double{b[1]}) < 5e-3);
  double across = 0;  // of the gap, to the left of the heading
  for (const int side : {0, 1}) {
    const auto i = static_cast<std::size_t>(side);
    const double gap = double{o[i]} + double{a[i]} - double{b[i]};
    across += gap * double{side == 0 ? -b[1] : b[0]} / size_of(b);
  }
  RC_PRE(std::abs(across) > 0.02);
  expect_close(turned(felt, angle), sidestep(turned(o, angle), turned(a, angle), 1, turned(b, angle)), 1e-3);
  expect_close(mirrored(felt), sidestep(mirrored(o), mirrored(a), 1, mirrored(b)));
}

TEST(Hiding, GoesToTheNearestFarSide) {
  const std::vector<Ball> balls = {{{20, 0, 0}, 2}, {{0, 5, 0}, 1}};
  // The threat is at (0, 20): behind the second ball, 1 + 1 below its centre at (0, 5), is (0, 3).
  expect_close(hide(balls, {0, 20, 0}, 1, {0, 0, 0}, 2, 6), {0, 1, 0});
  expect_close(hide(balls, {0, 20, 0}, 4, {1, 0, 0}, 2, 6), {-1, 0, 0});  // there already
  // With the first ball's far side nearer than the second's.
  const std::vector<Ball> other = {{{4, 0, 0}, 1}, {{0, -9, 0}, 1}};
  expect_close(hide(other, {20, 0, 0}, 1, {0, 0, 0}, 2, 6), {2.0f / 3, 0, 0});
  expect_close(hide(std::span(balls).subspan(1), {0, 5.5f, 0}, 1, {1, 0, 0}, 2, 6),
               {});  // within, off centre
  expect_close(hide({}, {0, 20, 0}, 1, {1, 0, 0}, 2, 6), {0, 0, 0});
  expect_close(hide(std::span(balls).subspan(1), {0, 5, 0}, 1, {1, 0, 0}, 2, 6), {0, 0, 0});  // threat within
}

// From the threat, the ball stands before the place that is sought.
RC_GTEST_PROP(Hiding, TheBallStandsBetween, ()) {
  const Ball ball{any_vector(3, 10), 2};
  const Vector threat = any_vector(3, 20);
  Vector from_threat{};
  for (std::size_t i = 0; i < 3; ++i) from_threat[i] = ball.offset[i] - threat[i];
  RC_PRE(size_of(from_threat) > 2.1);
  const Vector wish = hide(std::span(&ball, 1), threat, 1, {}, 1, 1000);  // slow: offset / 1000
  double along = 0;
  std::array<double, 3> beyond{};
  for (std::size_t i = 0; i < 3; ++i) {
    beyond[i] = double{wish[i]} * 1000 - double{ball.offset[i]};
    along += beyond[i] * double{from_threat[i]} / size_of(from_threat);
  }
  RC_ASSERT(std::abs(along - 3) < 1e-3);
  RC_ASSERT(std::abs(std::hypot(beyond[0], beyond[1], beyond[2]) - 3) < 1e-3);
}

TEST(Queuing, SeesWhoIsAheadInTheConeAndBrakes) {
  const float half = 0.8660254f;  // 30 degrees
  EXPECT_TRUE(is_ahead({3, 1, 0}, {2, 0, 0}, 5, half));
  EXPECT_FALSE(is_ahead({3, 2, 0}, {2, 0, 0}, 5, half));  // 33.7 degrees
  EXPECT_FALSE(is_ahead({5, 0, 0}, {2, 0, 0}, 5, half));
  EXPECT_FALSE(is_ahead({-3, 0, 0}, {2, 0, 0}, 5, half));
  EXPECT_FALSE(is_ahead({3, 0, 0}, {0, 0, 0}, 5, half));
  expect_close(brake({3, 4, 0}, {2, 0, 0}, 10), {-1, 0, 0});
  expect_close(brake({0, 0, 0}, {2, 4, 6}, 10), {-2, -4, -6});
  expect_close(brake({10, 0, 0}, {2, 0, 0}, 10), {0, 0, 0});
  expect_close(brake({10, 0, 0}, {2, 0, 0}, 0), {0, 0, 0});
  expect_close(brake({0, 0, 0}, {2, 0, 0}, 0), {0, 0, 0});
  expect_close(brake({20, 0, 0}, {2, 0, 0}, 10), {0, 0, 0});  // never pushes
}

}  // namespace
}  // namespace sturnus::test
