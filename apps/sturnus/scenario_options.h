// The options that say which scenario is meant and what is changed about it; shared by run, render and show.
#pragma once

#include <sturnus/result.h>
#include <sturnus/scenario.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace program {

struct ScenarioOptions {
  std::string scenario;          ///< shipped name or path
  std::vector<std::string> set;  ///< "key=value"
  std::optional<std::int64_t> count, seed, steps, first_step;
  std::string index;    ///< empty: the scenario's
  std::string path;     ///< of the sums over neighbours; empty: the scenario's
  std::string initial;  ///< path as the caller's folder has it; empty: the scenario's
};

/// SCENARIO, --count, --seed and --set: what a scenario says.
void add_parameter_options(CLI::App& command, ScenarioOptions& options);
/// The same and what only a run has.
void add_scenario_options(CLI::App& command, ScenarioOptions& options);

/// --index and --path: how neighbours are found and summed.
void add_search_options(CLI::App& command, std::string& index, std::string& path);

/// The scenario with all options applied, checked. Warnings go to standard error.
sturnus::Result<sturnus::ScenarioDef> effective_scenario(const ScenarioOptions& options);

/// Options of what steps a flock.
struct WorkOptions {
  std::optional<std::int64_t> threads;
  bool quiet = false;

  int thread_count() const { return static_cast<int>(threads.value_or(0)); }
};

void add_work_options(CLI::App& command, WorkOptions& options);

}  // namespace program
