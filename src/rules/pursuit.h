// How far ahead a pursuer looks: the time until it can catch who flees on a straight line.
#pragma once

#include <cmath>

#include "base/vec.h"

namespace sturnus {

/// The smallest positive T with |o + vT| = sT, o the offset to the prey, v its velocity, s the pursuer's
/// speed; `otherwise` where there is none. In double: near |v| = s the equation is nearly linear.
template <int D>
double time_to_catch(const Vec<D>& o, const Vec<D>& v, double s, double otherwise) {
  double a = -s * s, b = 0, c = 0;  // a T² + 2 b T + c = 0
  for (int axis = 0; axis < D; ++axis) {
    a += double{v[axis]} * double{v[axis]};
    b += double{o[axis]} * double{v[axis]};
    c += double{o[axis]} * double{o[axis]};
  }
  if (!(c > 0)) return 0;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return otherwise;
  // The root that adds what has the same sign, and the other by their product: nothing cancels.
  const double root = std::sqrt(discriminant);
  const double q = b < 0 ? root - b : -(root + b);
  const double one = q != 0 ? c / q : -1;
  const double other = a != 0 ? q / a : -1;
  if (one > 0 && other > 0) return one < other ? one : other;
  return one > 0 ? one : other > 0 ? other : otherwise;
}

}  // namespace sturnus
