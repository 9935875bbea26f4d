// Hiding: arrive at the far side of an obstacle, as seen from whom is hidden from (Reynolds 1999).
#include <sturnus/steering.h>

#include <limits>

#include "base/vec.h"

namespace sturnus {

Vector hide(std::span<const Ball> balls, const Vector& threat_offset, float margin, const Vector& velocity,
            float max_speed, float slowing_radius) {
  Vec<3> best;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Ball& ball : balls) {
    const Vec<3> from_threat = Vec<3>{ball.offset} - Vec<3>{threat_offset};
    if (!(length(from_threat) > ball.radius)) continue;
    const Vec<3> place = Vec<3>{ball.offset} + unit(from_threat) * (ball.radius + margin);
    if (!(dot(place, place) < nearest)) continue;
    nearest = dot(place, place);
    best = place;
  }
  if (nearest == std::numeric_limits<float>::infinity()) return {};
  return arrive(best.at, velocity, max_speed, slowing_radius);
}

}  // namespace sturnus
