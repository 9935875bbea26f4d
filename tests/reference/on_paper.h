// What the tests of the references share: worlds on paper, and equality without paper's rounding.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <ostream>

#include "reference.h"

namespace reference {

inline void PrintTo(Vec a, std::ostream* out) {
  *out << '(' << a.x << ", " << a.y << ", " << a.z << ')';
}

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Boid {
  Vec position, velocity;
};

inline Boids boids(std::initializer_list<Boid> list) {
  Boids all;
  for (const Boid& boid : list) {
    all.position.push_back(boid.position);
    all.velocity.push_back(boid.velocity);
  }
  return all;
}

/// Paper has no rounding; double's is far below 1e-12 of any number here.
inline testing::AssertionResult near(Vec actual, Vec expected) {
  if (length(actual - expected) <= 1e-12 * (1 + length(expected))) return testing::AssertionSuccess();
  return testing::AssertionFailure() << testing::PrintToString(actual) << " is not "
                                     << testing::PrintToString(expected);
}

}  // namespace reference
