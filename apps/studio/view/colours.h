// The studio's colours of things in the world, on a dark and on a light ground; as `sturnus render` has them,
// but for the space's edge, which is white on the dark ground.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/scenario.h>

#include <array>
#include <optional>
#include <string>

namespace studio {

struct Colours {
  sturnus::Rgba background, surface, outline, edge, grid, text;  ///< edge: of the space
  sturnus::Rgba hunter, full, starved, ready_tail, tired_tail;
  sturnus::Rgba food, obstacle, attracts, repels, quarantined, tracked;
  std::array<sturnus::Rgba, 6> flocks;  ///< of Okabe and Ito, without the hunters' vermilion
};

const Colours& colours(sturnus::ThemeName theme);

/// A colour that is seen on the theme's ground: light ones are darker on white.
sturnus::Rgba colour_on(sturnus::ThemeName theme, sturnus::Rgba colour);

/// "#rrggbb", or nothing where it is something else.
std::optional<sturnus::Rgba> colour_of_hex(const std::string& hex);

/// What a flock's boids have when nothing else gives them a colour: its own, vermilion for hunters, or the
/// next of the palette.
sturnus::Rgba flock_colour(const sturnus::ScenarioDef& scenario, std::size_t flock, sturnus::ThemeName theme);

}  // namespace studio
