// Hunt: turn toward prey (CS 184), or go at full speed where it will be (VUW: pursuit and interception).
#include "rules/rules.h"

namespace sturnus {

namespace {

// How far ahead a hunter looks.
float time_ahead(const HuntModel& hunt, const Vector& offset, const Vector& prey_velocity, float max_speed) {
  switch (hunt.aim) {
    case HuntAim::heading:
    case HuntAim::seek:
      return 0;
    case HuntAim::constant:
      return hunt.time;
    case HuntAim::distance:
      return prediction_time(Prediction::distance, hunt.factor, offset, prey_velocity, max_speed);
    case HuntAim::intercept:
      return prediction_time(Prediction::intercept, hunt.factor, offset, prey_velocity, max_speed);
  }
  return 0;
}

}  // namespace

template <int D>
Vec<D> aimed(const HuntModel& hunt, const Vec<D>& offset, const Vec<D>& prey_velocity, float max_speed) {
  const float ahead = time_ahead(hunt, widened(offset), widened(prey_velocity), max_speed);
  // A catch in the far future lies straight along the prey's way, however far.
  return unit(offset + prey_velocity * (ahead < 1e6f ? ahead : 1e6f));
}

template <int D>
Vec<D> chase(const HuntModel& hunt, const Vec<D>& toward, const Vec<D>& velocity, float max_speed) {
  if (hunt.aim == HuntAim::heading) return toward - unit(velocity);
  return narrow_to<D>(seek(widened(toward), widened(velocity), max_speed));
}

template Vec<2> aimed<2>(const HuntModel&, const Vec<2>&, const Vec<2>&, float);
template Vec<3> aimed<3>(const HuntModel&, const Vec<3>&, const Vec<3>&, float);
template Vec<2> chase<2>(const HuntModel&, const Vec<2>&, const Vec<2>&, float);
template Vec<3> chase<3>(const HuntModel&, const Vec<3>&, const Vec<3>&, float);

}  // namespace sturnus
