// sturnus show: the effective scenario with all defaults, as a file that loads again.
#include <sturnus/scenario.h>

#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

int show(const ScenarioOptions& options) {
  const auto scenario = effective_scenario(options);
  if (!scenario) return refuse(scenario.problems());
  print("# " + scenario->name + ": the effective scenario, with all defaults.\n" + to_toml(*scenario));
  return done;
}

}  // namespace

void add_show(CLI::App& app, Request& request) {
  CLI::App* command =
      add_command(app, "show", "Print a scenario with all its defaults, as TOML that loads again",
                  {"sturnus show ucsd", "sturnus show ucsd --set flock.birds.max_speed=12 > fast.toml"});
  const auto options = std::make_shared<ScenarioOptions>();
  add_scenario_options(*command, *options);
  command->callback([&request, options] { request.work = [options] { return show(*options); }; });
}

}  // namespace program
