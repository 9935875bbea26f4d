// Pictures as PNG and PPM files.
#pragma once

#include <string>
#include <vector>

#include "sturnus/picture.h"
#include "sturnus/result.h"

namespace sturnus {

/// The bytes of a PNG file (truecolour, eight bits, lightly compressed: speed counts more than size).
Result<std::vector<unsigned char>> encode_png(const Image& image);

/// The bytes of a binary PPM file (P6).
std::vector<unsigned char> encode_ppm(const Image& image);

/// Whether a name ends in .png or .ppm, in either case of letters; otherwise a sentence with what is
/// possible.
Status check_picture_name(const std::string& path);

/// Writes a picture in the format of the name's ending. The file appears complete or not at all.
Status write_picture(const std::string& path, const Image& image);

}  // namespace sturnus
