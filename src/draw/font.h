// The one typeface of all pictures: DejaVu Sans, carried inside the library.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace sturnus {

/// The bytes of the TrueType file, written by the build (cmake/embed_font.cmake). Size 0 where the font was
/// not found when the library was built: then text takes no room and leaves no ink.
extern const unsigned char embedded_font[];
extern const unsigned long embedded_font_size;

/// How much ink one line of text leaves in each pixel: rows from the top, 0 to 255.
struct TextInk {
  int left = 0;                     ///< pixels from the text's starting point to the first column
  int top = 0;                      ///< pixels from the baseline to the first row; negative above it
  int width = 0;                    ///< pixels
  int height = 0;                   ///< pixels
  std::vector<std::uint8_t> cover;  ///< width * height
};

/// Whether there is a font to write with.
bool has_font();

/// Advance of a line of UTF-8 text, in pixels. `size` is the height from the tallest letter to the lowest.
float text_width(std::string_view text, float size);

/// The ink of a line of UTF-8 text that starts `shift` (0 to 1) of a pixel right of its starting point.
/// Letters that the font lacks become its box; bytes that are no UTF-8 become U+FFFD.
TextInk text_ink(std::string_view text, float size, float shift);

/// From the baseline to the top of a capital letter, in pixels.
float capital_height(float size);

}  // namespace sturnus
