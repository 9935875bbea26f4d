// Wander: a bounded random walk of a sought direction (Reynolds 1999).
#include "rules/rules.h"

namespace sturnus {

template <int D>
Vec<D> wandered(const TermModel& term, const Self<D>& self, const Vec<D>& wander, const Moment& moment) {
  Draws draws(moment.seed, moment.step, self.id, Stream::wander);
  const Vector random = widened(draws.in_cube<D>());
  return narrow_to<D>(sturnus::wander(widened(wander), random, term.amount));
}

template Vec<2> wandered<2>(const TermModel&, const Self<2>&, const Vec<2>&, const Moment&);
template Vec<3> wandered<3>(const TermModel&, const Self<3>&, const Vec<3>&, const Moment&);

}  // namespace sturnus
