// What there is to see of the paths and walls that flocks follow.
#pragma once

#include "observe/scene.h"

namespace sturnus {

/// Thin lines below the boids; in space a wall has its foot and its top, and posts at its corners. What
/// several flocks follow is drawn once, what is switched off not at all.
void add_lines(const View& view, const SceneColours& colours, DrawList& list);

}  // namespace sturnus
