// The public way to draw triangles: turned into a draw list and drawn like any other.
#include <sturnus/triangles.h>

#include <algorithm>
#include <cmath>

#include "draw/draw.h"

namespace sturnus {
namespace {

Vec<3> vec(const Point3& point) {
  return {point};
}

Viewpoint viewpoint_of(const SpaceCamera& camera) {
  Viewpoint viewpoint = look_at(vec(camera.eye), vec(camera.target), vec(camera.up), camera.field_of_view);
  viewpoint.fade_from = camera.fade_from;
  viewpoint.fade_to = camera.fade_to;
  return viewpoint;
}

DrawList list_of(const std::vector<Triangle>& triangles, const std::vector<Line3>& lines) {
  DrawList list;
  list.facets.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners;
    list.facets.push_back({{vec(a), vec(b), vec(c)}, triangle.colour});
  }
  for (const Line3& line : lines) {
    Segment segment;
    segment.from = vec(line.from);
    segment.to = vec(line.to);
    segment.colour = line.colour;
    segment.width = line.width;
    list.segments.push_back(segment);
  }
  return list;
}

}  // namespace

Image draw_triangles(const std::vector<Triangle>& triangles, const std::vector<Line3>& lines,
                     const SpaceCamera& camera, const PictureOptions& options, int threads) {
  return draw(list_of(triangles, lines), viewpoint_of(camera), theme(options.theme), options.size,
              Workers(threads), options.supersampling);
}

Point3 direction_through(const SpaceCamera& camera, Size size, float x, float y) {
  const Projection projection(viewpoint_of(camera), size);
  const float right = (x - 0.5f * static_cast<float>(size.width)) / projection.pixels_per_slope();
  const float down = (y - 0.5f * static_cast<float>(size.height)) / projection.pixels_per_slope();
  return (projection.forward() + projection.right() * right - projection.up() * down).at;
}

std::optional<Frame3> frame_along(const Point3& direction) {
  // Scaled first, so that squares of the tiniest and largest components neither vanish nor overflow.
  const float largest = std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
  if (!(largest > 0)) return {};
  Vec<3> scaled;
  for (int axis = 0; axis < 3; ++axis) {
    const float component = direction[static_cast<std::size_t>(axis)];
    if (!std::isfinite(component)) return {};
    scaled[axis] = component / largest;
  }
  const Basis basis = basis_along(scaled);
  return Frame3{basis.u.at, basis.v.at, basis.w.at};
}

}  // namespace sturnus
