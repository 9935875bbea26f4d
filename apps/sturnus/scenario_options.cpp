// From options to the effective scenario.
#include "scenario_options.h"

#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <filesystem>

#include "command_line.h"
#include "output.h"

namespace program {
namespace {

using sturnus::Problem;
using sturnus::Problems;
using sturnus::ScenarioDef;
using sturnus::Status;

constexpr std::int64_t most = 9007199254740992;  // whole numbers up to here are exact everywhere

// Sets a parameter on behalf of an option, which is what a complaint names.
Status set_for(const std::string& option, ScenarioDef& scenario, const std::string& path,
               sturnus::Value value, bool names_key = false) {
  const Status status = set_parameter(scenario, path, value);
  if (status) return status;
  Problems problems = status.problems();
  for (Problem& problem : problems) {
    problem.file = option;
    if (!names_key) problem.key.clear();
  }
  return problems;
}

Status set_pair(ScenarioDef& scenario, const std::string& pair) {
  const auto equals = pair.find('=');
  if (equals == std::string::npos || equals == 0) {
    return Problem{"--set", 0, "",
                   "write key=value, such as flock.NAME.max_speed=12, but found \"" + pair + "\"", false};
  }
  const std::string key = pair.substr(0, equals);
  return set_for("--set", scenario, key, sturnus::parse_value(pair.substr(equals + 1)), true);
}

Status set_count(ScenarioDef& scenario, std::int64_t count) {
  if (scenario.flocks.size() == 1) {
    scenario.flocks.front().count = count;
    return {};
  }
  std::string text = "there are " + std::to_string(scenario.flocks.size()) + " flocks; say which with";
  for (const sturnus::FlockDef& flock : scenario.flocks) {
    text += (&flock == &scenario.flocks.front() ? " " : " or ") +
            ("--set flock." + flock.name + ".count=" + std::to_string(count));
  }
  return Problem{"--count", 0, "", text, false};
}

// The scenario's own paths are relative to its folder, the command line's to where the caller stands.
std::string path_for(const ScenarioDef& scenario, const std::string& path) {
  if (folder_of(scenario.file).empty() || path.front() == '/') return path;
  std::error_code error;
  const auto absolute = std::filesystem::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

Status apply(const ScenarioOptions& options, ScenarioDef& scenario) {
  for (const std::string& pair : options.set) {
    if (Status status = set_pair(scenario, pair); !status) return status;
  }
  if (options.count) {
    if (Status status = set_count(scenario, *options.count); !status) return status;
  }
  if (options.seed) scenario.seed = *options.seed;
  if (options.steps) scenario.run.steps = *options.steps;
  if (options.first_step) {
    scenario.run.first_step = *options.first_step;
    scenario.run.resumed = true;
  }
  if (!options.initial.empty()) scenario.run.initial = path_for(scenario, options.initial);
  if (!options.index.empty()) {
    if (Status status = set_for("--index", scenario, "index.kind", {options.index}); !status) return status;
  }
  if (options.path.empty()) return {};
  return set_for("--path", scenario, "index.path", {options.path});
}

// Warnings of the file, with their lines, and those that came with the options.
void tell_warnings(const Problems& of_file, const Problems& of_all) {
  tell(of_file);
  Problems more;
  for (const Problem& problem : of_all) {
    const auto same = [&](const Problem& other) {
      return other.key == problem.key && other.text == problem.text;
    };
    if (std::none_of(of_file.begin(), of_file.end(), same)) more.push_back(problem);
  }
  tell(more);
}

}  // namespace

void add_parameter_options(CLI::App& command, ScenarioOptions& options) {
  command.add_option("SCENARIO", options.scenario, "A shipped scenario (sturnus list) or the path of a file")
      ->required()
      ->type_name("");
  add_whole(command, "--count", options.count, 0, 1000000000, "Boids in the one flock");
  add_whole(command, "--seed", options.seed, 0, most, "Seed of all random streams");
  command.add_option("--set", options.set, "Set any parameter, as often as wanted (sturnus keys lists them)")
      ->type_name("key=value")
      ->allow_extra_args(false);
}

void add_search_options(CLI::App& command, std::string& index, std::string& path) {
  add_choice(command, "--index", index, {"all-pairs", "grid", "tree"}, "How neighbours are found");
  add_choice(command, "--path", path, {"auto", "dense", "sparse"}, "How sums over neighbours are made");
}

void add_scenario_options(CLI::App& command, ScenarioOptions& options) {
  add_parameter_options(command, options);
  add_whole(command, "--steps", options.steps, 0, 1000000000000000, "How many steps to do");
  add_search_options(command, options.index, options.path);
  add_text(command, "--initial", options.initial, "STATE.csv", "Take the boids from a state file");
  add_whole(command, "--first-step", options.first_step, 0, 1000000000000000,
            "The step at which that state stands");
}

void add_work_options(CLI::App& command, WorkOptions& options) {
  add_whole(command, "--threads", options.threads, 0, 1024,
            "Threads; 0: one for each core. No result depends on it");
  command.add_flag("--quiet", options.quiet, "Say nothing but what went wrong");
}

sturnus::Result<ScenarioDef> effective_scenario(const ScenarioOptions& options) {
  Problems warnings;
  auto scenario = sturnus::load_scenario(options.scenario, &warnings);
  if (!scenario) return scenario;
  if (const Status status = apply(options, *scenario); !status) return status.problems();
  const Problems problems = check(*scenario);
  if (has_errors(problems)) return problems;
  tell_warnings(warnings, problems);
  return scenario;
}

}  // namespace program
