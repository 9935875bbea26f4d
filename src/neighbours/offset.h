// The offset from one place to another, by the nearest image where the space wraps.
#pragma once

#include <array>

#include "base/vec.h"

namespace sturnus {

/// How a space wraps: the caller says so, because a part of a larger world does not.
struct Wrapping {
  bool wraps = false;
  std::array<float, 3> size{};  ///< length of each axis
  std::array<float, 3> half{};
};

/// (to - from) + shift, shift in {0, +size, -size} by comparison, never by rounding.
template <int D>
Vec<D> offset(const Vec<D>& from, const Vec<D>& to, const Wrapping& image) {
  Vec<D> o = to - from;
  if (!image.wraps) return o;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (o[axis] > image.half[i]) {
      o[axis] -= image.size[i];
    } else if (o[axis] < -image.half[i]) {
      o[axis] += image.size[i];
    }
  }
  return o;
}

}  // namespace sturnus
