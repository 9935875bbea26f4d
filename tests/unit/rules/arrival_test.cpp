// Arrival stops where seek swings and the bare desired velocity orbits; wander as a plain function.
#include "vectors.h"

namespace sturnus::test {
namespace {

TEST(Arrival, SlowsDownWithinTheRadiusAndIsSeekBeyond) {
  expect_close(arrive({3, 4, 0}, {1, 0, 0}, 10, 5), {5, 8, 0});
  expect_close(arrive({6, 8, 0}, {1, 0, 0}, 10, 5), {5, 8, 0});
  expect_close(arrive({1.5f, 2, 0}, {1, 0, 0}, 10, 5), {2, 4, 0});  // half of the radius, half of the speed
  expect_close(arrive({0, 0, 0}, {1, 2, 3}, 10, 5), {-1, -2, -3});
  expect_close(arrive({0, 0, 0}, {1, 2, 3}, 10, 0), {-1, -2, -3});
}

struct Walk {
  double farthest_beyond = 0, last_speed = 0, last_distance = 0, least_distance = 1e9;
};

// One agent from (-20, 0) toward the origin, semi-implicit.
template <class Steer>
Walk walk(Steer&& steer, Vector v, int steps) {
  Vector at = {-20, 0, 0};
  Walk out;
  const float dt = 0.05f;
  for (int step = 0; step < steps; ++step) {
    const Vector a = steer(Vector{-at[0], -at[1], -at[2]}, v);
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] += a[i] * dt;
      at[i] += v[i] * dt;
    }
    out.farthest_beyond = std::max(out.farthest_beyond, double{at[0]});
    out.least_distance = std::min(out.least_distance, size_of(at));
  }
  out.last_speed = size_of(v);
  out.last_distance = size_of(at);
  return out;
}

// x'' = -x·max/slowing - x' is damped critically or more for slowing >= 4 max.
TEST(Arrival, ComesToRestAtTheTargetWithoutOvershoot) {
  const Walk found = walk([](const Vector& o, const Vector& v) { return arrive(o, v, 2, 8); }, {}, 4000);
  EXPECT_LT(found.last_speed, 1e-3);
  EXPECT_LT(found.last_distance, 1e-3);
  EXPECT_LT(found.farthest_beyond, 0.02);
}

TEST(Arrival, WithAShortRadiusOvershootsByABoundedWayAndStops) {
  const Walk found = walk([](const Vector& o, const Vector& v) { return arrive(o, v, 2, 2); }, {}, 4000);
  EXPECT_LT(found.last_distance, 1e-3);
  EXPECT_GT(found.farthest_beyond, 0.05);
  EXPECT_LT(found.farthest_beyond, 1);
}

TEST(Arrival, SeekNeverStops) {
  const Walk found = walk([](const Vector& o, const Vector& v) { return seek(o, v, 2); }, {}, 4000);
  EXPECT_GT(found.last_speed, 0.01);
}

// VUW CGRA 354 (S2-19): adding the desired velocity itself is a pull of constant size, which keeps an orbit;
// the difference of both takes the agent in.
TEST(Arrival, AddingTheDesiredVelocityItselfOrbits) {
  const Vector across = {0, 6, 0};
  const auto orbit = [](const Vector& o, const Vector&) { return seek(o, {}, 2); };
  EXPECT_GT(walk(orbit, across, 8000).least_distance, 5);
  EXPECT_GT(walk(orbit, across, 8000).last_speed, 3);
  const auto arriving = [](const Vector& o, const Vector& v) { return arrive(o, v, 2, 8); };
  EXPECT_LT(walk(arriving, across, 8000).last_distance, 1e-3);
}

RC_GTEST_PROP(Arrival, TurnsWithTheWorldAndWishesAtMostFullSpeed, ()) {
  const Vector o = any_vector(3, 10), v = any_vector(3, 3);
  const double angle = *rc::gen::inRange(0, 628) / 100.0;
  expect_close(turned(arrive(o, v, 4, 5), angle), arrive(turned(o, angle), turned(v, angle), 4, 5), 1e-4);
  expect_close(mirrored(arrive(o, v, 4, 5)), arrive(mirrored(o), mirrored(v), 4, 5));
  RC_ASSERT(size_of(arrive(o, {}, 4, 5)) <= 4 + 1e-5);
}

TEST(WanderStep, IsAUnitVectorNearTheOldOne) {
  expect_close(wander({1, 0, 0}, {0, 1, 0}, 0.75f), {0.8f, 0.6f, 0});
  expect_close(wander({0, 1, 0}, {0.3f, 0.2f, 0}, 0), {0, 1, 0});
  expect_close(wander({1, 0, 0}, {-1, 0, 0}, 1), {1, 0, 0});  // through the origin: it stays
}

}  // namespace
}  // namespace sturnus::test
