// Turns each item of a draw list into shapes, in drawing order.
#include "draw/draw.h"

#include <algorithm>
#include <cmath>

#include "draw/facets.h"
#include "draw/glyphs.h"
#include "draw/light.h"
#include "draw/raster.h"

namespace sturnus {
namespace {

// What all items need on their way to the canvas.
struct Drawing {
  const Projection& projection;
  const Theme& theme;
  Size size;
  Canvas& canvas;
};

float nearness_of(const Projected& at, Layer layer) {
  return layer == Layer::above || !(at.depth > 0) ? on_top : 1.0f / at.depth;
}

void add_segment(const Drawing& d, const Segment& segment) {
  Vec<3> from = segment.from;
  Vec<3> to = segment.to;
  if (!d.projection.clip(from, to)) return;
  const Projected a = d.projection.project(from);
  const Projected b = d.projection.project(to);
  if (!a.in_front || !b.in_front) return;
  const float opacity = static_cast<float>(segment.colour.a) / 255.0f;
  const float middle_depth = 0.5f * (a.depth + b.depth);
  d.canvas.add(LineShape{{a.x, a.y, nearness_of(a, segment.layer)},
                         {b.x, b.y, nearness_of(b, segment.layer)},
                         segment.width,
                         segment.layer == Layer::above
                             ? segment.colour
                             : sunk(segment.colour, middle_depth, d.projection, d.theme),
                         std::clamp(segment.alpha_from, 0.0f, 1.0f) * opacity,
                         std::clamp(segment.alpha_to, 0.0f, 1.0f) * opacity});
}

void add_ring(const Drawing& d, const Ring& ring) {
  const Projected at = d.projection.project(ring.centre);
  if (!at.in_front) return;
  // The width lies half inside and half outside, so that the radius is the middle of the line.
  const float radius = ring.radius * at.scale;
  const float half = 0.5f * ring.width;
  const float hole = ring.width > 0 ? std::max(0.0f, radius - half) : -1.0f;
  const Rgba colour =
      ring.layer == Layer::above ? ring.colour : sunk(ring.colour, at.depth, d.projection, d.theme);
  d.canvas.add(DiscShape{{at.x, at.y, nearness_of(at, ring.layer)}, radius + half, hole, colour});
}

void add_flat_box(const Drawing& d, const Box& box) {
  const Projected low = d.projection.project(box.low);
  const Projected high = d.projection.project(box.high);
  if (!low.in_front || !high.in_front) return;
  // Cut well outside the picture: the rasteriser leaves out what is too large for it.
  const float far_x = static_cast<float>(d.size.width) + 100;
  const float far_y = static_cast<float>(d.size.height) + 100;
  const float left = std::clamp(low.x, -100.0f, far_x);
  const float right = std::clamp(high.x, -100.0f, far_x);
  const float top = std::clamp(high.y, -100.0f, far_y);
  const float bottom = std::clamp(low.y, -100.0f, far_y);
  if (box.fill.a > 0) d.canvas.add(BarShape{left, top, right, bottom, 0, box.fill});
  if (!(box.width > 0)) return;
  d.canvas.line(left, bottom, right, bottom, box.width, box.colour);
  d.canvas.line(right, bottom, right, top, box.width, box.colour);
  d.canvas.line(right, top, left, top, box.width, box.colour);
  d.canvas.line(left, top, left, bottom, box.width, box.colour);
}

// An edge in many pieces, because each takes the colour of its depth.
void add_edge(const Drawing& d, const Box& box, const Vec<3>& from, const Vec<3>& to) {
  constexpr int pieces = 16;
  for (int i = 0; i < pieces; ++i) {
    Segment segment;
    segment.from = from + (to - from) * (static_cast<float>(i) / pieces);
    segment.to = from + (to - from) * (static_cast<float>(i + 1) / pieces);
    segment.colour = box.colour;
    segment.width = box.width;
    add_segment(d, segment);
  }
}

void add_box(const Drawing& d, const Box& box) {
  if (!d.projection.in_space()) return add_flat_box(d, box);
  if (!(box.width > 0)) return;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    for (int side = 0; side < 4; ++side) {
      Vec<3> from = box.low;
      from[second] = (side & 1) != 0 ? box.high[second] : box.low[second];
      from[third] = (side & 2) != 0 ? box.high[third] : box.low[third];
      Vec<3> to = from;
      to[axis] = box.high[axis];
      add_edge(d, box, from, to);
    }
  }
}

void add_arrow(const Drawing& d, const Arrow& arrow) {
  Vec<3> from = arrow.from;
  Vec<3> to = arrow.to;
  if (!d.projection.clip(from, to)) return;
  const Projected a = d.projection.project(from);
  const Projected b = d.projection.project(to);
  const float dx = b.x - a.x;
  const float dy = b.y - a.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  if (!a.in_front || !b.in_front || !(length > 0)) return;
  // A short arrow shrinks its head before it loses it.
  const float head = std::min(4.5f * arrow.width, length);
  const float ux = dx / length;
  const float uy = dy / length;
  d.canvas.line(a.x, a.y, b.x - ux * head * 0.8f, b.y - uy * head * 0.8f, arrow.width, arrow.colour);
  DartShape tip;
  tip.at = {b.x, b.y, on_top};
  tip.forward_x = ux;
  tip.forward_y = uy;
  tip.nose = 0;
  tip.tail = head;
  tip.notch = 0.8f * head;
  tip.half_width = 0.45f * head;
  tip.colour = arrow.colour;
  d.canvas.add(tip);
}

void add_label(const Drawing& d, const Label& label) {
  float x = label.position[0] * static_cast<float>(d.size.width);
  float y = label.position[1] * static_cast<float>(d.size.height);
  if (!label.on_screen) {
    const Projected at = d.projection.project(label.position);
    if (!at.in_front) return;
    x = at.x;
    y = at.y;
  }
  x += label.offset_x;
  y += label.offset_y;
  if (label.plate && has_font() && !label.text.empty()) {
    const float width = text_width(label.text, label.size);
    const float left = label.align == Align::left    ? x
                       : label.align == Align::right ? x - width
                                                     : x - 0.5f * width;
    const float tall = 0.78f * label.size;
    d.canvas.add(
        BarShape{left - 8, y - tall, left + width + 8, y + tall, 6, with_alpha(d.theme.background, 0.72f)});
  }
  d.canvas.text(label.text, x, y, label.size, label.colour, label.align);
}

void add_layer(const Drawing& d, const DrawList& list, Layer layer) {
  for (const Segment& segment : list.segments) {
    if (segment.layer == layer) add_segment(d, segment);
  }
  for (const Ring& ring : list.rings) {
    if (ring.layer == layer) add_ring(d, ring);
  }
}

void add_glyphs(const Drawing& d, const DrawList& list) {
  for (const Facet& facet : list.facets) add_facet(facet, d.projection, d.theme, d.canvas);
  for (const Glyph& glyph : list.glyphs) add_glyph(glyph, d.projection, d.theme, d.canvas);
}

}  // namespace

Image draw(const DrawList& list, const Viewpoint& viewpoint, const Theme& theme, Size size,
           const Workers& workers, int supersampling) {
  const Projection projection(viewpoint, size);
  Canvas canvas;
  const Drawing d{projection, theme, size, canvas};
  const bool in_space = projection.in_space();
  canvas.reserve(list.glyphs.size() * (in_space ? 4 : 1) + list.facets.size() + list.segments.size() + 1024);
  if (in_space) {
    canvas.use_depth();
    // Lines do not hide, so in space they come after what hides them.
    add_glyphs(d, list);
  }
  for (const Box& box : list.boxes) add_box(d, box);
  add_layer(d, list, Layer::below);
  if (!in_space) add_glyphs(d, list);
  add_layer(d, list, Layer::above);
  for (const Arrow& arrow : list.arrows) add_arrow(d, arrow);
  for (const Label& label : list.labels) add_label(d, label);
  if (supersampling <= 0) supersampling = in_space ? 3 : 2;
  return paint(canvas, size, theme.background, supersampling, workers);
}

}  // namespace sturnus
