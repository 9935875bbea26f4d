// How large the space is: from its corners, or from the number of boids.
#include <sturnus/scenario.h>

#include <algorithm>

#include "base/root.h"

namespace sturnus {

Extent extent_of(const ScenarioDef& scenario) {
  const Space& space = scenario.space;
  if (!space.min.empty()) return {space.min, space.max};
  const double content = space.per_boid * static_cast<double>(std::max<std::int64_t>(1, scenario.boid_count()));
  const double half = 0.5 * (space.dimensions == 3 ? cube_root(content) : square_root(content));
  const auto axes = static_cast<std::size_t>(space.dimensions);
  return {Coordinates(axes, -half), Coordinates(axes, half)};
}

}  // namespace sturnus
