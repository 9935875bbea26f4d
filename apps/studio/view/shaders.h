// The studio's GLSL, each text a whole shader. What the numbers in the buffers mean stands beside those who
// fill them: Instance in session/frame.h, the rest in scenery.h and meshes.h.
#pragma once

#include <string>

namespace studio::shaders {

std::string figure_vertex();    ///< boids as darts, triangles and discs of the plane, and as balls
std::string sprite_vertex();    ///< discs, rings and balls of the scenery
std::string figure_fragment();  ///< for both
std::string body_vertex();      ///< boids as meshes that move: cones, fish, birds
std::string body_fragment();
std::string point_vertex();  ///< boids as points
std::string point_fragment();
std::string line_vertex();    ///< the scenery's lines
std::string trail_vertex();   ///< boids' ways of a step
std::string line_fragment();  ///< for both
std::string solid_vertex();   ///< triangles
std::string solid_fragment();

}  // namespace studio::shaders
