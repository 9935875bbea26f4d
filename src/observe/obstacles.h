// What there is to see of obstacles.
#pragma once

#include "observe/scene.h"

namespace sturnus {

/// Discs, rectangles and lines in the plane; balls, boxes and outlines in space. Where the space wraps, also
/// the images that reach into it.
void add_obstacles(const View& view, const SceneColours& colours, DrawList& list);

}  // namespace sturnus
