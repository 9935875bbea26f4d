// Arrival: seek that comes to rest at its target (Reynolds 1999).
#include <sturnus/steering.h>

#include "base/vec.h"

namespace sturnus {

Vector arrive(const Vector& offset, const Vector& velocity, float max_speed, float slowing_radius) {
  const float distance = length(Vec<3>{offset});
  const float share = distance < slowing_radius ? distance / slowing_radius : 1.0f;
  return seek(offset, velocity, max_speed * share);
}

}  // namespace sturnus
