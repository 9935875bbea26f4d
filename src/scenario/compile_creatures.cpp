// Compiles what hunters and feeders do.
#include <algorithm>

#include "base/root.h"
#include "scenario/creatures.h"

namespace sturnus {
namespace {

std::uint64_t mask_of(const ScenarioDef& scenario, const std::vector<std::string>& names) {
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    if (std::find(names.begin(), names.end(), scenario.flocks[i].name) != names.end())
      mask |= std::uint64_t{1} << i;
  }
  return mask;
}

SightModel sight_of(double distance, double view) {
  const auto reach = static_cast<float>(distance);
  return {reach * reach, static_cast<float>(cosine_of_degrees(view / 2)), view >= 360};
}

template <class Def>
TermModel term_of(TermKind kind, const Def& def) {
  TermModel out;
  out.kind = kind;
  out.weight = static_cast<float>(def.weight);
  out.priority = def.priority;
  out.order = def.order;
  return out;
}

void compile_hunt(const ScenarioDef& scenario, const FlockDef& flock, FlockModel& out) {
  const Hunt& hunt = *flock.hunt;
  if (!hunt.on) return;
  HuntModel model;
  model.prey = mask_of(scenario, hunt.prey);
  model.sight = sight_of(hunt.sight, hunt.field_of_view.value_or(flock.field_of_view));
  model.choose = hunt.choose;
  model.aim = hunt.aim;
  model.time = static_cast<float>(hunt.time);
  model.factor = static_cast<float>(hunt.factor);
  model.confusion = static_cast<float>(hunt.confusion);
  out.hunt = model;
  out.terms.push_back(term_of(TermKind::hunt, hunt));
}

void compile_jump(const FlockDef& flock, FlockModel& out) {
  const Jump& jump = *flock.jump;
  if (!jump.on) return;
  const bool cruises = flock.cruise && flock.cruise->on;
  JumpModel model;
  model.speed = static_cast<float>(jump.speed);
  model.end_speed = static_cast<float>(std::min(jump.speed, cruises ? flock.cruise->speed : flock.max_speed));
  model.duration = jump.duration;
  model.cooldown = jump.cooldown;
  model.trigger = sight_of(jump.distance, jump.field_of_view);
  out.jump = model;
}

void compile_feed(const ScenarioDef& scenario, const Feed& feed, FlockModel& out) {
  std::size_t kind = 0;
  while (scenario.food[kind].name != feed.on) ++kind;
  out.feed = FeedModel{static_cast<std::uint8_t>(kind), static_cast<float>(feed.radius), feed.form,
                       static_cast<std::size_t>(feed.births)};
  out.terms.push_back(term_of(TermKind::feed, feed));
}

}  // namespace

std::int64_t population_cap(const FlockDef& flock) {
  if (!flock.feed) return flock.count;
  return flock.feed->population_cap > 0 ? flock.feed->population_cap : 4 * flock.count;
}

void compile_creature(const ScenarioDef& scenario, std::size_t own, FlockModel& out) {
  const FlockDef& flock = scenario.flocks[own];
  out.body_radius = static_cast<float>(flock.body_radius);
  out.is_hunter = flock.hunt.has_value();
  if (flock.hunt) compile_hunt(scenario, flock, out);
  if (flock.jump) compile_jump(flock, out);
  if (flock.hunger) out.hunger = HungerModel{flock.hunger->full_for, flock.hunger->starves_after};
  if (flock.feed) compile_feed(scenario, *flock.feed, out);
  out.population_cap = static_cast<std::size_t>(population_cap(flock));
}

void compile_life(const ScenarioDef& scenario, Model& model) {
  for (const FlockDef& flock : scenario.flocks) {
    model.has_hunters |= flock.hunt.has_value();
    model.has_feeders |= flock.feed.has_value();
    model.uses_hunger |= flock.hunger.has_value();
    model.uses_jump |= flock.jump.has_value();
    model.uses_focus |= flock.hunt && flock.hunt->choose == HuntChoice::nearest;
  }
  for (const FoodDef& food : scenario.food) {
    model.food.push_back({static_cast<float>(food.body_radius), food.random.every,
                          static_cast<std::size_t>(food.random.count),
                          static_cast<std::size_t>(food.random.most)});
  }
}

}  // namespace sturnus
