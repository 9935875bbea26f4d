// Leader following: arrive behind the leader, keep out of its way (Reynolds 1999).
#include <sturnus/steering.h>

#include "base/vec.h"

namespace sturnus {

Vector follow_leader(const Vector& offset, const Vector& leader_velocity, float distance, float clearance,
                     const Vector& velocity, float max_speed, float slowing_radius) {
  const Vec<3> ahead{in_world({1, 0, 0}, leader_velocity)};
  const Vec<3> from_leader = Vec<3>{offset} * -1.0f;
  const float lead = dot(from_leader, ahead);
  const Vec<3> across = from_leader - ahead * lead;
  if (lead > 0 && lead < distance && length(across) < clearance) {
    const bool is_on_line = !(dot(across, across) > 0);
    const Vector aside = is_on_line ? in_world({0, 1, 0}, leader_velocity) : across.at;
    return seek(aside, velocity, max_speed);
  }
  return arrive((Vec<3>{offset} - ahead * distance).at, velocity, max_speed, slowing_radius);
}

}  // namespace sturnus
