// From animation data to geometry: four triangles for each boid.
#pragma once

#include <sturnus/triangles.h>
#include <sturnus/view.h>

#include <array>
#include <vector>

namespace prog06 {

/// The cone of the assignment about a place p: {p+0.5w, p+0.2u, p+0.2v}, {p+0.5w, p+0.2v, p-0.2u},
/// {p+0.5w, p-0.2u, p-0.2v}, {p+0.5w, p-0.2v, p+0.2u}, with u, v and w times `size`. Its base is open.
std::array<sturnus::Triangle, 4> cone(const sturnus::Point3& place, const sturnus::Frame3& frame, float size,
                                      sturnus::Rgba colour);

/// A hue for each direction in the plane, all equally bright; paler for directions that leave it.
sturnus::Rgba heading_colour(const sturnus::Point3& w);

/// The boids as cones along their velocities. A boid at rest keeps the frame that it had, and one that never
/// moved points along x.
class Cones {
 public:
  /// `size` multiplies the cone of the assignment.
  explicit Cones(float size) : size_(size) {}

  /// Takes the frames from the velocities; to be called after every step.
  void follow(const sturnus::View& view);

  /// The triangles of all boids as they stand. Boids that met a bad number are left out.
  std::vector<sturnus::Triangle> triangles(const sturnus::View& view) const;

  /// The last frame of a boid, by its id.
  const sturnus::Frame3& frame(std::uint64_t id) const { return frames_[id]; }

 private:
  float size_;
  std::vector<sturnus::Frame3> frames_;  // by id; ids count from 0
};

}  // namespace prog06
