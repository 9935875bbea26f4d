// PPM, which is a line of text before the bytes, or what the library knows.
#include "picture_file.h"

#include <sturnus/files.h>

namespace prog06 {

sturnus::Status write_picture(const std::string& path, const sturnus::Image& image) {
  const std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : "";
  if (ending == ".png" || ending == ".PNG") return sturnus::save_picture(path, image);
  std::string bytes = "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
  bytes.append(image.rgb.begin(), image.rgb.end());
  return sturnus::write_text(path, bytes);
}

}  // namespace prog06
