// Opening and reloading, as orders to the session.
#include "session/replacing.h"

#include <sturnus/files.h>

#include "desk.h"
#include "session/differences.h"

namespace studio {
namespace {

using sturnus::ScenarioDef;
using sturnus::Status;

std::string count_of(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " change is" : " changes are");
}

Status replace(World& world, const ScenarioDef& scenario, const std::string& label,
               const std::string& watched) {
  auto simulation = sturnus::open_simulation(scenario, world.simulation().threads());
  if (!simulation) return simulation.problems();
  world.replace(std::move(*simulation), label, watched);
  return {};
}

Status begin_anew(Session& session, World& world, const ScenarioDef& scenario, const std::string& reason) {
  const std::string file = world.watched();
  const Status status = replace(world, scenario, "reload " + scenario.name, file);
  if (!status) {
    session.hand_back([file, text = status.error()](Desk& desk) { desk.keep_saying(file, text); });
    return {};
  }
  session.note({scenario.file + ": " + reason + ", so the world began anew. Undo brings the old one back."});
  return {};
}

std::string without_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

void open_in(Session& session, const ScenarioDef& scenario, const std::string& label, bool is_watched) {
  session.order([scenario, label, is_watched](World& world) {
    const Status status = replace(world, scenario, label, is_watched ? scenario.file : "");
    if (status) world.set_read(scenario);
    return status;
  });
}

void replace_boids_in(Session& session, const std::string& table, const std::string& label,
                      const std::string& told) {
  session.order([&session, table, label, told](World& world) {
    ScenarioDef scenario = world.arranged();
    scenario.run.initial = table;
    scenario.run.first_step = 0;
    scenario.run.resumed = false;
    scenario.run.events.clear();
    const std::string file = world.watched();
    const ScenarioDef read = file.empty() ? scenario : world.read();
    const Status status = replace(world, scenario, label, file);
    if (status) world.set_read(read);
    if (status) session.note({told});
    return status;
  });
}

void reload_in(Session& session, const std::string& file, const ScenarioDef& after) {
  session.order([&session, file, after](World& world) -> Status {
    if (world.watched() != file) return {};  // another world was opened meanwhile
    const Differences found = differences(world.read(), after);
    world.set_read(after);  // also for the world that is set aside: undo is not undone by its file
    if (!found.is_all) return begin_anew(session, world, after, "what changed is more than numbers");
    if (const Status status = set_all(world, found.set, "reload " + after.name); !status)
      return begin_anew(session, world, after, without_end(status.problems().front().text));
    if (!found.set.empty()) session.note({after.file + ": " + count_of(found.set.size()) + " in force."});
    return {};
  });
}

}  // namespace studio
