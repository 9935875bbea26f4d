// Arithmetic on points of the world, for cameras and shapes.
#pragma once

#include <array>
#include <cmath>

namespace studio {

using Point = std::array<float, 3>;

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(const Point& a, float by) {
  return {a[0] * by, a[1] * by, a[2] * by};
}
inline float dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline float length(const Point& a) {
  return std::sqrt(dot(a, a));
}
/// A vector's direction; `otherwise` where it has none.
inline Point unit(const Point& a, const Point& otherwise = {1, 0, 0}) {
  const float long_ = length(a);
  return long_ > 0 && std::isfinite(long_) ? a * (1 / long_) : otherwise;
}

}  // namespace studio
