// Bodies of boids as triangles, made from a few numbers. x points ahead, y to the left, z to the top; a boid
// is one long, and its place is the origin.
#pragma once

#include <cstddef>
#include <vector>

#include "view/points.h"

namespace studio {

/// How a flock's boids are drawn; the shaders know the numbers.
enum class Mesh {
  disc = 0,
  dart = 1,
  triangle = 2,
  ball = 3,
  cone = 4,
  fish = 5,
  bird = 6,
  pyramid = 7,
  point = 8
};

/// What a corner belongs to; the shaders know the numbers. Jaws are in quarters, to open either way.
enum class BodyPart { body, fin, wing, jaw_up_left, jaw_up_right, jaw_down_left, jaw_down_right, throat };

/// Two texels of a buffer.
struct MeshCorner {
  Point position;
  float piece = 0;
  Point normal;
  float unused = 0;
};

struct MeshRange {
  std::size_t first = 0, corners = 0;
};

/// All meshes in one buffer, one after the other.
struct MeshBuffer {
  std::vector<MeshCorner> corners;
  MeshRange cone, pyramid, fish, bird;

  MeshRange of(Mesh mesh) const;
};
MeshBuffer make_meshes();

}  // namespace studio
