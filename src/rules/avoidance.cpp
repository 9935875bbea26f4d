// Unaligned collision avoidance: step aside from whoever will come too near (Reynolds 1999).
#include <sturnus/steering.h>

#include "base/vec.h"

namespace sturnus {
namespace {

// Below this share of the present distance, what lies across the heading is rounding, and no side to go by.
constexpr float least_share = 1e-3f;

}  // namespace

std::optional<float> nearest_approach_time(const Vector& offset, const Vector& other_velocity,
                                           const Vector& velocity) {
  const Vec<3> relative = Vec<3>{other_velocity} - Vec<3>{velocity};
  const float closing = -dot(Vec<3>{offset}, relative);
  const float speed_squared = dot(relative, relative);
  if (!(closing > 0) || !(speed_squared > 0)) return std::nullopt;
  return closing / speed_squared;
}

Vector sidestep(const Vector& offset, const Vector& other_velocity, float time, const Vector& velocity) {
  const Vec<3> gap = Vec<3>{offset} + (Vec<3>{other_velocity} - Vec<3>{velocity}) * time;
  const Vec<3> ahead = unit(Vec<3>{velocity});
  const Vec<3> across = gap - ahead * dot(gap, ahead);
  if (!(length(across) > least_share * length(Vec<3>{offset}))) return in_world({0, -1, 0}, velocity);
  return (unit(across) * -1.0f).at;
}

}  // namespace sturnus
