// Before anybody moves: whom each hunter sees, whom it has in focus, where that pulls it, and whether it
// jumps.
#include "base/hash.h"
#include "base/random.h"
#include "neighbours/query.h"
#include "rules/rules.h"
#include "step/prey.h"
#include "step/step.h"

namespace sturnus {
namespace {

// The looks and decisions of one hunter after the other.
template <int D>
class Hunting {
 public:
  Hunting(const Model& model, State& state, Scratch& scratch, std::vector<Span>& spans)
      : model_(model), state_(state), scratch_(scratch), spans_(spans), image_(image_of(model)) {}

  void look(std::size_t number) {
    const std::size_t i = scratch_.hunters.slots[number];
    const FlockModel& flock = model_.flocks[state_.flock[i]];
    put(scratch_.hunters.pull, number, Vec<D>{});
    if (!flock.hunt || is_full(model_, state_, i)) return;
    begin(i, *flock.hunt);
    if (flock.hunt->choose == HuntChoice::nearest) choose(i, flock);
    for_each_prey(i, *flock.hunt, flock, [&](const Prey<D>& prey, bool is_in_view) {
      if (is_in_view) add(prey, flock);
      if (flock.jump) is_near_ = is_near_ || is_seen(flock.jump->trigger, velocity_, speed_, prey);
    });
    if (chased_ > 0) {
      const Vec<D> toward = sum_ * (1.0f / static_cast<float>(chased_));
      put(scratch_.hunters.pull, number, chase(*flock.hunt, toward, velocity_, flock.max_speed));
    }
    if (flock.jump && is_near_) maybe_jump(i, *flock.jump);
  }

 private:
  void begin(std::size_t i, const HuntModel& hunt) {
    velocity_ = at<D>(state_.velocity, i);
    speed_ = length(velocity_);
    sum_ = {};
    chased_ = 0;
    is_near_ = false;
    focus_ = hunt.choose == HuntChoice::nearest ? state_.life.focus[i] : nobody;
  }

  // Everybody who is hunted and near enough to be seen or jumped at.
  template <class F>
  void for_each_prey(std::size_t i, const HuntModel& hunt, const FlockModel& flock, F&& f) {
    float reach_squared = hunt.sight.distance_squared;
    if (flock.jump) reach_squared = std::max(reach_squared, flock.jump->trigger.distance_squared);
    const auto ask = [&](std::size_t other) {
      if (!is_hunted(hunt, state_, other)) return;
      const Prey<D> prey = prey_at<D>(state_, i, other, image_);
      if (prey.distance_squared < reach_squared) f(prey, is_seen(hunt.sight, velocity_, speed_, prey));
    };
    if (!scratch_.is_indexed || !(reach_squared <= model_.reach * model_.reach)) {
      for (std::size_t other = 0; other < state_.size(); ++other) ask(other);
      return;
    }
    const std::array<float, 3> at_place = widened(at<D>(state_.position, i));
    scratch_.index->spans(at_place, at_place, model_.reach, spans_);
    for (const Span span : spans_) {
      for (std::uint32_t other = span.begin; other < span.end; ++other) ask(other);
    }
  }

  bool is_before(const Prey<D>& one, const Prey<D>& other) const {
    return one.distance_squared != other.distance_squared ? one.distance_squared < other.distance_squared
                                                          : state_.id[one.slot] < state_.id[other.slot];
  }

  // The nearest takes the focus when nobody has it, or when it is less than half as far as who has it.
  void choose(std::size_t i, const FlockModel& flock) {
    std::optional<Prey<D>> nearest, held;
    std::size_t in_view = 0;
    for_each_prey(i, *flock.hunt, flock, [&](const Prey<D>& prey, bool is_in_view) {
      if (!is_in_view) return;
      ++in_view;
      if (!nearest || is_before(prey, *nearest)) nearest = prey;
      if (state_.id[prey.slot] == focus_) held = prey;
    });
    if (!nearest) {
      focus_ = nobody;
    } else if (!held || nearest->distance_squared < 0.25f * held->distance_squared) {
      focus_ = state_.id[nearest->slot];
    }
    if (in_view > 1 && flock.hunt->confusion > 0) maybe_slip(i, flock, in_view);
    state_.life.focus[i] = focus_;
  }

  // To another prey in view, each equally likely, in whatever order they are met.
  void maybe_slip(std::size_t i, const FlockModel& flock, std::size_t in_view) {
    Draws draws(model_.seed, state_.step, state_.id[i], Stream::confusion);
    if (!(draws.uniform() < flock.hunt->confusion * static_cast<float>(in_view) * model_.dt)) return;
    const std::uint64_t salt = draws.bits();
    std::uint64_t least = nobody;
    std::uint64_t other = focus_;
    for_each_prey(i, *flock.hunt, flock, [&](const Prey<D>& prey, bool is_in_view) {
      const std::uint64_t id = state_.id[prey.slot];
      const std::uint64_t lot = fold(mix(salt + 1), id);
      if (!is_in_view || id == focus_ || lot >= least) return;
      least = lot;
      other = id;
    });
    focus_ = other;
  }

  void add(const Prey<D>& prey, const FlockModel& flock) {
    if (flock.hunt->choose == HuntChoice::nearest && state_.id[prey.slot] != focus_) return;
    sum_ += aimed(*flock.hunt, prey.offset, at<D>(state_.velocity, prey.slot), flock.max_speed);
    ++chased_;
  }

  void maybe_jump(std::size_t i, const JumpModel& jump) {
    if (state_.life.jump[i] > 0 || state_.life.rest[i] > 0 || !(speed_ > 0)) return;
    state_.life.jump[i] = jump.duration;
  }

  const Model& model_;
  State& state_;
  Scratch& scratch_;
  std::vector<Span>& spans_;
  Wrapping image_;
  Vec<D> velocity_, sum_;
  float speed_ = 0;
  std::size_t chased_ = 0;
  bool is_near_ = false;
  std::uint64_t focus_ = nobody;
};

void find_hunters(const Model& model, const State& state, Scratch& scratch) {
  std::vector<std::uint32_t>& slots = scratch.hunters.slots;
  slots.clear();
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (model.flocks[state.flock[i]].is_hunter && state.quarantined[i] == 0)
      slots.push_back(static_cast<std::uint32_t>(i));
  }
  fit(scratch.hunters.pull, model.dimensions, slots.size());
}

// The farthest that anybody asks for food.
void find_food(const Model& model, const State& state, Scratch& scratch) {
  float reach = 0;
  for (const FlockModel& flock : model.flocks) {
    if (!flock.feed) continue;
    const float touch = flock.body_radius + model.food[flock.feed->kind].body_radius;
    reach = std::max(reach, std::max(touch, flock.feed->radius));
  }
  scratch.pieces.build(state.food, model.dimensions, image_of(model), model.min, reach);
}

template <int D>
void hunt_in(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  scratch.parts.resize(static_cast<std::size_t>(workers.count()));
  workers.for_ranges(scratch.hunters.slots.size(), [&](std::size_t begin, std::size_t end, int part) {
    Hunting<D> hunting(model, state, scratch, scratch.parts[static_cast<std::size_t>(part)].kernel.spans);
    for (std::size_t number = begin; number < end; ++number) hunting.look(number);
  });
}

}  // namespace

void look_around(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  if (model.has_feeders) find_food(model, state, scratch);
  if (!model.has_hunters) return;
  find_hunters(model, state, scratch);
  model.dimensions == 3 ? hunt_in<3>(model, state, scratch, workers)
                        : hunt_in<2>(model, state, scratch, workers);
}

}  // namespace sturnus
