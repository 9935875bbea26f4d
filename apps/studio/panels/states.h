// What panels remember from one frame to the next.
#pragma once

#include <sturnus/scenario.h>

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "session/world.h"

namespace studio {

/// Of the settings.
struct InspectorState {
  std::shared_ptr<const sturnus::ScenarioDef> opened;  ///< of which `baseline` holds the values
  std::map<std::string, std::string> baseline;         ///< value as text, by path
  std::set<std::string> linked;                        ///< flocks whose radii move together
  std::uint64_t gesture = 0;                           ///< of the slider that is dragged
  std::size_t modified = 0;                            ///< how many values differ from the baseline
};

/// Of the unit that is followed.
struct TrackingState {
  bool was_on = false;
  std::set<std::string> hidden;  ///< terms whose arrows are not drawn
  bool rings = true, sight = true, neighbours = true;
};

/// One line of the plots.
struct PlotLine {
  Sample sample;
  double frame_seconds = 0;  ///< what the window's frame took then
};

/// Of the timeline and the plots.
struct PlotsState {
  std::vector<PlotLine> lines;  ///< in order of their steps
  std::shared_ptr<const sturnus::ScenarioDef> opened;
  std::uint64_t generation = 0, last = 0;
  std::set<std::string> shown{"polarisation", "milling", "nearest_distance", "clusters", "population"};
};

}  // namespace studio
