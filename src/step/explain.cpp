// The step's own sums, terms and arbitration for one boid, with a listener.
#include "step/explain.h"

#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>

#include "base/root.h"
#include "base/text.h"
#include "step/jump.h"
#include "step/prey.h"
#include "step/steering.h"
#include "world/columns.h"

namespace sturnus {
namespace {

// Finds a term in a flock's part of the list of parameters: "separation", or "separation.1" of several.
class TermFinder : public FieldVisitor {
 public:
  TermFinder(std::string_view flock, std::string_view kind, int order)
      : flock_(flock), kind_(kind), order_(order) {}

  void field(std::string_view, FieldRef, const About&) override {}
  void table(std::string_view, const About&, const std::function<void(FieldVisitor&)>&,
             std::string_view) override {}
  void items(std::string_view key, const About&, const Items& items) override {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (key == "flock" && items.name(i) == flock_) items.visit(i, *this);
      if (key == kind_ && items.order && *items.order(i) == order_ && path_.empty())
        path_ = items.size() > 1 ? say(key, ".", i) : std::string(key);
    }
  }
  const std::string& path() const { return path_; }

 private:
  std::string_view flock_, kind_;
  int order_;
  std::string path_;
};

std::string name_in(const ScenarioDef& scenario, std::string_view flock, const TermModel& term) {
  ScenarioDef copy = scenario;  // visiting hands out places to write to
  TermFinder finder(flock, name_of(term.kind), term.order);
  visit(copy, finder);
  return finder.path().empty() ? name_of(term.kind) : finder.path();
}

// Formula and source of a kind of term: those of its weight, or of the first of its keys that has any.
const ParameterRow* formula_row(const std::vector<ParameterRow>& rows, TermKind kind) {
  const ParameterRow* first = nullptr;
  for (const std::string& table : {say("flock.NAME.", name_of(kind), "."), say(name_of(kind), ".")}) {
    for (const ParameterRow& row : rows) {
      if (!row.path.starts_with(table) || *row.about.formula == '\0') continue;
      if (row.path == table + "weight") return &row;
      if (first == nullptr) first = &row;
    }
  }
  return first;
}

template <int D>
class Explainer {
 public:
  Explainer(const Explained& explained, State& state, Scratch& scratch, std::size_t slot,
            const Workers& workers)
      : explained_(explained),
        model_(explained.model),
        state_(state),
        scratch_(scratch),
        slot_(slot),
        flock_(model_.flocks[state.flock[slot]]),
        asked_(sum_around<D>(model_, state, scratch, slot, workers)),
        rows_(parameter_rows()) {}

  Explanation run() {
    describe();
    Steering<D> steering(model_, state_, scratch_, scratch_.parts.front());
    Vec<D> sum;
    const Vec<D> acceleration =
        steering.acceleration(slot_, [&](const TermModel& term, const Vec<D>& felt, const Vec<D>& granted) {
          add_term(term, felt, granted);
          sum += granted;
        });
    const auto velocity = at<D>(state_.velocity, slot_);
    out_.sum = widened(sum);
    out_.max_acceleration = flock_.max_acceleration;
    out_.cap_factor = cap_factor(sum, flock_.max_acceleration);
    out_.boundary = widened(boundary_turn(model_, at<D>(state_.position, slot_)));
    out_.acceleration = widened(acceleration);
    out_.dt = model_.dt;
    out_.is_jumping = is_jumping(state_, flock_, slot_);
    out_.next_velocity =
        widened(out_.is_jumping ? jump_velocity(*flock_.jump, state_.life.jump[slot_], velocity)
                                : velocity + acceleration * model_.dt);
    find_neighbours();
    return std::move(out_);
  }

 private:
  const SumBlock& sums() const { return scratch_.parts.front().sums; }

  void describe() {
    out_.step = state_.step;
    out_.id = state_.id[slot_];
    out_.dimensions = D;
    out_.flock = state_.flock[slot_];
    out_.flock_name = explained_.scenario.flocks[state_.flock[slot_]].name;
    out_.position = widened(at<D>(state_.position, slot_));
    out_.velocity = widened(at<D>(state_.velocity, slot_));
    out_.heading = widened(unit(at<D>(state_.velocity, slot_)));
    out_.arbitration = flock_.arbitration;
  }

  void add_term(const TermModel& term, const Vec<D>& felt, const Vec<D>& granted) {
    ExplainedTerm told;
    told.kind = name_of(term.kind);
    const auto row = static_cast<std::size_t>(term.row);
    told.name = term.kind == TermKind::custom ? explained_.rules[row]
                                              : name_in(explained_.scenario, out_.flock_name, term);
    told.felt = widened(felt);
    told.weight = term.weight;
    told.weighted = widened(felt * term.weight);
    told.granted = widened(granted);
    if (sums_neighbours(term.kind)) add_reach(row, told);
    if (term.kind == TermKind::hunt) {
      add_sight(flock_.hunt->sight, told);
      hunting_ = out_.terms.size();
    }
    if (const ParameterRow* about = formula_row(rows_, term.kind)) {
      told.formula = about->about.formula;
      told.source = about->about.source;
    }
    counting_.push_back(sums_neighbours(term.kind) ? &flock_.rows[row] : nullptr);
    out_.terms.push_back(std::move(told));
  }

  void add_reach(std::size_t row, ExplainedTerm& told) const {
    const NeighbourRow& filter = flock_.rows[row];
    told.neighbours = sums().at(row, slot_).count;
    told.inner = std::sqrt(filter.inner_squared);
    told.radius = filter.whole_population ? FlockModel::infinity_f : std::sqrt(filter.outer_squared);
    if (!filter.sees_all) told.field_of_view = degrees_of_view(filter.cos_half_view);
  }

  void add_sight(const SightModel& sight, ExplainedTerm& told) const {
    told.neighbours = 0;  // counted as they are found
    told.radius = std::sqrt(sight.distance_squared);
    if (!sight.sees_all) told.field_of_view = degrees_of_view(sight.cos_half_view);
  }

  static double degrees_of_view(float cos_half_view) {
    return 2 * std::acos(std::clamp(double{cos_half_view}, -1.0, 1.0)) * (180 / pi);
  }

  void find_neighbours() {
    for (std::size_t i = 0; i < state_.size(); ++i) {
      ExplainedNeighbour found;
      for (std::size_t t = 0; t < counting_.size(); ++t) {
        const NeighbourRow* row = counting_[t];
        if (row != nullptr && is_counted<D>(*row, asked_.boids, slot_, asked_.boids, i, asked_.question))
          found.terms.push_back(t);
      }
      if (hunting_ && is_chased(i)) {
        found.terms.push_back(*hunting_);
        ++*out_.terms[*hunting_].neighbours;
      }
      if (!found.terms.empty()) add_neighbour(i, std::move(found));
    }
    std::sort(out_.neighbours.begin(), out_.neighbours.end(),
              [](const ExplainedNeighbour& a, const ExplainedNeighbour& b) {
                return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
              });
  }

  // All prey in view, or the one in focus.
  bool is_chased(std::size_t i) const {
    const HuntModel& hunt = *flock_.hunt;
    if (is_full(model_, state_, slot_) || !is_hunted(hunt, state_, i)) return false;
    if (hunt.choose == HuntChoice::nearest && state_.id[i] != state_.life.focus[slot_]) return false;
    const auto velocity = at<D>(state_.velocity, slot_);
    return is_seen(hunt.sight, velocity, length(velocity),
                   prey_at<D>(state_, slot_, i, asked_.question.image));
  }

  void add_neighbour(std::size_t i, ExplainedNeighbour found) {
    const Vec<D> o = offset(at<D>(state_.position, slot_), at<D>(state_.position, i), asked_.question.image);
    found.id = state_.id[i];
    found.flock = state_.flock[i];
    found.distance = length(o);
    found.offset = widened(o);
    found.bearing = bearing_of(o);
    out_.neighbours.push_back(std::move(found));
  }

  std::optional<double> bearing_of(const Vec<D>& o) const {
    Vec<D, double> heading, way;
    for (int axis = 0; axis < D; ++axis) {
      heading[axis] = double{at<D>(state_.velocity, slot_)[axis]};
      way[axis] = double{o[axis]};
    }
    const double along = dot(heading, way);
    const double squared = dot(heading, heading) * dot(way, way);
    if (!(squared > 0)) return {};
    // Straight behind is 180 and not -180: adding 0 takes the sign from a zero.
    if constexpr (D == 2)
      return std::atan2(heading[0] * way[1] - heading[1] * way[0] + 0.0, along) * (180 / pi);
    return std::acos(std::clamp(along / std::sqrt(squared), -1.0, 1.0)) * (180 / pi);
  }

  const Explained& explained_;
  const Model& model_;
  State& state_;
  Scratch& scratch_;
  std::size_t slot_;
  const FlockModel& flock_;
  Asked asked_;
  std::vector<ParameterRow> rows_;
  std::vector<const NeighbourRow*> counting_;  ///< of each term; null where no row of it looks at anybody
  std::optional<std::size_t> hunting_;         ///< the term that looks at prey
  Explanation out_;
};

std::optional<std::size_t> place_of(const State& state, std::uint64_t id) {
  const auto found = std::find(state.id.begin(), state.id.end(), id);
  if (found == state.id.end()) return {};
  return static_cast<std::size_t>(found - state.id.begin());
}

}  // namespace

Result<Explanation> explain(const Explained& explained, const State& state, std::uint64_t id,
                            const Workers& workers) {
  const auto problem = [&](std::string text) {
    return Problem{explained.scenario.file, 0, "", std::move(text), false};
  };
  if (!place_of(state, id)) return problem(say("there is no boid with id ", id, " at step ", state.step));
  State copy = state;
  Scratch scratch;
  prepare(explained.model, explained.scenario, copy, scratch, explained.outside, workers);
  const std::size_t slot = *place_of(copy, id);
  if (copy.quarantined[slot] != 0)
    return problem(say("boid ", id, " is out of play because it met a bad number: it feels nothing"));
  if (state.dimensions == 3) return Explainer<3>(explained, copy, scratch, slot, workers).run();
  return Explainer<2>(explained, copy, scratch, slot, workers).run();
}

}  // namespace sturnus
