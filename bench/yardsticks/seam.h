// In a wrapped space: the places from which a search has to be made so that it also finds those beyond the
// seam.
#pragma once

#include "rules.h"

namespace bench {
namespace {

/// Calls `search` with the place itself, and with its image for each side of the space that is within reach.
template <int D, class Search>
inline void for_images(const Numbers& numbers, Vector<D> place, const Search& search, std::size_t axis = 0) {
  if (axis == D) return search(place);
  for_images<D>(numbers, place, search, axis + 1);
  const float at = place[axis];
  if (at - numbers.radius < numbers.min[axis]) {
    place[axis] = at + numbers.size[axis];
    for_images<D>(numbers, place, search, axis + 1);
  }
  if (at + numbers.radius > numbers.max[axis]) {
    place[axis] = at - numbers.size[axis];
    for_images<D>(numbers, place, search, axis + 1);
  }
}

}  // namespace
}  // namespace bench
