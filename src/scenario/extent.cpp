// How large the space is: from its corners, or from the number of boids.
#include "scenario/extent.h"

#include <algorithm>

#include "base/root.h"

namespace sturnus {

double per_boid_of(const Space& space) {
  double usual = 1;
  for (std::int64_t axis = 0; axis < space.dimensions; ++axis) usual *= Space::usual_spacing;
  return space.per_boid.value_or(usual);
}

Extent extent_of(const ScenarioDef& scenario) {
  const Space& space = scenario.space;
  if (!space.min.empty()) return {space.min, space.max};
  const double content =
      per_boid_of(space) * static_cast<double>(std::max<std::int64_t>(1, scenario.boid_count()));
  const double half = 0.5 * (space.dimensions == 3 ? cube_root(content) : square_root(content));
  const auto axes = static_cast<std::size_t>(space.dimensions);
  return {Coordinates(axes, -half), Coordinates(axes, half)};
}

}  // namespace sturnus
