// Small vectors of two or three components, and the few operations that steering needs.
#pragma once

#include <array>
#include <cmath>

namespace sturnus {

template <int D, class T = float>
struct Vec {
  std::array<T, D> at{};

  T& operator[](int axis) { return at[static_cast<std::size_t>(axis)]; }
  const T& operator[](int axis) const { return at[static_cast<std::size_t>(axis)]; }

  Vec& operator+=(const Vec& other) {
    for (int axis = 0; axis < D; ++axis) (*this)[axis] += other[axis];
    return *this;
  }
  Vec& operator-=(const Vec& other) {
    for (int axis = 0; axis < D; ++axis) (*this)[axis] -= other[axis];
    return *this;
  }
  Vec& operator*=(T factor) {
    for (int axis = 0; axis < D; ++axis) (*this)[axis] *= factor;
    return *this;
  }
  friend Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend Vec operator*(Vec a, T factor) { return a *= factor; }
  friend bool operator==(const Vec& a, const Vec& b) { return a.at == b.at; }
};

template <int D, class T>
T dot(const Vec<D, T>& a, const Vec<D, T>& b) {
  T sum = a[0] * b[0];
  for (int axis = 1; axis < D; ++axis) sum += a[axis] * b[axis];
  return sum;
}

template <int D, class T>
T length(const Vec<D, T>& v) {
  return std::sqrt(dot(v, v));
}

/// v / |v|; the zero vector where v has no direction.
template <int D, class T>
Vec<D, T> unit(const Vec<D, T>& v) {
  const T size = length(v);
  return size > T(0) ? v * (T(1) / size) : Vec<D, T>{};
}

/// Between three-component arrays, as the public headers have them, and vectors; z is 0 in two dimensions.
template <int D>
Vec<D> narrow_to(const std::array<float, 3>& v) {
  Vec<D> out;
  for (int axis = 0; axis < D; ++axis) out[axis] = v[static_cast<std::size_t>(axis)];
  return out;
}
template <int D>
std::array<float, 3> widened(const Vec<D>& v) {
  std::array<float, 3> out{};
  for (int axis = 0; axis < D; ++axis) out[static_cast<std::size_t>(axis)] = v[axis];
  return out;
}

}  // namespace sturnus
