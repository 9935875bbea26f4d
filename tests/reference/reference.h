// Plain double-precision, all-pairs references of the five published systems that Sturnus ships as scenarios:
// UCSD CSE 167 "Animation: Boids", the assignment prog06, CGRA 354 "Boids continued", "Boids Simulation with
// QuadTree Optimization" and CS 184 "Flocking Simulation". The engine's float32 answers are held against
// these.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace reference {

/// A point or a direction. Planar systems leave z at 0.
struct Vec {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec&, const Vec&) = default;
};

inline Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(Vec a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vec operator*(double s, Vec a) {
  return a * s;
}
inline Vec operator/(Vec a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline Vec& operator+=(Vec& a, Vec b) {
  return a = a + b;
}
inline Vec& operator-=(Vec& a, Vec b) {
  return a = a - b;
}
inline Vec& operator/=(Vec& a, double s) {
  return a = a / s;
}
inline double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec a) {
  return std::hypot(a.x, a.y, a.z);
}

/// All boids of a world. `flock` numbers each boid's flock; left empty, all are of one flock (only VUW asks).
struct Boids {
  std::vector<Vec> position, velocity;
  std::vector<int> flock = {};
};

/// The boids after one step of noiseless rules. `exempt[j]` is true where float32 and double may legitimately
/// decide differently for boid j: a neighbour on the edge of a ring or of the view, the boid on a turn line
/// or on the seam. Take an element as `bool`: `auto` would be a proxy into a Step that may be gone.
struct Step {
  Boids next;
  std::vector<bool> exempt;
};

/// Lengths in pixels, times in frames (S0-11). The world is [0, width] x [0, height].
struct UcsdParameters {
  double separation_radius = 30;      ///< d_s, open edge
  double visual_radius = 150;         ///< d_v, open edge
  double separation_weight = 0.02;    ///< alpha_s
  double alignment_weight = 0.03;     ///< alpha_a
  double cohesion_weight = 0.001;     ///< alpha_c
  double boundary_weight = 0.5;       ///< alpha_b, the turn in pixels per frame²
  double width = 1280, height = 720;  ///< resolution
  double margin_x = 200, margin_y = 160;
  double min_speed = 5, max_speed = 10;  ///< s_min, s_max
};

/// Lengths in units of the box's side, times in frames (S1-4 to S1-14). The box is [-half_size, half_size]².
struct Prog06Parameters {
  double radius = 0.4;             ///< R, closed edge; separation only
  double separation_weight = 0.1;  ///< w_s
  double alignment_weight = 0.3;   ///< w_a, the whole population
  double cohesion_weight = 1.0;    ///< w_c, the whole population
  double max_update = 0.02;        ///< cap on the length of a velocity update
  double half_size = 0.5;
  double nudge = 0.02;  ///< added per axis while outside, after the cap
  double max_speed = 0.05;
};

/// Lengths in scene units, times in seconds (S2-1 to S2-18). The world is the wrapped cube
/// [-half_size, half_size)³.
struct VuwParameters {
  double avoidance_radius = 2;  ///< closed edge, all flocks
  double avoidance_weight = 4;
  double neighbour_radius = 5;  ///< closed edge, own flock
  double alignment_weight = 1.0;
  double cohesion_weight = 0.6;
  double min_speed = 4, max_speed = 8;
  double half_size = 20;         ///< m_bound_hsize
  double timestep = 1.0 / 60.0;  ///< seconds
};

/// Lengths in pixels, times in frames (S3-2 to S3-11, S3-19). The world is [0, width] x [0, height].
struct QuadtreeParameters {
  double close_range = 50;     ///< open edge
  double visual_range = 150;   ///< open edge
  double field_of_view = 240;  ///< full angle in degrees: twice ANGLE_LIMIT
  double separation_factor = 0.002;
  double alignment_factor = 0.09;
  double cohesion_factor = 0.0009;
  double width = 1600, height = 900;
  double margin = 100;
  double turn_factor = 0.2;  ///< pixels per frame²
  double min_speed = 3, max_speed = 6;
};

/// Lengths in pixels, times in frames (S4-1 to S4-8, S4-19). The world is the wrapped
/// [0, width) x [0, height).
struct Cs184Parameters {
  double radius_a = 12;  ///< separation in [0, a)
  double radius_b = 28;  ///< alignment in [a, b)
  double radius_c = 60;  ///< cohesion in [b, c)
  double separation_weight = 3;
  double alignment_weight = 0.06;
  double cohesion_weight = 2;
  double cruise_weight = 0.1;
  double cruise_speed = 2.5;
  double max_acceleration = 0.3;
  double min_speed = 0, max_speed = 4;
  double width = 800, height = 600;
};

/// One synchronous step of each system; the argument is left as it was.
Step ucsd(const Boids& boids, const UcsdParameters& parameters = {});
Step prog06(const Boids& boids, const Prog06Parameters& parameters = {});
Step vuw_core(const Boids& boids, const VuwParameters& parameters = {});
Step quadtree(const Boids& boids, const QuadtreeParameters& parameters = {});
Step cs184(const Boids& boids, const Cs184Parameters& parameters = {});

/// Shortens a vector that is longer than `longest`; the zero vector is never normalised.
inline Vec capped(Vec a, double longest) {
  const double len = length(a);
  return len > longest ? a * (longest / len) : a;
}

/// Speed limits as UCSD writes them: a boid at rest has no direction to speed up in and stays at rest
/// (S0-10).
inline Vec limit_speed(Vec velocity, double min_speed, double max_speed) {
  const double speed = length(velocity);
  if (speed > 0.0) {
    if (speed > max_speed) return velocity * (max_speed / speed);
    if (speed < min_speed) return velocity * (min_speed / speed);
  }
  return velocity;
}

/// The direction of a velocity; a boid at rest has the zero vector for a heading.
inline Vec heading(Vec velocity) {
  const double speed = length(velocity);
  return speed > 0.0 ? velocity / speed : Vec{};
}

/// +1 below `low`, -1 above `high`, both strict; lines that cross may hold together and cancel.
inline double inward(double coordinate, double low, double high) {
  return (coordinate < low ? 1.0 : 0.0) - (coordinate > high ? 1.0 : 0.0);
}

/// One axis of the minimum image, by comparison with half the size. An offset of exactly half the size stays.
inline double nearest_image(double offset, double size) {
  if (offset > size / 2) return offset - size;
  if (offset < -size / 2) return offset + size;
  return offset;
}

/// Floored modulo: min + mod(coordinate - min, max - min), where rounding to exactly max becomes min (S2-17).
inline double wrapped(double coordinate, double min, double max) {
  double inside = std::fmod(coordinate - min, max - min);
  if (inside < 0) inside += max - min;
  return min + inside >= max ? min : min + inside;
}

// What follows decides `exempt` and no more: where float32's rounding, not a rule, has the last word.

/// float32 resolves about 1e-7 of a length; ten times that is called the edge. `slack` widens it, in length.
inline bool near_radius(double distance, double radius, double slack = 0) {
  return radius > 0 && std::isfinite(radius) && std::abs(distance - radius) <= 1e-6 * radius + slack;
}

inline bool near_line(double coordinate, double line, double world_size) {
  return std::abs(coordinate - line) <= 1e-6 * world_size;
}

/// Neither zero nor large enough for float32 to square: float32 may take it for zero.
inline bool nearly_zero(double len) {
  return len > 0 && len < 1e-15;
}

/// A minimum speed makes a whole velocity of whatever direction is left, and here only rounding is left.
inline bool direction_lost(Vec velocity, Vec change, double min_speed) {
  const bool at_rest = velocity == Vec{} && change == Vec{};
  return !at_rest && length(velocity + change) < 1e-3 * min_speed;
}

/// One axis of a pair in a wrapped world: an image chosen at nearly half the size could be the other one.
inline bool near_half(double offset, double size) {
  return std::abs(std::abs(offset) - size / 2) <= 1e-6 * size;
}

/// One axis of a pair in a wrapped world: float32 rounds an offset across the seam at the size of the world,
/// not at the distance, so the edge of a radius is that much wider there.
inline double seam_slack(double offset, double size) {
  return std::abs(offset) > size / 2 ? 1e-7 * size : 0.0;
}

}  // namespace reference
