// The two themes; flock colours are those of Okabe and Ito, ordered by contrast with the background.
#include "draw/theme.h"

#include <algorithm>

namespace sturnus {
namespace {

constexpr Rgba orange = rgb(0xe69f00);
constexpr Rgba sky_blue = rgb(0x56b4e9);
constexpr Rgba bluish_green = rgb(0x009e73);
constexpr Rgba yellow = rgb(0xf0e442);
constexpr Rgba blue = rgb(0x0072b2);
constexpr Rgba vermilion = rgb(0xd55e00);
constexpr Rgba reddish_purple = rgb(0xcc79a7);

constexpr Theme dark{
    .background = rgb(0x0f1419),
    .surface = rgb(0x141b22),
    .outline = rgb(0x2b3640),
    .grid = rgb(0x222c35),
    .text = rgb(0xe6edf3),
    .faint_text = rgb(0x8b98a5),
    .predator = vermilion,
    .food = rgb(0x5fbf5a),
    .full_hunter = rgb(0xf0342c),
    .starved = rgb(0xffffff),
    .ready_tail = rgb(0x3ddc55),
    .tired_tail = rgb(0x6b7680),
    .obstacle = rgb(0x6b7680),
    .attractor = blue,
    .flocks = {sky_blue, orange, bluish_green, reddish_purple, yellow, blue},
};

constexpr Theme light{
    .background = rgb(0xffffff),
    .surface = rgb(0xf7f9fa),
    .outline = rgb(0xb4bec7),
    .grid = rgb(0xe3e8ec),
    .text = rgb(0x1b232b),
    .faint_text = rgb(0x5e6a75),
    .predator = vermilion,
    .food = rgb(0x3c9a3a),
    .full_hunter = rgb(0xd6201a),
    .starved = rgb(0xd9dee3),
    .ready_tail = rgb(0x1fa83a),
    .tired_tail = rgb(0x8a949d),
    .obstacle = rgb(0x8a949d),
    .attractor = sky_blue,
    .flocks = {blue, orange, bluish_green, reddish_purple, sky_blue, yellow},
};

std::uint8_t mix_byte(std::uint8_t from, std::uint8_t to, float part) {
  const auto start = static_cast<float>(from);
  return static_cast<std::uint8_t>(start + (static_cast<float>(to) - start) * part + 0.5f);
}

}  // namespace

const Theme& theme(ThemeName name) {
  return name == ThemeName::light ? light : dark;
}

Rgba mix(Rgba from, Rgba to, float part) {
  if (!(part > 0)) return from;
  part = std::min(part, 1.0f);
  return {mix_byte(from.r, to.r, part), mix_byte(from.g, to.g, part), mix_byte(from.b, to.b, part),
          mix_byte(from.a, to.a, part)};
}

}  // namespace sturnus
