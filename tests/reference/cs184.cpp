// Reference of "Flocking Simulation", the CS 184 final project by David Hahn and Gloria Hwang: the three
// rules in concentric rings, the cruise speed, limited acceleration and a wrapped world. The document gives
// words, not code.

#include "reference.h"

namespace reference {
namespace {

/// neighbour - unit, to the nearest image of the neighbour.
Vec nearest_offset(const Boids& boids, std::size_t unit, std::size_t neighbour,
                   const Cs184Parameters& parameters) {
  const Vec o = boids.position[neighbour] - boids.position[unit];
  return {nearest_image(o.x, parameters.width), nearest_image(o.y, parameters.height), o.z};
}

/// A unit on a ring's inner edge is in the ring, on its outer edge in the next (S4-4).
bool in_ring(double distance, double inner, double outer) {
  return inner <= distance && distance < outer;
}

/// "The difference between the neighbour's position and the unit's position ... divided by the neighbour's
/// distance so that units that are further away have less impact": a direction divided by a distance, o/d²
/// (S4-2). A coincident neighbour has no direction.
Vec contribution(Vec offset) {
  const double distance = length(offset);
  return distance > 0.0 ? offset / (distance * distance) : Vec{};
}

/// The mean contribution over a ring: cohesion, and with the opposite sign separation (S4-2, S4-3).
Vec mean_contribution(const Boids& boids, std::size_t unit, double inner, double outer,
                      const Cs184Parameters& parameters) {
  Vec sum;
  double n = 0;
  for (std::size_t neighbour = 0; neighbour < boids.position.size(); ++neighbour) {
    if (neighbour == unit) continue;
    const Vec offset = nearest_offset(boids, unit, neighbour, parameters);
    if (!in_ring(length(offset), inner, outer)) continue;
    sum += contribution(offset);
    n += 1;
  }
  return n > 0 ? sum / n : Vec{};
}

/// The mean of the neighbours' normalised velocities; the unit's own is not taken away (S4-1).
Vec mean_heading(const Boids& boids, std::size_t unit, double inner, double outer,
                 const Cs184Parameters& parameters) {
  Vec sum;
  double n = 0;
  for (std::size_t neighbour = 0; neighbour < boids.position.size(); ++neighbour) {
    if (neighbour == unit) continue;
    if (!in_ring(length(nearest_offset(boids, unit, neighbour, parameters)), inner, outer)) continue;
    sum += heading(boids.velocity[neighbour]);
    n += 1;
  }
  return n > 0 ? sum / n : Vec{};
}

/// "The difference between the target cruising speed and the current" speed, along the heading (S4-5).
Vec cruise(Vec velocity, const Cs184Parameters& parameters) {
  return (parameters.cruise_speed - length(velocity)) * heading(velocity);
}

/// The weighted vectors added together, and the magnitude of the whole limited (S4-6, S4-7).
Vec acceleration(const Boids& boids, std::size_t unit, const Cs184Parameters& parameters) {
  const double a = parameters.radius_a, b = parameters.radius_b, c = parameters.radius_c;
  const Vec separation = -1.0 * mean_contribution(boids, unit, 0, a, parameters);
  const Vec alignment = mean_heading(boids, unit, a, b, parameters);
  const Vec cohesion = mean_contribution(boids, unit, b, c, parameters);
  const Vec sum = parameters.separation_weight * separation + parameters.alignment_weight * alignment +
                  parameters.cohesion_weight * cohesion +
                  parameters.cruise_weight * cruise(boids.velocity[unit], parameters);
  return capped(sum, parameters.max_acceleration);
}

/// Units that cross a border come out on the opposite side (S4-19).
Vec wrap(Vec p, const Cs184Parameters& parameters) {
  return {wrapped(p.x, 0, parameters.width), wrapped(p.y, 0, parameters.height), p.z};
}

bool on_seam(Vec p, const Cs184Parameters& parameters) {
  const double width = parameters.width, height = parameters.height;
  return near_line(p.x, 0, width) || near_line(p.x, width, width) || near_line(p.y, 0, height) ||
         near_line(p.y, height, height);
}

bool pair_is_exempt(Vec raw, double distance, Vec neighbour_velocity, const Cs184Parameters& parameters) {
  const double slack = seam_slack(raw.x, parameters.width) + seam_slack(raw.y, parameters.height);
  const bool either_image = near_half(raw.x, parameters.width) || near_half(raw.y, parameters.height);
  const bool in_reach = distance < parameters.radius_c;
  return near_radius(distance, parameters.radius_a, slack) ||
         near_radius(distance, parameters.radius_b, slack) ||
         near_radius(distance, parameters.radius_c, slack) || nearly_zero(distance) ||
         (distance > 0 && distance <= slack) ||
         (in_reach && (either_image || nearly_zero(length(neighbour_velocity))));
}

bool is_exempt(const Boids& boids, std::size_t unit, Vec next_position, Vec change,
               const Cs184Parameters& parameters) {
  for (std::size_t neighbour = 0; neighbour < boids.position.size(); ++neighbour) {
    if (neighbour == unit) continue;
    const Vec raw = boids.position[neighbour] - boids.position[unit];
    const double distance = length(nearest_offset(boids, unit, neighbour, parameters));
    if (pair_is_exempt(raw, distance, boids.velocity[neighbour], parameters)) return true;
  }
  const Vec velocity = boids.velocity[unit];
  return on_seam(next_position, parameters) || nearly_zero(length(velocity)) ||
         direction_lost(velocity, change, parameters.min_speed);
}

}  // namespace

/// Semi-implicit Euler, a frame at a time: x(t + dt) = x(t) + v(t + dt), v(t + dt) = v(t) + a(t) (S4-8).
Step cs184(const Boids& boids, const Cs184Parameters& parameters) {
  Step step{boids, std::vector<bool>(boids.position.size())};
  for (std::size_t unit = 0; unit < boids.position.size(); ++unit) {
    const Vec a = acceleration(boids, unit, parameters);
    Vec& position = step.next.position[unit];
    Vec& velocity = step.next.velocity[unit];
    velocity += a;
    velocity = limit_speed(velocity, parameters.min_speed, parameters.max_speed);
    position += velocity;
    position = wrap(position, parameters);
    step.exempt[unit] = is_exempt(boids, unit, position, a, parameters);
  }
  return step;
}

}  // namespace reference
