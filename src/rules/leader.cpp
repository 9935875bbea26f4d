// Leader following: arrive behind the leader, keep out of its way (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/rules.h"

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

template <int D>
Vec<D> leader_following(const LeaderModel& model, const Others<D>& others, const Self<D>& self,
                        float max_speed) {
  const auto slot = nearest_of(others, model.flocks, std::numeric_limits<float>::infinity(), self);
  if (!slot) return {};
  return narrow_to<D>(follow_leader(widened(others.offset_to(self, *slot)), widened(others.velocity(*slot)),
                                    model.distance, model.clearance, widened(self.velocity), max_speed,
                                    model.slowing));
}

template Vec<2> leader_following<2>(const LeaderModel&, const Others<2>&, const Self<2>&, float);
template Vec<3> leader_following<3>(const LeaderModel&, const Others<3>&, const Self<3>&, float);

}  // namespace sturnus
