// How one glyph of a draw list becomes shapes.
#pragma once

#include "draw/camera.h"
#include "draw/canvas.h"
#include "draw/theme.h"
#include "observe/draw_list.h"

namespace sturnus {

/// The corners of the cone that stands for a boid in space, for size 1 and the place p = 0:
/// triangle i is {nose, base[i], base[i + 1]}. Its base is open.
struct Cone {
  Vec<3> nose;
  Vec<3> base[5];  // the last is the first again
};

/// A cone with its axis along `heading`, which must not be zero.
Cone cone_along(const Vec<3>& heading);

/// Smallest length of a glyph in the picture, pixels: a flock seen from far away stays visible.
inline constexpr float smallest_glyph = 3.0f;

void add_glyph(const Glyph& glyph, const Projection& projection, const Theme& theme, Canvas& canvas);

}  // namespace sturnus
