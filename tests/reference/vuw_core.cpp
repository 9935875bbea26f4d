// Reference of CGRA 354 "Lecture 14-15: Boids continued", the Core part: avoidance, cohesion, alignment,
// sensible speed and a wrapped bounding box.

#include "reference.h"

namespace reference {
namespace {

bool same_flock(const Boids& boids, std::size_t a, std::size_t b) {
  return boids.flock.empty() || boids.flock[a] == boids.flock[b];
}

/// other - boid, to the nearest image of the other.
Vec nearest_offset(const Boids& boids, std::size_t boid, std::size_t other, double size) {
  const Vec o = boids.position[other] - boids.position[boid];
  return {nearest_image(o.x, size), nearest_image(o.y, size), nearest_image(o.z, size)};
}

/// Closed edge: only `distance > radius` is passed over (S2-12, S2-16). A radius of 0 means nobody.
bool within(double distance, double radius) {
  return radius > 0 && !(distance > radius);
}

/// The displacement divided by its squared magnitude, summed over the boids of every flock (S2-12, S2-18).
Vec avoidance(const Boids& boids, std::size_t boid, const VuwParameters& parameters) {
  Vec avoidance;
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (boid == other) continue;
    const Vec displacement = -1.0 * nearest_offset(boids, boid, other, 2 * parameters.half_size);
    const double distance = length(displacement);
    if (!within(distance, parameters.avoidance_radius)) continue;
    if (distance > 0.0) avoidance += displacement / (distance * distance);
  }
  return avoidance;
}

struct Averages {
  Vec position, velocity;
};

/// `neighbours = 1` counts the boid itself, so the sums start at its own values: a lone boid feels nothing,
/// where a sum started at zero would steer it to the origin (S2-14, S2-15).
Averages neighbourhood(const Boids& boids, std::size_t boid, const VuwParameters& parameters) {
  Vec average_position = boids.position[boid];
  Vec average_velocity = boids.velocity[boid];
  double neighbours = 1;
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (boid == other || !same_flock(boids, boid, other)) continue;
    const Vec offset = nearest_offset(boids, boid, other, 2 * parameters.half_size);
    if (!within(length(offset), parameters.neighbour_radius)) continue;
    average_position += boids.position[boid] + offset;
    average_velocity += boids.velocity[other];
    neighbours += 1;
  }
  return {average_position / neighbours, average_velocity / neighbours};
}

/// The weighted sum (S2-11). The lecture's alignment repeats the cohesion line; average velocity minus own is
/// meant.
Vec total_acceleration(const Boids& boids, std::size_t boid, const VuwParameters& parameters) {
  const Averages average = neighbourhood(boids, boid, parameters);
  const Vec cohesion = average.position - boids.position[boid];
  const Vec alignment = average.velocity - boids.velocity[boid];
  return avoidance(boids, boid, parameters) * parameters.avoidance_weight +
         cohesion * parameters.cohesion_weight + alignment * parameters.alignment_weight;
}

/// position = aabb.min + mod(position - aabb.min, aabb.max - aabb.min), element-wise (S2-17).
Vec wrap(Vec p, double half) {
  return {wrapped(p.x, -half, half), wrapped(p.y, -half, half), wrapped(p.z, -half, half)};
}

bool on_seam(Vec p, double half) {
  const double size = 2 * half;
  return near_line(std::abs(p.x), half, size) || near_line(std::abs(p.y), half, size) ||
         near_line(std::abs(p.z), half, size);
}

bool pair_is_exempt(Vec raw, double distance, const VuwParameters& parameters) {
  const double size = 2 * parameters.half_size;
  const double slack = seam_slack(raw.x, size) + seam_slack(raw.y, size) + seam_slack(raw.z, size);
  const bool in_reach = within(distance, std::fmax(parameters.avoidance_radius, parameters.neighbour_radius));
  const bool either_image = near_half(raw.x, size) || near_half(raw.y, size) || near_half(raw.z, size);
  return near_radius(distance, parameters.avoidance_radius, slack) ||
         near_radius(distance, parameters.neighbour_radius, slack) || nearly_zero(distance) ||
         (distance > 0 && distance <= slack) || (in_reach && either_image);
}

bool is_exempt(const Boids& boids, std::size_t boid, Vec next_position, Vec change,
               const VuwParameters& parameters) {
  for (std::size_t other = 0; other < boids.position.size(); ++other) {
    if (boid == other) continue;
    const Vec raw = boids.position[other] - boids.position[boid];
    const double distance = length(nearest_offset(boids, boid, other, 2 * parameters.half_size));
    if (pair_is_exempt(raw, distance, parameters)) return true;
  }
  return on_seam(next_position, parameters.half_size) ||
         direction_lost(boids.velocity[boid], change, parameters.min_speed);
}

}  // namespace

/// All forces first, then all boids move (S2-3), position before velocity: the old velocity moves the boid
/// (S2-1).
Step vuw_core(const Boids& boids, const VuwParameters& parameters) {
  const std::size_t count = boids.position.size();
  std::vector<Vec> acceleration(count);
  for (std::size_t boid = 0; boid < count; ++boid)
    acceleration[boid] = total_acceleration(boids, boid, parameters);

  Step step{boids, std::vector<bool>(count)};
  for (std::size_t boid = 0; boid < count; ++boid) {
    Vec& position = step.next.position[boid];
    Vec& velocity = step.next.velocity[boid];
    const Vec change = parameters.timestep * acceleration[boid];
    position += parameters.timestep * velocity;
    velocity += change;
    velocity = limit_speed(velocity, parameters.min_speed, parameters.max_speed);
    position = wrap(position, parameters.half_size);
    step.exempt[boid] = is_exempt(boids, boid, position, change, parameters);
  }
  return step;
}

}  // namespace reference
