// One boid's vector in arrays of coordinates.
#pragma once

#include <sturnus/view.h>

#include "base/vec.h"

namespace sturnus {

/// Where the columns are; null where they are empty.
inline std::array<const float*, 3> pointers(const Columns& columns) {
  std::array<const float*, 3> out{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    out[axis] = columns[axis].empty() ? nullptr : columns[axis].data();
  return out;
}

template <int D>
Vec<D> at(const Columns& columns, std::size_t i) {
  Vec<D> v;
  for (int axis = 0; axis < D; ++axis) v[axis] = columns[static_cast<std::size_t>(axis)][i];
  return v;
}

template <int D>
void put(Columns& columns, std::size_t i, const Vec<D>& v) {
  for (int axis = 0; axis < D; ++axis) columns[static_cast<std::size_t>(axis)][i] = v[axis];
}

}  // namespace sturnus
