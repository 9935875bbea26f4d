// A colour as eight-bit sRGB, the form in which scenarios name it and pictures store it.
#pragma once

#include <cstdint>

namespace sturnus {

/// Red, green, blue and opacity, each 0 to 255, in sRGB and not premultiplied.
struct Rgba {
  std::uint8_t r = 0;    ///< red, 0..255
  std::uint8_t g = 0;    ///< green, 0..255
  std::uint8_t b = 0;    ///< blue, 0..255
  std::uint8_t a = 255;  ///< opacity: 0 shows nothing, 255 hides what lies below

  friend constexpr bool operator==(const Rgba&, const Rgba&) = default;
};

/// 0xrrggbb as people write it in style sheets, fully opaque.
constexpr Rgba rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16 & 0xff), static_cast<std::uint8_t>(hex >> 8 & 0xff),
          static_cast<std::uint8_t>(hex & 0xff), 255};
}

/// The same colour with another opacity, 0 to 1; values outside are clamped, and no number counts as 0.
/// It replaces the opacity that the colour had and does not multiply it.
constexpr Rgba with_alpha(Rgba colour, float alpha) {
  const float kept = alpha > 0 ? (alpha < 1 ? alpha : 1.0f) : 0.0f;
  colour.a = static_cast<std::uint8_t>(kept * 255.0f + 0.5f);
  return colour;
}

}  // namespace sturnus
