// Hunters, eaters and those drawn to targets feel what the references say, in random worlds of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "living.h"
#include "support.h"

namespace sturnus::test {
namespace {

constexpr double side = 200;
constexpr double top_speed = 6;
constexpr double doubtful = 1e-4;  // share of a limit within which float32 may see otherwise

using reference::Vec;

Vec vec(const Point& p) {
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

/// Random worlds of two kinds of boids, in the plane or in space, wrapped or open.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed), dimensions_(seed % 2 == 0 ? 2 : 3), wraps_(seed % 4 < 2) {}

  double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  template <class T>
  T one_of(std::initializer_list<T> all) {
    return *(all.begin() + std::uniform_int_distribution<int>(0, static_cast<int>(all.size()) - 1)(random_));
  }
  Point point(double half) {
    Point p{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis)
      p[axis] = static_cast<float>(number(-half, half));
    return p;
  }
  Coordinates place() {
    const Point p = point(side / 2);
    return Coordinates(p.begin(), p.begin() + dimensions_);
  }
  int dimensions() const { return dimensions_; }
  Vec size() const { return wraps_ ? Vec{side, side, dimensions_ == 3 ? side : 0} : Vec{}; }

  /// Flock 0 steers, flock 1 is looked at; nobody feels anything else.
  ScenarioDef world() {
    ScenarioDef scenario = bare(dimensions_);
    const auto axes = static_cast<std::size_t>(dimensions_);
    scenario.space.min = Coordinates(axes, -side / 2);
    scenario.space.max = Coordinates(axes, side / 2);
    scenario.space.boundary.kind = wraps_ ? BoundaryKind::wrap : BoundaryKind::open;
    scenario.flocks.push_back(scenario.flocks.front());
    scenario.flocks[0].name = "hunters";
    scenario.flocks[1].name = "prey";
    for (FlockDef& flock : scenario.flocks) flock.max_speed = top_speed;
    return scenario;
  }
  State boids(std::size_t count) {
    std::vector<Placed> all;
    for (std::size_t i = 0; i < count; ++i)
      all.push_back({point(side / 2), point(top_speed / 2), i == 0 ? 0 : 1});
    return state_of(dimensions_, all);
  }

 private:
  std::mt19937 random_;
  int dimensions_;
  bool wraps_;
};

const ExplainedTerm& term_of(const Explanation& told, const std::string& kind) {
  const auto found = std::find_if(told.terms.begin(), told.terms.end(),
                                  [&](const ExplainedTerm& term) { return term.kind == kind; });
  EXPECT_NE(found, told.terms.end()) << kind;
  return *found;
}

void expect_near(const Point& felt, const Vec& expected, double scale, const std::string& what) {
  EXPECT_LE(reference::length(vec(felt) - expected), 1e-4 * (scale + reference::length(expected))) << what;
}

// ---- hunters ----

/// A prey as the hunter finds it; `is_clear` where float32 can't err about whether it is in view.
struct Seen {
  std::size_t number = 0;
  reference::Mover at_offset;
  bool is_in_view = false, is_clear = true;
};

std::vector<Seen> seen_by(const State& state, const Hunt& hunt, double view, const Vec& size) {
  const auto mover = [&](std::size_t slot) {
    Point p{}, v{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(state.dimensions); ++axis) {
      p[axis] = state.position[axis][slot];
      v[axis] = state.velocity[axis][slot];
    }
    return reference::Mover{vec(p), vec(v)};
  };
  const auto self =
      static_cast<std::size_t>(std::find(state.id.begin(), state.id.end(), 0u) - state.id.begin());
  const reference::Mover hunter = mover(self);
  std::vector<Seen> all;
  for (std::size_t slot = 0; slot < state.size(); ++slot) {
    if (slot == self) continue;
    Seen one{static_cast<std::size_t>(state.id[slot]), mover(slot)};
    const Vec o = reference::offset(hunter.position, one.at_offset.position, size);
    one.at_offset.position = o;
    const double off = std::acos(std::clamp(reference::dot(o, hunter.velocity) / reference::length(o) /
                                                reference::length(hunter.velocity),
                                            -1.0, 1.0)) /
                       std::numbers::pi * 360;
    one.is_in_view = reference::length(o) < hunt.sight && off <= view;
    one.is_clear = std::abs(reference::length(o) - hunt.sight) > doubtful * hunt.sight &&
                   (view >= 360 || std::abs(off - view) > 0.05);
    all.push_back(one);
  }
  return all;
}

reference::HuntRule rule_of(const Hunt& hunt) {
  using Aim = reference::HuntRule::Aim;
  const std::vector<std::pair<HuntAim, Aim>> aims = {{HuntAim::heading, Aim::heading},
                                                     {HuntAim::seek, Aim::seek},
                                                     {HuntAim::constant, Aim::constant},
                                                     {HuntAim::distance, Aim::distance},
                                                     {HuntAim::intercept, Aim::intercept}};
  const auto found =
      std::find_if(aims.begin(), aims.end(), [&](const auto& pair) { return pair.first == hunt.aim; });
  return {found->second, hunt.time, hunt.factor, top_speed};
}

Hunt some_hunt(Chance& chance) {
  Hunt hunt;
  hunt.prey = {"prey"};
  hunt.sight = chance.number(20, 95);
  hunt.aim = chance.one_of(
      {HuntAim::heading, HuntAim::seek, HuntAim::constant, HuntAim::distance, HuntAim::intercept});
  hunt.time = chance.number(0, 20);
  hunt.factor = chance.number(0, 0.5);
  hunt.field_of_view = chance.one_of({90.0, 200.0, 360.0});
  return hunt;
}

bool all_clear(const std::vector<Seen>& seen) {
  return std::all_of(seen.begin(), seen.end(), [](const Seen& one) { return one.is_clear; });
}

TEST(LivingAgainstReference, AHunterGoesForThePreyInView) {
  int compared = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Chance chance(seed);
    ScenarioDef scenario = chance.world();
    scenario.flocks[0].hunt = some_hunt(chance);
    const State state = chance.boids(25);
    const auto seen =
        seen_by(state, *scenario.flocks[0].hunt, *scenario.flocks[0].hunt->field_of_view, chance.size());
    if (!all_clear(seen)) continue;
    std::vector<reference::Mover> prey;
    for (const Seen& one : seen) {
      if (one.is_in_view) prey.push_back(one.at_offset);
    }
    const Explanation told = take(world_from(scenario, state).explain(0));
    expect_near(term_of(told, "hunt").felt,
                reference::hunt(rule_of(*scenario.flocks[0].hunt), vec(told.velocity), prey), top_speed,
                "seed " + std::to_string(seed));
    EXPECT_EQ(term_of(told, "hunt").neighbours, prey.size()) << seed;
    compared += prey.empty() ? 0 : 1;
  }
  EXPECT_GT(compared, 200);
}

// Who is in focus is followed over many steps, in which prey come into view, come near and get lost.
TEST(LivingAgainstReference, AHunterKeepsItsFocusAsLongAsItShould) {
  int kept = 0, changed = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Chance chance(seed);
    ScenarioDef scenario = chance.world();
    Hunt hunt = some_hunt(chance);
    hunt.choose = HuntChoice::nearest;
    scenario.flocks[0].hunt = hunt;
    Simulation world = world_from(scenario, chance.boids(30));
    std::optional<std::size_t> held;
    for (int step = 0; step < 60; ++step) {
      const auto seen = seen_by(world.view().state(), hunt, *hunt.field_of_view, chance.size());
      std::vector<reference::Sighted> in_view;
      for (const Seen& one : seen) {
        if (one.is_in_view) in_view.push_back({one.number, reference::length(one.at_offset.position)});
      }
      const Explanation told = take(world.explain(0));
      std::optional<std::size_t> chased;
      if (!told.neighbours.empty()) chased = static_cast<std::size_t>(told.neighbours.front().id);
      ASSERT_LE(told.neighbours.size(), 1u);
      if (all_clear(seen)) {
        EXPECT_EQ(chased, reference::focus(held, in_view)) << "seed " << seed << " step " << step;
        if (chased) ++(chased == held ? kept : changed);
      }
      held = chased;
      world.step();
    }
  }
  EXPECT_GT(kept, 500);
  EXPECT_GT(changed, 40);
}

// ---- food and targets ----

reference::Form form_of(SteeringForm form) {
  switch (form) {
    case SteeringForm::heading:
      return reference::Form::heading;
    case SteeringForm::seek:
      return reference::Form::seek;
    case SteeringForm::arrive:
      return reference::Form::arrive;
    case SteeringForm::orbit:
      return reference::Form::orbit;
    case SteeringForm::linear:
      return reference::Form::linear;
  }
  return reference::Form::heading;
}

TEST(LivingAgainstReference, FoodPullsThoseWhoNoticeIt) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Chance chance(seed);
    ScenarioDef scenario = chance.world();
    const Feed feed{.on = "food",
                    .radius = chance.number(30, 95),
                    .form = chance.one_of({SteeringForm::heading, SteeringForm::seek, SteeringForm::linear,
                                           SteeringForm::orbit})};
    scenario.flocks[0].feed = feed;
    scenario.food.push_back(FoodDef{});
    scenario.food[0].count = 0;
    State state = chance.boids(1);
    const Point self = {state.position[0][0], state.position[1][0],
                        chance.dimensions() == 3 ? state.position[2][0] : 0};
    std::vector<Vec> offsets;
    bool is_clear = true;
    for (std::uint64_t id = 1; id < 20; ++id) {
      const Point place = chance.point(side / 2);
      state.food.id.push_back(id);
      state.food.kind.push_back(0);
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(chance.dimensions()); ++axis)
        state.food.position[axis].push_back(place[axis]);
      offsets.push_back(reference::offset(vec(self), vec(place), chance.size()));
      is_clear =
          is_clear && std::abs(reference::length(offsets.back()) - feed.radius) > doubtful * feed.radius;
    }
    state.next_id = 20;
    if (!is_clear) continue;
    const Explanation told = take(world_from(scenario, state).explain(0));
    expect_near(term_of(told, "feed").felt,
                reference::feed(form_of(feed.form), feed.radius, top_speed, vec(told.velocity), offsets),
                side, "seed " + std::to_string(seed));
  }
}

// Where the reference has the target at that time.
Vec place_of(const TargetDef& target, double time) {
  const auto coordinate = [](const Coordinates& all, std::size_t axis) {
    return axis < all.size() ? all[axis] : 0.0;
  };
  Vec at{coordinate(target.at, 0), coordinate(target.at, 1), coordinate(target.at, 2)};
  if (target.motion == TargetMotion::line)
    at += time *
          Vec{coordinate(target.velocity, 0), coordinate(target.velocity, 1), coordinate(target.velocity, 2)};
  if (target.motion == TargetMotion::circle) {
    const double turned = 2 * std::numbers::pi * time / target.period;
    at += target.circle * Vec{std::cos(turned), std::sin(turned), 0};
  }
  return at;
}

TargetDef some_target(Chance& chance, std::size_t number) {
  TargetDef target;
  target.name = std::string("t").append(std::to_string(number));
  target.kind = chance.one_of({TargetKind::attract, TargetKind::repel});
  target.form = chance.one_of({SteeringForm::heading, SteeringForm::seek, SteeringForm::arrive,
                               SteeringForm::orbit, SteeringForm::linear});
  if (target.form == SteeringForm::arrive) target.kind = TargetKind::attract;
  target.at = chance.place();
  target.weight = chance.number(0.1, 2);
  target.radius = chance.one_of({infinity, 80.0});
  target.slowing = chance.number(20, 100);
  target.motion = chance.one_of({TargetMotion::still, TargetMotion::line, TargetMotion::circle});
  for (int axis = 0; axis < chance.dimensions(); ++axis) target.velocity.push_back(chance.number(-2, 2));
  target.circle = chance.number(5, 60);
  target.period = chance.number(-50, -20);
  return target;
}

TEST(LivingAgainstReference, TargetsPullInEveryFormAndMotion) {
  int compared = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Chance chance(seed);
    ScenarioDef scenario = chance.world();
    for (std::size_t i = 0; i < 5; ++i) scenario.targets.push_back(some_target(chance, i));
    scenario.time.dt = 0.25;
    Simulation world = world_from(scenario, chance.boids(1));
    const int steps = static_cast<int>(seed % 50);
    world.run(static_cast<std::uint64_t>(steps));
    const Explanation told = take(world.explain(0));
    std::vector<reference::TargetRule> rules;
    bool is_clear = true;
    for (const TargetDef& target : scenario.targets) {
      const Vec o = reference::offset(vec(told.position), place_of(target, steps * 0.25), chance.size());
      rules.push_back({target.kind == TargetKind::repel, form_of(target.form), target.weight, target.radius,
                       target.slowing, o});
      is_clear = is_clear && !(std::abs(reference::length(o) - target.radius) < doubtful * side);
      // Half a world away either image may be the nearer one.
      for (const double part : {o.x, o.y, o.z})
        is_clear = is_clear && std::abs(part) < side * (0.5 - doubtful);
    }
    if (chance.size().x > 0 && !is_clear) continue;
    ++compared;
    expect_near(term_of(told, "targets").felt, reference::targets(rules, top_speed, vec(told.velocity)), side,
                "seed " + std::to_string(seed));
  }
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace sturnus::test
