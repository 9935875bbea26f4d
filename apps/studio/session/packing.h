// From a simulation to a frame: what the window needs of it, in the layout that the graphics card takes.
#pragma once

#include <sturnus/simulation.h>

#include "session/frame.h"

namespace studio {

/// Boids, food, obstacles, targets and the pointer as they stand. Memory of the frame is used again.
void pack(const sturnus::Simulation& simulation, Frame& frame);

}  // namespace studio
