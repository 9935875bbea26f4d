// Interception, pursuit, evasion, offset pursuit, against solutions by other means.
#include "vectors.h"

namespace sturnus::test {
namespace {

// |o + v T| - s T.
double miss(const Vector& o, const Vector& v, double speed, double time) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = double{o[axis]} + double{v[axis]} * time;
    sum += at * at;
  }
  return std::sqrt(sum) - speed * time;
}

TEST(Interception, OfWhoComesStraightOnTakesTheDistanceOverBothSpeeds) {
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {-2, 0, 0}, 3)}, 2, 1e-6);
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {2, 0, 0}, 4)}, 5, 1e-6);
}

TEST(Interception, OfWhoCrossesIsARightTriangle) {
  // 3 away, quarry 4 across, own 5: after one time unit 3-4-5.
  EXPECT_NEAR(double{*interception_time({3, 0, 0}, {0, 4, 0}, 5)}, 1, 1e-6);
  EXPECT_NEAR(double{*interception_time({0, 0, 3}, {0, 4, 0}, 5)}, 1, 1e-6);
}

TEST(Interception, OfWhoIsAsFastIsLinear) {
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {-2, 0, 0}, 2)}, 2.5, 1e-6);
  // |o + vT|² = s²T²: 25 - 2·3·5/... o = (3, 4), v = (-5, 0), s = 5: T = -25 / (2·-15).
  EXPECT_NEAR(double{*interception_time({3, 4, 0}, {-5, 0, 0}, 5)}, 25.0 / 30, 1e-6);
  EXPECT_FALSE(interception_time({10, 0, 0}, {2, 0, 0}, 2));
  EXPECT_FALSE(interception_time({10, 0, 0}, {0, 2, 0}, 2));
}

TEST(Interception, OfWhoIsFasterMayBePossibleTwiceAndIsTakenTheFirstTime) {
  // (10 - 4T)² = 4T²: T = 10/6 or 5.
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {-4, 0, 0}, 2)}, 10.0 / 6, 1e-6);
  EXPECT_FALSE(interception_time({10, 0, 0}, {4, 0, 0}, 2));
  EXPECT_FALSE(interception_time({10, 8, 0}, {-4, 0, 0}, 2));  // passes too far off
}

TEST(Interception, WhereTheyHaveMetTakesNoTime) {
  EXPECT_EQ(interception_time({0, 0, 0}, {5, 0, 0}, 1), 0.0f);
  EXPECT_EQ(interception_time({0, 0, 0}, {0, 0, 0}, 0), 0.0f);
}

TEST(Interception, OfWhoStandsStillIsImpossibleOnlyWithoutSpeed) {
  EXPECT_NEAR(double{*interception_time({6, 8, 0}, {0, 0, 0}, 2)}, 5, 1e-6);
  EXPECT_FALSE(interception_time({6, 8, 0}, {0, 0, 0}, 0));
}

TEST(Interception, KeepsItsDigitsWhereSpeedsNearlyAgree) {
  // s = |v|(1 + 2^-20), quarry flees: T = 10 / (s - |v|) = 10·2^20, where a = v² - s² has few digits in
  // float.
  const float speed = 1.0f + 0x1p-20f;
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {1, 0, 0}, speed)} / (10 * 0x1p20), 1, 1e-6);
  // And comes: T = 10 / (s + |v|); -b - root would cancel.
  EXPECT_NEAR(double{*interception_time({10, 0, 0}, {-1, 0, 0}, speed)}, 10 / (2 + 0x1p-20), 1e-6);
}

TEST(Interception, OfVastDistancesDoesNotOverflow) {
  EXPECT_NEAR(double{*interception_time({1e15f, 0, 0}, {0, 0, 0}, 1e15f)}, 1, 1e-6);
  EXPECT_FALSE(interception_time({1e15f, 0, 0}, {0, 0, 0}, 1e-5f));  // not within 1e15 time units
}

// Marches in small steps of double to the first change of sign, where the quadratic has not been heard of.
RC_GTEST_PROP(Interception, IsTheFirstTimeWhenTheReachMeetsTheQuarry, ()) {
  const int dimensions = *rc::gen::inRange(2, 4);
  const Vector o = any_vector(dimensions, 10), v = any_vector(dimensions, 3);
  const auto speed = static_cast<float>(*rc::gen::inRange(0, 400)) / 100;
  RC_PRE(size_of(o) > 0.1);
  const auto time = interception_time(o, v, speed);
  const double until = time ? std::min(double{*time}, 100.0) : 100.0;
  for (int i = 0; i < 2000; ++i) RC_ASSERT(miss(o, v, double{speed}, until * i / 2001) > 0);
  if (time) {
    RC_ASSERT(std::abs(miss(o, v, double{speed}, double{*time})) <=
              1e-6 * (10 + (size_of(v) + double{speed}) * double{*time}));
  }
}

TEST(Prediction, HasThreeForms) {
  const Vector o = {3, 4, 0}, v = {1, 0, 0};
  EXPECT_EQ(prediction_time(Prediction::constant, 7, o, v, 2), 7);
  EXPECT_EQ(prediction_time(Prediction::distance, 0.5f, o, v, 2), 2.5f);
  EXPECT_EQ(prediction_time(Prediction::intercept, 0.5f, o, v, 2), *interception_time(o, v, 2));
  EXPECT_EQ(prediction_time(Prediction::intercept, 0.5f, o, {3, 4, 0}, 2), 2.5f);  // there is none
}

TEST(Pursuit, SeeksWhereTheQuarryWillBeAndEvasionFleesIt) {
  // (3, 0) + (0, 4): 5 (0.6, 0.8) - (1, 1).
  expect_close(pursue({3, 0, 0}, {0, 4, 0}, 1, {1, 1, 0}, 5), {2, 3, 0});
  expect_close(evade({3, 0, 0}, {0, 4, 0}, 1, {1, 1, 0}, 5), {-4, -5, 0});
  expect_close(pursue({3, 0, 0}, {-3, 0, 0}, 1, {1, 2, 3}, 5), {-1, -2, -3});  // it comes here
}

// Constant bearing: at full speed along the pursued direction the line to the quarry does not turn.
RC_GTEST_PROP(Pursuit, AtTheInterceptionTimeKeepsTheBearing, ()) {
  const Vector o = any_vector(3, 10), v = any_vector(3, 1);
  RC_PRE(size_of(o) > 1);
  const float speed = 2;
  const auto time = interception_time(o, v, speed);
  RC_ASSERT(time.has_value());
  const Vector own = pursue(o, v, *time, {}, speed);
  Vector later{};
  for (std::size_t axis = 0; axis < 3; ++axis) later[axis] = o[axis] + (v[axis] - own[axis]) * 0.5f * *time;
  double dot = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) dot += double{o[axis]} * double{later[axis]};
  RC_ASSERT(dot >= (1 - 1e-6) * size_of(o) * size_of(later) - 1e-5);
  RC_ASSERT(std::abs(size_of(later) - 0.5 * size_of(o)) < 1e-4);
}

TEST(LeadersFrame, IsAheadLeftAndUp) {
  expect_close(in_world({1, 2, 3}, {5, 0, 0}), {1, 2, 3});
  expect_close(in_world({1, 2, 3}, {0, 5, 0}), {-2, 1, 3});
  expect_close(in_world({1, 2, 3}, {0, 0, 0}), {1, 2, 3});   // at rest: the world's axes
  expect_close(in_world({1, 2, 3}, {0, 0, 5}), {-3, 2, 1});  // straight up: left is y
  expect_close(in_world({0, 0, 1}, {3, 0, 4}), {-0.8f, 0, 0.6f});
}

RC_GTEST_PROP(LeadersFrame, IsARotation, ()) {
  const Vector leader = any_vector(3, 4), a = any_vector(3, 4), b = any_vector(3, 4);
  const Vector found_a = in_world(a, leader), found_b = in_world(b, leader);
  double before = 0, after = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    before += double{a[axis]} * double{b[axis]};
    after += double{found_a[axis]} * double{found_b[axis]};
  }
  RC_ASSERT(std::abs(before - after) < 1e-4);
  RC_ASSERT(std::abs(size_of(a) - size_of(found_a)) < 1e-5);
}

// A follower that begins anywhere comes to the offset of a steady leader and stays there, without a lag.
TEST(OffsetPursuit, ComesToItsPlaceBesideASteadyLeader) {
  const Vector leader_velocity = {0.6f, 0.8f, 0}, place = {-3, 2, 0};
  const float top = 2, slowing = 8, dt = 0.05f;
  Vector leader = {0, 0, 0}, at = {-20, 5, 0}, v = {};
  for (int step = 0; step < 4000; ++step) {
    Vector o{};
    for (std::size_t i = 0; i < 3; ++i) o[i] = leader[i] - at[i];
    const Vector a = pursue_offset(o, leader_velocity, place, slowing / top, v, top, slowing);
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] += a[i] * dt;
      at[i] += v[i] * dt;
      leader[i] += leader_velocity[i] * dt;
    }
  }
  const Vector wanted = in_world(place, leader_velocity);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(double{at[i] - leader[i]}, double{wanted[i]}, 0.01);
}

RC_GTEST_PROP(Pursuit, TurnsAndMirrorsWithTheWorld, ()) {
  const Vector o = any_vector(3, 10), q = any_vector(3, 3), v = any_vector(3, 3), place = any_vector(3, 5);
  RC_PRE(size_of(o) > 0.5 && size_of({q[0], q[1], 0}) > 0.1);
  const double angle = *rc::gen::inRange(0, 628) / 100.0;
  const auto turn = [angle](const Vector& a) { return turned(a, angle); };
  const float time = 0.5f;
  expect_close(turn(pursue(o, q, time, v, 4)), pursue(turn(o), turn(q), time, turn(v), 4), 2e-3);
  expect_close(mirrored(evade(o, q, time, v, 4)), evade(mirrored(o), mirrored(q), time, mirrored(v), 4));
  expect_close(turn(pursue_offset(o, q, place, time, v, 4, 2)),
               pursue_offset(turn(o), turn(q), place, time, turn(v), 4, 2), 2e-3);
  expect_close(mirrored(pursue_offset(o, q, place, time, v, 4, 2)),
               pursue_offset(mirrored(o), mirrored(q), mirrored(place), time, mirrored(v), 4, 2), 2e-3);
}

}  // namespace
}  // namespace sturnus::test
