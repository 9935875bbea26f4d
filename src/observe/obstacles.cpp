// Obstacles as items of a draw list.
#include "observe/obstacles.h"

#include <algorithm>
#include <cmath>

namespace sturnus {
namespace {

constexpr float fill_alpha = 0.45f;  // flat obstacles let the ground shine through, their rims don't

// The space, and who draws in it.
struct Ground {
  Extent extent;
  int dimensions;
  Rgba colour;
  DrawList& list;

  float low(int axis) const { return static_cast<float>(extent.min[static_cast<std::size_t>(axis)]); }
  float high(int axis) const { return static_cast<float>(extent.max[static_cast<std::size_t>(axis)]); }
};

void add_sphere(const Ground& ground, const Vec<3>& centre, float radius) {
  if (ground.dimensions == 3) {
    ground.list.glyphs.push_back({centre, {}, 2 * radius, ground.colour, GlyphKind::ball});
    return;
  }
  ground.list.rings.push_back({centre, radius, with_alpha(ground.colour, fill_alpha), 0, Layer::below});
  ground.list.rings.push_back({centre, radius, ground.colour, 1.5f, Layer::below});
}

// A face of a box: the rectangle about a middle, spanned by two axes.
void add_face(const Ground& ground, const Vec<3>& middle, const Vec<3>& half, int axis) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::array<Vec<3>, 4> corners{middle, middle, middle, middle};
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i][u] += i == 1 || i == 2 ? half[u] : -half[u];
    corners[i][v] += i >= 2 ? half[v] : -half[v];
  }
  ground.list.facets.push_back({{corners[0], corners[1], corners[2]}, ground.colour});
  ground.list.facets.push_back({{corners[0], corners[2], corners[3]}, ground.colour});
}

void add_box(const Ground& ground, const Vec<3>& centre, const Vec<3>& half) {
  if (ground.dimensions == 2) {
    ground.list.boxes.push_back(
        {centre - half, centre + half, ground.colour, 1.5f, with_alpha(ground.colour, fill_alpha)});
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    Vec<3> out;
    out[axis] = half[axis];
    add_face(ground, centre + out, half, axis);
    add_face(ground, centre - out, half, axis);
  }
}

// Where an edge of the space crosses a plane.
void cross_edge(const Vec<3>& from, const Vec<3>& to, const Obstacle& plane, std::vector<Vec<3>>& corners) {
  const Vec<3> normal{plane.normal};
  const float a = dot(from - Vec<3>{plane.at}, normal);
  const float b = dot(to - Vec<3>{plane.at}, normal);
  if ((a >= 0) != (b >= 0)) corners.push_back(from + (to - from) * (a / (a - b)));
}

std::vector<Vec<3>> crossings(const Ground& ground, const Obstacle& plane) {
  std::vector<Vec<3>> corners;
  const int axes = ground.dimensions;
  for (int along = 0; along < axes; ++along) {
    for (int side = 0; side < 1 << (axes - 1); ++side) {
      Vec<3> from;
      for (int k = 1; k < axes; ++k) {
        const int axis = (along + k) % axes;
        from[axis] = (side >> (k - 1) & 1) != 0 ? ground.high(axis) : ground.low(axis);
      }
      Vec<3> to = from;
      from[along] = ground.low(along);
      to[along] = ground.high(along);
      cross_edge(from, to, plane, corners);
    }
  }
  return corners;
}

// Lines between all crossings that lie on one face of the space: the outline of the plane's part inside.
void add_plane(const Ground& ground, const Obstacle& plane) {
  const std::vector<Vec<3>> corners = crossings(ground, plane);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      bool on_one_face = ground.dimensions == 2;
      for (int axis = 0; axis < ground.dimensions; ++axis) {
        const float at = corners[i][axis];
        on_one_face =
            on_one_face || (at == corners[j][axis] && (at == ground.low(axis) || at == ground.high(axis)));
      }
      if (on_one_face)
        ground.list.segments.push_back({corners[i], corners[j], ground.colour, 2.5f, 1, 1, Layer::below});
    }
  }
}

// Calls f(centre) for the obstacle and, where the space wraps, for those of its images that reach into it.
template <class F>
void for_each_image(const Ground& ground, bool wraps, const Vec<3>& at, const Vec<3>& half, F&& f) {
  std::vector<Vec<3>> images{at};
  for (int axis = 0; wraps && axis < ground.dimensions; ++axis) {
    const float size = ground.high(axis) - ground.low(axis);
    for (std::size_t i = images.size(); i-- > 0;) {
      Vec<3> image = images[i];
      if (at[axis] - half[axis] < ground.low(axis)) image[axis] += size;
      if (at[axis] + half[axis] > ground.high(axis)) image[axis] -= size;
      if (image[axis] != at[axis]) images.push_back(image);
    }
  }
  for (const Vec<3>& image : images) f(image);
}

}  // namespace

void add_obstacles(const View& view, const SceneColours& colours, DrawList& list) {
  if (view.state().obstacles.empty()) return;
  const Ground ground{extent_of(view.scenario()), view.dimensions(), colours.obstacle, list};
  const bool wraps = view.scenario().space.boundary.kind == BoundaryKind::wrap;
  for (const Obstacle& obstacle : view.state().obstacles) {
    const float radius = obstacle.radius;
    const bool is_box = obstacle.kind == ObstacleKind::box;
    const Vec<3> half = is_box ? Vec<3>{obstacle.half} : Vec<3>{{radius, radius, radius}};
    if (obstacle.kind == ObstacleKind::plane) {
      add_plane(ground, obstacle);
      continue;
    }
    for_each_image(ground, wraps, Vec<3>{obstacle.at}, half, [&](const Vec<3>& at) {
      is_box ? add_box(ground, at, half) : add_sphere(ground, at, radius);
    });
  }
}

}  // namespace sturnus
