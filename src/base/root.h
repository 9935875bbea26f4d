// Roots and angles with the same bits everywhere: only + - * / and the exact square root are used.
#pragma once

#include <cmath>

namespace sturnus {

inline double square_root(double x) {
  return std::sqrt(x);
}

/// Cube root by Newton's method from a start found by halving; for x >= 0, to a few units in the last place.
inline double cube_root(double x) {
  if (!(x > 0)) return 0;
  double scale = 1;
  while (x * scale * scale * scale > 8) scale *= 0.5;
  while (x * scale * scale * scale < 1) scale *= 2;
  const double scaled = x * scale * scale * scale;
  double root = 1.5;
  for (int i = 0; i < 8; ++i) root = (2 * root + scaled / (root * root)) / 3;
  return root / scale;
}

/// Cosine and sine of an angle in radians, |angle| <= 2 pi or so: the angle is halved thrice, taken by
/// series, and doubled back. Errors below 1e-14.
struct CosSin {
  double cos, sin;
};
inline CosSin cos_sin(double angle) {
  const double x = angle / 8;
  const double x2 = x * x;
  double c = 1, s = x, term_c = 1, term_s = x;
  for (int k = 1; k <= 9; ++k) {
    term_c *= -x2 / ((2 * k - 1) * (2 * k));
    term_s *= -x2 / ((2 * k) * (2 * k + 1));
    c += term_c;
    s += term_s;
  }
  for (int i = 0; i < 3; ++i) {
    const double doubled = c * c - s * s;
    s = 2 * s * c;
    c = doubled;
  }
  return {c, s};
}

inline constexpr double pi = 3.14159265358979323846;
inline double cosine_of_degrees(double degrees) {
  return cos_sin(degrees * (pi / 180)).cos;
}

}  // namespace sturnus
