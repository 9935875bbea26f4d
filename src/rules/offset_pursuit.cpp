// Offset pursuit: arriving at a place beside a leader, where it will be (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/foresight.h"
#include "rules/rules.h"

namespace sturnus {

Vector in_world(const Vector& ahead_left_up, const Vector& leader_velocity) {
  Vec<3> ahead = unit(Vec<3>{leader_velocity});
  if (ahead == Vec<3>{}) ahead = {{1, 0, 0}};
  Vec<3> left = unit(Vec<3>{{-ahead[1], ahead[0], 0}});
  if (left == Vec<3>{}) left = {{0, 1, 0}};
  const Vec<3> up{{ahead[1] * left[2] - ahead[2] * left[1], ahead[2] * left[0] - ahead[0] * left[2],
                   ahead[0] * left[1] - ahead[1] * left[0]}};
  return (ahead * ahead_left_up[0] + left * ahead_left_up[1] + up * ahead_left_up[2]).at;
}

Vector pursue_offset(const Vector& offset, const Vector& leader_velocity, const Vector& ahead_left_up,
                     float time, const Vector& velocity, float max_speed, float slowing_radius) {
  const Vec<3> leader{predicted(offset, leader_velocity, time)};
  const Vec<3> place = leader + Vec<3>{in_world(ahead_left_up, leader_velocity)};
  return arrive(place.at, velocity, max_speed, slowing_radius);
}

}  // namespace sturnus
