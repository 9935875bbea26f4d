// Reading and renaming of state files.
#include "inputs.h"

#include <sturnus/files.h>

#include "command_line.h"

namespace program {
namespace {

// The path of a file that a scenario names: relative to the scenario's own folder.
std::string path_of(const sturnus::ScenarioDef& scenario, const std::string& file) {
  return file.front() == '/' ? file : folder_of(scenario.file) + file;
}

sturnus::Status read_into(Inputs& inputs, const sturnus::ScenarioDef& scenario, const std::string& file) {
  if (file.empty() || inputs.contains(file)) return {};
  auto text = sturnus::read_text(path_of(scenario, file));
  if (!text) return text.problems();
  inputs.emplace(file, std::move(*text));
  return {};
}

}  // namespace

sturnus::Result<Inputs> read_inputs(const sturnus::ScenarioDef& scenario) {
  Inputs inputs;
  sturnus::Status status = read_into(inputs, scenario, scenario.run.initial);
  if (!scenario.run.initial.empty() && status) return inputs;  // the flocks' own files are not looked at then
  for (const sturnus::FlockDef& flock : scenario.flocks) {
    if (status) status = read_into(inputs, scenario, flock.start.file);
  }
  if (!status) return status.problems();
  return inputs;
}

sturnus::Result<sturnus::Simulation> open_simulation(const sturnus::ScenarioDef& scenario,
                                                     const Inputs& inputs, int threads) {
  sturnus::SimulationOptions options;
  options.threads = threads;
  for (const auto& [file, text] : inputs) {
    auto table = sturnus::parse_state_csv(text, path_of(scenario, file));
    if (!table) return table.problems();
    options.tables.emplace(file, std::move(*table));
  }
  return sturnus::Simulation::create(scenario, options);
}

sturnus::ScenarioDef with_inputs_beside(sturnus::ScenarioDef scenario, const Inputs& inputs, Inputs& copies) {
  const auto move_beside = [&](std::string& file, const std::string& name) {
    if (file.empty()) return;
    const auto text = inputs.find(file);
    file.clear();
    if (text == inputs.end()) return;  // a flock's file that run.initial takes the place of
    file = name;
    copies.emplace(name, text->second);
  };
  move_beside(scenario.run.initial, "initial.csv");
  for (sturnus::FlockDef& flock : scenario.flocks)
    move_beside(flock.start.file, "start-" + flock.name + ".csv");
  return scenario;
}

}  // namespace program
