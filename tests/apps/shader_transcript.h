// The Shadertoy flock once more in C++: the same floats in the same order of sums, to hold the shaders
// against.
//
// Written line by line after shadertoy/buffer_a.glsl. Its numbers come from the scenario as a person reads
// it, not from what the program wrote into the shader or from the engine's compiled model.
#pragma once

#include <sturnus/scenario.h>

#include <array>
#include <vector>

namespace shader_transcript {

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

struct Boid {
  Vec3 position, velocity, wander;
  int flock = 0;
};

/// What the site gives a shader in every frame.
struct Inputs {
  float width = 1280, height = 720;  ///< pixels
  bool pressed = false;              ///< the mouse, in the plane
  std::array<float, 2> mouse{};      ///< pixels, y up
  bool world_is_window = true;       ///< the world is the window, a unit a pixel
};

/// The flock as frame 0 sets it up. Scenarios start in the whole space.
std::vector<Boid> start(const sturnus::ScenarioDef& scenario, const Inputs& inputs);

/// The flock of frame `frame`, from that of the frame before.
std::vector<Boid> next(const sturnus::ScenarioDef& scenario, const Inputs& inputs,
                       const std::vector<Boid>& flock, int frame);

}  // namespace shader_transcript
