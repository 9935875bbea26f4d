// Pieces of GLSL that several shaders are made of.
#pragma once

#include <string>

namespace studio::shaders {

extern const std::string version;
extern const std::string lens;            ///< the camera's uniforms and the haze of distance
extern const std::string wide_line;       ///< widens a line to pixels
extern const std::string figure_outputs;  ///< what figure_fragment() reads
extern const std::string boid;            ///< pulls a boid, and its colour

}  // namespace studio::shaders
