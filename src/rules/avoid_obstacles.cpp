// Obstacles: sideways, out of the way of the first ahead (VUW CGRA 354), or away from all near (CS 184).
#include <cmath>
#include <span>

#include "rules/rules.h"

namespace sturnus {
namespace {

// A perpendicular that depends on the direction alone: to the left, in 3D also square to the axis that the
// direction leans on least, the first of those that are equal.
Place<2> any_perpendicular(const Place<2>& h) {
  return {{-h[1], h[0]}};
}
Place<3> any_perpendicular(const Place<3>& h) {
  int least = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(h[axis]) < std::abs(h[least])) least = axis;
  }
  Place<3> out;
  out[(least + 1) % 3] = h[(least + 2) % 3] * -1;
  out[(least + 2) % 3] = h[(least + 1) % 3];
  return unit(out);
}

// unit(E - C), E the point of the line along h that is nearest to the centre.
template <int D>
Place<D> sideways(const Place<D>& to_centre, const Place<D>& h) {
  const Place<D> from_centre = h * (dot(to_centre, h) / dot(h, h)) - to_centre;
  // A heading in single precision says no more about the side.
  const bool is_aimed_at = dot(from_centre, from_centre) <= 1e-12 * dot(to_centre, to_centre);
  return is_aimed_at ? any_perpendicular(h) : unit(from_centre);
}

// Whoever tells of obstacles: an index, or a list of their numbers.
struct Listed {
  const ObstacleIndex& obstacles;
  std::span<const std::uint32_t> numbers;

  template <int D, class F>
  void visit(const Vec<D>&, double, F&& f) const {
    for (const std::uint32_t number : numbers) f(obstacles.obstacle(number));
  }
};

template <int D, class Obstacles>
Vec<D> sweep(const TermModel& term, const FlockModel& flock, const Model& model, const Obstacles& obstacles,
             const Self<D>& self) {
  const Place<D> h = place_of(self.heading());
  if (h == Place<D>{}) return {};
  const Place<D> from = place_of(self.position);
  const double thicker = double{flock.body_radius} + double{term.clearance};
  const double ahead = double{term.look_ahead};
  double first = double{FlockModel::infinity_f};
  Place<D> force;
  obstacles.visit(self.position, ahead + thicker, [&](const Obstacle& obstacle) {
    const Place<D> o = way(model, from, place_of<D>(obstacle.at));
    const auto met = meet(obstacle, o, h, thicker);
    if (!met || met->t > ahead || !(met->t < first)) return;
    first = met->t;
    force = obstacle.kind == ObstacleKind::sphere ? sideways(o, h) : met->out;
  });
  return rounded(force);
}

// How far the surface of an obstacle is, and the unit vector away from it: of a sphere from its centre, which
// has no direction. Inside a box the way out is that through the nearest face.
template <int D>
Surface<D> away_from(const Obstacle& obstacle, const Place<D>& o) {
  Surface<D> found = surface(obstacle, o, 0);
  if (obstacle.kind == ObstacleKind::sphere) found.out = unit(o) * -1.0;
  if (obstacle.kind == ObstacleKind::box && found.distance > 0) {
    const Place<D> to_box = way_to_box(obstacle, o);
    found = {length(to_box), unit(to_box) * -1.0};
  }
  return found;
}

template <int D, class Obstacles>
Vec<D> mean_away(const TermModel& term, const Model& model, const Obstacles& obstacles, const Self<D>& self) {
  const Place<D> from = place_of(self.position);
  Place<D> sum;
  int count = 0;
  obstacles.visit(self.position, double{term.look_ahead}, [&](const Obstacle& obstacle) {
    const Surface<D> away = away_from(obstacle, way(model, from, place_of<D>(obstacle.at)));
    if (away.distance > double{term.look_ahead}) return;
    sum += away.out;
    ++count;
  });
  if (count == 0) return {};
  return rounded(sum * (1.0 / count) - place_of(self.heading()));
}

template <int D, class Obstacles>
Vec<D> avoid(const TermModel& term, const FlockModel& flock, const Model& model, const Obstacles& obstacles,
             const Self<D>& self) {
  return term.obstacle_form == ObstacleForm::sweep ? sweep(term, flock, model, obstacles, self)
                                                   : mean_away(term, model, obstacles, self);
}

}  // namespace

template <int D>
Vec<D> avoid_obstacles(const TermModel& term, const FlockModel& flock, const Model& model,
                       const ObstacleIndex& obstacles, const Self<D>& self) {
  return obstacles.empty() ? Vec<D>{} : avoid(term, flock, model, obstacles, self);
}

template <int D>
Vec<D> avoid_listed(const TermModel& term, const FlockModel& flock, const Model& model,
                    const ObstacleIndex& obstacles, std::span<const std::uint32_t> numbers,
                    const Self<D>& self) {
  return avoid(term, flock, model, Listed{obstacles, numbers}, self);
}

template Vec<2> avoid_obstacles<2>(const TermModel&, const FlockModel&, const Model&, const ObstacleIndex&,
                                   const Self<2>&);
template Vec<3> avoid_obstacles<3>(const TermModel&, const FlockModel&, const Model&, const ObstacleIndex&,
                                   const Self<3>&);
template Vec<2> avoid_listed<2>(const TermModel&, const FlockModel&, const Model&, const ObstacleIndex&,
                                std::span<const std::uint32_t>, const Self<2>&);
template Vec<3> avoid_listed<3>(const TermModel&, const FlockModel&, const Model&, const ObstacleIndex&,
                                std::span<const std::uint32_t>, const Self<3>&);

std::optional<float> distance_to_sphere(const Vector& to_centre, const Vector& velocity, float radius) {
  const Place<3> h = place_of(unit(Vec<3>{velocity}));
  if (h == Place<3>{}) return {};
  const auto t = meet_sphere(place_of<3>(to_centre), h, double{radius});
  if (!t) return {};
  return static_cast<float>(*t);
}

Vector avoid_sphere(const Vector& to_centre, const Vector& velocity, float radius, float look_ahead) {
  const auto distance = distance_to_sphere(to_centre, velocity, radius);
  if (!distance || *distance > look_ahead) return {};
  return rounded(sideways(place_of<3>(to_centre), place_of(unit(Vec<3>{velocity})))).at;
}

}  // namespace sturnus
