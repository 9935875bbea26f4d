// Boids in Buffer A: where they are by the word of the Common tab, and their state.
#pragma once

#include <sturnus/view.h>

#include <cstdint>
#include <vector>

#include "gl_objects.h"
#include "shader_text.h"

namespace shadertoy {

/// What common.glsl says: COUNT, DIMENSIONS, flock_of(boid), texel_of(boid).
class Boids {
 public:
  /// Asks a probe shader that includes Common, and checks that all lies within a picture of this size.
  static sturnus::Result<Boids> find(const Shaders& shaders, sturnus::Size size);

  /// Their state as it stands in Buffer A. Ids are the shader's numbers.
  sturnus::State read(const Target& buffer_a, int frame) const;

 private:
  struct Texel {
    int x, y;
  };
  sturnus::Status check(const Shaders& shaders, sturnus::Size size) const;
  int texels_each() const { return dimensions_ - 1; }  // in 3D the velocity is to the right of the place

  int dimensions_ = 2;
  std::vector<int> flock_;
  std::vector<Texel> texel_;
};

}  // namespace shadertoy
