// The two sets of colours.
#include "view/colours.h"

#include <charconv>

namespace studio {
namespace {

using sturnus::rgb;
using sturnus::Rgba;

constexpr Rgba orange = rgb(0xe69f00), sky_blue = rgb(0x56b4e9), green = rgb(0x009e73),
               yellow = rgb(0xf0e442), blue = rgb(0x0072b2), vermilion = rgb(0xd55e00),
               purple = rgb(0xcc79a7);

// Lighter ones (0 to 255) can't be told from a white ground.
constexpr int lightest_on_white = 150;

constexpr Colours dark{
    .background = rgb(0x0f1419),
    .surface = rgb(0x141b22),
    .outline = rgb(0x2b3640),
    .edge = rgb(0xffffff),
    .grid = rgb(0x222c35),
    .text = rgb(0xe6edf3),
    .hunter = vermilion,
    .full = rgb(0xf0342c),
    .starved = rgb(0xffffff),
    .ready_tail = rgb(0x3ddc55),
    .tired_tail = rgb(0x6b7680),
    .food = rgb(0x5fbf5a),
    .obstacle = rgb(0x6b7680),
    .attracts = rgb(0x3a9bdc),
    .repels = vermilion,
    .quarantined = rgb(0x6b7680),
    .tracked = rgb(0xff3b30),
    .flocks = {sky_blue, orange, green, purple, yellow, blue},
};

constexpr Colours light{
    .background = rgb(0xffffff),
    .surface = rgb(0xf7f9fa),
    .outline = rgb(0xb4bec7),
    .edge = rgb(0x1b232b),
    .grid = rgb(0xe3e8ec),
    .text = rgb(0x1b232b),
    .hunter = vermilion,
    .full = rgb(0xd6201a),
    .starved = rgb(0xd9dee3),
    .ready_tail = rgb(0x1fa83a),
    .tired_tail = rgb(0x8a949d),
    .food = rgb(0x3c9a3a),
    .obstacle = rgb(0x8a949d),
    .attracts = blue,
    .repels = vermilion,
    .quarantined = rgb(0xa3acb4),
    .tracked = rgb(0xe0201a),
    .flocks = {blue, orange, green, purple, sky_blue, yellow},
};

}  // namespace

const Colours& colours(sturnus::ThemeName theme) {
  return theme == sturnus::ThemeName::light ? light : dark;
}

sturnus::Rgba colour_on(sturnus::ThemeName theme, sturnus::Rgba colour) {
  if (theme == sturnus::ThemeName::dark) return colour;
  const int brightness = (3 * colour.r + 6 * colour.g + colour.b) / 10;
  if (brightness <= lightest_on_white) return colour;
  const auto darker = [&](std::uint8_t part) {
    return static_cast<std::uint8_t>(part * lightest_on_white / (2 * brightness - lightest_on_white));
  };
  return {darker(colour.r), darker(colour.g), darker(colour.b), colour.a};
}

std::optional<Rgba> colour_of_hex(const std::string& hex) {
  std::uint32_t value = 0;
  if (hex.size() != 7 || hex[0] != '#') return {};
  const char* end = hex.data() + hex.size();
  if (std::from_chars(hex.data() + 1, end, value, 16).ptr != end) return {};
  return rgb(value);
}

Rgba flock_colour(const sturnus::ScenarioDef& scenario, std::size_t flock, sturnus::ThemeName theme) {
  const sturnus::FlockDef& def = scenario.flocks[flock];
  if (const auto own = colour_of_hex(def.colour.start)) return *own;
  const Colours& all = colours(theme);
  return def.hunt ? all.hunter : all.flocks[flock % all.flocks.size()];
}

}  // namespace studio
