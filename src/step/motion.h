// The motion of a stretch of boids: from sums over neighbours to accelerations, velocities and places.
#pragma once

#include "step/steering.h"

namespace sturnus {

/// A stretch of boids whose sums are known. Where they go is written to `scratch.previous_position` and
/// `scratch.previous_velocity`, which become the state's when all have moved.
template <int D>
struct Motion {
  const Model& model;
  State& state;
  Scratch& scratch;
  PartScratch& part;
  Steering<D> steering;
  const Boids& boids;  ///< all, as the kernel sees them
  Wrapping image;
};

/// Moves those of the boids [begin, end) that are in play, one at a time.
template <int D>
void move_plain(Motion<D>& motion, std::size_t begin, std::size_t end);

/// The same on the machine's widest registers, with the same bits.
template <int D>
void move_wide(Motion<D>& motion, std::size_t begin, std::size_t end);

/// Solid obstacles: stops those of the moved boids [begin, end) whose way leads into one, and brings out who
/// is inside.
template <int D>
void keep_out(Motion<D>& motion, std::size_t begin, std::size_t end);

/// The same with the same bits; most boids are ruled out many at a time.
template <int D>
void keep_out_wide(Motion<D>& motion, std::size_t begin, std::size_t end);

}  // namespace sturnus
