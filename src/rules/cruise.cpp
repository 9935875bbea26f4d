// Cruise: accelerate toward a speed along the own heading (CS 184's fourth rule).
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> cruise(const TermModel& term, const Self<D>& self) {
  return self.heading() * (term.amount - self.speed());
}

template Vec<2> cruise<2>(const TermModel&, const Self<2>&);
template Vec<3> cruise<3>(const TermModel&, const Self<3>&);

}  // namespace sturnus
