// Everything that can be wrong with a scenario beyond the range of a single number, each in one sentence.
#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/behaviours.h"
#include "scenario/common_checks.h"
#include "scenario/creatures.h"
#include "scenario/events.h"
#include "scenario/obstacles.h"

namespace sturnus {
namespace {

constexpr std::size_t most_flocks = 64;
constexpr std::size_t most_terms = 63;  // and one for the colour

class Checker : Findings {
 public:
  Checker(const ScenarioDef& scenario, Problems& problems) : Findings(scenario, problems) {
    for (const FlockDef& flock : scenario.flocks) names_.push_back(flock.name);
  }

  void run() {
    check_numbers();
    check_space();
    check_boundary();
    check_flocks();
    check_targets();
    check_obstacles();
    check_behaviours(scenario_, problems_);
    check_creatures(scenario_, problems_);
    check_camera();
    check_events();
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(scenario_.space.dimensions); }

  // Every single value against its own range: structs filled by hand have not met the parser.
  void check_numbers();

  void check_size(const Coordinates& at, std::size_t size, const std::string& key) {
    if (!at.empty() && at.size() != size)
      say_error(key, say("must have ", size, " numbers, but has ", at.size()));
  }

  void check_space() {
    const Space& space = scenario_.space;
    if (!(scenario_.time.dt > 0))
      say_error("time.dt", say("must be above 0, but is ", number_text(scenario_.time.dt)));
    check_size(space.min, axes(), "space.min");
    check_size(space.max, axes(), "space.max");
    if (space.min.empty() != space.max.empty()) {
      return say_error(space.min.empty() ? "space.min" : "space.max", "is missing; min and max go together");
    }
    if (!space.min.empty() && space.per_boid)
      return say_error("space.per_boid", "give per_boid, or min and max, not both");
    if (space.min.empty() && space.per_boid && !(*space.per_boid > 0)) {
      return say_error("space.per_boid", "must be above 0, or give space.min and space.max");
    }
    for (std::size_t axis = 0; axis < std::min(space.min.size(), space.max.size()); ++axis) {
      if (!(space.min[axis] < space.max[axis])) {
        say_error("space.max", say("must be above min on every axis, but ", number_text(space.max[axis]),
                                   " is not above ", number_text(space.min[axis])));
      }
    }
    if (!has_errors(problems_)) check_extent();
  }

  void check_extent() {
    const Extent extent = extent_of(scenario_);
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const std::string key = scenario_.space.min.empty() ? "space.per_boid" : "space.max";
      if (!(std::abs(extent.min[axis]) <= 1e15 && std::abs(extent.max[axis]) <= 1e15)) {
        return say_error(key, "makes the space reach beyond 1e15");
      }
      const float size = static_cast<float>(extent.max[axis]) - static_cast<float>(extent.min[axis]);
      const double coarse = 1e-6 * std::max(std::abs(extent.min[axis]), std::abs(extent.max[axis]));
      if (!(size >= 1e-15f) || !(double{size} > coarse)) {
        return say_error(key, "makes the space too small for its place to be told apart in single precision");
      }
    }
  }

  void check_boundary() {
    const Boundary& boundary = scenario_.space.boundary;
    const std::string key = "space.boundary.margin";
    if (boundary.margin.size() > 1) check_size(boundary.margin, axes(), key);
    if (has_errors(problems_) || boundary.kind != BoundaryKind::turn) return;
    const Extent extent = extent_of(scenario_);
    for (std::size_t axis = 0; axis < axes() && !boundary.margin.empty(); ++axis) {
      const double margin = boundary.margin[boundary.margin.size() == 1 ? 0 : axis];
      const double size = extent.max[axis] - extent.min[axis];
      if (2 * margin > size) {
        say_warning(key, say("the margins of ", number_text(margin), " cross on the ",
                             std::string_view("xyz").substr(axis, 1), " axis, which is only ",
                             number_text(size), " long; between them both push"));
      }
    }
  }

  void check_flocks() {
    if (scenario_.flocks.empty())
      return say_error("flock", "there is no flock; a file needs at least one [[flock]]");
    if (scenario_.flocks.size() > most_flocks)
      say_error("flock", say("there are more than ", most_flocks, " flocks"));
    for (std::size_t i = 0; i < scenario_.flocks.size(); ++i) {
      const FlockDef& flock = scenario_.flocks[i];
      const std::string prefix = say("flock.", flock.name, ".");
      check_name(i, prefix);
      check_rows(flock, i);
      if (flock.max_speed < flock.min_speed) {
        say_error(prefix + "max_speed",
                  say(number_text(flock.max_speed), " is below min_speed ", number_text(flock.min_speed)));
      }
      check_start(flock.start, prefix + "start.");
      check_terms(flock, prefix);
      check_colour(flock.colour, prefix + "colour.");
      say_if(wrong_form(scenario_.pointer.form, flock), "pointer.form");
    }
  }

  // Which rows a step sums together are bits of one number.
  void check_rows(const FlockDef& flock, std::size_t i) {
    const std::size_t terms =
        flock.separation.size() + flock.alignment.size() + flock.cohesion.size() + flock.flee.size();
    if (terms > most_terms)
      say_error(say("flock.", names_[i]),
                say("there are ", terms, " terms over neighbours; a flock can have ", most_terms));
  }

  void check_name(std::size_t i, const std::string& prefix) {
    const std::string& name = names_[i];
    const auto end = names_.begin() + static_cast<std::ptrdiff_t>(i);
    say_if(wrong_name("flocks", name, {names_.begin(), end}), prefix + "name");
    if (name == "own" || name == "all")
      say_error(prefix + "name", say("\"", name, "\" has a meaning of its own"));
  }

  void check_start(const Start& start, const std::string& prefix) {
    check_size(start.min, axes(), prefix + "min");
    check_size(start.max, axes(), prefix + "max");
    check_size(start.centre, axes(), prefix + "centre");
    check_size(start.heading, axes(), prefix + "heading");
    if (start.max_speed < start.min_speed) say_error(prefix + "speed", "the smaller speed must come first");
    if (start.region == StartRegion::box) {
      if (start.min.empty() || start.max.empty())
        return say_error(prefix + "region", "a box needs min and max");
      for (std::size_t axis = 0; axis < std::min(start.min.size(), start.max.size()); ++axis) {
        if (start.min[axis] > start.max[axis]) say_error(prefix + "max", "must not be below min");
      }
    }
    if (start.region == StartRegion::ring && start.inner > start.radius) {
      say_error(prefix + "inner", say("the ring's inner radius ", number_text(start.inner),
                                      " is above its radius ", number_text(start.radius)));
    }
  }

  template <class Term>
  void check_list(const std::vector<Term>& terms, const std::string& prefix, bool over_offsets) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const std::string here = terms.size() == 1 ? prefix : say(prefix, i, ".");
      check_reach(terms[i], here, over_offsets);
      check_whose(terms[i].of, here + "of");
    }
  }

  template <class Term>
  void check_reach(const Term& term, const std::string& prefix, bool over_offsets) {
    if (term.inner > term.radius) {
      say_error(prefix + "radius", say("the outer radius ", number_text(term.radius),
                                       " is below the inner radius ", number_text(term.inner)));
    }
    if (!std::isinf(term.radius)) return;
    const std::string lead = "an infinite radius means the whole population, which ";
    const std::string key = prefix + "radius";
    if constexpr (requires { term.strength; }) {
      if (term.strength != Strength::grows) say_error(key, lead + "needs strength \"d\"");
    }
    if (term.inner > 0) say_error(key, lead + "can't have an inner radius");
    if (term.sample < 1) say_error(key, lead + "can't be sampled");
    if (term.field_of_view.value_or(flock_view_) < 360) say_error(key, lead + "needs a field of view of 360");
    if (over_offsets && scenario_.space.boundary.kind == BoundaryKind::wrap) {
      say_error(key, lead + "has no centre in a wrapped space; give a radius or another boundary");
    }
  }

  void check_whose(const Whose& whose, const std::string& key) {
    if (whose.kind == Whose::Kind::named) check_names(whose.names, key);
  }

  void check_names(const std::vector<std::string>& wanted, const std::string& key) {
    for (const std::string& name : wanted) {
      if (std::find(names_.begin(), names_.end(), name) == names_.end())
        say_error(key, unknown_word("flock", name, names_));
    }
  }

  void check_terms(const FlockDef& flock, const std::string& prefix) {
    flock_view_ = flock.field_of_view;
    check_list(flock.separation, prefix + "separation.", true);
    check_list(flock.alignment, prefix + "alignment.", false);
    check_list(flock.cohesion, prefix + "cohesion.", true);
    for (const Flee& flee : flock.flee) {
      if (flee.from.empty()) say_error(prefix + "flee.from", "names nobody to flee from");
      check_names(flee.from, prefix + "flee.from");
      say_if(wrong_form(flee.form, flock), prefix + "flee.form");
      if (flee.form == SteeringForm::arrive)
        say_error(prefix + "flee.form", "nobody flees by slowing down; \"arrive\" is for what attracts");
    }
  }

  void check_targets() {
    std::vector<std::string> names;
    for (const TargetDef& target : scenario_.targets) {
      const std::string prefix = say("target.", target.name, ".");
      say_if(wrong_name("targets", target.name, names), prefix + "name");
      names.push_back(target.name);
      check_target(target, prefix);
    }
  }

  void check_target(const TargetDef& target, const std::string& prefix) {
    say_if(wrong_place(target.at, axes()), prefix + "at");
    if (target.at.empty()) say_error(prefix + "at", "is missing; a target needs a place");
    check_size(target.velocity, axes(), prefix + "velocity");
    if (target.motion == TargetMotion::line && target.velocity.empty())
      say_error(prefix + "velocity", "is missing; a target that moves in a line needs one");
    if (target.motion == TargetMotion::circle && target.period == 0)
      say_error(prefix + "period", "must not be 0");
    if (target.kind == TargetKind::repel && target.form == SteeringForm::arrive)
      say_error(prefix + "form", "\"arrive\" slows down near the target, which is for those that attract");
    if (target.felt_by.kind == Whose::Kind::own)
      return say_error(prefix + "felt_by", "must be \"all\" or a list of flock names");
    check_whose(target.felt_by, prefix + "felt_by");
    for (const FlockDef& flock : scenario_.flocks) {
      const auto& felt_by = target.felt_by;
      if (felt_by.kind == Whose::Kind::all ||
          std::find(felt_by.names.begin(), felt_by.names.end(), flock.name) != felt_by.names.end())
        say_if(wrong_form(target.form, flock), prefix + "form");
    }
  }

  void check_colour(const Colour& colour, const std::string& prefix) {
    check_whose(colour.of, prefix + "of");
    if (colour.start.empty() || colour.start == "random") return;
    if (!is_hex_colour(colour.start))
      say_error(prefix + "start", say("must be \"#rrggbb\" or \"random\", but found \"", colour.start, "\""));
  }

  void check_obstacles() {
    if (has_errors(problems_)) return;  // places are drawn in the space, which must be sound
    Problems found = obstacle_problems(scenario_);
    problems_.insert(problems_.end(), found.begin(), found.end());
  }

  void check_camera() {
    check_size(scenario_.camera.eye, 3, "camera.eye");
    check_size(scenario_.camera.target, 3, "camera.target");
    if (!scenario_.camera.eye.empty() && scenario_.camera.eye == scenario_.camera.target) {
      say_error("camera.eye", "must not be where the target is");
    }
  }

  // Events are checked against the scenario as it stands when their turn comes.
  void check_events() {
    if (has_errors(problems_) || scenario_.run.events.empty()) return;
    ScenarioDef now = scenario_;
    now.run.events.clear();
    for (std::size_t i = 0; i < scenario_.run.events.size(); ++i) {
      const Event& event = scenario_.run.events[i];
      if (const auto error = check_command(now, event.command)) {
        say_error(say("run.events.", i), say("the event of step ", event.step, ": ", *error));
        continue;
      }
      change_scenario(event.command, event.step, now);
    }
  }

  std::vector<std::string> names_;
  double flock_view_ = 360;
};

// Assigns every value to itself, which checks its range.
class RangeVisitor : public FieldVisitor {
 public:
  using Tell = std::function<void(std::string, std::string)>;
  RangeVisitor(std::string prefix, const Tell& tell) : prefix_(std::move(prefix)), tell_(tell) {}

  void field(std::string_view key, FieldRef place, const About& about) override {
    const auto value = value_at(place);
    if (!value) return;
    if (const auto* ring = std::get_if<RingRef>(&place); ring != nullptr && *ring->inner > *ring->outer)
      return;
    if (const auto error = assign(place, *value, about)) tell_(prefix_ + std::string(key), *error);
  }
  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view) override {
    RangeVisitor inner(say(prefix_, key, "."), tell_);
    visit_inside(inner);
  }
  void items(std::string_view key, const About&, const Items& items) override {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string name = items.name ? say(items.name(i), ".") : items.size() > 1 ? say(i, ".") : "";
      RangeVisitor inner(say(prefix_, key, ".", name), tell_);
      items.visit(i, inner);
    }
  }

 private:
  std::string prefix_;
  const Tell& tell_;
};

void Checker::check_numbers() {
  ScenarioDef copy = scenario_;  // visiting hands out places to write to
  const RangeVisitor::Tell tell = [this](std::string key, std::string text) {
    say_error(std::move(key), std::move(text));
  };
  RangeVisitor visitor("", tell);
  visit(copy, visitor);
}

}  // namespace

Problems check(const ScenarioDef& scenario) {
  Problems problems;
  Checker(scenario, problems).run();
  return problems;
}

}  // namespace sturnus
