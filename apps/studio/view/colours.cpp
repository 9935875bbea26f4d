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

constexpr Colours dark{
    .background = rgb(0x0f1419),
    .surface = rgb(0x141b22),
    .outline = rgb(0x2b3640),
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
