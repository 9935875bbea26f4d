// The texts of a pair of Shadertoy shaders, and how Shadertoy makes complete fragment shaders of them.
#pragma once

#include <sturnus/result.h>

#include <string>

namespace shadertoy {

/// One tab of Shadertoy's editor.
struct Tab {
  std::string file;  ///< path
  std::string text;
};

struct Shaders {
  Tab common;  ///< empty text where there is none
  Tab buffer_a;
  Tab image;
};

/// Reads common.glsl (which may be absent), buffer_a.glsl and image.glsl of a folder.
sturnus::Result<Shaders> read_shaders(const std::string& folder);

/// The complete fragment shaders: version, precisions, Shadertoy's uniforms, Common, the tab, and a main.
std::string buffer_a_shader(const Shaders& shaders);
std::string image_shader(const Shaders& shaders);  ///< alpha is 1, as on Shadertoy

/// Writes for each texel i of a picture `probe_width` wide: flock_of(i - 1), texel_of(i - 1), 0, and for
/// texel 0: COUNT, DIMENSIONS, 0, 0.
std::string probe_shader(const Shaders& shaders);

/// What a driver's compile or link log says, by file and line of the tabs.
sturnus::Problems problems_in(const std::string& log, const Shaders& shaders, const Tab& tab);

}  // namespace shadertoy
