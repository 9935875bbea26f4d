// The boid that is steered, and the random numbers that are its own.
#pragma once

#include <sturnus/steering.h>

#include "base/random.h"
#include "scenario/model.h"

namespace sturnus {

template <int D>
struct Self {
  std::uint64_t id = 0;
  Vec<D> position;
  Vec<D> velocity;
  float speed = 0;
  Vec<D> heading;  ///< v / |v|; zero at rest

  Self(std::uint64_t own_id, const Vec<D>& own_position, const Vec<D>& own_velocity)
      : id(own_id), position(own_position), velocity(own_velocity), speed(length(own_velocity)), heading(unit(own_velocity)) {}
};

/// When and under which seed numbers are drawn.
struct Moment {
  std::uint64_t seed = 0;
  std::uint64_t step = 0;
};

/// Between the public three-component vectors and the engine's own; z is 0 in two dimensions.
template <int D>
Vector wide(const Vec<D>& v) {
  Vector out{};
  for (int axis = 0; axis < D; ++axis) out[static_cast<std::size_t>(axis)] = v[axis];
  return out;
}

template <int D>
Vec<D> narrow(const Vector& v) {
  Vec<D> out;
  for (int axis = 0; axis < D; ++axis) out[axis] = v[static_cast<std::size_t>(axis)];
  return out;
}

}  // namespace sturnus
