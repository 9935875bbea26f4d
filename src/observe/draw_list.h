// What is to be drawn, as plain data in world coordinates, for whoever draws it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"
#include "sturnus/colour.h"

namespace sturnus {

/// The form of one glyph. Flat pictures draw a cone as a dart and a ball as a circle; pictures of space draw
/// a dart or a triangle as a cone.
enum class GlyphKind : std::uint8_t {
  dart,      ///< arrowhead with a notched tail, along the heading
  triangle,  ///< the same with a straight tail
  circle,    ///< filled, always facing the viewer
  cone,      ///< four flat-shaded triangles along the heading, open at the base
  ball,      ///< shaded sphere
};

/// Whether something lies below or above the glyphs. In space, what lies above is never hidden.
enum class Layer : std::uint8_t { below, above };

/// One unit, predator, piece of food or obstacle.
struct Glyph {
  Vec<3> position;  ///< world; z = 0 in the plane
  Vec<3> heading;   ///< any length; a glyph without a heading is drawn as a circle or a ball
  /// World length: nose to tail of a dart or triangle, diameter of a circle or ball. For a cone it scales the
  /// model, which is half as long as this and 0.4 of it wide.
  float size = 1;
  Rgba colour;
  GlyphKind kind = GlyphKind::dart;
};

/// A flat-shaded triangle, seen and lit from both sides.
struct Facet {
  std::array<Vec<3>, 3> corners;  ///< world
  Rgba colour;                    ///< in full light
};

/// A straight line whose opacity may change along the way, such as a piece of a trail.
struct Segment {
  Vec<3> from;  ///< world
  Vec<3> to;    ///< world
  Rgba colour;
  float width = 1.5f;    ///< pixels
  float alpha_from = 1;  ///< 0 to 1, times the colour's own opacity
  float alpha_to = 1;    ///< 0 to 1, times the colour's own opacity
  Layer layer = Layer::below;
};

/// A line with a head at `to`, drawn above the glyphs: forces and velocities.
struct Arrow {
  Vec<3> from;  ///< world
  Vec<3> to;    ///< world
  Rgba colour;
  float width = 2;  ///< pixels; the head is four times as wide
};

/// A circle around a place; in space, the outline of a sphere.
struct Ring {
  Vec<3> centre;     ///< world
  float radius = 1;  ///< world
  Rgba colour;
  float width = 1.5f;  ///< pixels; 0 fills the circle
  Layer layer = Layer::below;
};

/// A rectangle, or in space a box of twelve edges: the world's outline, or a cell of the index.
struct Box {
  Vec<3> low;   ///< world, the corner with the smallest coordinates
  Vec<3> high;  ///< world, the corner with the largest coordinates
  Rgba colour;
  float width = 1.5f;     ///< pixels; 0 draws no edges
  Rgba fill{0, 0, 0, 0};  ///< flat pictures only; transparent unless told
};

/// Which end of the text stands at its place.
enum class Align : std::uint8_t { left, centre, right };

/// A line of text, above everything else.
struct Label {
  std::string text;  ///< UTF-8, one line
  /// World coordinates; or, with `on_screen`, fractions of the picture: x from its left edge, y from its top.
  Vec<3> position;
  bool on_screen = false;
  float offset_x = 0;  ///< pixels to the right of the place
  float offset_y = 0;  ///< pixels below the place
  float size = 13;     ///< pixels from the top of the tallest letter to the bottom of the lowest
  Rgba colour;
  Align align = Align::left;
  bool plate = false;  ///< a faint plate in the background's colour behind it, for crowded pictures
};

/// Everything in one picture. Drawn in this order: boxes; segments and rings below; facets; glyphs; segments
/// and rings above; arrows; labels. Within one list, later items cover earlier ones, except where depth
/// decides.
struct DrawList {
  std::vector<Box> boxes;
  std::vector<Segment> segments;
  std::vector<Ring> rings;
  std::vector<Facet> facets;
  std::vector<Glyph> glyphs;
  std::vector<Arrow> arrows;
  std::vector<Label> labels;

  /// Empties the lists and keeps their memory, for the next frame.
  void clear() {
    boxes.clear();
    segments.clear();
    rings.clear();
    facets.clear();
    glyphs.clear();
    arrows.clear();
    labels.clear();
  }
};

}  // namespace sturnus
