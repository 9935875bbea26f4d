// Pictures in memory: what an image is, and what may be chosen about the way it is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sturnus/colour.h"

namespace sturnus {

/// Width and height of a picture, in pixels.
struct Size {
  int width = 1280;  ///< pixels, at least 1
  int height = 720;  ///< pixels, at least 1

  friend constexpr bool operator==(const Size&, const Size&) = default;
};

/// A finished picture: rows from top to bottom, pixels from left to right, three bytes each.
/// There is no padding, so `rgb` can go to a PPM file or a video pipe as it is.
struct Image {
  int width = 0;                  ///< pixels
  int height = 0;                 ///< pixels
  std::vector<std::uint8_t> rgb;  ///< width * height * 3 bytes: red, green, blue, in sRGB

  Image() = default;
  /// A picture of one colour. A negative size counts as empty.
  Image(Size size, Rgba fill);

  /// Where the three bytes of a pixel begin. `x` from the left, `y` from the top, both from 0;
  /// the caller keeps them inside the picture.
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }

  /// The colour of one pixel, with the same rule for `x` and `y` as `offset`.
  Rgba at(int x, int y) const {
    const std::uint8_t* pixel = rgb.data() + offset(x, y);
    return {pixel[0], pixel[1], pixel[2], 255};
  }

  Size size() const { return {width, height}; }

  friend bool operator==(const Image&, const Image&) = default;
};

/// Which set of colours a picture uses.
enum class ThemeName : std::uint8_t {
  dark,   ///< for screens: light figures on a nearly black ground
  light,  ///< for print: dark figures on white
};

/// How a picture is drawn. What is drawn comes from the simulation, and the camera from the scenario.
struct PictureOptions {
  Size size;                          ///< pixels
  ThemeName theme = ThemeName::dark;  ///< colours
  /// Samples along each side of a pixel, 1 to 4: with 3, each pixel is the mean of nine samples.
  /// 0 chooses: 3 in space, where the edges of cones need it, and 2 in the plane, where darts, lines and
  /// rings weigh their own edges.
  int supersampling = 0;
};

/// The TrueType file that pictures are written with, DejaVu Sans; empty where the library was built without.
std::span<const unsigned char> picture_font();

/// Smallest and largest side of a picture that will be drawn, in pixels.
inline constexpr int min_picture_side = 16;
inline constexpr int max_picture_side = 16384;

}  // namespace sturnus
