// The colours of pictures: a dark theme for screens, a light one for print.
#pragma once

#include <array>
#include <cstddef>

#include "sturnus/picture.h"

namespace sturnus {

struct Theme {
  Rgba background;  ///< behind everything
  Rgba surface;     ///< the world's ground and the panels of a plot, a shade off the background
  Rgba outline;     ///< world outline, cells, axes
  Rgba grid;        ///< lines that should hardly be seen
  Rgba text;
  Rgba faint_text;  ///< units, tick labels
  Rgba predator;
  Rgba food;
  Rgba full_hunter;  ///< after a meal
  Rgba starved;      ///< what a hunter pales to: white, where that can be seen
  Rgba ready_tail;   ///< of one that can jump
  Rgba tired_tail;   ///< of one that can't
  Rgba obstacle;
  Rgba attractor;
  std::array<Rgba, 6>
      flocks;                ///< told apart by colour-blind eyes; the predator's vermilion is not among them
  float depth_fade = 0.72f;  ///< how much of the background the farthest glyph in space takes on, 0 to 1

  /// The colour of flock or line `index`; they repeat after the last.
  Rgba flock(std::size_t index) const { return flocks[index % flocks.size()]; }
};

const Theme& theme(ThemeName name);

/// `part` of the way from one colour to the other, 0 to 1; opacity is mixed too.
Rgba mix(Rgba from, Rgba to, float part);

}  // namespace sturnus
