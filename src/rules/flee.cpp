// Flee: away from the neighbours' middle; zero without a neighbour.
#include "rules/pull.h"
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> flee(const TermModel& term, const NeighbourSum& sum, const Self<D>& self, float max_speed) {
  if (sum.count == 0) return {};
  const Vec<D> away = vec_of<D>(sum) * (-1.0f / static_cast<float>(sum.count));
  // A mean of unit vectors is shorter where they differ, and counts less.
  if (term.form == SteeringForm::heading) return away - self.heading();
  return pull_of({term.form}, away, self, max_speed);
}

template Vec<2> flee<2>(const TermModel&, const NeighbourSum&, const Self<2>&, float);
template Vec<3> flee<3>(const TermModel&, const NeighbourSum&, const Self<3>&, float);

}  // namespace sturnus
