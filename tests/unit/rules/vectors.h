// For the tests of steering behaviours: vectors in double, and turning and mirroring them.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sturnus/steering.h>

#include <cmath>

namespace sturnus::test {

inline void expect_close(const Vector& found, const Vector& expected, double within = 1e-5) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(double{found[axis]}, double{expected[axis]}, within) << "axis " << axis;
}

inline double size_of(const Vector& v) {
  return std::sqrt(double{v[0]} * double{v[0]} + double{v[1]} * double{v[1]} + double{v[2]} * double{v[2]});
}

/// A vector with components in [-size, size], of a plane or of space.
inline Vector any_vector(int dimensions, double size) {
  Vector v{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
    v[axis] = static_cast<float>(size * *rc::gen::inRange(-10000, 10001) / 10000);
  return v;
}

/// Turned by an angle (radians) about z.
inline Vector turned(const Vector& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {static_cast<float>(c * double{v[0]} - s * double{v[1]}),
          static_cast<float>(s * double{v[0]} + c * double{v[1]}), v[2]};
}

/// Mirrored in the x axis (in space: in the plane y = 0).
inline Vector mirrored(const Vector& v) {
  return {v[0], -v[1], v[2]};
}

}  // namespace sturnus::test
