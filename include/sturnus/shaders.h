// A flock as a pair of fragment shaders for the site Shadertoy.
#pragma once

#include <sturnus/result.h>
#include <sturnus/scenario.h>

#include <string>
#include <vector>

namespace sturnus {

/// The world of a flat shader: the window, one unit a pixel, so that margins follow its size; or the
/// scenario's own space, fitted into the window. `automatic` takes the window where the space is flat, begins
/// at (0, 0) and is at least 256 units wide and high, as one measured in pixels is, and no flock starts at a
/// given place.
enum class ShaderWorld { automatic, window, scenario };

struct ShaderOptions {
  ShaderWorld world = ShaderWorld::automatic;
  std::string written_by;  ///< the command that made the tabs, for a comment; may be empty
};

/// One tab of a shader: a file name such as "buffer_a.glsl", and the text to paste.
struct ShaderTab {
  std::string file;
  std::string text;
};

/// The most boids that a shader may have: every boid looks at all others.
inline constexpr std::int64_t most_shader_boids = 4096;

/// The tabs Common, Buffer A and Image that run a scenario, with its numbers in Common; or every part of the
/// scenario that a shader can't express, with its key. Starts and noise come from a noise texture instead of
/// the engine's random numbers; everything else is the engine's step in floats. How it is drawn is the
/// shader's own: of the scenario's looks it takes colours and sizes. The scenario must have passed `check`.
Result<std::vector<ShaderTab>> shadertoy_tabs(const ScenarioDef& scenario, const ShaderOptions& options = {});

}  // namespace sturnus
