// Hiding: arrive at the far side of an obstacle, as seen from whom is hidden from (Reynolds 1999).
#include <sturnus/steering.h>

#include <limits>

#include "rules/rules.h"

namespace sturnus {
namespace {

// The nearest of the places that are hidden from a threat; the first of equals.
class Refuge {
 public:
  Refuge(const Vector& threat_offset, float margin) : threat_(threat_offset), margin_(margin) {}

  void consider(const Ball& ball) {
    const Vec<3> from_threat = Vec<3>{ball.offset} - threat_;
    if (!(length(from_threat) > ball.radius)) return;
    const Vec<3> place = Vec<3>{ball.offset} + unit(from_threat) * (ball.radius + margin_);
    if (!(dot(place, place) < nearest_)) return;
    nearest_ = dot(place, place);
    place_ = place;
  }

  bool is_found() const { return nearest_ < std::numeric_limits<float>::infinity(); }
  const Vector& offset() const { return place_.at; }

 private:
  Vec<3> threat_;
  float margin_;
  Vec<3> place_;
  float nearest_ = std::numeric_limits<float>::infinity();
};

// What an obstacle hides: itself, or the ball around a box.
float hiding_radius(const Obstacle& obstacle) {
  return obstacle.kind == ObstacleKind::sphere ? obstacle.radius : length(Vec<3>{obstacle.half});
}

}  // namespace

Vector hide(std::span<const Ball> balls, const Vector& threat_offset, float margin, const Vector& velocity,
            float max_speed, float slowing_radius) {
  Refuge refuge(threat_offset, margin);
  for (const Ball& ball : balls) refuge.consider(ball);
  if (!refuge.is_found()) return {};
  return arrive(refuge.offset(), velocity, max_speed, slowing_radius);
}

template <int D>
Vec<D> hiding(const HideModel& hide, const Model& model, const ObstacleIndex& obstacles,
              const Others<D>& others, const Self<D>& self, float max_speed) {
  const auto hunter = nearest_of(others, hide.flocks, hide.radius_squared, self);
  if (!hunter) return {};
  const Vector threat = widened(others.offset_to(self, *hunter));
  const Vector own = widened(self.velocity);
  Refuge refuge(threat, hide.margin);
  const Place<D> from = place_of(self.position);
  obstacles.visit(self.position, double{hide.reach}, [&](const Obstacle& obstacle) {
    if (obstacle.kind == ObstacleKind::plane) return;  // its far side is solid
    const Place<D> o = way(model, from, place_of<D>(obstacle.at));
    if (surface(obstacle, o, 0).distance > double{hide.reach}) return;
    refuge.consider({widened(rounded(o)), hiding_radius(obstacle)});
  });
  if (!refuge.is_found())
    return narrow_to<D>(evade(threat, widened(others.velocity(*hunter)), hide.time, own, max_speed));
  return narrow_to<D>(arrive(refuge.offset(), own, max_speed, hide.slowing));
}

template Vec<2> hiding<2>(const HideModel&, const Model&, const ObstacleIndex&, const Others<2>&,
                          const Self<2>&, float);
template Vec<3> hiding<3>(const HideModel&, const Model&, const ObstacleIndex&, const Others<3>&,
                          const Self<3>&, float);

}  // namespace sturnus
