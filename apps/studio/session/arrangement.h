// The scenario as it stands: what people placed and set belongs to it.
#pragma once

#include "session/timeline.h"

namespace studio {

/// The scenario from its start with all that was done to it by hand up to now: parameters, attractors and
/// obstacles as rows; units and food as events of its first step, but for what was put where the eraser went
/// later. Bursts, drags and erased boids are of the session alone.
sturnus::ScenarioDef arranged(const Timeline& timeline);

/// A scenario that goes on from now with the timeline's boids, which are to be given as the table
/// `run.initial`.
sturnus::ScenarioDef continued(const Timeline& timeline);

/// Writes what was done since the timeline's start as a scenario with events, and beside it the boids with
/// which it began where that is not the scenario's own start.
sturnus::Status write_session(const Timeline& timeline, const std::string& path);

/// The scenario with paths that do not depend on where it stands.
sturnus::ScenarioDef with_whole_paths(sturnus::ScenarioDef scenario);

/// A name that no file has: the name itself, or with -2, -3 ... before its ending.
std::string free_name(const std::string& name);

}  // namespace studio
