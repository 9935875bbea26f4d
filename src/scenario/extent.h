// The share of the space that each boid has where the space has no corners of its own.
#pragma once

#include <sturnus/scenario.h>

namespace sturnus {

/// Area in two, volume in three dimensions.
double per_boid_of(const Space& space);

}  // namespace sturnus
