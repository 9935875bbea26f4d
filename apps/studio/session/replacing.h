// Other worlds in place of the one that runs; undo brings it back.
#pragma once

#include <sturnus/scenario.h>

#include "session/session.h"

namespace studio {

/// Which file a world follows.
enum class Follows { none, its_own, as_before };

/// Opens a scenario in place of the world. What stands in its way is noted, and the old world goes on. `told`
/// is noted when the new world is there.
void open_in(Session& session, const sturnus::ScenarioDef& scenario, const std::string& label,
             Follows follows, const std::string& told = "");

/// Makes the world that follows this file what the file now says: parameters are set where it runs, anything
/// else begins it anew.
void reload_in(Session& session, const std::string& file, const sturnus::ScenarioDef& after);

}  // namespace studio
