// Wall following (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/nearest_image.h"
#include "rules/rules.h"

namespace sturnus {
namespace {

Vec<3> level_left(const Vector& along) {
  return unit(Vec<3>{{-along[1], along[0], 0}});
}

// The left of the piece that ends at that corner and of the one that begins there, together.
Vec<3> left_at_corner(const Polyline& wall, std::size_t corner) {
  const std::size_t corners = wall.corners.size();
  const Vec<3> here{wall.corners[corner]};
  Vec<3> left;
  if (wall.loop || corner > 0)
    left += level_left((here - Vec<3>{wall.corners[(corner + corners - 1) % corners]}).at);
  if (wall.loop || corner + 1 < corners)
    left += level_left((Vec<3>{wall.corners[(corner + 1) % corners]} - here).at);
  return left;
}

// 1 on the left of the wall and on it, -1 on the right. Beyond a sharp corner one piece alone can't tell.
float side_of(const Polyline& wall, const OnPolyline& nearest, const Vec<3>& place) {
  const std::size_t next = (nearest.piece + 1) % wall.corners.size();
  const float size = length(Vec<3>{wall.corners[next]} - Vec<3>{wall.corners[nearest.piece]});
  Vec<3> left = level_left(nearest.along);
  if (nearest.into_piece >= size) left = left_at_corner(wall, next);
  if (!(nearest.into_piece > 0)) left = left_at_corner(wall, nearest.piece);
  return dot(place - Vec<3>{nearest.at}, left) < 0 ? -1.0f : 1.0f;
}

Vec<3> levelled(const Vec<3>& v) {
  return {{v[0], v[1], 0}};
}

}  // namespace

Vector follow_wall(const Polyline& wall, float distance, float radius, float ahead, float time,
                   const Vector& position, const Vector& velocity, float max_speed) {
  const Vec<3> here = levelled(Vec<3>{position});
  const Vec<3> predicted = levelled(Vec<3>{position} + Vec<3>{velocity} * time);
  const OnPolyline nearest = nearest_on(wall, predicted.at);
  if (nearest.along == Vector{}) return {};
  const float side = side_of(wall, nearest_on(wall, here.at), here);
  const float gap = nearest.distance * side_of(wall, nearest, predicted) * side;
  if (!(std::abs(gap - distance) > radius)) return {};
  const OnPolyline sought = further_on(wall, nearest, ahead);
  const Vec<3> place = Vec<3>{sought.at} + level_left(sought.along) * (side * distance);
  return seek((place - here).at, velocity, max_speed);
}

template <int D>
Vec<D> wall_following(const LineModel& model, const Wrapping& image, const Self<D>& self, float max_speed) {
  const Polyline wall{model.corners, model.is_loop};
  const Vector level = levelled(Vec<3>{widened(self.position)}).at;
  const Vector position = nearest_image<2>(wall, level, image);
  return narrow_to<D>(follow_wall(wall, model.distance, model.radius, model.ahead, model.time, position,
                                  widened(self.velocity), max_speed));
}

template Vec<2> wall_following<2>(const LineModel&, const Wrapping&, const Self<2>&, float);
template Vec<3> wall_following<3>(const LineModel&, const Wrapping&, const Self<3>&, float);

}  // namespace sturnus
