// From shapes to pixels: the CPU rasteriser.
#pragma once

#include "base/workers.h"
#include "draw/canvas.h"
#include "sturnus/picture.h"

namespace sturnus {

/// Paints a canvas on a ground of one colour. Each pixel is the mean of supersampling x supersampling samples
/// (1 to 4). The same picture, bit for bit, for any number of workers.
Image paint(const Canvas& canvas, Size size, Rgba background, int supersampling, const Workers& workers);

}  // namespace sturnus
