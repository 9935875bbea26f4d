// What one place makes a boid feel, by the form of steering; for targets, the pointer, food and those who are
// fled.
#pragma once

#include "rules/self.h"

namespace sturnus {

/// How a place pulls.
struct Pull {
  SteeringForm form = SteeringForm::heading;
  float slowing = 0;  ///< length; for "arrive"
};

/// `o` is the offset to the place, turned round where it repels. Zero at the place itself, but for what takes
/// the own velocity off.
template <int D>
Vec<D> pull_of(const Pull& pull, const Vec<D>& o, const Self<D>& self, float max_speed) {
  switch (pull.form) {
    case SteeringForm::heading:
      return narrow_to<D>(face(widened(o), widened(self.velocity)));
    case SteeringForm::seek:
      return narrow_to<D>(seek(widened(o), widened(self.velocity), max_speed));
    case SteeringForm::linear:
      return o;
    case SteeringForm::arrive:
      return narrow_to<D>(arrive(widened(o), widened(self.velocity), max_speed, pull.slowing));
    case SteeringForm::orbit:
      return unit(o) * max_speed;
  }
  return {};
}

}  // namespace sturnus
