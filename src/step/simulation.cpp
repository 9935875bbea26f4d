// Simulation: the four objects of a run, its commands and their log.
#include <sturnus/simulation.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/float_settings.h"
#include "base/text.h"
#include "scenario/creatures.h"
#include "scenario/events.h"
#include "scenario/obstacles.h"
#include "scenario/targets.h"
#include "step/explain.h"
#include "step/step.h"
#include "world/commands.h"
#include "world/spawn.h"
#include "world/state.h"

namespace sturnus {
namespace {

struct Logged {
  Event event;
  bool by_hand = false;
};

constexpr const char* external_name = "external";

// Whether what happened in one log before a step is just the first `count` events of another.
bool same_past(const std::vector<Logged>& one, const std::vector<Logged>& other, std::size_t count,
               std::uint64_t step) {
  if (one.size() < count || (one.size() > count && one[count].event.step < step)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (to_text(to_value(one[i].event)) != to_text(to_value(other[i].event))) return false;
  }
  return true;
}

}  // namespace

struct Snapshot::Data {
  ScenarioDef scenario;
  State state;
  std::vector<Logged> log;
  std::size_t done = 0;
  StepReport report;
};

std::uint64_t Snapshot::step() const {
  return data_ ? data_->state.step : 0;
}

Accelerations::Accelerations(Columns& columns, std::size_t slots) : columns_(&columns), size_(slots) {}

void Accelerations::add(std::size_t slot, float x, float y, float z) {
  assert(slot < size_);
  const std::array<float, 3> given = {x, y, z};
  for (std::size_t axis = 0; axis < 3 && !(*columns_)[axis].empty(); ++axis)
    (*columns_)[axis][slot] += given[axis];
}

struct Simulation::World {
  ScenarioDef initial;   ///< as it began, without events
  ScenarioDef scenario;  ///< as it stands
  Model model;           ///< as compiled, with the user's rules among its terms
  State state;
  Scratch scratch;
  Workers workers;
  Outside outside;
  std::vector<std::pair<std::string, std::int64_t>> rules;  ///< names and priorities
  std::vector<Logged> log;                                  ///< all events, in order of their steps
  std::size_t done = 0;                                     ///< how many of them are carried out
  StepReport report;

  explicit World(const ScenarioDef& def, int threads)
      : initial(def), scenario(def), model(compile(def)), workers(threads) {
    for (const Event& event : def.run.events) log.push_back({event, false});
    initial.run.events.clear();
    scenario.run.events.clear();
    rules.emplace_back(external_name, 0);
    add_custom_terms();
  }

  void add_custom_terms() {
    for (std::size_t i = 0; i < rules.size(); ++i) {
      TermModel term;
      term.kind = TermKind::custom;
      term.row = static_cast<int>(i);
      term.priority = rules[i].second;
      term.order = std::numeric_limits<int>::max();
      add_term(model, term);
    }
  }

  void carry_out(const Command& command) {
    const Applied applied = apply(command, scenario, model, state);
    if (applied.is_in_vain) ++report.commands_in_vain;
    if (applied.has_compiled) add_custom_terms();
    scratch.room = 0;
    if (std::holds_alternative<AddBoids>(command) || std::holds_alternative<EraseBoids>(command))
      outside.external = {};
    if (applied.has_moved_boids) forget_last_step();
  }

  // What was before the last step no longer belongs to the boids that are there now.
  void forget_last_step() {
    scratch.previous_position = {};
    scratch.previous_velocity = {};
    scratch.room = 0;
  }

  // Does every logged event whose step has come.
  void do_events() {
    for (; done < log.size() && log[done].event.step <= state.step; ++done)
      carry_out(log[done].event.command);
  }

  // A state that was saved has what events did to its boids; parameters, targets, obstacles and the pointer
  // are set again, and what is past leaves the log: from here on it is part of how the run began.
  void settle_past() {
    const auto first = static_cast<std::uint64_t>(initial.run.first_step);
    const auto is_past = [&](const Event& event) {
      return event.step < first || (event.step == first && initial.run.resumed);
    };
    bool has_pointer = false;
    std::size_t past = 0;
    for (; past < log.size() && is_past(log[past].event); ++past) {
      const Event& event = log[past].event;
      if (redo(event.command, event.step, scenario, model, state).has_compiled) add_custom_terms();
      has_pointer = has_pointer || std::holds_alternative<MovePointer>(event.command);
    }
    log.erase(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(past));
    initial = scenario;
    initial.run.resumed = false;
    // As they stand: where random ones stood depends on the space as it was.
    if (past > 0) initial.obstacles = definitions_of(state.obstacles, model.dimensions);
    if (!has_pointer) return;
    const auto axes = static_cast<std::ptrdiff_t>(model.dimensions);
    const Coordinates at(state.pointer.at.begin(), state.pointer.at.begin() + axes);
    MovePointer pointer{state.pointer.mode, at, state.pointer.pressed};
    if (state.pointer.along != std::array<float, 3>{})
      pointer.along.assign(state.pointer.along.begin(), state.pointer.along.begin() + axes);
    log.insert(log.begin(), {{first, std::move(pointer)}, false});
  }

  void forget_later() {
    const auto is_later_by_hand = [](const Logged& logged) { return logged.by_hand; };
    log.erase(std::remove_if(log.begin() + static_cast<std::ptrdiff_t>(done), log.end(), is_later_by_hand),
              log.end());
  }

  void record(const Command& command) {
    forget_later();
    log.insert(log.begin() + static_cast<std::ptrdiff_t>(done), {{state.step, command}, true});
    ++done;
  }
};

namespace {

const State* table_of(const SimulationOptions& options, const ScenarioDef& scenario, const std::string& file,
                      const std::string& key, Problems& problems) {
  const auto found = options.tables.find(file);
  if (found == options.tables.end()) {
    problems.push_back({scenario.file, 0, key, say("the boids of \"", file, "\" were not read"), false});
    return nullptr;
  }
  if (found->second.dimensions != scenario.space.dimensions) {
    problems.push_back({scenario.file, 0, key,
                        say("\"", file, "\" holds boids in ", found->second.dimensions,
                            " dimensions, but the space has ", scenario.space.dimensions),
                        false});
    return nullptr;
  }
  for (const std::uint8_t flock : found->second.flock) {
    if (flock < scenario.flocks.size()) continue;
    problems.push_back({scenario.file, 0, key,
                        say("\"", file, "\" holds a boid of flock ", int{flock}, ", but there are only ",
                            scenario.flocks.size(), " flocks, numbered from 0"),
                        false});
    return nullptr;
  }
  for (const std::uint8_t kind : found->second.food.kind) {
    if (kind < scenario.food.size()) continue;
    problems.push_back({scenario.file, 0, key,
                        say("\"", file, "\" holds food of kind ", int{kind}, ", but there are only ",
                            scenario.food.size(), " kinds of food, numbered from 0"),
                        false});
    return nullptr;
  }
  return &found->second;
}

// The sentence for more boids than the machine can hold; empty when they fit.
std::string too_many(double boids) {
  if (bytes_needed(boids) <= 0.9 * bytes_available()) return {};
  const auto gigabytes = [](double bytes) { return static_cast<std::int64_t>(bytes / 1e9 + 0.5); };
  return say(static_cast<std::int64_t>(boids), " boids need about ", gigabytes(bytes_needed(boids)),
             " GB of memory, but this machine has ", gigabytes(bytes_available()), " GB");
}

Problem no_free_place(const ScenarioDef& scenario, std::size_t flock, std::int64_t inside) {
  const FlockDef& def = scenario.flocks[flock];
  return {scenario.file, 0, say("flock.", def.name, ".start"),
          say(inside, " of ", def.count, " boids found no place outside of the obstacles"), false};
}

void check_memory(const ScenarioDef& scenario, Problems& problems) {
  double boids = 0;
  for (const FlockDef& flock : scenario.flocks)
    boids += static_cast<double>(scenario.run.initial.empty() || flock.feed ? population_cap(flock) : 0);
  std::string key = "flock.count";
  for (const Event& event : scenario.run.events) {
    const auto* add = std::get_if<AddBoids>(&event.command);
    if (add == nullptr) continue;
    boids += static_cast<double>(add->count);
    key = "run.events";
  }
  const std::string text = too_many(boids);
  if (!text.empty()) problems.push_back({scenario.file, 0, key, text, false});
}

}  // namespace

Simulation::Simulation(std::unique_ptr<World> world) : world_(std::move(world)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Result<Simulation> Simulation::create(const ScenarioDef& scenario, const SimulationOptions& options) {
  const FloatSettings settings;
  Problems problems = check(scenario);
  if (has_errors(problems)) return problems;
  problems.clear();
  const Run& run = scenario.run;
  const State* all =
      run.initial.empty() ? nullptr : table_of(options, scenario, run.initial, "run.initial", problems);
  check_memory(scenario, problems);
  if (!problems.empty()) return problems;

  auto world = std::make_unique<World>(scenario, options.threads);
  world->state.dimensions = world->model.dimensions;
  world->state.step = static_cast<std::uint64_t>(run.first_step);
  world->state.obstacles = *obstacles_of(scenario);
  wrap_positions(world->model, world->state);
  if (all != nullptr) {
    world->settle_past();
    append_boids(world->scenario, world->model, *all, -1, world->state);
  }
  for (std::size_t i = 0; all == nullptr && i < scenario.flocks.size(); ++i) {
    const std::string& file = scenario.flocks[i].start.file;
    if (file.empty()) {
      const std::int64_t inside = spawn_flock(scenario, world->model, i, world->state);
      if (inside > 0) problems.push_back(no_free_place(scenario, i, inside));
    } else if (const State* some =
                   table_of(options, scenario, file, say("flock.", scenario.flocks[i].name, ".start.file"),
                            problems)) {
      append_boids(scenario, world->model, *some, static_cast<int>(i), world->state);
    }
  }
  if (all == nullptr) spawn_food(scenario, world->model, world->state);
  if (!problems.empty()) return problems;
  wrap_positions(world->model, world->state);
  quarantine(world->model, world->state, world->workers);
  world->do_events();
  return Simulation(std::move(world));
}

void Simulation::step() {
  const FloatSettings settings;
  World& world = *world_;
  world.do_events();  // after a restore, those of this very step
  sturnus::step(world.model, world.scenario, world.state, world.scratch, world.outside, world.report,
                world.workers);
  world.outside.external = {};
  world.do_events();
}

void Simulation::run(std::uint64_t steps) {
  for (std::uint64_t i = 0; i < steps; ++i) step();
}

Status Simulation::push(const Command& command) {
  const FloatSettings settings;
  World& world = *world_;
  if (const auto error = check_command(world.scenario, command)) {
    return Problem{world.scenario.file, 0, "", *error, false};
  }
  const auto* move = std::get_if<MoveBoid>(&command);
  if (move != nullptr && !view().slot(move->id)) {
    return Problem{world.scenario.file, 0, "", say("there is no boid with id ", move->id), false};
  }
  const auto* add = std::get_if<AddBoids>(&command);
  const double more = add == nullptr ? 0 : static_cast<double>(add->count);
  if (const std::string text = too_many(static_cast<double>(world.state.size()) + more); !text.empty()) {
    return Problem{world.scenario.file, 0, "", text, false};
  }
  world.record(command);
  world.carry_out(command);
  return {};
}

View Simulation::view() const {
  return {world_->state, world_->scenario, world_->scratch.previous_position,
          world_->scratch.previous_velocity};
}

std::uint64_t Simulation::hash() const {
  return sturnus::hash(world_->state);
}
std::uint64_t Simulation::step_number() const {
  return world_->state.step;
}
const ScenarioDef& Simulation::scenario() const {
  return world_->scenario;
}

int Simulation::threads() const {
  return world_->workers.count();
}

StepReport Simulation::report() const {
  StepReport report = world_->report;
  for (const std::uint8_t flag : world_->state.quarantined) report.quarantined += flag;
  return report;
}

ScenarioDef Simulation::recording() const {
  ScenarioDef out = world_->initial;
  for (const Logged& logged : world_->log) out.run.events.push_back(logged.event);
  return out;
}

Snapshot Simulation::snapshot() const {
  Snapshot out;
  out.data_ = std::make_shared<Snapshot::Data>(
      Snapshot::Data{world_->scenario, world_->state, world_->log, world_->done, world_->report});
  return out;
}

void Simulation::restore(const Snapshot& snapshot, Later later) {
  const FloatSettings settings;
  World& world = *world_;
  const Snapshot::Data& data = *snapshot.data_;
  // What came after this moment is kept for replay where the world lived through it; where it lived through
  // another past, the snapshot's own future holds.
  if (later == Later::as_then || !same_past(world.log, data.log, data.done, data.state.step))
    world.log = data.log;
  world.scenario = data.scenario;
  world.model = compile(world.scenario);
  world.add_custom_terms();
  world.state = data.state;
  world.report = data.report;
  world.done = data.done;
  if (later == Later::never) world.forget_later();
  world.forget_last_step();
  world.outside.external = {};
}

void Simulation::add_rule(std::string name, std::int64_t priority, Rule rule) {
  const FloatSettings settings;
  World& world = *world_;
  world.rules.emplace_back(std::move(name), priority);
  world.outside.rules.push_back(std::move(rule));
  world.model = compile(world.scenario);
  world.add_custom_terms();
}

Accelerations Simulation::external() {
  fit(world_->outside.external, world_->model.dimensions, world_->state.size());
  return {world_->outside.external, world_->state.size()};
}

void Simulation::watch(StepWatch* watch) {
  world_->outside.watch = watch;
}

std::vector<std::array<float, 3>> Simulation::target_places() const {
  std::vector<std::array<float, 3>> places;
  place_targets(world_->model, world_->state.step, places);
  return places;
}

std::vector<std::array<std::array<float, 3>, 2>> Simulation::index_boxes() const {
  const World& world = *world_;
  std::vector<std::array<std::array<float, 3>, 2>> out;
  if (!(world.model.reach > 0) || world.state.size() == 0) return out;
  const Cloud cloud = cloud_of(world.model, world.state);
  std::vector<std::uint32_t> order;
  std::vector<IndexBox> boxes;
  const auto index = make_index(world.model.index, cloud, world.model.reach);
  index->build(cloud, world.model.reach, world.workers, order);
  index->boxes(boxes);
  for (const IndexBox& box : boxes) out.push_back({box.min, box.max});
  return out;
}

Result<Explanation> Simulation::explain(std::uint64_t id) const {
  const FloatSettings settings;
  std::vector<std::string> rules;
  for (const auto& rule : world_->rules) rules.push_back(rule.first);
  const Explained explained{world_->model, world_->scenario, world_->outside, rules};
  return sturnus::explain(explained, world_->state, id, world_->workers);
}

void Simulation::poison_scratch() {
  poison(world_->scratch);
}

}  // namespace sturnus
