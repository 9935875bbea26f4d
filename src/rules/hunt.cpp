// Hunt: turn toward prey (CS 184), or go at full speed where it will be (VUW: pursuit and interception).
#include "rules/pursuit.h"
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> aimed(const HuntModel& hunt, const Vec<D>& offset, const Vec<D>& prey_velocity, float max_speed) {
  double ahead = 0;
  switch (hunt.aim) {
    case HuntAim::heading:
    case HuntAim::seek:
      break;
    case HuntAim::constant:
      ahead = double{hunt.time};
      break;
    case HuntAim::distance:
      ahead = double{hunt.factor * length(offset)};
      break;
    case HuntAim::intercept:
      ahead = time_to_catch(offset, prey_velocity, double{max_speed}, double{hunt.factor * length(offset)});
      break;
  }
  // A catch in the far future lies straight along the prey's way, however far.
  const auto time = static_cast<float>(ahead < 1e6 ? ahead : 1e6);
  return unit(offset + prey_velocity * time);
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
