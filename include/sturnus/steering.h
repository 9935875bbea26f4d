// Steering behaviours as plain functions for one agent; the engine's own rules call them.
//
// Vectors are x, y, z with z = 0 in two dimensions. An `offset` is another's place minus the own one; where a
// space wraps it is the caller who takes the nearest image. Accelerations are in length per time squared; the
// step adds them to the velocity once each time unit. After Reynolds, "Steering behaviors for autonomous
// characters" (1999), where no other source is named. Nothing is allocated, nothing is random, and only
// + - * / and the square root are used, so that the bits are the same everywhere.
#pragma once

#include <sturnus/behaviours.h>

#include <array>
#include <optional>
#include <span>

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
/// Arrival: like seek, but slower within `slowing_radius` (length) of the target, where it comes to rest:
/// unit(o)·max_speed·min(1, |o|/slowing_radius) - v. With no slowing radius it is seek.
Vector arrive(const Vector& offset, const Vector& velocity, float max_speed, float slowing_radius);

/// Wander: the next direction of a bounded random walk, unit(direction + rate·random). `random` is the
/// caller's, its components in [-1, 1]; the smaller the `rate` the smoother the way. Where the walk meets the
/// origin exactly the direction stays.
Vector wander(const Vector& direction, const Vector& random, float rate);

/// The time, not below 0, after which someone with `speed` (length per time) may meet a quarry at `offset`
/// that keeps its velocity: the smallest root of |o + v T| = speed·T. 0 where they have met; none where the
/// quarry can't be met, or not within 1e15 time units. speed = |v| is a linear equation and no special case.
std::optional<float> interception_time(const Vector& offset, const Vector& quarry_velocity, float speed);

/// The time to look ahead. `amount` is that time for `constant`, and otherwise time per length: `distance`
/// gives amount·|o|, and so does `intercept` where there is no interception.
float prediction_time(Prediction prediction, float amount, const Vector& offset,
                      const Vector& quarry_velocity, float speed);

/// Pursuit: seek where the quarry will be after `time`: o + v T. Evasion flees the same place.
Vector pursue(const Vector& offset, const Vector& quarry_velocity, float time, const Vector& velocity,
              float max_speed);
Vector evade(const Vector& offset, const Vector& quarry_velocity, float time, const Vector& velocity,
             float max_speed);

/// A vector that is given as (ahead, left, up) of somebody with that velocity, in the world's axes. Left is
/// level: z × ahead; up is ahead × left. Straight up or down, left is y; at rest ahead is x.
Vector in_world(const Vector& ahead_left_up, const Vector& leader_velocity);

/// Offset pursuit: arrive at a place in the leader's frame, `ahead_left_up` (length) from where the leader
/// will be after `time`. With time = slowing_radius / max_speed a steady leader is followed without a lag.
Vector pursue_offset(const Vector& offset, const Vector& leader_velocity, const Vector& ahead_left_up,
                     float time, const Vector& velocity, float max_speed, float slowing_radius);

/// Corners in order, at least two that differ (else whoever follows feels nothing); where the line is a
/// `loop` the last is joined to the first.
struct Polyline {
  std::span<const Vector> corners;
  bool loop = false;
};

/// A place on a polyline.
struct OnPolyline {
  Vector at{};            ///< length
  Vector along{};         ///< unit vector along its piece, or zero where no two corners differ
  float distance = 0;     ///< length; from the place that was asked about
  std::size_t piece = 0;  ///< between corner `piece` and the next
  float into_piece = 0;   ///< length from the beginning of the piece
};

/// The place of the line that is nearest; the first of equals.
OnPolyline nearest_on(const Polyline& line, const Vector& place);
/// The place that lies `length` further along the line, at most one round of a loop; a line without a loop
/// ends with its last corner. Its `distance` is from where it began.
OnPolyline further_on(const Polyline& line, const OnPolyline& from, float length);

/// Path following: zero while the place after `time` will be within `radius` (length) of the path, and
/// otherwise seek the path's point that lies `ahead` (length) beyond the nearest one.
Vector follow_path(const Polyline& path, float radius, float ahead, float time, const Vector& position,
                   const Vector& velocity, float max_speed);

/// Wall following: path following along the line at `distance` (length) from the wall, on the side where the
/// agent is, in the order of the wall's corners; on the wall itself that is the left. In three dimensions the
/// wall stands upright on its line, whose corners have z = 0, and the agent goes level.
Vector follow_wall(const Polyline& wall, float distance, float radius, float ahead, float time,
                   const Vector& position, const Vector& velocity, float max_speed);

/// Flow field following: the desired velocity that stands where the agent will be after `time`, minus the own
/// velocity. `flow` is any function from a place to a velocity.
template <class Flow>
Vector follow_flow(const Flow& flow, float time, const Vector& position, const Vector& velocity) {
  Vector ahead = position;
  for (std::size_t axis = 0; axis < 3; ++axis) ahead[axis] += velocity[axis] * time;
  Vector desired = flow(ahead);
  for (std::size_t axis = 0; axis < 3; ++axis) desired[axis] -= velocity[axis];
  return desired;
}

/// Velocities on the points of a grid, x fastest; at least one point on each axis.
struct FlowGrid {
  std::span<const Vector> velocities;   ///< length per time; points[0]·points[1]·points[2] of them
  std::array<std::size_t, 3> points{};  ///< on each axis; one in z for a plane
  Vector first{};                       ///< length; where the first point lies
  Vector spacing{};                     ///< length, above 0 on every axis with more than one point
  /// Between the points linearly on every axis; beyond the grid, what stands on its edge.
  Vector operator()(const Vector& place) const;
};

/// A whirl about an upright axis: `speed` (length per time) at the radius `core` (length), less within like a
/// turning disc, less outside like 1/distance (Rankine). Turns from x to y for a positive speed.
Vector vortex(const Vector& from_centre, float speed, float core);

/// Leader following: arrive at the place `distance` (length) behind the leader; but who is in the leader's
/// way, up to `distance` ahead and within `clearance` (length) of the line of flight, steps aside at full
/// speed, to the left on the line itself. The frame is that of `in_world`.
Vector follow_leader(const Vector& offset, const Vector& leader_velocity, float distance, float clearance,
                     const Vector& velocity, float max_speed, float slowing_radius);

/// When two who keep their velocities are nearest, -(o·w)/(w·w) with w = the other's velocity - the own.
/// None where that is not ahead: they move apart, or alike.
std::optional<float> nearest_approach_time(const Vector& offset, const Vector& other_velocity,
                                           const Vector& velocity);

/// Unaligned collision avoidance: the unit vector across the own heading, away from where the other will be
/// at the nearest approach, after `time`. Who meets head-on steps to the right; so do both.
Vector sidestep(const Vector& offset, const Vector& other_velocity, float time, const Vector& velocity);

/// A ball to hide behind.
struct Ball {
  Vector offset{};   ///< length; its centre minus the own position
  float radius = 0;  ///< length
};

/// Hide: arrive behind the ball whose far side, `margin` (length) off its surface as seen from the threat, is
/// nearest; the first of equals. Zero with nothing to hide behind. A ball around the threat hides nobody.
Vector hide(std::span<const Ball> balls, const Vector& threat_offset, float margin, const Vector& velocity,
            float max_speed, float slowing_radius);

/// Whether somebody at `offset` is nearer than `distance` (length) within the cone around the own heading
/// whose half angle has this cosine. Nobody is ahead of who is at rest.
bool is_ahead(const Vector& offset, const Vector& velocity, float distance, float cos_half);

/// Queuing: the brake for somebody ahead, -v·(1 - |o|/distance): none at `distance`, all of the speed in one
/// time unit when they touch. For whoever `is_ahead`.
Vector brake(const Vector& offset, const Vector& velocity, float distance);

}  // namespace sturnus
