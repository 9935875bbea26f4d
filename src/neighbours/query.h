// Lists of neighbours for those who need names, not sums: measures, highlighting, later eating and focus.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "neighbours/index.h"
#include "neighbours/offset.h"

namespace sturnus {

/// One boid found, in order of (distance², id).
struct Found {
  float distance_squared;
  std::uint64_t id;
  std::uint32_t slot;
  friend bool operator<(const Found& a, const Found& b) {
    return a.distance_squared != b.distance_squared ? a.distance_squared < b.distance_squared : a.id < b.id;
  }
};

/// What lists are asked of: an index over a cloud whose boids already stand in the index's order.
struct Neighbourhood {
  const NeighbourIndex* index;
  Cloud cloud;
  Wrapping image;
  std::span<const std::uint64_t> ids;
};

/// Calls f(slot, distance²) for every visible boid nearer than `radius`, which must be within the index's
/// reach.
template <int D, class F>
void visit(const Neighbourhood& among, const Vec<D>& at, float radius, std::vector<Span>& spans, F&& f) {
  std::array<float, 3> place{};
  for (int axis = 0; axis < D; ++axis) place[static_cast<std::size_t>(axis)] = at[axis];
  among.index->spans(place, place, radius, spans);
  for (const Span span : spans) {
    for (std::uint32_t i = span.begin; i < span.end; ++i) {
      Vec<D> other;
      for (int axis = 0; axis < D; ++axis)
        other[axis] = among.cloud.position[static_cast<std::size_t>(axis)][i];
      const Vec<D> o = offset(at, other, among.image);
      const float distance_squared = dot(o, o);
      if (distance_squared < radius * radius && among.cloud.hidden[i] == 0) f(i, distance_squared);
    }
  }
}

/// The k nearest boids within `radius`, nearest first; fewer where there are fewer.
template <int D>
std::vector<Found> nearest(const Neighbourhood& among, const Vec<D>& at, std::size_t k, float radius) {
  std::vector<Span> spans;
  std::vector<Found> found;
  visit<D>(among, at, radius, spans, [&](std::uint32_t slot, float distance_squared) {
    found.push_back({distance_squared, among.ids[slot], slot});
  });
  const auto kept = found.begin() + static_cast<std::ptrdiff_t>(std::min(k, found.size()));
  std::partial_sort(found.begin(), kept, found.end());
  found.erase(kept, found.end());
  return found;
}

}  // namespace sturnus
