// From where a line is looked at in a space that wraps.
#pragma once

#include <sturnus/steering.h>

#include "rules/rules.h"

namespace sturnus {

/// The image of a place, of those in the space and beside it, from which the line is nearest.
template <int D>
Vector nearest_image(const Polyline& line, const Vector& place, const Wrapping& image) {
  if (!image.wraps) return place;
  Vector best = place;
  float least = nearest_on(line, place).distance;
  constexpr int images = D == 2 ? 9 : 27;
  for (int number = 1; number < images; ++number) {
    Vector shifted = place;
    const std::array<int, 3> shifts = {number % 3, number / 3 % 3, number / 9};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis) {
      if (shifts[axis] == 1) shifted[axis] += image.size[axis];
      if (shifts[axis] == 2) shifted[axis] -= image.size[axis];
    }
    const float distance = nearest_on(line, shifted).distance;
    if (!(distance < least)) continue;
    least = distance;
    best = shifted;
  }
  return best;
}

}  // namespace sturnus
