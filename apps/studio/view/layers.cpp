// A frame's scenery as lines, sprites and triangles.
#include "view/scenery.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

using sturnus::Rgba;
using sturnus::with_alpha;

struct Corners {
  Point low{}, high{};
};

Corners corners_of(const sturnus::Extent& extent) {
  Corners out;
  for (std::size_t axis = 0; axis < extent.min.size() && axis < 3; ++axis) {
    out.low[axis] = static_cast<float>(extent.min[axis]);
    out.high[axis] = static_cast<float>(extent.max[axis]);
  }
  return out;
}

void add_box(const Point& low, const Point& high, int dimensions, Rgba colour, float width,
             std::vector<Line>& out) {
  const auto axes = static_cast<std::size_t>(dimensions);
  // In space an edge is cut up, because each piece takes the colour of its depth.
  const int pieces = dimensions == 3 ? 8 : 1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (int side = 0; side < (dimensions == 3 ? 4 : 2); ++side) {
      Point start = low;
      if ((side & 1) != 0) start[(axis + 1) % axes] = high[(axis + 1) % axes];
      if ((side & 2) != 0) start[(axis + 2) % axes] = high[(axis + 2) % axes];
      const float step = (high[axis] - low[axis]) / static_cast<float>(pieces);
      for (int piece = 0; piece < pieces; ++piece) {
        Point from = start;
        from[axis] += step * static_cast<float>(piece);
        Point to = from;
        to[axis] += step;
        out.push_back({from, width, to, colour});
      }
    }
  }
}

void add_rectangle(const Point& low, const Point& high, Rgba colour, std::vector<ShapeCorner>& out) {
  const Point right{high[0], low[1], low[2]}, left{low[0], high[1], low[2]};
  for (const Point& at : {low, right, high, low, high, left}) out.push_back({at, colour});
}

// A face of a box: two triangles from a corner along two edges.
void add_face(const Point& from, const Point& u, const Point& v, Rgba colour, std::vector<ShapeCorner>& out) {
  for (const Point& at : {from, from + u, from + u + v, from, from + u + v, from + v})
    out.push_back({at, colour});
}

void add_block(const Point& low, const Point& high, Rgba colour, std::vector<ShapeCorner>& out) {
  const Point size = high - low;
  const Point x{size[0], 0, 0}, y{0, size[1], 0}, z{0, 0, size[2]};
  for (const Point& corner : {low, high}) {
    const float sign = corner == low ? 1.0f : -1.0f;
    add_face(corner, x * sign, y * sign, colour, out);
    add_face(corner, y * sign, z * sign, colour, out);
    add_face(corner, z * sign, x * sign, colour, out);
  }
}

// About ten lines along the longer side, at a round distance.
float grid_step(const Corners& space) {
  const Point size = space.high - space.low;
  const float rough = std::max({size[0], size[1], size[2], 1e-6f}) / 10;
  const float ten = std::pow(10.0f, std::floor(std::log10(rough)));
  for (const float by : {1.0f, 2.0f, 5.0f}) {
    if (rough <= by * ten) return by * ten;
  }
  return 10 * ten;
}

// In the plane all over it, in space on the floor.
void add_grid(const Corners& space, int dimensions, Rgba colour, std::vector<Line>& out) {
  const std::size_t second = dimensions == 2 ? 1 : 2;
  const float step = grid_step(space);
  for (const auto& [axis, other] : {std::pair<std::size_t, std::size_t>{0, second}, {second, 0}}) {
    for (float at = std::ceil(space.low[axis] / step) * step; at <= space.high[axis]; at += step) {
      Point from = space.low, to = space.low;
      from[axis] = to[axis] = at;
      to[other] = space.high[other];
      out.push_back({from, 1, to, colour});
    }
  }
}

bool has_no_side(const sturnus::Obstacle& plane) {
  return plane.normal[0] == 0 && plane.normal[1] == 0 && plane.normal[2] == 0;
}

// The part of the space's rectangle that lies behind a line: what is cut off goes corner by corner.
std::vector<Point> behind(const sturnus::Obstacle& plane, const std::vector<Point>& around) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point& a = around[i];
    const Point& b = around[(i + 1) % around.size()];
    const float of_a = dot(a - plane.at, plane.normal), of_b = dot(b - plane.at, plane.normal);
    if (of_a <= 0) out.push_back(a);
    if ((of_a < 0) != (of_b < 0) && of_a != of_b) out.push_back(a + (b - a) * (of_a / (of_a - of_b)));
  }
  return out;
}

void add_flat_plane(const sturnus::Obstacle& plane, const Corners& space, Rgba colour, Layer& out) {
  const Point& low = space.low;
  const Point& high = space.high;
  const auto solid = behind(plane, {low, {high[0], low[1], 0}, high, {low[0], high[1], 0}});
  for (std::size_t i = 2; i < solid.size(); ++i) {
    for (const Point& at : {solid[0], solid[i - 1], solid[i]})
      out.solids.push_back({at, with_alpha(colour, 0.3f)});
  }
  const Point along{-plane.normal[1], plane.normal[0], 0};
  const float reach = length(high - low);
  out.lines.push_back({plane.at - along * reach, 1.5f, plane.at + along * reach, colour});
}

// A lattice on the plane, as large as the space.
void add_lattice(const sturnus::Obstacle& plane, const Corners& space, Rgba colour, std::vector<Line>& out) {
  const Point any = std::abs(plane.normal[1]) < 0.9f ? Point{0, 1, 0} : Point{1, 0, 0};
  const Point u = unit(cross(any, plane.normal)), v = cross(plane.normal, u);
  const Point middle = (space.low + space.high) * 0.5f;
  const Point foot = middle - plane.normal * dot(middle - plane.at, plane.normal);
  const float reach = 0.5f * length(space.high - space.low) * 0.7f;
  constexpr int lines = 12, pieces = 6;
  for (int i = 0; i <= lines; ++i) {
    const float aside = reach * (2.0f * static_cast<float>(i) / lines - 1);
    for (int piece = 0; piece < pieces; ++piece) {
      const float from = reach * (2.0f * static_cast<float>(piece) / pieces - 1);
      const float to = from + 2 * reach / pieces;
      out.push_back({foot + u * aside + v * from, 1, foot + u * aside + v * to, colour});
      out.push_back({foot + v * aside + u * from, 1, foot + v * aside + u * to, colour});
    }
  }
}

void add_obstacle(const sturnus::Obstacle& obstacle, const Corners& space, int dimensions, Rgba colour,
                  Layer& out) {
  const bool is_flat = dimensions == 2;
  if (obstacle.kind == sturnus::ObstacleKind::sphere) {
    out.sprites.push_back(
        {obstacle.at, obstacle.radius, is_flat ? with_alpha(colour, 0.45f) : colour, 0, 0, Sprite::ball});
    if (is_flat) out.sprites.push_back({obstacle.at, obstacle.radius, colour, 1.5f, 0, 0});
    return;
  }
  if (obstacle.kind == sturnus::ObstacleKind::box) {
    const Point low = obstacle.at - obstacle.half, high = obstacle.at + obstacle.half;
    if (!is_flat) return add_block(low, high, colour, out.solids);
    add_rectangle(low, high, with_alpha(colour, 0.45f), out.solids);
    return add_box(low, high, 2, colour, 1.5f, out.lines);
  }
  if (has_no_side(obstacle)) return;
  if (is_flat) return add_flat_plane(obstacle, space, colour, out);
  add_lattice(obstacle, space, with_alpha(colour, 0.55f), out.lines);
}

void add_pointer(const Frame& frame, const Colours& colours, Layer& out) {
  if (!frame.pointer.pressed) return;
  const Rgba colour = frame.pointer.mode == sturnus::PointerMode::attract ? colours.attracts : colours.repels;
  out.sprites.push_back({frame.pointer.at, 0, with_alpha(colour, 0.25f), 0, 16, Sprite::bright});
  out.sprites.push_back({frame.pointer.at, 0, colour, 2, 16, Sprite::bright});
}

}  // namespace

void add_ground(const Frame& frame, const Colours& colours, const ViewOptions& options, Layer& out) {
  const Corners space = corners_of(frame.extent);
  const bool is_flat = frame.dimensions == 2;
  if (is_flat && (options.outline || options.grid))
    add_rectangle(space.low, space.high, colours.surface, out.solids);
  if (options.grid)
    add_grid(space, frame.dimensions, is_flat ? colours.grid : with_alpha(colours.outline, 0.6f), out.lines);
  if (options.index) {
    for (const auto& box : frame.index_boxes)
      add_box(box[0], box[1], frame.dimensions, with_alpha(colours.outline, is_flat ? 1.0f : 0.5f), 1,
              out.lines);
  }
  if (options.outline || options.grid)
    add_box(space.low, space.high, frame.dimensions, colours.edge, 1.5f, out.lines);
}

void add_obstacles(const Frame& frame, const Colours& colours, Layer& out) {
  const Corners space = corners_of(frame.extent);
  for (const sturnus::Obstacle& obstacle : frame.obstacles)
    add_obstacle(obstacle, space, frame.dimensions, colours.obstacle, out);
}

void add_food(const Frame& frame, const Colours& colours, Layer& out) {
  for (const Piece& piece : frame.food) {
    const auto& kinds = frame.scenario->food;
    const auto own = piece.kind < kinds.size() ? colour_of_hex(kinds[piece.kind].colour) : std::nullopt;
    out.sprites.push_back({{piece.position[0], piece.position[1], piece.position[2]},
                           0.5f * piece.size,
                           own.value_or(colours.food),
                           0,
                           1.5f,
                           Sprite::ball});
  }
}

void add_targets(const Frame& frame, const Colours& colours, const ViewOptions& options, Layer& out) {
  const float size =
      frame.scenario->flocks.empty() ? 5 : static_cast<float>(frame.scenario->flocks.front().size);
  for (const TargetPlace& target : frame.targets) {
    const Rgba colour = target.repels ? colours.repels : colours.attracts;
    if (options.reaches && std::isfinite(target.radius) && target.radius > 0)
      out.sprites.push_back({target.at, target.radius, with_alpha(colour, 0.35f), 1, 0, 0});
    out.sprites.push_back({target.at, 0.45f * size, colour, 0, 3, Sprite::bright});
    out.sprites.push_back({target.at, 0.95f * size, colour, 1.5f, 7, Sprite::bright});
  }
  add_pointer(frame, colours, out);
}

}  // namespace studio
