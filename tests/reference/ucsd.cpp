// Reference of UCSD CSE 167 Assignment 5, "Animation: Boids": equations (1) to (7), then its speed limits.

#include "reference.h"

namespace reference {
namespace {

/// Equation (2), the mean push away: (1/N_s) sum [|p_j - p_i| < d_s] (p_j - p_i). Zero where N_s = 0 (S0-5).
Vec separation(const Boids& boids, std::size_t j, const UcsdParameters& parameters) {
  const std::vector<Vec>& p = boids.position;
  Vec sum;
  double n_s = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i == j) continue;
    if (length(p[j] - p[i]) < parameters.separation_radius) {
      sum += p[j] - p[i];
      n_s += 1;
    }
  }
  return n_s > 0 ? sum / n_s : Vec{};
}

/// Equations (3) and (5), for q = p and q = v: the mean of q over the visible others, minus q_j. Zero where
/// N_v = 0 (S0-6, S0-7). The safety distance cuts no hole: who is avoided is seen as well (S0-8).
Vec mean_minus_own(const Boids& boids, const std::vector<Vec>& q, std::size_t j, double d_v) {
  const std::vector<Vec>& p = boids.position;
  Vec sum;
  double n_v = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i == j) continue;
    if (length(p[j] - p[i]) < d_v) {
      sum += q[i];
      n_v += 1;
    }
  }
  return n_v > 0 ? sum / n_v - q[j] : Vec{};
}

/// Equation (7), with y growing downward: strict, a unit step, both axes in a corner (S0-9).
Vec boundary(Vec p, const UcsdParameters& parameters) {
  const double d_left = parameters.margin_x, d_right = parameters.width - parameters.margin_x;
  const double d_top = parameters.margin_y, d_bottom = parameters.height - parameters.margin_y;
  return {inward(p.x, d_left, d_right), inward(p.y, d_top, d_bottom), 0};
}

/// Equation (1), the weighted sum (S0-4).
Vec force(const Boids& boids, std::size_t j, const UcsdParameters& parameters) {
  const Vec f_s = separation(boids, j, parameters);
  const Vec f_c = mean_minus_own(boids, boids.position, j, parameters.visual_radius);
  const Vec f_a = mean_minus_own(boids, boids.velocity, j, parameters.visual_radius);
  const Vec f_b = boundary(boids.position[j], parameters);
  return parameters.separation_weight * f_s + parameters.cohesion_weight * f_c +
         parameters.alignment_weight * f_a + parameters.boundary_weight * f_b;
}

bool on_turn_line(Vec p, const UcsdParameters& parameters) {
  const double width = parameters.width, height = parameters.height;
  return near_line(p.x, parameters.margin_x, width) || near_line(p.x, width - parameters.margin_x, width) ||
         near_line(p.y, parameters.margin_y, height) || near_line(p.y, height - parameters.margin_y, height);
}

bool is_exempt(const Boids& boids, std::size_t j, Vec change, const UcsdParameters& parameters) {
  for (std::size_t i = 0; i < boids.position.size(); ++i) {
    if (i == j) continue;
    const double distance = length(boids.position[j] - boids.position[i]);
    if (near_radius(distance, parameters.separation_radius)) return true;
    if (near_radius(distance, parameters.visual_radius)) return true;
  }
  return on_turn_line(boids.position[j], parameters) ||
         direction_lost(boids.velocity[j], change, parameters.min_speed);
}

}  // namespace

/// Synchronous and semi-implicit: every boid reads the old state, and the new velocity moves it (S0-2).
Step ucsd(const Boids& boids, const UcsdParameters& parameters) {
  Step step{boids, std::vector<bool>(boids.position.size())};
  for (std::size_t j = 0; j < boids.position.size(); ++j) {
    const Vec f = force(boids, j, parameters);
    Vec& velocity = step.next.velocity[j];
    velocity += f;
    velocity = limit_speed(velocity, parameters.min_speed, parameters.max_speed);
    step.next.position[j] += velocity;
    step.exempt[j] = is_exempt(boids, j, f, parameters);
  }
  return step;
}

}  // namespace reference
