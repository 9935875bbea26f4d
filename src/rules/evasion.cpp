// Evasion: steering away from where a pursuer will be (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/foresight.h"
#include "rules/rules.h"

namespace sturnus {

Vector evade(const Vector& offset, const Vector& quarry_velocity, float time, const Vector& velocity,
             float max_speed) {
  const Vec<3> place{predicted(offset, quarry_velocity, time)};
  return seek((place * -1.0f).at, velocity, max_speed);
}

template <int D>
Vec<D> evasion(const PursuitModel& model, const Others<D>& others, const Self<D>& self, float max_speed) {
  const auto slot = nearest_of(others, model.flocks, model.radius_squared, self);
  if (!slot) return {};
  const Vector o = widened(others.offset_to(self, *slot));
  const Vector pursuer = widened(others.velocity(*slot));
  const float time = prediction_time(model.prediction, model.amount, o, pursuer, max_speed);
  return narrow_to<D>(evade(o, pursuer, time, widened(self.velocity), max_speed));
}

template Vec<2> evasion<2>(const PursuitModel&, const Others<2>&, const Self<2>&, float);
template Vec<3> evasion<3>(const PursuitModel&, const Others<3>&, const Self<3>&, float);

}  // namespace sturnus
