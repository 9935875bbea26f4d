// The picture on disk.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <string>

namespace prog06 {

/// Writes PNG where the name ends in .png, and PPM under every other name.
sturnus::Status write_picture(const std::string& path, const sturnus::Image& image);

}  // namespace prog06
