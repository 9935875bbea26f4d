// From a draw list and a viewpoint to a picture.
#pragma once

#include "base/workers.h"
#include "draw/camera.h"
#include "draw/theme.h"
#include "observe/draw_list.h"
#include "sturnus/picture.h"

namespace sturnus {

/// The picture of a draw list, the same bit for bit for any number of workers. `supersampling` as in
/// PictureOptions.
Image draw(const DrawList& list, const Viewpoint& viewpoint, const Theme& theme, Size size,
           const Workers& workers, int supersampling = 0);

}  // namespace sturnus
