// Compiles a scenario to a Model: rows of data for the kernel, terms in order, everything in float.
#include <algorithm>
#include <cmath>

#include "base/root.h"
#include "scenario/behaviours.h"
#include "scenario/creatures.h"
#include "scenario/model.h"

namespace sturnus {
namespace {

std::uint64_t mask_of(const ScenarioDef& scenario, const Whose& whose, std::size_t own) {
  if (whose.kind == Whose::Kind::own) return std::uint64_t{1} << own;
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    const bool named =
        std::find(whose.names.begin(), whose.names.end(), scenario.flocks[i].name) != whose.names.end();
    if (whose.kind == Whose::Kind::all || named) mask |= std::uint64_t{1} << i;
  }
  return mask;
}

// Builds the rows and terms of one flock.
class FlockCompiler {
 public:
  FlockCompiler(const ScenarioDef& scenario, std::size_t own, const Model& model)
      : scenario_(scenario), def_(scenario.flocks[own]), own_(own), model_(model) {}

  FlockModel run() {
    limits();
    for (const Separation& term : def_.separation) separation(term);
    for (const Alignment& term : def_.alignment) alignment(term);
    for (const Cohesion& term : def_.cohesion) cohesion(term);
    for (const Flee& term : def_.flee) flee(term);
    own_terms();
    compile_behaviours(scenario_, own_, out_);
    compile_creature(scenario_, own_, out_);
    colour();
    sort();
    for (const NeighbourRow& row : out_.rows) {
      if (!row.whole_population) out_.reach_squared = std::max(out_.reach_squared, row.outer_squared);
    }
    return std::move(out_);
  }

 private:
  void limits() {
    out_.min_speed = static_cast<float>(def_.min_speed);
    out_.max_speed = static_cast<float>(def_.max_speed);
    out_.max_acceleration = static_cast<float>(def_.max_acceleration);
    out_.arbitration = def_.arbitration;
    out_.body_radius = static_cast<float>(def_.body_radius);
    if (def_.noise && def_.noise->on) out_.noise_turn = static_cast<float>(def_.noise->turn * (pi / 180));
  }

  NeighbourRow ring(double inner, double outer, Edge edge) const {
    NeighbourRow row;
    const auto inner_f = static_cast<float>(inner);
    const auto outer_f = static_cast<float>(outer);
    row.whole_population = std::isinf(outer);
    row.inner_squared = inner_f * inner_f;
    row.outer_squared = row.whole_population ? 0 : outer_f * outer_f;
    if (edge == Edge::closed && row.outer_squared > 0) {
      row.outer_squared = std::nextafter(row.outer_squared, FlockModel::infinity_f);
    }
    return row;
  }

  void see(NeighbourRow& row, const std::optional<double>& own_view, double sample) const {
    const double view = own_view.value_or(def_.field_of_view);
    row.sees_all = view >= 360;
    row.cos_half_view = static_cast<float>(cosine_of_degrees(view / 2));
    if (sample < 1) row.sample_below = std::max(1u, static_cast<std::uint32_t>(sample * 4294967295.0));
  }

  template <class Term>
  TermModel neighbour_term(TermKind kind, const Term& term, const NeighbourRow& row) {
    out_.rows.push_back(row);
    TermModel out;
    out.kind = kind;
    out.row = static_cast<int>(out_.rows.size()) - 1;
    out.weight = static_cast<float>(term.weight);
    out.priority = term.priority;
    out.order = term.order;
    return out;
  }

  template <class Term>
  NeighbourRow row_of(const Term& term) const {
    NeighbourRow row = ring(term.inner, term.radius, term.edge);
    see(row, term.field_of_view, term.sample);
    row.flocks = mask_of(scenario_, term.of, own_);
    if (term.sample <= 0) row.flocks = 0;
    return row;
  }

  void separation(const Separation& term) {
    if (!term.on) return;
    NeighbourRow row = row_of(term);
    row.strength = term.strength;
    TermModel out = neighbour_term(TermKind::separation, term, row);
    out.combine = term.combine;
    out_.terms.push_back(out);
  }

  void alignment(const Alignment& term) {
    if (!term.on) return;
    NeighbourRow row = row_of(term);
    row.quantity = term.match == Match::velocity ? Quantity::velocity : Quantity::heading;
    TermModel out = neighbour_term(TermKind::alignment, term, row);
    out.match = term.match;
    out.relative = term.relative;
    out.count_self = term.count_self;
    out_.terms.push_back(out);
  }

  void cohesion(const Cohesion& term) {
    if (!term.on) return;
    NeighbourRow row = row_of(term);
    row.strength = term.strength;
    TermModel out = neighbour_term(TermKind::cohesion, term, row);
    out.combine = term.combine;
    out.count_self = term.count_self;
    out_.terms.push_back(out);
  }

  void flee(const Flee& term) {
    if (!term.on) return;
    NeighbourRow row = ring(0, term.radius, Edge::open);
    see(row, term.field_of_view, 1);
    row.strength = term.form == SteeringForm::linear ? Strength::grows : Strength::constant;
    row.flocks = mask_of(scenario_, {Whose::Kind::named, term.from}, own_);
    TermModel out = neighbour_term(TermKind::flee, term, row);
    out.form = term.form;
    out_.terms.push_back(out);
  }

  template <class Def>
  void own_term(TermKind kind, const std::optional<Def>& def, double weight, double amount) {
    if (!def || !def->on) return;
    TermModel out;
    out.kind = kind;
    out.weight = static_cast<float>(weight);
    out.amount = static_cast<float>(amount);
    out.priority = def->priority;
    out.order = def->order;
    out_.terms.push_back(out);
  }

  void own_terms() {
    if (def_.cruise) own_term(TermKind::cruise, def_.cruise, def_.cruise->weight, def_.cruise->speed);
    if (def_.wander) own_term(TermKind::wander, def_.wander, def_.wander->weight, def_.wander->rate);
    if (def_.noise && def_.noise->acceleration > 0)
      own_term(TermKind::noise, def_.noise, 1, def_.noise->acceleration);
    if (def_.targets.on && is_drawn()) {
      TermModel targets;
      targets.kind = TermKind::targets;
      targets.weight = static_cast<float>(def_.targets.weight);
      targets.priority = def_.targets.priority;
      targets.order = def_.targets.order;
      out_.terms.push_back(targets);
    }
    avoid_obstacles();
    TermModel pointer;
    pointer.kind = TermKind::pointer;
    pointer.weight = model_.pointer.weight;
    pointer.form = model_.pointer.form;
    pointer.priority = scenario_.pointer.priority;
    pointer.order = std::numeric_limits<int>::max();
    out_.terms.push_back(pointer);
  }

  bool is_drawn() const {
    return std::any_of(model_.targets.begin(), model_.targets.end(),
                       [&](const TargetModel& target) { return (target.felt_by >> own_ & 1) != 0; });
  }

  void avoid_obstacles() {
    if (!def_.avoid_obstacles || !def_.avoid_obstacles->on) return;
    const AvoidObstacles& avoid = *def_.avoid_obstacles;
    own_term(TermKind::avoid_obstacles, def_.avoid_obstacles, avoid.weight, 0);
    TermModel& term = out_.terms.back();
    term.obstacle_form = avoid.form;
    const bool sweeps = avoid.form == ObstacleForm::sweep;
    term.look_ahead = static_cast<float>(sweeps ? avoid.look_ahead : avoid.radius);
    term.clearance = static_cast<float>(sweeps ? avoid.clearance : 0);
  }

  void colour() {
    out_.colour_averaging = static_cast<float>(def_.colour.averaging);
    out_.colour_noise = static_cast<float>(def_.colour.noise);
    if (!(def_.colour.averaging > 0) || def_.cohesion.empty()) return;
    NeighbourRow row = row_of(def_.cohesion.front());
    row.quantity = Quantity::colour;
    row.flocks = mask_of(scenario_, def_.colour.of, own_);
    out_.rows.push_back(row);
    out_.colour_row = static_cast<int>(out_.rows.size()) - 1;
  }

  void sort() {
    std::stable_sort(out_.terms.begin(), out_.terms.end(), [](const TermModel& a, const TermModel& b) {
      return a.priority != b.priority ? a.priority < b.priority : a.order < b.order;
    });
  }

  const ScenarioDef& scenario_;
  const FlockDef& def_;
  std::size_t own_;
  const Model& model_;
  FlockModel out_;
};

void compile_space(const ScenarioDef& scenario, Model& model) {
  const Extent extent = extent_of(scenario);
  const Boundary& boundary = scenario.space.boundary;
  model.boundary = boundary.kind;
  model.is_solid = scenario.space.solid;
  model.turn_strength = static_cast<float>(boundary.strength);
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
    model.min[axis] = static_cast<float>(extent.min[axis]);
    model.max[axis] = static_cast<float>(extent.max[axis]);
    model.size[axis] = model.max[axis] - model.min[axis];
    if (boundary.margin.empty()) continue;
    model.margin[axis] = static_cast<float>(boundary.margin[boundary.margin.size() == 1 ? 0 : axis]);
  }
}

std::array<double, 3> doubles(const Coordinates& at) {
  std::array<double, 3> out{};
  std::copy(at.begin(), at.end(), out.begin());
  return out;
}

TargetModel target_model(const ScenarioDef& scenario, const TargetDef& def) {
  TargetModel out;
  out.kind = def.kind;
  out.form = def.form;
  out.weight = static_cast<float>(def.weight);
  out.radius = static_cast<float>(def.radius);
  out.slowing = static_cast<float>(def.slowing);
  out.felt_by = mask_of(scenario, def.felt_by, 0);
  out.motion = def.motion;
  out.at = doubles(def.at);
  out.velocity = doubles(def.velocity);
  out.circle = def.circle;
  out.period = def.period;
  return out;
}

PointerModel pointer_model(const Pointer& def) {
  return {static_cast<float>(def.weight), static_cast<float>(def.radius),
          static_cast<float>(def.repel_radius.value_or(def.radius)), def.form,
          static_cast<float>(def.slowing)};
}

// What the whole model needs because some row or flock uses it.
void gather_uses(const ScenarioDef& scenario, Model& model) {
  float reach_squared = 0;
  for (std::size_t i = 0; i < model.flocks.size(); ++i) {
    const FlockModel& flock = model.flocks[i];
    const FlockDef& def = scenario.flocks[i];
    model.most_rows = std::max(model.most_rows, flock.rows.size());
    reach_squared = std::max(reach_squared, flock.reach_squared);
    model.uses_colour |= def.colour.averaging > 0 || def.colour.noise > 0 || def.colour.start == "random";
    model.uses_wander |= def.wander.has_value();
    for (const NeighbourRow& row : flock.rows) {
      model.uses_totals |= row.whole_population;
      model.uses_headings |= row.quantity == Quantity::heading;
    }
  }
  model.reach = std::sqrt(reach_squared);
}

// How far boids look for obstacles, and where they are solid how far a step goes.
void gather_obstacle_reach(Model& model) {
  for (const FlockModel& flock : model.flocks) {
    for (const TermModel& term : flock.terms) {
      if (term.kind != TermKind::avoid_obstacles) continue;
      model.obstacle_reach =
          std::max(model.obstacle_reach, term.look_ahead + term.clearance + flock.body_radius);
    }
    if (!model.is_solid) continue;
    const float step = std::isinf(flock.max_speed) ? 0 : flock.max_speed * model.dt;
    // A little more, because the length of a step is rounded.
    model.obstacle_reach = std::max(model.obstacle_reach, 1.001f * step + flock.body_radius);
  }
}

}  // namespace

std::array<float, 3> colour_of_hex(const std::string& hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  std::array<float, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = static_cast<float>(16 * digit(hex[1 + 2 * i]) + digit(hex[2 + 2 * i])) / 255.0f;
  }
  return out;
}

Model compile(const ScenarioDef& scenario) {
  Model model;
  model.dimensions = static_cast<int>(scenario.space.dimensions);
  model.seed = static_cast<std::uint64_t>(scenario.seed);
  model.dt = static_cast<float>(scenario.time.dt);
  model.tick = scenario.time.dt;
  model.integrator = scenario.time.integrator;
  compile_space(scenario, model);
  model.index = scenario.index;
  model.pointer = pointer_model(scenario.pointer);
  for (const TargetDef& def : scenario.targets) model.targets.push_back(target_model(scenario, def));
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    model.flocks.push_back(FlockCompiler(scenario, i, model).run());
  }
  gather_uses(scenario, model);
  gather_obstacle_reach(model);
  gather_behaviours(model);
  compile_life(scenario, model);
  return model;
}

void add_term(Model& model, const TermModel& term) {
  for (FlockModel& flock : model.flocks) {
    const auto place = std::find_if(flock.terms.begin(), flock.terms.end(),
                                    [&](const TermModel& other) { return other.priority > term.priority; });
    flock.terms.insert(place, term);
  }
}

}  // namespace sturnus
