// Reference of "Boids Simulation with QuadTree Optimization" (Bella Liu): its three algorithms with the
// visible range angle and the turn at the margins, over all pairs instead of the tree.

#include <algorithm>
#include <numbers>

#include "reference.h"

namespace reference {
namespace {

/// The angle between two vectors in radians. A zero vector has no direction and gives 0, so a boid at rest
/// sees all round and a coincident boid is seen.
double get_angle(Vec a, Vec b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// ANGLE_LIMIT in radians, measured from the heading: half of the field (S3-5).
double angle_limit(const QuadtreeParameters& parameters) {
  return parameters.field_of_view / 2 * std::numbers::pi / 180;
}

/// A field of 360 degrees switches the check off: rounding must not hide who is exactly behind.
bool in_view(Vec velocity, Vec offset, const QuadtreeParameters& parameters) {
  return parameters.field_of_view >= 360 || get_angle(velocity, offset) <= angle_limit(parameters);
}

/// The check of distance and angle that every term makes. The boid is not its own neighbour (S3-3).
bool flockmate(const Boids& boids, std::size_t boid, std::size_t other, double range,
               const QuadtreeParameters& parameters) {
  if (other == boid) return false;
  const Vec offset = boids.position[other] - boids.position[boid];
  return length(offset) < range && in_view(boids.velocity[boid], offset, parameters);
}

/// The sum of the offsets away, added to the acceleration once, after the loop (S3-2).
Vec separation(const Boids& boids, std::size_t boid, const QuadtreeParameters& parameters) {
  Vec steer;
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (!flockmate(boids, boid, other, parameters.close_range, parameters)) continue;
    steer += boids.position[boid] - boids.position[other];
  }
  return steer;
}

/// Alignment (q = velocity, S3-3) and cohesion (q = position, S3-4): the mean over the flockmates minus the
/// boid's own.
Vec mean_minus_own(const Boids& boids, const std::vector<Vec>& q, std::size_t boid,
                   const QuadtreeParameters& parameters) {
  Vec steer;
  double total = 0;
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (!flockmate(boids, boid, other, parameters.visual_range, parameters)) continue;
    steer += q[other];
    total += 1;
  }
  if (total == 0) return {};
  steer /= total;
  steer -= q[boid];
  return steer;
}

/// The turn at the edges: four strict comparisons, two of which hold in a corner (S3-11).
Vec edge_turn(Vec position, const QuadtreeParameters& parameters) {
  Vec turn;
  if (position.x > parameters.width - parameters.margin) turn.x -= parameters.turn_factor;
  if (position.x < parameters.margin) turn.x += parameters.turn_factor;
  if (position.y > parameters.height - parameters.margin) turn.y -= parameters.turn_factor;
  if (position.y < parameters.margin) turn.y += parameters.turn_factor;
  return turn;
}

/// Starts from zero in every step: the document never says to reset it, and means it.
Vec acceleration(const Boids& boids, std::size_t boid, const QuadtreeParameters& parameters) {
  Vec acceleration;
  acceleration += separation(boids, boid, parameters) * parameters.separation_factor;
  acceleration += mean_minus_own(boids, boids.velocity, boid, parameters) * parameters.alignment_factor;
  acceleration += mean_minus_own(boids, boids.position, boid, parameters) * parameters.cohesion_factor;
  return acceleration;
}

/// A flockmate within reach whose angle, or whether it has one at all, rounding decides.
bool near_view_edge(Vec velocity, Vec offset, const QuadtreeParameters& parameters) {
  const double reach = std::max(parameters.close_range, parameters.visual_range);
  if (parameters.field_of_view >= 360 || length(offset) >= reach) return false;
  if (velocity == Vec{} || offset == Vec{}) return false;
  return nearly_zero(length(velocity)) || nearly_zero(length(offset)) ||
         std::abs(get_angle(velocity, offset) - angle_limit(parameters)) <= 1e-4;
}

bool on_turn_line(Vec p, const QuadtreeParameters& parameters) {
  const double width = parameters.width, height = parameters.height, margin = parameters.margin;
  return near_line(p.x, margin, width) || near_line(p.x, width - margin, width) ||
         near_line(p.y, margin, height) || near_line(p.y, height - margin, height);
}

bool is_exempt(const Boids& boids, std::size_t boid, Vec change, const QuadtreeParameters& parameters) {
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (other == boid) continue;
    const Vec offset = boids.position[other] - boids.position[boid];
    if (near_radius(length(offset), parameters.close_range)) return true;
    if (near_radius(length(offset), parameters.visual_range)) return true;
    if (near_view_edge(boids.velocity[boid], offset, parameters)) return true;
  }
  return on_turn_line(boids.position[boid], parameters) ||
         direction_lost(boids.velocity[boid], change, parameters.min_speed);
}

}  // namespace

/// velocity += acceleration, position += velocity, from the old state of all (S3-12); the speed is kept
/// to 3..6 (S3-19).
Step quadtree(const Boids& boids, const QuadtreeParameters& parameters) {
  Step step{boids, std::vector<bool>(boids.position.size())};
  for (std::size_t boid = 0; boid < boids.position.size(); ++boid) {
    const Vec change = acceleration(boids, boid, parameters) + edge_turn(boids.position[boid], parameters);
    Vec& velocity = step.next.velocity[boid];
    velocity += change;
    velocity = limit_speed(velocity, parameters.min_speed, parameters.max_speed);
    step.next.position[boid] += velocity;
    step.exempt[boid] = is_exempt(boids, boid, change, parameters);
  }
  return step;
}

}  // namespace reference
