// Queuing: brake for whoever is ahead (Reynolds 1999).
#include <sturnus/steering.h>

#include <algorithm>

#include "base/vec.h"

namespace sturnus {

bool is_ahead(const Vector& offset, const Vector& velocity, float distance, float cos_half) {
  const Vec<3> o{offset}, v{velocity};
  const float speed = length(v), gap = length(o);
  return speed > 0 && gap < distance && dot(v, o) >= cos_half * speed * gap;
}

Vector brake(const Vector& offset, const Vector& velocity, float distance) {
  const float share = distance > 0 ? std::max(0.0f, 1 - length(Vec<3>{offset}) / distance) : 0.0f;
  return (Vec<3>{velocity} * -share).at;
}

}  // namespace sturnus
