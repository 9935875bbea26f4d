// Who eats whom, who starves, who is born: all in order of id, so that nothing depends on threads.
#include "step/life.h"

#include <algorithm>
#include <cmath>

#include "neighbours/offset.h"
#include "rules/rules.h"
#include "step/moved.h"
#include "world/columns.h"
#include "world/solid_body.h"
#include "world/spawn.h"
#include "world/state.h"

namespace sturnus {
namespace {

// A clock with less than this share of a step left has run out: sums of dt are not exact.
constexpr double rounding = 1e-3;

bool has_life(const Model& model) {
  return model.has_hunters || model.has_feeders || !model.food.empty();
}

// Runs down to 0; true when it gets there in this step.
bool run_down(double& clock, double tick) {
  if (!(clock > 0)) return false;
  clock -= tick;
  if (clock > rounding * tick) return false;
  clock = 0;
  return true;
}

void run_clocks(const Model& model, State& state, const Hunters& hunters) {
  Life& life = state.life;
  for (const std::uint32_t i : hunters.slots) {
    const FlockModel& flock = model.flocks[state.flock[i]];
    if (flock.hunger) {
      run_down(life.full[i], model.tick);
      life.fasting[i] += model.tick;
    }
    if (!flock.jump) continue;
    run_down(life.rest[i], model.tick);
    if (run_down(life.jump[i], model.tick)) life.rest[i] = flock.jump->cooldown;
  }
}

// Who is touched by whom, at the places after the motion.
template <int D>
class Bodies {
 public:
  Bodies(const Model& model, const State& state, Scratch& scratch, const Moved<D>& moved)
      : model_(model),
        state_(state),
        parts_(scratch.parts),
        alive_(scratch.life.alive),
        moved_(moved),
        image_(image_of(model)) {}

  bool is_hungry(std::size_t i) const {
    if (state_.quarantined[i] != 0 || alive_[i] == 0 || !model_.flocks[state_.flock[i]].hunt) return false;
    return !model_.flocks[state_.flock[i]].hunger || !(state_.life.full[i] > 0);
  }

  bool feeds(std::size_t i) const {
    return model_.flocks[state_.flock[i]].feed && state_.quarantined[i] == 0 && alive_[i] != 0;
  }

  /// The nearest living prey that a hunter touches, the lowest id of equally near ones. `part` says whose
  /// memory to work in.
  std::optional<std::size_t> prey_of(std::size_t hunter, int part) const {
    const FlockModel& own = model_.flocks[state_.flock[hunter]];
    const auto place = at<D>(state_.position, hunter);
    std::optional<std::size_t> best;
    float least = 0;
    moved_.visit(place, longest_touch(own), spans_of(part), [&](std::size_t i) {
      if ((own.hunt->prey >> state_.flock[i] & 1) == 0 || alive_[i] == 0 || state_.quarantined[i] != 0)
        return;
      const Vec<D> o = offset(place, at<D>(state_.position, i), image_);
      const float touch = own.body_radius + model_.flocks[state_.flock[i]].body_radius;
      const float d2 = dot(o, o);
      if (!(d2 <= touch * touch)) return;
      if (best && !(d2 < least || (d2 == least && state_.id[i] < state_.id[*best]))) return;
      best = i;
      least = d2;
    });
    return best;
  }

  /// The same for a piece of food.
  std::optional<std::size_t> piece_of(std::size_t feeder, const Pieces& pieces,
                                      const std::vector<std::uint8_t>& uneaten) const {
    const FlockModel& own = model_.flocks[state_.flock[feeder]];
    std::optional<std::size_t> best;
    float least = 0;
    pieces.visit<D>(
        at<D>(state_.position, feeder), touch_of(own),
        [&](std::uint32_t piece, std::uint8_t kind, const Vec<D>& o) {
          const float d2 = dot(o, o);
          if (kind != own.feed->kind || uneaten[piece] == 0) return;
          if (best && !(d2 < least || (d2 == least && state_.food.id[piece] < state_.food.id[*best]))) return;
          best = piece;
          least = d2;
        });
    return best;
  }

  /// Whether it is less work to ask every piece who touches it than every boid for pieces.
  bool asks_pieces() const {
    if (state_.food.size() > state_.size() / 4) return false;
    for (const FlockModel& flock : model_.flocks) {
      if (flock.feed && !moved_.can_ask(touch_of(flock))) return false;
    }
    return true;
  }

  /// Calls f(slot) for everybody who touches a piece of his food.
  template <class F>
  void visit_feeders(std::size_t piece, int part, F&& f) const {
    float longest = 0;
    for (const FlockModel& flock : model_.flocks) {
      if (flock.feed && flock.feed->kind == state_.food.kind[piece])
        longest = std::max(longest, touch_of(flock));
    }
    const auto place = at<D>(state_.food.position, piece);
    moved_.visit(place, longest, spans_of(part), [&](std::size_t i) {
      if (!feeds(i)) return;
      const FlockModel& own = model_.flocks[state_.flock[i]];
      if (own.feed->kind != state_.food.kind[piece]) return;
      const Vec<D> o = offset(at<D>(state_.position, i), place, image_);
      if (dot(o, o) <= touch_of(own) * touch_of(own)) f(i);
    });
  }

 private:
  float touch_of(const FlockModel& feeder) const {
    return feeder.body_radius + model_.food[feeder.feed->kind].body_radius;
  }
  float longest_touch(const FlockModel& hunter) const {
    float longest = 0;
    for (const FlockModel& prey : model_.flocks) longest = std::max(longest, prey.body_radius);
    return hunter.body_radius + longest;
  }
  std::vector<Span>& spans_of(int part) const { return parts_[static_cast<std::size_t>(part)].kernel.spans; }

  const Model& model_;
  const State& state_;
  std::vector<PartScratch>& parts_;
  const std::vector<std::uint8_t>& alive_;
  const Moved<D>& moved_;
  Wrapping image_;
};

void sort_by_id(const State& state, std::vector<std::uint32_t>& slots) {
  std::sort(slots.begin(), slots.end(),
            [&](std::uint32_t a, std::uint32_t b) { return state.id[a] < state.id[b]; });
}

// Those of `count` for whom asks(number, part) holds, by id: asked on all threads, gathered on one.
template <class Slot, class Asks>
void gather_eaters(const State& state, LifeScratch& scratch, std::size_t count, Slot&& slot, Asks&& asks,
                   const Workers& workers) {
  scratch.touches.resize(count);
  workers.for_ranges(count, [&](std::size_t begin, std::size_t end, int part) {
    for (std::size_t number = begin; number < end; ++number)
      scratch.touches[number] = asks(slot(number), part) ? 1 : 0;
  });
  scratch.eaters.clear();
  for (std::size_t number = 0; number < count; ++number) {
    if (scratch.touches[number] != 0) scratch.eaters.push_back(static_cast<std::uint32_t>(slot(number)));
  }
  sort_by_id(state, scratch.eaters);
}

// The same for all who touch food, by asking the food.
template <int D>
void gather_feeders(const State& state, const Bodies<D>& bodies, Scratch& scratch, const Workers& workers) {
  for (PartScratch& part : scratch.parts) part.eaters.clear();
  workers.for_ranges(state.food.size(), [&](std::size_t begin, std::size_t end, int part) {
    std::vector<std::uint32_t>& eaters = scratch.parts[static_cast<std::size_t>(part)].eaters;
    for (std::size_t piece = begin; piece < end; ++piece)
      bodies.visit_feeders(piece, part,
                           [&](std::size_t i) { eaters.push_back(static_cast<std::uint32_t>(i)); });
  });
  std::vector<std::uint32_t>& all = scratch.life.eaters;
  all.clear();
  for (const PartScratch& part : scratch.parts) all.insert(all.end(), part.eaters.begin(), part.eaters.end());
  sort_by_id(state, all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

template <int D>
void eat_prey(const Model& model, State& state, Scratch& scratch, const Bodies<D>& bodies, StepReport& report,
              const Workers& workers) {
  LifeScratch& life = scratch.life;
  const std::vector<std::uint32_t>& hunters = scratch.hunters.slots;
  gather_eaters(
      state, life, hunters.size(), [&](std::size_t number) { return hunters[number]; },
      [&](std::size_t i, int part) { return bodies.is_hungry(i) && bodies.prey_of(i, part); }, workers);
  for (const std::uint32_t i : life.eaters) {
    if (!bodies.is_hungry(i)) continue;  // was itself eaten
    const auto prey = bodies.prey_of(i, 0);
    if (!prey) continue;
    life.alive[*prey] = 0;
    ++report.eaten;
    const auto& hunger = model.flocks[state.flock[i]].hunger;
    if (!hunger) continue;
    state.life.fasting[i] = 0;
    state.life.full[i] = hunger->full_for;
  }
}

void starve(const Model& model, const State& state, Scratch& scratch, StepReport& report) {
  for (const std::uint32_t i : scratch.hunters.slots) {
    const auto& hunger = model.flocks[state.flock[i]].hunger;
    if (!hunger || state.quarantined[i] != 0 || scratch.life.alive[i] == 0) continue;
    if (!(state.life.fasting[i] > hunger->starves_after - rounding * model.tick)) continue;
    scratch.life.alive[i] = 0;
    ++report.starved;
  }
}

template <int D>
void eat_food(State& state, Scratch& scratch, const Bodies<D>& bodies, const Workers& workers) {
  LifeScratch& life = scratch.life;
  life.meals.clear();
  life.uneaten.assign(state.food.size(), 1);
  if (state.food.size() == 0) return;
  if (bodies.asks_pieces()) {
    gather_feeders(state, bodies, scratch, workers);
  } else {
    gather_eaters(
        state, life, state.size(), [](std::size_t i) { return i; },
        [&](std::size_t i, int) {
          return bodies.feeds(i) && bodies.piece_of(i, scratch.pieces, life.uneaten).has_value();
        },
        workers);
  }
  for (const std::uint32_t i : life.eaters) {
    const auto piece = bodies.piece_of(i, scratch.pieces, life.uneaten);
    if (!piece) continue;
    life.uneaten[*piece] = 0;
    life.meals.push_back({widened(at<D>(state.food.position, *piece)), widened(at<D>(state.position, i)),
                          std::size_t{state.flock[i]}});
  }
}

void bury(State& state, Scratch& scratch) {
  const auto is_gone = [](const std::vector<std::uint8_t>& marks) {
    return std::find(marks.begin(), marks.end(), 0) != marks.end();
  };
  if (is_gone(scratch.life.alive)) {
    keep(state, scratch.life.alive);
    keep(scratch.previous_position, scratch.life.alive);
    keep(scratch.previous_velocity, scratch.life.alive);
  }
  if (is_gone(scratch.life.uneaten)) keep(state.food, scratch.life.uneaten);
}

void count_members(const Model& model, const State& state, std::vector<std::size_t>& members) {
  members.assign(model.flocks.size(), 0);
  for (const std::uint8_t flock : state.flock) ++members[flock];
}

// A newborn comes from where its eater stands: at an edge and at solid obstacles its way ends as a motion
// does.
template <int D>
void settle_newborn(const Model& model, const ObstacleIndex& obstacles, const Meal& meal, State& state) {
  const std::size_t slot = state.size() - 1;
  auto position = at<D>(state.position, slot);
  auto velocity = at<D>(state.velocity, slot);
  keep_inside(model, position, velocity);
  if (model.is_solid && !obstacles.empty()) {
    const Solids<D> solids(model, obstacles, model.flocks[meal.flock].body_radius);
    solids.keep_out(narrow_to<D>(meal.eater), position, velocity);
  }
  put(state.position, slot, position);
  put(state.velocity, slot, velocity);
}

// A newborn has not moved yet.
void note_newborn(const State& state, Scratch& scratch) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (state.position[axis].empty()) continue;
    scratch.previous_position[axis].push_back(state.position[axis].back());
    scratch.previous_velocity[axis].push_back(state.velocity[axis].back());
  }
}

template <int D>
void give_birth(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
                StepReport& report) {
  LifeScratch& life = scratch.life;
  if (life.meals.empty()) return;
  count_members(model, state, life.members);
  for (const Meal& meal : life.meals) {
    const std::size_t flock = meal.flock;
    const FlockModel& own = model.flocks[flock];
    const float beside = own.body_radius + model.food[own.feed->kind].body_radius;
    for (std::size_t birth = 0; birth < own.feed->births; ++birth) {
      if (life.members[flock] >= own.population_cap) {
        ++report.births_refused;
        continue;
      }
      spawn_beside(scenario, model, flock, meal.place, beside, state);
      settle_newborn<D>(model, scratch.obstacles, meal, state);
      note_newborn(state, scratch);
      ++life.members[flock];
      ++report.born;
    }
  }
}

// New pieces wherever a multiple of the period was passed, while there is room for them.
void lay_out_food(const Model& model, const ScenarioDef& scenario, const ObstacleIndex& obstacles,
                  State& state) {
  const auto periods = [&](std::uint64_t steps, double every) {
    return std::floor((static_cast<double>(steps) + rounding) * model.tick / every);
  };
  for (std::size_t kind = 0; kind < model.food.size(); ++kind) {
    const FoodModel& food = model.food[kind];
    if (!(food.every > 0)) continue;
    const double due = periods(state.step + 1, food.every) - periods(state.step, food.every);
    if (!(due > 0)) continue;
    const auto there =
        static_cast<std::size_t>(std::count(state.food.kind.begin(), state.food.kind.end(), kind));
    const std::size_t room = food.most > there ? food.most - there : 0;
    const double wanted = due * static_cast<double>(food.count);
    const bool fits = wanted < static_cast<double>(room);
    spawn_food(scenario, model, kind, fits ? static_cast<std::size_t>(wanted) : room, obstacles, state);
  }
}

template <int D>
void live_in(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
             StepReport& report, const Workers& workers) {
  scratch.life.alive.assign(state.size(), 1);
  scratch.life.uneaten.assign(state.food.size(), 1);
  scratch.life.meals.clear();
  if (model.has_hunters || model.has_feeders) {
    const Moved<D> moved(model, state, scratch, workers);
    const Bodies<D> bodies(model, state, scratch, moved);
    if (model.has_hunters) {
      run_clocks(model, state, scratch.hunters);
      eat_prey<D>(model, state, scratch, bodies, report, workers);
      starve(model, state, scratch, report);
    }
    if (model.has_feeders) eat_food<D>(state, scratch, bodies, workers);
  }
  bury(state, scratch);
  give_birth<D>(model, scenario, state, scratch, report);
  lay_out_food(model, scenario, scratch.obstacles, state);
}

}  // namespace

void live(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch, StepReport& report,
          const Workers& workers) {
  if (!has_life(model)) return;
  model.dimensions == 3 ? live_in<3>(model, scenario, state, scratch, report, workers)
                        : live_in<2>(model, scenario, state, scratch, report, workers);
}

}  // namespace sturnus
