// sturnus check: everything that is wrong with scenario files, each with its line and key.
#include <sturnus/files.h>
#include <sturnus/scenario.h>

#include <algorithm>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

bool names_state_files(const sturnus::ScenarioDef& scenario) {
  const auto has_file = [](const sturnus::FlockDef& flock) { return !flock.start.file.empty(); };
  return !scenario.run.initial.empty() ||
         std::any_of(scenario.flocks.begin(), scenario.flocks.end(), has_file);
}

bool is_good(const std::string& file) {
  sturnus::Problems warnings;
  const auto scenario = sturnus::load_scenario(file, &warnings);
  if (!scenario) {
    tell(scenario.problems());
    return false;
  }
  tell(warnings);
  if (names_state_files(*scenario)) {
    if (const auto flock = sturnus::open_simulation(*scenario, 1); !flock) {
      tell(flock.problems());
      return false;
    }
  }
  print(file + ": ok" + (warnings.empty() ? "" : ", with " + counted(warnings.size(), "warning")) + "\n");
  return true;
}

int check_files(const std::vector<std::string>& files) {
  const auto bad =
      std::count_if(files.begin(), files.end(), [](const std::string& file) { return !is_good(file); });
  return bad == 0 ? done : bad_input;
}

}  // namespace

void add_check(CLI::App& app, Request& request) {
  CLI::App* command = add_command(app, "check", "Say everything that is wrong with scenario files",
                                  {"sturnus check my.toml", "sturnus check scenarios/*.toml"});
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "Scenario files (and the state files that they name)")
      ->type_name("")
      ->required();
  command->callback([&request, files] { request.work = [files] { return check_files(*files); }; });
}

}  // namespace program
