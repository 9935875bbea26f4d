// What is saved, under names that are free.
#include <sturnus/files.h>

#include "desk.h"
#include "files/files.h"
#include "session/replacing.h"

namespace studio {
namespace {

using sturnus::Simulation;
using sturnus::Status;

// A name that no file has: the name itself, or with -2, -3 ... before its ending.
std::string free_name(const std::string& name) {
  const std::filesystem::path path(name);
  std::filesystem::path chosen = path;
  std::error_code error;
  for (int i = 2; std::filesystem::exists(chosen, error); ++i) {
    chosen = path;
    chosen.replace_filename(path.stem().string() + "-" + std::to_string(i) + path.extension().string());
  }
  return chosen.string();
}

// The typed name with the right ending, or one of the world's.
std::string name_of(const Desk& desk, const std::string& typed, const std::string& tail,
                    const std::string& ending) {
  if (typed.empty()) return new_name(desk, tail + ending);
  return free_name(typed.ends_with(ending) ? typed : typed + ending);
}

void tell(Session& session, const Status& status, const std::string& sentence) {
  if (status) session.note({sentence});
}

std::int64_t steps_done(const Simulation& simulation) {
  return static_cast<std::int64_t>(simulation.step_number()) - simulation.recording().run.first_step;
}

}  // namespace

std::string new_name(const Desk& desk, const std::string& ending) {
  const std::string name = std::filesystem::path(desk.scenario().name).filename().string();
  return free_name((name.empty() ? "world" : name) + "-" + std::to_string(desk.frame->step) + ending);
}

void Files::save_scenario(Desk& desk, const std::string& name) const {
  const std::string path = name_of(desk, name, "", ".toml");
  const Status status = sturnus::write_text(path, to_toml(with_whole_paths(desk.scenario())));
  desk.say(status ? "The scenario as it stands is in " + path + "." : status.error(), !status);
}

void Files::save_session(Desk& desk, const std::string& name) const {
  const std::string path = name_of(desk, name, "-session", ".toml");
  desk.session.order([&session = desk.session, path](World& world) {
    sturnus::ScenarioDef recorded = with_whole_paths(world.simulation().recording());
    const std::int64_t steps = steps_done(world.simulation());
    recorded.run.steps = steps;
    const Status status = sturnus::write_text(path, to_toml(recorded));
    tell(session, status,
         "The session is in " + path + "; sturnus run " + path + " --steps " + std::to_string(steps) +
             " ends in this very world.");
    return status;
  });
}

void Files::save_state(Desk& desk, const std::string& name) const {
  const std::string path = name_of(desk, name, "", ".csv");
  desk.session.order([&session = desk.session, path](World& world) {
    const Status status = sturnus::write_text(path, sturnus::state_csv(world.simulation().view().state()));
    tell(session, status, "The boids are in " + path + ".");
    return status;
  });
}

}  // namespace studio
