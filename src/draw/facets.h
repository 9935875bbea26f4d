// How one flat-shaded triangle of a draw list becomes shapes.
#pragma once

#include "draw/camera.h"
#include "draw/canvas.h"
#include "draw/theme.h"
#include "observe/draw_list.h"

namespace sturnus {

/// Adds what is in front of the viewer and near the picture; nothing when a corner is not finite.
void add_facet(const Facet& facet, const Projection& projection, const Theme& theme, Canvas& canvas);

}  // namespace sturnus
