// Steps, deeds and their undoing.
#include "session/world.h"

#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <chrono>

#include "session/events.h"
#include "session/packing.h"

namespace studio {
namespace {

using sturnus::Command;
using sturnus::SetParameter;
using sturnus::Simulation;
using sturnus::Status;

// A quarter of the history's memory is for the moments before deeds.
constexpr std::size_t deeds_share = 4;
// And this part of it for the past of each world that was set aside.
constexpr std::size_t aside_share = 32;
// A simulation with its working memory takes about so many times its state.
constexpr std::size_t working_memory = 4;

}  // namespace

World::World(Simulation simulation, std::size_t history_bytes)
    : history_bytes_(history_bytes), now_(std::move(simulation), history_bytes) {}

void World::step() {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  now_.simulation.step();
  step_seconds_ = std::chrono::duration<double>(Clock::now() - begin).count();
  now_.last = std::max(now_.last, now_.simulation.step_number());
  scenario_ = nullptr;
  now_.history.follow(now_.simulation);
}

Status World::act(const Command& command, const std::string& label, std::uint64_t gesture) {
  const std::optional<Change> change = change_of(command);
  const bool was_past = is_past();
  const bool is_new = !label.empty() && (was_past || !goes_on(change.has_value(), gesture));
  Deed deed;
  deed.label = label;
  deed.gesture = gesture;
  deed.step = now_.simulation.step_number();
  if (is_new && (!change || was_past)) keep_moment(deed);
  if (const Status status = now_.simulation.push(command); !status) return status;
  if (was_past && !std::holds_alternative<sturnus::MovePointer>(command)) let_go();
  begin_future(now_.simulation.step_number());
  if (is_new) remember(std::move(deed));
  if (!label.empty() && change) add(*change, undo_.back());
  return {};
}

// Forgets what was known of the steps from this one on, as it was before.
void World::begin_future(std::uint64_t step) {
  scenario_ = nullptr;
  way_to_.reset();
  now_.last = now_.simulation.step_number();
  now_.history.cut(step);
  now_.history.amend(now_.simulation);
}

// A hand that held the pointer in what is now the past holds it no longer.
void World::let_go() {
  if (!now_.simulation.view().state().pointer.pressed) return;
  const auto done = done_by_hand(now_.simulation.recording().run.events, now_.events);
  const auto held = std::find_if(done.rbegin(), done.rend(), [&](const sturnus::Event& event) {
    return event.step <= now_.simulation.step_number() &&
           std::holds_alternative<sturnus::MovePointer>(event.command);
  });
  if (held == done.rend()) return;
  sturnus::MovePointer off = std::get<sturnus::MovePointer>(held->command);
  off.pressed = false;
  off.along.clear();
  static_cast<void>(now_.simulation.push(off));
}

// What a command does to a parameter that has a value which can be put back.
std::optional<World::Change> World::change_of(const Command& command) const {
  const auto* set = std::get_if<SetParameter>(&command);
  if (set == nullptr) return {};
  const auto before = sturnus::get_parameter(now_.simulation.scenario(), set->path);
  if (!before || before->empty()) return {};
  return Change{set->path, *before, set->value};
}

bool World::goes_on(bool is_change, std::uint64_t gesture) const {
  if (gesture == 0 || undo_.empty() || undo_.back().gesture != gesture) return false;
  return is_change || undo_.back().moment.has_value();
}

// Of one parameter only the first value before and the last one after count.
void World::add(const Change& change, Deed& deed) {
  if (deed.moment) return;
  for (Change& known : deed.changes) {
    if (known.path != change.path) continue;
    known.after = change.after;
    return;
  }
  deed.changes.push_back(change);
}

void World::remember(Deed deed) {
  redo_.clear();
  undo_.push_back(std::move(deed));
  while (undo_.size() > 1 && bytes_of_deeds() > history_bytes_ / deeds_share) undo_.erase(undo_.begin());
}

std::size_t World::bytes_of_deeds() const {
  const std::size_t moment = size_of(now_.simulation.view().state());
  std::size_t bytes = 0;
  for (const Deed& deed : undo_) {
    bytes += deed.moment ? moment : 0;
    if (deed.other)
      bytes += deed.other->history.bytes() + working_memory * size_of(deed.other->simulation.view().state());
  }
  return bytes;
}

void World::keep_moment(Deed& deed) const {
  deed.moment = now_.simulation.snapshot();
  deed.last = now_.last;
  deed.first = now_.history.front();
}

// Every parameter of a deed, the last one first. A deed that lies ahead is taken back where it was done.
bool World::put_back(const Deed& deed, Deed& back) {
  const bool was_past = is_past();
  if (was_past) keep_moment(back);
  while (now_.simulation.step_number() < deed.step && !go_to(deed.step)) {
  }
  back.step = now_.simulation.step_number();
  bool all = true;
  for (auto change = deed.changes.rbegin(); change != deed.changes.rend(); ++change) {
    all = static_cast<bool>(now_.simulation.push(SetParameter{change->path, change->before})) && all;
    if (!was_past) back.changes.push_back({change->path, change->after, change->before});
  }
  begin_future(back.step);
  return all;
}

// To the moment that the deed kept, with the future that it had.
void World::go_back(const Deed& deed, Deed& back) {
  keep_moment(back);
  back.step = deed.step;
  now_.simulation.restore(*deed.moment, sturnus::Later::as_then);
  if (now_.simulation.step_number() == deed.last) let_go();
  if (now_.simulation.step_number() < now_.history.first()) now_.history.start(now_.simulation);
  begin_future(deed.step > 0 ? deed.step - 1 : 0);
  now_.last = std::max(now_.last, deed.last);
  if (now_.simulation.step_number() != now_.history.first()) now_.history.set_front(*deed.first);
  jumped();
}

// Takes the last deed of one list back, with those of the same gesture.
bool World::take_back(std::vector<Deed>& from, std::vector<Deed>& to) {
  if (from.empty()) return false;
  const std::uint64_t gesture = from.back().gesture;
  bool done = take_one_back(from, to);
  while (done && gesture != 0 && !from.empty() && from.back().gesture == gesture)
    done = take_one_back(from, to);
  return done;
}

// Puts what leads here again into the other list.
bool World::take_one_back(std::vector<Deed>& from, std::vector<Deed>& to) {
  Deed deed = std::move(from.back());
  from.pop_back();
  Deed back;
  back.label = deed.label;
  back.gesture = deed.gesture;
  if (deed.other) {
    back.other = set_aside(std::move(*deed.other));
  } else if (deed.moment) {
    go_back(deed, back);
  } else if (!put_back(deed, back)) {
    return false;
  }
  scenario_ = nullptr;
  to.push_back(std::move(back));
  return true;
}

void World::jumped() {
  ++generation_;
  scenario_ = nullptr;
  way_to_.reset();
}

bool World::go_to(std::uint64_t step) {
  const std::uint64_t wanted =
      std::clamp(step, now_.history.first(), std::max(now_.history.first(), now_.last));
  if (way_to_ != wanted) {
    const std::uint64_t now = now_.simulation.step_number();
    const sturnus::Snapshot& moment = now_.history.before(wanted);
    if (wanted < now || moment.step() > now) now_.simulation.restore(moment);
    jumped();
    way_to_ = wanted;
  }
  if (now_.simulation.step_number() < wanted) now_.simulation.step();
  scenario_ = nullptr;
  if (now_.simulation.step_number() < wanted) return false;
  way_to_.reset();
  return true;
}

// A world that is set aside keeps some of its past.
std::shared_ptr<Timeline> World::set_aside(Timeline next) {
  auto old = std::make_shared<Timeline>(std::move(now_));
  now_ = std::move(next);
  if (now_.number == 0) now_.number = ++worlds_;
  old->history.shrink(history_bytes_ / aside_share);
  jumped();
  return old;
}

void World::replace(Simulation simulation, const std::string& label, const std::string& watched) {
  Timeline next(std::move(simulation), history_bytes_);
  next.watched = watched;
  Deed deed;
  deed.label = label;
  deed.other = set_aside(std::move(next));
  remember(std::move(deed));
}

std::vector<std::shared_ptr<const Timeline>> World::others() const {
  std::vector<std::shared_ptr<const Timeline>> out;
  for (const auto* deeds : {&undo_, &redo_}) {
    for (const Deed& deed : *deeds) {
      if (deed.other) out.push_back(deed.other);
    }
  }
  return out;
}

void World::watch(const std::string& file, const sturnus::ScenarioDef& read) {
  now_.watched = file;
  set_read(read);
}

void World::set_read(const sturnus::ScenarioDef& read) {
  now_.read = std::make_shared<const sturnus::ScenarioDef>(read);
}

// The same scenario once more: nothing new was opened, and who is followed and which file stay.
void World::begin_again(Timeline next, const std::string& label) {
  next.opened = now_.opened;
  next.read = now_.read;
  next.watched = now_.watched;
  next.tracked = now_.tracked;
  Deed deed;
  deed.label = label;
  deed.other = set_aside(std::move(next));
  remember(std::move(deed));
}

Status World::restart(std::int64_t seed) {
  sturnus::ScenarioDef scenario = arranged();
  scenario.seed = seed;
  auto fresh = sturnus::open_simulation(scenario, now_.simulation.threads());
  if (!fresh) return fresh.problems();
  begin_again(Timeline(std::move(*fresh), history_bytes_), "restart");
  return {};
}

Status World::extend(const std::string& label, const std::function<void(sturnus::ScenarioDef&)>& add) {
  sturnus::ScenarioDef base = arranged(), opened = *now_.opened, here = continued(now_);
  for (sturnus::ScenarioDef* scenario : {&base, &opened, &here}) add(*scenario);
  const auto start = std::make_shared<sturnus::State>(now_.simulation.view().state());
  // A table of nobody has no line that could tell which numbers are taken.
  if (start->size() == 0 && start->food.size() == 0) start->next_id = 0;
  sturnus::SimulationOptions options;
  options.threads = now_.simulation.threads();
  options.tables = {{here.run.initial, *start}};
  auto begun = Simulation::create(here, options);
  if (!begun) return begun.problems();
  begin_again(Timeline(std::move(*begun), history_bytes_), label);
  now_.base = std::make_shared<const sturnus::ScenarioDef>(std::move(base));
  now_.opened = std::make_shared<const sturnus::ScenarioDef>(std::move(opened));
  now_.start = start;
  return {};
}

void World::track_any() {
  const sturnus::View view = now_.simulation.view();
  if (view.size() == 0) return;
  const std::uint64_t pick = view.step() + 2654435761u * ++picks_ + 12345u;
  auto slot = static_cast<std::size_t>(pick % view.size());
  if (picks_ > 1 && view.id(slot) == picked_) slot = (slot + 1) % view.size();
  now_.tracked = picked_ = view.id(slot);
}

void World::track_next(int direction) {
  const sturnus::View view = now_.simulation.view();
  const std::vector<std::uint32_t> slots = view.slots_by_id();
  if (slots.empty()) return now_.tracked.reset();
  const std::uint64_t id = now_.tracked.value_or(0);
  const auto at =
      std::lower_bound(slots.begin(), slots.end(), id,
                       [&](std::uint32_t slot, std::uint64_t value) { return view.id(slot) < value; });
  std::ptrdiff_t place = at - slots.begin();
  const auto count = static_cast<std::ptrdiff_t>(slots.size());
  const bool is_there = at != slots.end() && view.id(*at) == id;
  if (direction < 0 || is_there) place += direction;
  now_.tracked = view.id(slots[static_cast<std::size_t>((place % count + count) % count)]);
}

void World::keep_tracked() {
  if (now_.tracked && !now_.simulation.view().slot(*now_.tracked)) track_next(1);
}

void World::show(Frame& frame) {
  if (!scenario_) scenario_ = std::make_shared<const sturnus::ScenarioDef>(now_.simulation.scenario());
  keep_tracked();
  pack(now_.simulation, frame);
  frame.generation = generation_;
  frame.scenario = scenario_;
  frame.opened = now_.opened;
  frame.watched = now_.watched;
  frame.step_seconds = step_seconds_;
  frame.reach = {now_.history.first(), now_.last, undo_.empty() ? "" : undo_.back().label,
                 redo_.empty() ? "" : redo_.back().label};
  frame.tracked.reset();
  frame.explained.reset();
  if (now_.tracked) {
    if (auto told = now_.simulation.explain(*now_.tracked)) frame.explained = std::move(*told);
    if (const auto slot = now_.simulation.view().slot(*now_.tracked)) frame.tracked = *slot;
  }
  frame.index_boxes.clear();
  if (wishes_.index) frame.index_boxes = now_.simulation.index_boxes();
  if (!wishes_.neighbours) return;
  const std::vector<std::uint32_t> counts = sturnus::neighbour_counts(now_.simulation.view());
  for (std::size_t slot = 0; slot < counts.size(); ++slot)
    frame.boids[slot].crowd = static_cast<std::uint8_t>(std::min(counts[slot], 255u));
}

Sample World::sample(double link) const {
  Sample sample;
  const sturnus::View view = now_.simulation.view();
  sample.generation = generation_;
  sample.measures = sturnus::measure(view, link);
  sample.population.assign(view.scenario().flocks.size(), 0);
  for (const std::uint8_t flock : view.state().flock) ++sample.population[flock];
  sample.food = view.state().food.size();
  sample.step_seconds = step_seconds_;
  return sample;
}

}  // namespace studio
