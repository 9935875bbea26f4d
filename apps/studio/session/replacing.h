// Other worlds in place of the one that runs; undo brings it back.
#pragma once

#include <sturnus/scenario.h>

#include "session/session.h"

namespace studio {

/// Opens a scenario in place of the world, which then follows its file or none. What stands in its way is
/// noted, and the old world goes on.
void open_in(Session& session, const sturnus::ScenarioDef& scenario, const std::string& label,
             bool is_watched);

/// Puts the boids of a state CSV into the scenario as it stands, in place of those that are there.
void replace_boids_in(Session& session, const std::string& table, const std::string& label,
                      const std::string& told);

/// Makes the world that follows this file what the file now says: parameters are set where it runs, anything
/// else begins it anew.
void reload_in(Session& session, const std::string& file, const sturnus::ScenarioDef& after);

}  // namespace studio
