// Light and haze: how bright a face is, and how distance takes its colour away.
#pragma once

#include "draw/camera.h"
#include "draw/theme.h"
#include "sturnus/colour.h"

namespace sturnus {

/// The unit vector towards the light, which stands above the viewer's left shoulder.
Vec<3> towards_light(const Projection& projection);

/// A colour under light from 0 (none, or from behind) to 1.
Rgba shaded(Rgba colour, float light);

/// The colour of a face that is seen from both sides; `along` and `across` are two of its edges, `to_eye`
/// points from it to the viewer, `light` is a unit vector.
Rgba lit_face(Rgba colour, const Vec<3>& along, const Vec<3>& across, const Vec<3>& to_eye,
              const Vec<3>& light);

/// A colour at a depth: the farther, the more of the background.
Rgba sunk(Rgba colour, float depth, const Projection& projection, const Theme& theme);

}  // namespace sturnus
