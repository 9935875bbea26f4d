// Where targets are at any time, by a closed form; how they come into a scenario and go.
#include "scenario/targets.h"

#include <algorithm>
#include <cmath>

#include "base/root.h"
#include "base/text.h"
#include "scenario/events.h"

namespace sturnus {
namespace {

// Folds a coordinate into [min, max] as a ball between two walls would go.
double folded(double at, double min, double max) {
  const double size = max - min;
  double inside = at - min;
  inside -= 2 * size * std::floor(inside / (2 * size));
  return min + (inside > size ? 2 * size - inside : inside);
}

// Exactly max, which rounding may give, is min.
float wrapped_place(double at, float min, float max) {
  const double size = double{max} - double{min};
  const auto inside = static_cast<float>(at - size * std::floor((at - double{min}) / size));
  return inside >= min && inside < max ? inside : min;
}

// On its way along a line it stays in the space, unless that has no edge.
double on_its_line(const Model& model, const TargetModel& target, std::size_t axis, double time) {
  const double at = target.at[axis] + target.velocity[axis] * time;
  if (model.boundary == BoundaryKind::open || model.wraps()) return at;
  return folded(at, double{model.min[axis]}, double{model.max[axis]});
}

std::array<double, 3> place_at(const Model& model, const TargetModel& target, double time) {
  std::array<double, 3> at = target.at;
  if (target.motion == TargetMotion::line) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimensions); ++axis)
      at[axis] = on_its_line(model, target, axis, time);
  }
  if (target.motion == TargetMotion::circle) {
    const double turns = time / target.period;
    const CosSin angle = cos_sin(2 * pi * (turns - std::floor(turns)));
    at[0] += target.circle * angle.cos;
    at[1] += target.circle * angle.sin;
  }
  return at;
}

// In double, by the nearest image.
double squared_between(const Model& model, const std::array<float, 3>& place, const EraseBoids& erase) {
  std::array<double, 3> o{};
  for (std::size_t axis = 0; axis < erase.at.size(); ++axis) {
    o[axis] = double{place[axis]} - erase.at[axis];
    const double size = model.size[axis];
    if (model.wraps()) o[axis] -= size * std::floor(o[axis] / size + 0.5);
  }
  o = beside(o, erase.along);
  return o[0] * o[0] + o[1] * o[1] + o[2] * o[2];
}

}  // namespace

void place_targets(const Model& model, std::uint64_t step, std::vector<std::array<float, 3>>& places) {
  places.resize(model.targets.size());
  const double time = static_cast<double>(step) * double{model.dt};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = place_at(model, model.targets[i], time);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool wraps = model.wraps() && axis < static_cast<std::size_t>(model.dimensions);
      places[i][axis] =
          wraps ? wrapped_place(at[axis], model.min[axis], model.max[axis]) : static_cast<float>(at[axis]);
    }
  }
}

void add_target(const PlaceTarget& placed, ScenarioDef& scenario) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(scenario.targets.begin(), scenario.targets.end(),
                       [&](const TargetDef& other) { return other.name == name; });
  };
  TargetDef target;
  target.name = "target";
  for (std::size_t number = 2; is_taken(target.name); ++number) target.name = say("target-", number);
  target.kind = placed.kind;
  target.at = placed.at;
  target.form = placed.form;
  target.weight = placed.weight;
  target.radius = placed.radius;
  scenario.targets.push_back(std::move(target));
}

bool erase_targets(const EraseBoids& erase, std::uint64_t step, ScenarioDef& scenario) {
  if (scenario.targets.empty()) return false;
  const Model model = compile(scenario);
  std::vector<std::array<float, 3>> places;
  place_targets(model, step, places);
  std::vector<TargetDef> kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (squared_between(model, places[i], erase) > erase.radius * erase.radius)
      kept.push_back(std::move(scenario.targets[i]));
  }
  const bool is_changed = kept.size() != places.size();
  scenario.targets = std::move(kept);
  return is_changed;
}

}  // namespace sturnus
