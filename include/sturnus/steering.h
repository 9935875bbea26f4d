// Steering behaviours as plain functions for one agent; the engine's own rules call them.
//
// Vectors are x, y, z with z = 0 in two dimensions. Accelerations are in length per time squared; the step
// adds them to the velocity once each time unit. After Reynolds, "Steering behaviors for autonomous
// characters" (1999).
#pragma once

#include <array>

namespace sturnus {

using Vector = std::array<float, 3>;

/// v / |v|, or the zero vector where v has no direction.
Vector heading(const Vector& velocity);

/// Reynolds' seek: full speed toward `offset` (target - position), minus the own velocity. At the target,
/// where there is no direction, only the own velocity is taken away. Negate the offset to flee.
Vector seek(const Vector& offset, const Vector& velocity, float max_speed);

/// Turn toward a direction: unit(direction) - heading (CS 184). Zero where there is no direction.
Vector face(const Vector& direction, const Vector& velocity);

}  // namespace sturnus
