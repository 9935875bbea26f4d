// Compiles Reynolds' steering behaviours to terms and their numbers.
#include <algorithm>
#include <cmath>

#include "base/root.h"
#include "scenario/behaviours.h"

namespace sturnus {
namespace {

float number(double value) {
  return static_cast<float>(value);
}

std::array<float, 3> vector_of(const Coordinates& at) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < at.size(); ++axis) out[axis] = number(at[axis]);
  return out;
}

std::uint64_t bit_of(const ScenarioDef& scenario, const std::string& name) {
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    if (scenario.flocks[i].name == name) mask |= std::uint64_t{1} << i;
  }
  return mask;
}

PursuitModel compiled(const ScenarioDef& scenario, const Pursuit& def) {
  PursuitModel out;
  for (const std::string& name : def.of) out.flocks |= bit_of(scenario, name);
  out.prediction = def.prediction;
  out.amount = number(def.prediction == Prediction::constant ? def.time : def.per_length);
  out.radius_squared = number(def.radius) * number(def.radius);
  out.has_offset = !def.offset.empty();
  out.offset = vector_of(def.offset);
  out.slowing = number(def.slowing);
  return out;
}

HideModel compiled(const ScenarioDef& scenario, const Hide& def) {
  HideModel out;
  for (const std::string& name : def.from) out.flocks |= bit_of(scenario, name);
  out.radius_squared = number(def.radius) * number(def.radius);
  out.reach = number(def.reach);
  out.margin = number(def.margin);
  out.slowing = number(def.slowing);
  out.time = number(def.time);
  return out;
}

template <class Def>
LineModel line_of(const Def& def) {
  LineModel out;
  for (const Coordinates& point : def.points) out.corners.push_back(vector_of(point));
  out.is_loop = def.loop;
  out.radius = number(def.radius);
  out.ahead = number(def.ahead);
  out.time = number(def.time);
  return out;
}

LineModel compiled(const ScenarioDef&, const FollowPath& def) {
  return line_of(def);
}

LineModel compiled(const ScenarioDef&, const FollowWall& def) {
  LineModel out = line_of(def);
  out.distance = number(def.distance);
  return out;
}

FlowModel compiled(const ScenarioDef&, const FollowFlow& def) {
  return {def.kind,         vector_of(def.centre), vector_of(def.velocity), number(def.speed),
          number(def.core), number(def.rate),      number(def.time)};
}

LeaderModel compiled(const ScenarioDef& scenario, const FollowLeader& def) {
  return {bit_of(scenario, def.leader), number(def.distance), number(def.clearance), number(def.slowing)};
}

AvoidanceModel compiled(const ScenarioDef&, const AvoidCollisions& def) {
  return {number(def.radius), number(def.gap) * number(def.gap), number(def.time)};
}

QueueModel compiled(const ScenarioDef&, const Queue& def) {
  return {number(def.distance), number(cosine_of_degrees(def.angle / 2))};
}

}  // namespace

void compile_behaviours(const ScenarioDef& scenario, std::size_t own, FlockModel& out) {
  const auto add = [&](TermKind kind, const auto& def, auto& model) {
    if (!def || !def->on) return;
    model = compiled(scenario, *def);
    TermModel term;
    term.kind = kind;
    term.weight = number(def->weight);
    term.priority = def->priority;
    term.order = def->order;
    out.terms.push_back(term);
  };
  const FlockDef& def = scenario.flocks[own];
  BehavioursModel& models = out.behaviours;
  add(TermKind::pursue, def.pursue, models.pursue);
  add(TermKind::evade, def.evade, models.evade);
  add(TermKind::hide, def.hide, models.hide);
  add(TermKind::follow_path, def.follow_path, models.path);
  add(TermKind::follow_wall, def.follow_wall, models.wall);
  add(TermKind::flow, def.flow, models.flow);
  add(TermKind::follow_leader, def.follow_leader, models.leader);
  add(TermKind::avoid_collisions, def.avoid_collisions, models.avoidance);
  add(TermKind::queue, def.queue, models.queue);
}

void gather_behaviours(Model& model) {
  for (const FlockModel& flock : model.flocks) {
    const BehavioursModel& own = flock.behaviours;
    model.watched |= own.pursue.flocks | own.evade.flocks | own.leader.flocks | own.hide.flocks;
    model.obstacle_reach = std::max(model.obstacle_reach, own.hide.reach);
    const float reach = std::max(own.avoidance.radius, own.queue.distance);
    model.uses_lists |= reach > 0;
    model.reach = std::max(model.reach, reach);
  }
}

}  // namespace sturnus
