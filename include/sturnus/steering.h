// Steering behaviours as plain functions for one agent; the engine's own rules call them.
//
// Vectors are x, y, z with z = 0 in two dimensions. Accelerations are in length per time squared; the step
// adds them to the velocity once each time unit. After Reynolds, "Steering behaviors for autonomous
// characters" (1999).
#pragma once

#include <array>
#include <optional>

namespace sturnus {

using Vector = std::array<float, 3>;

/// v / |v|, or the zero vector where v has no direction.
Vector heading(const Vector& velocity);

/// Reynolds' seek: full speed toward `offset` (target - position), minus the own velocity. At the target,
/// where there is no direction, only the own velocity is taken away. Negate the offset to flee.
Vector seek(const Vector& offset, const Vector& velocity, float max_speed);

/// Turn toward a direction: unit(direction) - heading (CS 184). Zero where there is no direction.
Vector face(const Vector& direction, const Vector& velocity);

/// How far along its heading a boid first touches a sphere: the smaller root t of |t h - to_centre| = radius,
/// h = v/|v|, as a length (VUW CGRA 354, S2-26, S2-27). A tangent counts; 0 inside; nothing where the sphere
/// is missed or behind, nor at rest. `to_centre` is centre - position; `radius` (length) includes the boid's
/// own.
std::optional<float> distance_to_sphere(const Vector& to_centre, const Vector& velocity, float radius);

/// Sideways out of the way of a sphere that is touched within `look_ahead` (length), otherwise zero:
/// unit(E - C), E the point of the line ahead that is nearest to the centre C (VUW CGRA 354, S2-28). Aimed at
/// the very centre, to within a millionth of its distance, a fixed perpendicular to the heading.
Vector avoid_sphere(const Vector& to_centre, const Vector& velocity, float radius, float look_ahead);

}  // namespace sturnus
