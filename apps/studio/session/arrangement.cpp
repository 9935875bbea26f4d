// What was done by hand, done again to a world without boids, so that only the scenario changes.
#include "session/arrangement.h"

#include <sturnus/files.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "session/events.h"

namespace studio {
namespace {

using namespace sturnus;

constexpr const char* table_name = "start.csv";

// The same obstacles as numbers of a row.
ObstacleDef row_of(const Obstacle& obstacle, std::size_t axes) {
  const auto numbers = [axes](const std::array<float, 3>& at) {
    return Coordinates(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(axes));
  };
  ObstacleDef row;
  Coordinates from = numbers(obstacle.at);
  if (obstacle.kind == ObstacleKind::sphere) {
    from.push_back(double{obstacle.radius});
    row.spheres = {from};
  } else if (obstacle.kind == ObstacleKind::plane) {
    for (const double part : numbers(obstacle.normal)) from.push_back(part);
    row.planes = {from};
  } else {
    Coordinates to = from;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      from[axis] -= double{obstacle.half[axis]};
      to[axis] += double{obstacle.half[axis]};
    }
    from.insert(from.end(), to.begin(), to.end());
    row.boxes = {from};
  }
  return row;
}

// Rows of the same kind that follow each other are one.
void add_row(std::vector<ObstacleDef>& rows, const ObstacleDef& row) {
  ObstacleDef* last = rows.empty() || rows.back().random ? nullptr : &rows.back();
  if (last != nullptr && last->boxes.empty() && last->planes.empty() && !row.spheres.empty()) {
    last->spheres.push_back(row.spheres.front());
  } else {
    rows.push_back(row);
  }
}

// Those that a scenario began with stay as it says them, unless one of them is gone.
void keep_obstacles(const std::vector<Obstacle>& before, const std::vector<Obstacle>& now,
                    ScenarioDef& scenario) {
  const bool all_there = now.size() >= before.size() && std::equal(before.begin(), before.end(), now.begin());
  if (!all_there) scenario.obstacles.clear();
  const auto axes = static_cast<std::size_t>(scenario.space.dimensions);
  for (std::size_t i = all_there ? before.size() : 0; i < now.size(); ++i)
    add_row(scenario.obstacles, row_of(now[i], axes));
}

bool changes_scenario(const Command& command) {
  return std::holds_alternative<SetParameter>(command) || std::holds_alternative<PlaceTarget>(command) ||
         std::holds_alternative<PlaceObstacle>(command) || std::holds_alternative<EraseBoids>(command);
}

bool has_moving_targets(const ScenarioDef& scenario) {
  return std::any_of(scenario.targets.begin(), scenario.targets.end(),
                     [](const TargetDef& target) { return target.motion != TargetMotion::still; });
}

// Does to a scenario, without any boids, what was done by hand.
ScenarioDef with_rows(const ScenarioDef& begun, const std::vector<Event>& deeds) {
  ScenarioDef bare = begun;
  bare.run.events.clear();
  bare.run.initial.clear();
  for (FlockDef& flock : bare.flocks) {
    flock.count = 0;
    flock.start.file.clear();
  }
  for (FoodDef& food : bare.food) food.count = 0;
  auto simulation = Simulation::create(bare, {.threads = 1, .tables = {}});
  if (!simulation) return begun;
  const std::vector<Obstacle> before = simulation->view().state().obstacles;
  for (const Event& deed : deeds) {
    if (!changes_scenario(deed.command)) continue;
    if (has_moving_targets(simulation->scenario()) && deed.step > simulation->step_number())
      simulation->run(deed.step - simulation->step_number());
    static_cast<void>(simulation->push(deed.command));
  }
  ScenarioDef out = simulation->scenario();
  keep_obstacles(before, simulation->view().state().obstacles, out);
  out.run.initial = begun.run.initial;
  for (std::size_t i = 0; i < out.flocks.size(); ++i) {
    out.flocks[i].count = begun.flocks[i].count;
    out.flocks[i].start.file = begun.flocks[i].start.file;
  }
  for (std::size_t i = 0; i < out.food.size(); ++i) out.food[i].count = begun.food[i].count;
  return out;
}

// Where units or food are put down; nothing for other commands.
const Coordinates* place_of(const Command& command) {
  if (const auto* boids = std::get_if<AddBoids>(&command)) return &boids->at;
  if (const auto* food = std::get_if<AddFood>(&command)) return &food->at;
  return nullptr;
}

// Whether a stroke of the eraser goes over a place, by the nearest image.
bool reaches(const EraseBoids& erase, const Coordinates& place, const ScenarioDef& scenario) {
  const Extent extent = extent_of(scenario);
  std::array<double, 3> offset{};
  double along = 0, squared = 0, away = 0;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const double side = extent.max[axis] - extent.min[axis];
    offset[axis] = place[axis] - erase.at[axis];
    if (scenario.space.boundary.kind == BoundaryKind::wrap)
      offset[axis] -= side * std::round(offset[axis] / side);
    if (erase.along.empty()) continue;
    along += offset[axis] * erase.along[axis];
    squared += erase.along[axis] * erase.along[axis];
  }
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const double aside = offset[axis] - (erase.along.empty() ? 0 : along / squared * erase.along[axis]);
    away += aside * aside;
  }
  return away <= erase.radius * erase.radius;
}

bool is_erased(const Coordinates& place, std::vector<Event>::const_iterator from,
               std::vector<Event>::const_iterator end, const ScenarioDef& scenario) {
  return std::any_of(from, end, [&](const Event& event) {
    const auto* erase = std::get_if<EraseBoids>(&event.command);
    return erase != nullptr && reaches(*erase, place, scenario);
  });
}

// The scenario's own events, and at its first step what was put down by hand.
std::vector<Event> with_placed(const std::vector<Event>& own, const std::vector<Event>& deeds,
                               const ScenarioDef& scenario) {
  const auto first = static_cast<std::uint64_t>(scenario.run.first_step);
  std::vector<Event> out;
  for (const Event& event : own) {
    const Coordinates* place = event.step <= first ? place_of(event.command) : nullptr;
    if (place == nullptr || !is_erased(*place, deeds.begin(), deeds.end(), scenario)) out.push_back(event);
  }
  const auto later = std::find_if(out.begin(), out.end(), [&](const Event& e) { return e.step > first; });
  std::vector<Event> placed;
  for (auto deed = deeds.begin(); deed != deeds.end(); ++deed) {
    const Coordinates* place = place_of(deed->command);
    if (place != nullptr && !is_erased(*place, deed, deeds.end(), scenario))
      placed.push_back({first, deed->command});
  }
  out.insert(later, placed.begin(), placed.end());
  return out;
}

}  // namespace

ScenarioDef arranged(const Timeline& timeline) {
  const ScenarioDef recording = timeline.simulation.recording();
  std::vector<Event> deeds = done_by_hand(recording.run.events, timeline.events);
  std::erase_if(deeds, [&](const Event& deed) { return deed.step > timeline.simulation.step_number(); });
  const ScenarioDef& begun = timeline.base ? *timeline.base : recording;
  ScenarioDef out = with_rows(begun, deeds);
  out.run.events = with_placed(timeline.base ? begun.run.events : timeline.events, deeds, out);
  return out;
}

ScenarioDef continued(const Timeline& timeline) {
  const Simulation& simulation = timeline.simulation;
  const State& state = simulation.view().state();
  ScenarioDef out = simulation.scenario();
  out.obstacles.clear();
  keep_obstacles({}, state.obstacles, out);
  out.run.initial = table_name;
  out.run.first_step = static_cast<std::int64_t>(simulation.step_number());
  out.run.resumed = false;
  const auto axes = static_cast<std::ptrdiff_t>(state.dimensions);
  if (state.pointer.pressed) {
    MovePointer pointer{
        state.pointer.mode, {state.pointer.at.begin(), state.pointer.at.begin() + axes}, true};
    if (state.pointer.along != std::array<float, 3>{})
      pointer.along.assign(state.pointer.along.begin(), state.pointer.along.begin() + axes);
    out.run.events.push_back({state.step, std::move(pointer)});
  }
  for (const Event& event : timeline.events) {
    if (event.step > state.step) out.run.events.push_back(event);
  }
  return out;
}

Status write_session(const Timeline& timeline, const std::string& path) {
  ScenarioDef recorded = with_whole_paths(timeline.simulation.recording());
  recorded.run.steps = static_cast<std::int64_t>(timeline.simulation.step_number()) - recorded.run.first_step;
  if (timeline.start) {
    const std::filesystem::path file(path);
    const std::string table =
        free_name((file.parent_path() / (file.stem().string() + "-start.csv")).string());
    if (const Status status = write_text(table, state_csv(*timeline.start)); !status) return status;
    recorded.run.initial = std::filesystem::path(table).filename().string();
  }
  return write_text(path, to_toml(recorded));
}

ScenarioDef with_whole_paths(ScenarioDef scenario) {
  const std::filesystem::path folder = std::filesystem::path(scenario.file).parent_path();
  const auto make_whole = [&](std::string& path) {
    if (!path.empty()) path = std::filesystem::absolute(folder / path).lexically_normal().string();
  };
  make_whole(scenario.run.initial);
  for (FlockDef& flock : scenario.flocks) make_whole(flock.start.file);
  return scenario;
}

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

}  // namespace studio
