// A random world with everything that the kernels ask for, and what they sum over it.
#pragma once

#include <algorithm>

#include "neighbours/passes.h"
#include "worlds.h"

namespace sturnus::test {

/// Boids in the order of their index.
struct Scene {
  RandomWorld world;
  Columns velocity, heading, colour;
  std::vector<std::uint8_t> flock;
  Model model;
  std::unique_ptr<NeighbourIndex> index;

  Boids boids() const {
    Boids out;
    out.count = world.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.position[axis] = world.position[axis].data();
      out.velocity[axis] = velocity[axis].data();
      out.heading[axis] = heading[axis].data();
      out.colour[axis] = colour[axis].data();
    }
    out.id = world.ids.data();
    out.flock = flock.data();
    if (std::count(world.hidden.begin(), world.hidden.end(), 1) != 0) out.hidden = world.hidden.data();
    out.flocks = (std::uint64_t{1} << model.flocks.size()) - 1;
    return out;
  }
};

/// The sums of the passes, most_rows for each boid, over memory full of garbage; those of the hidden and
/// those that no row asks for are zero.
inline std::vector<NeighbourSum> sums_by(const Scene& scene, const Passes& passes) {
  std::vector<Span> batches;
  scene.index->batches(batches);
  const NeighbourQuestion question{&scene.model, scene.index.get(), scene.world.image(), {}, 0, &passes};
  const Boids boids = scene.boids();
  const std::size_t rows = scene.model.most_rows;
  KernelScratch scratch;
  SumBlock block;
  block.fit(rows, 0, scene.world.size());
  block.spoil();
  scene.world.dimensions == 3 ? neighbour_sums<3>(boids, batches, boids, question, scratch, block)
                              : neighbour_sums<2>(boids, batches, boids, question, scratch, block);
  std::vector<NeighbourSum> sums(scene.world.size() * rows);
  for (std::size_t i = 0; i < scene.world.size(); ++i) {
    if (scene.world.hidden[i] != 0) continue;
    for (std::size_t r = 0; r < scene.model.flocks[scene.flock[i]].rows.size(); ++r)
      sums[i * rows + r] = block.at(r, i);
  }
  return sums;
}

}  // namespace sturnus::test
