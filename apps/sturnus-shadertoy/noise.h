// The runner's own noise texture, which stands for Shadertoy's "RGBA Noise Medium".
#pragma once

#include <cstdint>
#include <vector>

namespace shadertoy {

inline constexpr std::uint32_t noise_side = 256;  ///< texels

/// One byte of the noise: a PCG hash (O'Neill 2014; Jarzynski and Olano 2020) of the texel's place and
/// channel.
constexpr std::uint8_t noise_byte(std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
  const std::uint32_t key = (y * noise_side + x) * 4 + channel;
  const std::uint32_t v = key * 747796405u + 2891336453u;
  std::uint32_t w = ((v >> ((v >> 28) + 4)) ^ v) * 277803737u;
  w = (w >> 22) ^ w;
  return static_cast<std::uint8_t>(w >> 24);
}

/// All texels, four bytes each, rows in order of y.
inline std::vector<std::uint8_t> noise_texels() {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(noise_side * noise_side * 4);
  for (std::uint32_t y = 0; y < noise_side; ++y) {
    for (std::uint32_t x = 0; x < noise_side; ++x) {
      for (std::uint32_t channel = 0; channel < 4; ++channel) bytes.push_back(noise_byte(x, y, channel));
    }
  }
  return bytes;
}

}  // namespace shadertoy
