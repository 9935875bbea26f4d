// The picture of a moment: the boids, the edge of their box, and the place that the mouse holds.
#pragma once

#include <sturnus/triangles.h>
#include <sturnus/view.h>

#include <optional>

#include "choices.h"
#include "cones.h"

namespace prog06 {

class Scene {
 public:
  explicit Scene(const Choices& choices);

  /// To be called with the start and after every step: remembers which way the boids point.
  void follow(const sturnus::View& view) { cones_.follow(view); }

  /// The picture as it is shown and written.
  sturnus::Image picture(const sturnus::View& view) const;

  /// The place under a pixel: on the plane of the flat box, or in 3D on the plane through the target that
  /// faces the camera. Nothing where the view misses it.
  std::optional<sturnus::Point3> place_under(int x, int y) const;

 private:
  sturnus::SpaceCamera camera_;
  sturnus::PictureOptions options_;
  bool is_flat_;
  Cones cones_;
};

}  // namespace prog06
