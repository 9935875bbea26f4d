// The rules as every yardstick computes them, one neighbour at a time.
//
// In an unnamed namespace: each yardstick is compiled with flags of its own, and the linker must not put the
// code of one in the place of another's.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "yardstick.h"

namespace bench {
namespace {

template <int D>
using Vector = std::array<float, D>;

template <int D>
struct Boid {
  Vector<D> position;
  Vector<D> velocity;
};

template <int D>
struct Sums {
  int neighbours = 0;
  Vector<D> separation{}, velocity{}, offset{};
};

template <int D>
inline float dot(const Vector<D>& a, const Vector<D>& b) {
  float sum = 0;
  for (std::size_t axis = 0; axis < D; ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// From one place to another, in a wrapped space to its nearest image, by comparison.
template <int D, Course course>
inline Vector<D> offset_between(const Numbers& numbers, const Vector<D>& from, const Vector<D>& to) {
  Vector<D> offset;
  for (std::size_t axis = 0; axis < D; ++axis) {
    offset[axis] = to[axis] - from[axis];
    if constexpr (course == Course::wrapped) {
      // Chosen, not branched over: which way it goes is a guess that processors lose.
      const float half = 0.5f * numbers.size[axis];
      const float back = offset[axis] > half ? -numbers.size[axis] : 0.0f;
      const float forth = offset[axis] < -half ? numbers.size[axis] : 0.0f;
      offset[axis] += back + forth;
    }
  }
  return offset;
}

/// Adds the neighbour at `offset`, if it is near enough and seen.
template <int D, Course course>
inline void add_neighbour(const Numbers& numbers, const Vector<D>& own_velocity, const Vector<D>& offset,
                          const Vector<D>& velocity, Sums<D>& sums) {
  const float distance_squared = dot<D>(offset, offset);
  if (!(distance_squared < numbers.radius * numbers.radius)) return;
  if constexpr (course == Course::sighted) {
    const float lengths = std::sqrt(dot<D>(own_velocity, own_velocity)) * std::sqrt(distance_squared);
    if (dot<D>(own_velocity, offset) < numbers.cos_half_view * lengths) return;
  }
  ++sums.neighbours;
  for (std::size_t axis = 0; axis < D; ++axis) {
    sums.velocity[axis] += velocity[axis];
    sums.offset[axis] += offset[axis];
  }
  if (!(distance_squared < numbers.separation_radius * numbers.separation_radius)) return;
  if (distance_squared < std::numeric_limits<float>::min()) return;  // at one point: no direction
  const float scale = course == Course::wrapped ? 1.0f / distance_squared : 1.0f;
  for (std::size_t axis = 0; axis < D; ++axis) sums.separation[axis] += offset[axis] * scale;
}

template <int D, Course course>
inline Vector<D> acceleration(const Numbers& numbers, const Boid<D>& boid, const Sums<D>& sums) {
  Vector<D> out{};
  const float share = sums.neighbours > 0 ? 1.0f / static_cast<float>(sums.neighbours) : 0.0f;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float lag = sums.neighbours > 0 ? sums.velocity[axis] * share - boid.velocity[axis] : 0.0f;
    out[axis] = -numbers.separation * sums.separation[axis] + numbers.alignment * lag +
                numbers.cohesion * sums.offset[axis] * share;
  }
  const float length = std::sqrt(dot<D>(out, out));
  if (length > numbers.max_acceleration) {
    for (float& value : out) value *= numbers.max_acceleration / length;
  }
  if constexpr (course == Course::sighted) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (boid.position[axis] < numbers.min[axis] + numbers.margin) out[axis] += numbers.turn;
      if (boid.position[axis] > numbers.max[axis] - numbers.margin) out[axis] -= numbers.turn;
    }
  }
  return out;
}

/// The boid one step later.
template <int D, Course course>
inline Boid<D> moved(const Numbers& numbers, const Boid<D>& boid, const Sums<D>& sums) {
  const Vector<D> push = acceleration<D, course>(numbers, boid, sums);
  Boid<D> out = boid;
  for (std::size_t axis = 0; axis < D; ++axis) out.velocity[axis] += push[axis] * numbers.dt;
  const float speed = std::sqrt(dot<D>(out.velocity, out.velocity));
  if (speed > 0 && (speed > numbers.max_speed || speed < numbers.min_speed)) {
    const float wanted = speed > numbers.max_speed ? numbers.max_speed : numbers.min_speed;
    for (float& value : out.velocity) value *= wanted / speed;
  }
  for (std::size_t axis = 0; axis < D; ++axis) {
    float& at = out.position[axis];
    at += out.velocity[axis] * numbers.dt;
    if constexpr (course == Course::wrapped) {
      if (at < numbers.min[axis]) at += numbers.size[axis];
      if (at >= numbers.max[axis]) at -= numbers.size[axis];
    }
  }
  return out;
}

template <int D>
inline Boid<D> boid_at(const Flock& flock, std::size_t i) {
  Boid<D> boid;
  for (std::size_t axis = 0; axis < D; ++axis) {
    boid.position[axis] = flock.position[axis][i];
    boid.velocity[axis] = flock.velocity[axis][i];
  }
  return boid;
}

template <int D>
inline void put(Flock& flock, std::size_t i, const Boid<D>& boid) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    flock.position[axis][i] = boid.position[axis];
    flock.velocity[axis][i] = boid.velocity[axis];
  }
}

template <int D>
inline Flock empty_flock(std::size_t size) {
  Flock flock;
  for (std::size_t axis = 0; axis < D; ++axis) {
    flock.position[axis].resize(size);
    flock.velocity[axis].resize(size);
  }
  return flock;
}

template <int D>
inline std::vector<Boid<D>> boids_of(const Flock& flock) {
  std::vector<Boid<D>> boids(flock.size());
  for (std::size_t i = 0; i < boids.size(); ++i) boids[i] = boid_at<D>(flock, i);
  return boids;
}

template <int D>
inline Flock flock_of(const std::vector<Boid<D>>& boids) {
  Flock flock = empty_flock<D>(boids.size());
  for (std::size_t i = 0; i < boids.size(); ++i) put<D>(flock, i, boids[i]);
  return flock;
}

}  // namespace
}  // namespace bench
