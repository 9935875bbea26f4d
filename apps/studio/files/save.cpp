// What is saved, under names that are free.
#include <sturnus/files.h>

#include "desk.h"
#include "files/files.h"

namespace studio {
namespace {

using sturnus::Simulation;
using sturnus::Status;

// The scenario's name and the step.
std::string usual_name(const Desk& desk) {
  const std::string name = std::filesystem::path(desk.scenario().name).filename().string();
  return (name.empty() ? "world" : name) + "-" + std::to_string(desk.frame->step);
}

// The typed name with the right ending, or one of the world's. Whether it is free is asked when it is
// written.
std::string name_of(const Desk& desk, const std::string& typed, const std::string& tail,
                    const std::string& ending) {
  if (typed.empty()) return usual_name(desk) + tail + ending;
  return typed.ends_with(ending) ? typed : typed + ending;
}

void tell(Session& session, const Status& status, const std::string& sentence) {
  if (status) session.note({sentence});
}

std::int64_t steps_done(const Simulation& simulation) {
  return static_cast<std::int64_t>(simulation.step_number()) - simulation.recording().run.first_step;
}

}  // namespace

std::string new_name(const Desk& desk, const std::string& ending) {
  return free_name(usual_name(desk) + ending);
}

void Files::save_scenario(Desk& desk, const std::string& name) const {
  desk.session.order([&session = desk.session, name = name_of(desk, name, "", ".toml")](World& world) {
    const std::string path = free_name(name);
    const Status status = sturnus::write_text(path, to_toml(with_whole_paths(world.arranged())));
    tell(session, status, "The scenario as it stands is in " + path + ".");
    return status;
  });
}

void Files::save_session(Desk& desk, const std::string& name) const {
  desk.session.order(
      [&session = desk.session, name = name_of(desk, name, "-session", ".toml")](World& world) {
        const std::string path = free_name(name);
        const Status status = world.write_session(path);
        tell(session, status,
             "The session is in " + path + "; sturnus run " + path + " --steps " +
                 std::to_string(steps_done(world.simulation())) + " ends in this very world.");
        return status;
      });
}

void Files::save_state(Desk& desk, const std::string& name) const {
  desk.session.order([&session = desk.session, name = name_of(desk, name, "", ".csv")](World& world) {
    const std::string path = free_name(name);
    const Status status = sturnus::write_text(path, sturnus::state_csv(world.simulation().view().state()));
    tell(session, status, "The boids are in " + path + ".");
    return status;
  });
}

}  // namespace studio
