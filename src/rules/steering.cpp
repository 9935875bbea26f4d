// Steering behaviours for one agent.
#include <sturnus/steering.h>

#include "base/vec.h"

namespace sturnus {

Vector heading(const Vector& velocity) {
  return unit(Vec<3>{velocity}).at;
}

Vector seek(const Vector& offset, const Vector& velocity, float max_speed) {
  return (unit(Vec<3>{offset}) * max_speed - Vec<3>{velocity}).at;
}

Vector face(const Vector& direction, const Vector& velocity) {
  const Vec<3> wanted = unit(Vec<3>{direction});
  if (wanted == Vec<3>{}) return {};
  return (wanted - unit(Vec<3>{velocity})).at;
}

Vector wander(const Vector& direction, const Vector& random, float rate) {
  const Vec<3> next = unit(Vec<3>{direction} + Vec<3>{random} * rate);
  return next == Vec<3>{} ? direction : next.at;
}

}  // namespace sturnus
