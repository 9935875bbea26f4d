// What stands around the boids: the space's edge, grid and index, obstacles, food, targets and the pointer.
#pragma once

#include <sturnus/result.h>

#include <cstdint>
#include <vector>

#include "session/frame.h"
#include "view/lens.h"
#include "view/shapes.h"
#include "view/view.h"

namespace studio {

/// A disc, ring or ball, two texels.
struct Sprite {
  enum Flag : std::uint32_t { ball = 1, bright = 2 };  ///< lit in space; does not sink into the distance
  Point at{};
  float radius = 0;  ///< length
  sturnus::Rgba colour;
  float ring = 0;      ///< pixels of the design; 0: filled
  float smallest = 0;  ///< radius in pixels of the design
  std::uint32_t flags = 0;
};
static_assert(sizeof(Sprite) == 32);

/// A line, two texels.
struct Line {
  Point from{};
  float width = 1;  ///< pixels of the design
  Point to{};
  sturnus::Rgba colour;
};
static_assert(sizeof(Line) == 32);
static_assert(sizeof(ShapeCorner) == 16);

/// Things of one place in the order of drawing.
struct Layer {
  std::vector<Line> lines;
  std::vector<Sprite> sprites;
  std::vector<ShapeCorner> solids;  ///< triangles

  void clear() { lines.clear(), sprites.clear(), solids.clear(); }
};

/// The space's ground and edge, grid and index boxes.
void add_ground(const Frame& frame, const Colours& colours, const ViewOptions& options, Layer& out);
void add_obstacles(const Frame& frame, const Colours& colours, Layer& out);
void add_food(const Frame& frame, const Colours& colours, Layer& out);
void add_targets(const Frame& frame, const Colours& colours, const ViewOptions& options, Layer& out);

class Scenery {
 public:
  static sturnus::Result<Scenery> create();
  void draw(const Layer& layer, const Lens& lens);
  /// Triangles without light, above everything.
  void draw(const Shapes& shapes, const Lens& lens);

 private:
  Scenery(gl::Program lines, gl::Program sprites, gl::Program solids);
  void draw_solids(const std::vector<ShapeCorner>& corners, const Lens& lens, bool lit);

  gl::Program lines_, sprites_, solids_;
  gl::Pulled buffer_{GL_RGBA32UI};
};

}  // namespace studio
