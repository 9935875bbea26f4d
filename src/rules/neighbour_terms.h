// Separation, alignment, cohesion: from sums over neighbours to steering. With no neighbour a term is zero.
//
// Inline, because nearly every boid comes through here in every step.
#pragma once

#include "neighbours/kernel.h"
#include "rules/self.h"

namespace sturnus {

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

template <int D>
Vec<D> separation(const TermModel& term, const NeighbourSum& sum) {
  return combined<D>(term, sum) * -1.0f;
}

template <int D>
Vec<D> alignment(const TermModel& term, const NeighbourSum& sum, const Self<D>& self) {
  const Vec<D> own = term.match == Match::velocity ? self.velocity : self.heading();
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

}  // namespace sturnus
