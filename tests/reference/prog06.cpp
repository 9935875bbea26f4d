// Reference of the assignment prog06, Part 2, "Simulating Boids": its three loops, its capped velocity
// update, and the nudge back into the box.

#include "reference.h"

namespace reference {
namespace {

/// diff / (dist * dist) summed over all others with dist <= R; coincident boids push nowhere (S1-6).
Vec separation(const Boids& boids, std::size_t i, double radius) {
  Vec separation;
  for (std::size_t j = 0; j < boids.position.size(); ++j) {
    if (j == i) continue;
    const Vec diff = boids.position[i] - boids.position[j];
    const double dist = length(diff);
    if (dist <= radius) {
      if (dist > 0.0) separation += diff / (dist * dist);
    }
  }
  return separation;
}

/// The mean of all others, however far, minus one's own: alignment of velocities (S1-8), cohesion of
/// positions (S1-9). A boid with nobody else to average feels nothing.
Vec mean_minus_own(const std::vector<Vec>& q, std::size_t i) {
  if (q.size() < 2) return {};
  Vec mean;
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (j == i) continue;
    mean += q[j];
  }
  mean /= static_cast<double>(q.size() - 1);
  mean -= q[i];
  return mean;
}

/// The weighted sum, kept to the length 0.02 (S1-10 to S1-12).
Vec velocity_update(const Boids& boids, std::size_t i, const Prog06Parameters& parameters) {
  Vec update;
  update += parameters.separation_weight * separation(boids, i, parameters.radius);
  update += parameters.alignment_weight * mean_minus_own(boids.velocity, i);
  update += parameters.cohesion_weight * mean_minus_own(boids.position, i);
  return capped(update, parameters.max_update);
}

/// The factor added to the velocity of a boid outside the box; the box has no walls in z (S1-13).
Vec nudge(Vec p, const Prog06Parameters& parameters) {
  const double half = parameters.half_size;
  return parameters.nudge * Vec{inward(p.x, -half, half), inward(p.y, -half, half), 0};
}

bool on_turn_line(Vec p, double half) {
  return near_line(std::abs(p.x), half, 2 * half) || near_line(std::abs(p.y), half, 2 * half);
}

bool is_exempt(const Boids& boids, std::size_t i, const Prog06Parameters& parameters) {
  for (std::size_t j = 0; j < boids.position.size(); ++j) {
    if (j == i) continue;
    const double dist = length(boids.position[i] - boids.position[j]);
    if (near_radius(dist, parameters.radius) || nearly_zero(dist)) return true;
  }
  return on_turn_line(boids.position[i], parameters.half_size);
}

}  // namespace

/// All updates first, then all velocities, then all positions (S1-10), with the speed cap that the text hints
/// at (S1-14).
Step prog06(const Boids& boids, const Prog06Parameters& parameters) {
  const std::size_t count = boids.position.size();
  std::vector<Vec> updates(count);
  for (std::size_t i = 0; i < count; ++i) updates[i] = velocity_update(boids, i, parameters);

  Step step{boids, std::vector<bool>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    Vec& velocity = step.next.velocity[i];
    velocity += updates[i];
    velocity += nudge(boids.position[i], parameters);
    velocity = capped(velocity, parameters.max_speed);
    step.next.position[i] += velocity;
    step.exempt[i] = is_exempt(boids, i, parameters);
  }
  return step;
}

}  // namespace reference
