// The state files that a scenario names: read once, for the simulation and for the copy in an experiment's
// folder.
#pragma once

#include <sturnus/result.h>
#include <sturnus/simulation.h>

#include <map>
#include <string>

namespace program {

/// Texts of state CSV files, by the file's name as the scenario says it.
using Inputs = std::map<std::string, std::string>;

sturnus::Result<Inputs> read_inputs(const sturnus::ScenarioDef& scenario);

/// The simulation, with its boids from these texts where the scenario wants them from files.
sturnus::Result<sturnus::Simulation> open_simulation(const sturnus::ScenarioDef& scenario,
                                                     const Inputs& inputs, int threads);

/// The scenario with the names that its state files get in an experiment's folder, and those files' texts.
sturnus::ScenarioDef with_inputs_beside(sturnus::ScenarioDef scenario, const Inputs& inputs, Inputs& copies);

}  // namespace program
