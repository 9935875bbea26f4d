// Path following (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/nearest_image.h"
#include "rules/rules.h"

namespace sturnus {

Vector follow_path(const Polyline& path, float radius, float ahead, float time, const Vector& position,
                   const Vector& velocity, float max_speed) {
  const Vec<3> predicted = Vec<3>{position} + Vec<3>{velocity} * time;
  const OnPolyline nearest = nearest_on(path, predicted.at);
  if (!(nearest.distance > radius) || nearest.along == Vector{}) return {};
  const OnPolyline sought = further_on(path, nearest, ahead);
  return seek((Vec<3>{sought.at} - Vec<3>{position}).at, velocity, max_speed);
}

template <int D>
Vec<D> path_following(const LineModel& model, const Wrapping& image, const Self<D>& self, float max_speed) {
  const Polyline path{model.corners, model.is_loop};
  const Vector position = nearest_image<D>(path, widened(self.position), image);
  return narrow_to<D>(
      follow_path(path, model.radius, model.ahead, model.time, position, widened(self.velocity), max_speed));
}

template Vec<2> path_following<2>(const LineModel&, const Wrapping&, const Self<2>&, float);
template Vec<3> path_following<3>(const LineModel&, const Wrapping&, const Self<3>&, float);

}  // namespace sturnus
