// Where somebody will be.
#pragma once

#include <sturnus/steering.h>

#include "base/vec.h"

namespace sturnus {

/// Straight on at its present velocity.
inline Vector predicted(const Vector& offset, const Vector& velocity, float time) {
  return (Vec<3>{offset} + Vec<3>{velocity} * time).at;
}

}  // namespace sturnus
