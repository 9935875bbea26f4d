// A flock as a pair of fragment shaders for the site Shadertoy.
#pragma once

#include <sturnus/result.h>
#include <sturnus/scenario.h>

#include <string>
#include <vector>

namespace sturnus {

/// The world of a flat shader: the window, one unit a pixel, so that margins follow its size; or the
/// scenario's own space, fitted into the window. `automatic` takes the window where the space is flat, begins
/// at (0, 0) and is at least 256 units wide and high, as one measured in pixels is.
enum class ShaderWorld { automatic, window, scenario };

/// One tab of a shader: a file name such as "buffer_a.glsl", and the text to paste.
struct ShaderTab {
  std::string file;
  std::string text;
};

/// The most boids that a shader may have: every boid looks at all others.
inline constexpr std::int64_t most_shader_boids = 4096;

/// The tabs Common, Buffer A and Image that run a scenario, with its numbers in Common; or every part of the
/// scenario that a shader can't express, with its key. Starts and noise come from a noise texture instead of
/// the engine's random numbers; everything else is the engine's step in floats. The scenario must have passed
/// `check`.
Result<std::vector<ShaderTab>> shadertoy_tabs(const ScenarioDef& scenario,
                                              ShaderWorld world = ShaderWorld::automatic);

}  // namespace sturnus
