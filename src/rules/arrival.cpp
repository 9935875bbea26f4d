// Arrival: seek that comes to rest at its target (Reynolds 1999).
#include <sturnus/steering.h>

#include <algorithm>

#include "base/vec.h"

namespace sturnus {

Vector arrive(const Vector& offset, const Vector& velocity, float max_speed, float slowing_radius) {
  const float distance = length(Vec<3>{offset});
  if (!(distance < slowing_radius)) return seek(offset, velocity, max_speed);
  return (Vec<3>{offset} * (max_speed / slowing_radius) - Vec<3>{velocity}).at;
}

}  // namespace sturnus
