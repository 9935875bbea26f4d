// Darts, circles, cones and balls.
#include "draw/glyphs.h"

#include <algorithm>
#include <cmath>

#include "draw/light.h"

namespace sturnus {
namespace {

Spot spot(const Projected& at) {
  return {at.x, at.y, at.depth > 0 ? 1.0f / at.depth : on_top};
}

bool has_direction(const Vec<3>& heading) {
  const float squared = dot(heading, heading);
  return squared > 0 && std::isfinite(squared);
}

void add_disc(const Glyph& glyph, const Projected& at, const Projection& projection, const Theme& theme,
              Canvas& canvas) {
  const float radius = 0.5f * std::max(smallest_glyph, glyph.size * at.scale);
  canvas.add(DiscShape{spot(at), radius, -1, sunk(glyph.colour, at.depth, projection, theme)});
}

void add_dart(const Glyph& glyph, const Projected& at, Canvas& canvas) {
  const float flat = std::sqrt(glyph.heading[0] * glyph.heading[0] + glyph.heading[1] * glyph.heading[1]);
  const float length = std::max(smallest_glyph, glyph.size * at.scale);
  DartShape dart;
  dart.at = {at.x, at.y, on_top};
  dart.forward_x = glyph.heading[0] / flat;
  dart.forward_y = -glyph.heading[1] / flat;  // the picture's y points down
  dart.nose = 0.56f * length;
  dart.tail = 0.44f * length;
  dart.notch = glyph.kind == GlyphKind::triangle ? dart.tail : 0.22f * length;
  dart.half_width = (glyph.kind == GlyphKind::triangle ? 0.28f : 0.34f) * length;
  dart.colour = glyph.colour;
  canvas.add(dart);
}

void add_cone(const Glyph& glyph, const Projected& at, const Projection& projection, const Theme& theme,
              Canvas& canvas) {
  // The model is half as long as its size.
  const float size = std::max(glyph.size, 2.0f * smallest_glyph / at.scale);
  const Cone cone = cone_along(glyph.heading);
  const Projected nose = projection.project(glyph.position + cone.nose * size);
  Projected base[5];
  bool visible = nose.in_front;
  for (int i = 0; i < 5; ++i) {
    base[i] = projection.project(glyph.position + cone.base[i] * size);
    visible = visible && base[i].in_front;
  }
  if (!visible) return;
  const Vec<3> light = towards_light(projection);
  const Vec<3> to_eye = projection.eye() - glyph.position;
  for (int i = 0; i < 4; ++i) {
    // The base is open: the inside may show.
    const Rgba lit =
        lit_face(glyph.colour, cone.base[i] - cone.nose, cone.base[i + 1] - cone.nose, to_eye, light);
    const Rgba colour = sunk(lit, at.depth, projection, theme);
    canvas.add(TriangleShape{{spot(nose), spot(base[i]), spot(base[i + 1])}, colour});
  }
}

void add_ball(const Glyph& glyph, const Projected& at, const Projection& projection, const Theme& theme,
              Canvas& canvas) {
  BallShape ball;
  ball.at = spot(at);
  ball.radius = 0.5f * std::max(smallest_glyph, glyph.size * at.scale);
  ball.depth_radius = 0.5f * glyph.size;
  ball.colour = sunk(glyph.colour, at.depth, projection, theme);
  ball.shadow = sunk(shaded(glyph.colour, 0), at.depth, projection, theme);
  canvas.add(ball);
}

}  // namespace

Cone cone_along(const Vec<3>& heading) {
  const Basis basis = basis_along(heading);
  const Vec<3> u = basis.u * 0.2f;
  const Vec<3> v = basis.v * 0.2f;
  return {basis.w * 0.5f, {u, v, u * -1.0f, v * -1.0f, u}};
}

void add_glyph(const Glyph& glyph, const Projection& projection, const Theme& theme, Canvas& canvas) {
  const Projected at = projection.project(glyph.position);
  if (!at.in_front) return;
  const bool is_round = glyph.kind == GlyphKind::circle || glyph.kind == GlyphKind::ball;
  if (projection.in_space()) {
    if (glyph.kind == GlyphKind::circle) return add_disc(glyph, at, projection, theme, canvas);
    if (is_round || !has_direction(glyph.heading)) return add_ball(glyph, at, projection, theme, canvas);
    return add_cone(glyph, at, projection, theme, canvas);
  }
  const Vec<3> flat_heading{{glyph.heading[0], glyph.heading[1], 0}};
  if (is_round || !has_direction(flat_heading)) return add_disc(glyph, at, projection, theme, canvas);
  add_dart(glyph, at, canvas);
}

}  // namespace sturnus
