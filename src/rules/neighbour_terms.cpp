// Separation, alignment, cohesion, flee: from sums over neighbours to steering. With no neighbour a term is
// zero.
#include "rules/rules.h"

namespace sturnus {
namespace {

template <int D>
Vec<D> vec_of(const NeighbourSum& sum) {
  Vec<D> v;
  for (int axis = 0; axis < D; ++axis) v[axis] = sum.value[static_cast<std::size_t>(axis)];
  return v;
}

template <int D>
Vec<D> combined(const TermModel& term, const NeighbourSum& sum) {
  const auto value = vec_of<D>(sum);
  if (term.combine == Combine::sum || sum.count == 0) return value;
  return value * (1.0f / static_cast<float>(sum.count + (term.count_self ? 1u : 0u)));
}

}  // namespace

template <int D>
Vec<D> separation(const TermModel& term, const NeighbourSum& sum) {
  return combined<D>(term, sum) * -1.0f;
}

template <int D>
Vec<D> alignment(const TermModel& term, const NeighbourSum& sum, const Self<D>& self) {
  const Vec<D>& own = term.match == Match::velocity ? self.velocity : self.heading;
  if (sum.count == 0 && !(term.count_self && !term.relative)) return {};
  Vec<D> total = vec_of<D>(sum);
  if (term.count_self) total += own;
  const Vec<D> average = total * (1.0f / static_cast<float>(sum.count + (term.count_self ? 1u : 0u)));
  return term.relative ? average - own : average;
}

template <int D>
Vec<D> cohesion(const TermModel& term, const NeighbourSum& sum) {
  return combined<D>(term, sum);
}

template <int D>
Vec<D> flee(const TermModel& term, const NeighbourSum& sum, const Self<D>& self, float max_speed) {
  if (sum.count == 0) return {};
  const Vec<D> away = vec_of<D>(sum) * (-1.0f / static_cast<float>(sum.count));
  switch (term.form) {
    case SteeringForm::heading:
      return away - self.heading;
    case SteeringForm::seek:
      return narrow_to<D>(seek(widened(away), widened(self.velocity), max_speed));
    case SteeringForm::linear:
      return away;
  }
  return {};
}

template Vec<2> separation<2>(const TermModel&, const NeighbourSum&);
template Vec<3> separation<3>(const TermModel&, const NeighbourSum&);
template Vec<2> alignment<2>(const TermModel&, const NeighbourSum&, const Self<2>&);
template Vec<3> alignment<3>(const TermModel&, const NeighbourSum&, const Self<3>&);
template Vec<2> cohesion<2>(const TermModel&, const NeighbourSum&);
template Vec<3> cohesion<3>(const TermModel&, const NeighbourSum&);
template Vec<2> flee<2>(const TermModel&, const NeighbourSum&, const Self<2>&, float);
template Vec<3> flee<3>(const TermModel&, const NeighbourSum&, const Self<3>&, float);

}  // namespace sturnus
