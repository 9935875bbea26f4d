// What changed between two readings of a scenario: parameters to set, or a change that needs a new world.
#pragma once

#include <sturnus/result.h>
#include <sturnus/scenario.h>

#include <map>
#include <string>
#include <vector>

#include "session/world.h"

namespace studio {

/// Every parameter's text by its path: "flock.birds.separation.weight" is "0.02". People's words (title,
/// about, try, source) are left out.
std::map<std::string, std::string> flatten(const sturnus::ScenarioDef& scenario);

/// One parameter with its new value, as TOML.
struct Difference {
  std::string path, value;
  friend bool operator==(const Difference&, const Difference&) = default;
};

struct Differences {
  std::vector<Difference> set;  ///< in order of their paths
  /// Whether setting those makes `before` the same as `after`. Flocks, events and whatever else comes or goes
  /// is no parameter.
  bool is_all = true;
};
Differences differences(const sturnus::ScenarioDef& before, const sturnus::ScenarioDef& after);

/// An order in which the scenario is right after each of them, or why there is none.
sturnus::Result<std::vector<Difference>> in_order(const sturnus::ScenarioDef& scenario,
                                                  const std::vector<Difference>& changes);

/// Sets them all in a running world, as one deed. On failure the world is as it was, and the first sentence
/// says why.
sturnus::Status set_all(World& world, const std::vector<Difference>& changes, const std::string& label);

}  // namespace studio
