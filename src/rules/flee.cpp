// Flee: away from the neighbours' middle; zero without a neighbour.
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> flee(const TermModel& term, const NeighbourSum& sum, const Self<D>& self, float max_speed) {
  if (sum.count == 0) return {};
  const Vec<D> away = vec_of<D>(sum) * (-1.0f / static_cast<float>(sum.count));
  switch (term.form) {
    case SteeringForm::heading:
      return away - self.heading();
    case SteeringForm::seek:
      return narrow_to<D>(seek(widened(away), widened(self.velocity), max_speed));
    case SteeringForm::linear:
      return away;
    case SteeringForm::orbit:
      return unit(away) * max_speed;
    case SteeringForm::arrive:
      break;  // not for those who flee, as the check says
  }
  return {};
}

template Vec<2> flee<2>(const TermModel&, const NeighbourSum&, const Self<2>&, float);
template Vec<3> flee<3>(const TermModel&, const NeighbourSum&, const Self<3>&, float);

}  // namespace sturnus
