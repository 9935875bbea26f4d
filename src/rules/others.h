// The others that a boid looks at one by one: the members of a few small flocks, and near neighbours.
#pragma once

#include <sturnus/view.h>

#include <limits>
#include <span>

#include "neighbours/query.h"
#include "rules/self.h"
#include "world/columns.h"

namespace sturnus {

template <int D>
struct Others {
  const State& state;
  std::span<const std::uint32_t> watched;  ///< slots of the members of the watched flocks in play, by id
  Neighbourhood near;                      ///< has an index where somebody asks it
  Wrapping image;
  std::vector<Span>& spans;  ///< memory for walks

  Vec<D> offset_to(const Self<D>& self, std::uint32_t slot) const {
    return offset(self.position, at<D>(state.position, slot), image);
  }
  Vec<D> velocity(std::uint32_t slot) const { return at<D>(state.velocity, slot); }
};

/// The slot of the nearest member of some flocks, never the boid itself, of equals the one with the lowest
/// id; none where nobody is within the radius.
template <int D>
std::optional<std::uint32_t> nearest_of(const Others<D>& others, std::uint64_t flocks, float radius_squared,
                                        const Self<D>& self) {
  std::optional<std::uint32_t> best;
  float least = radius_squared;
  for (const std::uint32_t slot : others.watched) {
    if ((flocks >> others.state.flock[slot] & 1u) == 0 || others.state.id[slot] == self.id) continue;
    const Vec<D> o = others.offset_to(self, slot);
    const float distance_squared = dot(o, o);
    if (!(distance_squared < least)) continue;
    least = distance_squared;
    best = slot;
  }
  return best;
}

}  // namespace sturnus
