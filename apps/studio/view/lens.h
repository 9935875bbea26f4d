// What every shader has to know of the camera, the window and the ground.
#pragma once

#include <array>

#include "view/camera.h"
#include "view/colours.h"
#include "view/gl.h"

namespace studio {

struct Lens {
  const Camera* camera;
  const Colours* colours;
  float scale = 1;                  ///< pixels of the display for one of the design
  std::array<float, 2> fade{0, 1};  ///< depths between which things sink into the ground's colour, length

  /// Gives a program its uniforms and makes it the one in use.
  void use(const gl::Program& program) const;
};

/// The haze goes from the nearest to the farthest corner of a box.
std::array<float, 2> fade_of(const Camera& camera, const sturnus::Extent& extent);

/// A colour as a uniform of three numbers.
void set_colour(const gl::Program& program, const char* uniform, sturnus::Rgba colour);

}  // namespace studio
