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

  float speed() const { return length(velocity); }
  Vec<D> heading() const { return unit(velocity); }  ///< v / |v|; zero at rest

  Self(std::uint64_t own_id, const Vec<D>& own_position, const Vec<D>& own_velocity)
      : id(own_id), position(own_position), velocity(own_velocity) {}
};

/// When and under which seed numbers are drawn.
struct Moment {
  std::uint64_t seed = 0;
  std::uint64_t step = 0;
};

}  // namespace sturnus
