// A list of shapes in pixel coordinates, recorded first and painted at once (see raster.h).
#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "draw/font.h"
#include "observe/draw_list.h"
#include "sturnus/picture.h"

namespace sturnus {

/// Nearness that nothing hides.
inline constexpr float on_top = 1e30f;

/// A place in the picture: pixels from its top left corner, and one over the distance from the viewer.
struct Spot {
  float x = 0;
  float y = 0;
  float nearness = on_top;
};

/// Hides what is farther; its edges are cut sample by sample, so neighbours that share an edge leave no gap.
struct TriangleShape {
  std::array<Spot, 3> at;
  Rgba colour;
};

/// A shaded sphere that hides what is farther.
struct BallShape {
  Spot at;
  float radius = 1;        ///< pixels
  float depth_radius = 0;  ///< the same in the unit of 1 / nearness
  Rgba colour;             ///< in full light
  Rgba shadow;             ///< in none
};

/// An arrowhead in the plane of the picture, with its own smooth edges.
struct DartShape {
  Spot at;
  float forward_x = 1;  ///< unit vector towards the nose, pixels
  float forward_y = 0;
  float nose = 4;        ///< from `at` to the nose, pixels
  float tail = 4;        ///< from `at` back to the wing tips, pixels
  float notch = 2;       ///< from `at` back to the notch, pixels; equal to tail for a straight one
  float half_width = 2;  ///< pixels
  Rgba colour;
};

/// A filled circle, or a ring of some width inside `radius`.
struct DiscShape {
  Spot at;
  float radius = 1;  ///< pixels
  float hole = -1;   ///< radius of the hole, pixels; below 0 for none
  Rgba colour;
};

/// A line; opaque ones have round ends, so that corners close; transparent ones end square, so that the
/// pieces of a trail meet without a darker joint.
struct LineShape {
  Spot from, to;
  float width = 1;  ///< pixels
  Rgba colour;      ///< its opacity is not used
  float alpha_from = 1;
  float alpha_to = 1;
};

/// A filled rectangle, with round corners if wanted.
struct BarShape {
  float left = 0, top = 0, right = 0, bottom = 0;  ///< pixels
  float corner = 0;                                ///< radius of the corners, pixels
  Rgba colour;
};

using Shape = std::variant<TriangleShape, BallShape, DartShape, DiscShape, LineShape, BarShape>;

/// A line of text; text is painted after all shapes.
struct TextShape {
  TextInk ink;
  int x = 0;  ///< starting point, pixels
  int y = 0;  ///< baseline, pixels
  Rgba colour;
};

class Canvas {
 public:
  void add(const Shape& shape) { shapes_.push_back(shape); }

  /// A straight line of one colour, opacity included, that nothing hides.
  void line(float x0, float y0, float x1, float y1, float width, Rgba colour);

  /// A line of text with its left end, middle or right end at x, and the middle of its capital letters at y.
  void text(std::string_view text, float x, float y, float size, Rgba colour, Align align = Align::left);

  /// Shapes hide one another by nearness instead of by order alone.
  void use_depth() { has_depth_ = true; }

  bool has_depth() const { return has_depth_; }
  const std::vector<Shape>& shapes() const { return shapes_; }
  const std::vector<TextShape>& texts() const { return texts_; }
  void reserve(std::size_t count) { shapes_.reserve(count); }

 private:
  std::vector<Shape> shapes_;
  std::vector<TextShape> texts_;
  bool has_depth_ = false;
};

}  // namespace sturnus
