// Flat-shaded triangles, cut where the rasteriser could not follow them.
#include "draw/facets.h"

#include <cmath>

#include "draw/light.h"

namespace sturnus {
namespace {

// Pixels from the middle of the picture. What reaches farther is cut there, because the rasteriser leaves out
// shapes with larger coordinates; pictures end well before.
constexpr float widest = 30000.0f;

// A triangle that five planes have cut has at most eight corners. Rounding may add a few where it is next to
// nothing; those without a place would not be seen.
struct Polygon {
  std::array<Vec<3>, 12> at;
  std::size_t count = 0;

  void add(const Vec<3>& corner) {
    if (count < at.size()) at[count++] = corner;
  }
};

// What lies where dot(p - eye, normal) is at least `least`.
struct HalfSpace {
  Vec<3> normal;
  float least = 0;
};

Polygon cut(const Polygon& polygon, const HalfSpace& half, const Vec<3>& eye) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec<3>& a = polygon.at[i];
    const Vec<3>& b = polygon.at[(i + 1) % polygon.count];
    const float from = dot(a - eye, half.normal) - half.least;
    const float to = dot(b - eye, half.normal) - half.least;
    if (from >= 0) kept.add(a);
    if ((from >= 0) != (to >= 0)) kept.add(a + (b - a) * (from / (from - to)));
  }
  return kept;
}

Polygon visible_part(const Facet& facet, const Projection& projection) {
  Polygon polygon{{facet.corners[0], facet.corners[1], facet.corners[2]}, 3};
  if (!projection.in_space()) return polygon;
  const Vec<3> ahead = projection.forward() * (widest / projection.pixels_per_slope());
  const HalfSpace halves[] = {{projection.forward(), projection.nearest()},
                              {ahead + projection.right()},
                              {ahead - projection.right()},
                              {ahead + projection.up()},
                              {ahead - projection.up()}};
  for (const HalfSpace& half : halves) {
    polygon = cut(polygon, half, projection.eye());
    if (polygon.count == 0) break;
  }
  return polygon;
}

bool is_finite(const Facet& facet) {
  for (const Vec<3>& corner : facet.corners) {
    for (const float value : corner.at) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

Spot spot(const Projected& at) {
  return {at.x, at.y, at.depth > 0 ? 1.0f / at.depth : on_top};
}

}  // namespace

void add_facet(const Facet& facet, const Projection& projection, const Theme& theme, Canvas& canvas) {
  if (!is_finite(facet)) return;
  const Polygon polygon = visible_part(facet, projection);
  if (polygon.count < 3) return;
  const auto& [a, b, c] = facet.corners;
  const Vec<3> to_eye = projection.in_space() ? projection.eye() - a : projection.forward() * -1.0f;
  const Rgba lit = lit_face(facet.colour, b - a, c - a, to_eye, towards_light(projection));
  const Vec<3> middle = (a + b + c) * (1.0f / 3.0f);
  const Rgba colour = sunk(lit, dot(middle - projection.eye(), projection.forward()), projection, theme);
  const Projected first = projection.project(polygon.at[0]);
  Projected last = projection.project(polygon.at[1]);
  for (std::size_t i = 2; i < polygon.count; ++i) {
    const Projected next = projection.project(polygon.at[i]);
    if (first.in_front && last.in_front && next.in_front) {
      canvas.add(TriangleShape{{spot(first), spot(last), spot(next)}, colour});
    }
    last = next;
  }
}

}  // namespace sturnus
