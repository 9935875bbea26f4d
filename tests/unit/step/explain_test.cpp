// What a boid is said to feel is what the next step computes, adds up, and is found without changing a bit.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

// Bits of every number, and +0 and -0 as one: the sums of a budget begin at +0.
void expect_same(const Point& found, const Point& expected, const std::string& what) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(found[axis], expected[axis]) << what << " " << axis;
}

Point plus(const Point& a, const Point& b, float scale = 1) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}

void expect_adds_up(const Explanation& told, const std::string& what) {
  Point sum{};
  for (const ExplainedTerm& term : told.terms) {
    expect_same(term.weighted, plus({}, term.felt, term.weight), what + " weighted " + term.name);
    sum = plus(sum, term.granted);
  }
  expect_same(told.sum, sum, what + " sum");
  const double factor = std::min(1.0, double{told.max_acceleration} / length_of(sum));
  EXPECT_NEAR(told.cap_factor, length_of(sum) > 0 ? factor : 1, 1e-6) << what;
  expect_same(told.acceleration, plus(told.boundary, sum, told.cap_factor), what + " acceleration");
  if (!told.is_jumping)
    expect_same(told.next_velocity, plus(told.velocity, told.acceleration, told.dt), what + " velocity");
}

// What the real step made of the velocity: the same bits where no limit acts, else the same direction.
void expect_is_next(const Explanation& told, const Simulation& after, const std::string& what) {
  const FlockDef& flock = after.scenario().flocks[static_cast<std::size_t>(told.flock)];
  const double speed = length_of(told.next_velocity);
  const Point real = velocity_of(after, told.id);
  const bool is_free = speed > flock.min_speed * 1.00001 && speed < flock.max_speed * 0.99999;
  if (is_free || speed == 0 || told.is_jumping)
    return expect_same(real, told.next_velocity, what + " next velocity");
  const double limited = std::clamp(speed, flock.min_speed, flock.max_speed);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(real[axis], told.next_velocity[axis] * limited / speed, 1e-5 * limited) << what;
}

void expect_counts(const Explanation& told, const std::string& what) {
  for (std::size_t t = 0; t < told.terms.size(); ++t) {
    const auto counts = [&](const ExplainedNeighbour& one) {
      return std::find(one.terms.begin(), one.terms.end(), t) != one.terms.end();
    };
    const auto listed =
        static_cast<std::size_t>(std::count_if(told.neighbours.begin(), told.neighbours.end(), counts));
    EXPECT_EQ(told.terms[t].neighbours.value_or(0), listed) << what << " " << told.terms[t].name;
  }
}

// Asks about some boids, steps, and holds the answers to what happened; `silent` is not asked.
void follow_closely(Simulation& asked, Simulation& silent, const std::string& what) {
  const std::size_t count = asked.view().size();
  std::vector<Explanation> told;
  for (std::size_t slot = 0; slot < count; slot += std::max<std::size_t>(1, count / 7)) {
    if (!asked.view().quarantined(slot)) told.push_back(take(asked.explain(asked.view().id(slot))));
  }
  asked.step();
  silent.step();
  EXPECT_EQ(asked.hash(), silent.hash()) << what;
  for (const Explanation& one : told) {
    const std::string who = what + " boid " + std::to_string(one.id);
    expect_adds_up(one, who);
    expect_is_next(one, asked, who);
    expect_counts(one, who);
  }
}

void without_random_turns(ScenarioDef& scenario) {
  for (FlockDef& flock : scenario.flocks) {
    if (flock.noise) flock.noise->turn = 0;
  }
}

void follow_steps(const ScenarioDef& scenario, const std::string& what, int threads = 1) {
  Simulation asked = start(scenario, threads);
  Simulation silent = start(scenario, threads);
  for (const int rest : {0, 15}) {
    asked.run(static_cast<std::uint64_t>(rest));
    silent.run(static_cast<std::uint64_t>(rest));
    follow_closely(asked, silent, what + " after " + std::to_string(rest));
  }
}

TEST(Explain, IsWhatTheNextStepOfEveryShippedScenarioComputes) {
  for (const ShippedScenario& shipped : shipped_scenarios()) {
    ScenarioDef scenario = take(parse_scenario(shipped.text, shipped.name));
    without_random_turns(scenario);
    for (FlockDef& flock : scenario.flocks) flock.count = std::min<std::int64_t>(flock.count, 400);
    follow_steps(scenario, shipped.name);
  }
}

/// Two flocks with every kind of row and term.
ScenarioDef everything(int dimensions, BoundaryKind boundary) {
  ScenarioDef scenario;
  scenario.space.dimensions = dimensions;
  scenario.space.boundary = {boundary, {30}, 0.1};
  FlockDef& flock = scenario.flocks.front();
  flock.count = 150;
  flock.field_of_view = 250;
  flock.separation.push_back({.weight = 0.1, .radius = 25, .inner = 8, .edge = Edge::closed, .order = 1});
  flock.alignment.push_back(
      {.weight = 0.1, .radius = infinity, .match = Match::heading, .field_of_view = 360, .order = 2});
  flock.cohesion.front().sample = 0.5;
  flock.flee = {{.from = {"others"}, .radius = 40, .order = 4}};
  flock.cruise = Cruise{};
  flock.wander = Wander{};
  flock.noise = Noise{.acceleration = 0.01};
  scenario.flocks.push_back(scenario.flocks.front());
  FlockDef& others = scenario.flocks.back();
  others.name = "others";
  others.count = 30;
  others.flee.clear();
  others.arbitration = Arbitration::budget;
  others.cohesion.front().of = {Whose::Kind::all, {}};
  return scenario;
}

TEST(Explain, HoldsForEveryIndexPathKernelAndEdge) {
  const IsaGuard guard;
  for (const int dimensions : {2, 3}) {
    for (const BoundaryKind edge : {BoundaryKind::wrap, BoundaryKind::turn, BoundaryKind::open}) {
      for (const IndexKind index : {IndexKind::grid, IndexKind::tree, IndexKind::all_pairs}) {
        for (const SumPath path : {SumPath::sparse, SumPath::dense}) {
          ScenarioDef scenario = everything(dimensions, edge);
          scenario.index.kind = index;
          scenario.index.path = path;
          for (const Isa isa : {Isa::plain, Isa::best}) {
            use_isa(isa);
            follow_steps(scenario, "a mixture", 2);
          }
        }
      }
    }
  }
}

// Of others in the first flock's world, at random places.
Explanation explained_at_random(Arbitration arbitration, double max) {
  ScenarioDef scenario = everything(2, BoundaryKind::turn);
  scenario.seed = *rc::gen::inRange(0, 1000000);
  FlockDef& flock = scenario.flocks.front();
  flock.count = 60;
  flock.arbitration = arbitration;
  flock.max_acceleration = max;
  flock.cohesion.front().priority = *rc::gen::inRange(-2, 2);
  flock.cruise->priority = *rc::gen::inRange(-2, 2);
  return take(start(scenario).explain(static_cast<std::uint64_t>(*rc::gen::inRange(0, 60))));
}

TEST(Explain, WhatIsGrantedObeysTheBudget) {
  EXPECT_TRUE(rc::check([] {
    const double max = *rc::gen::inRange(1, 100) / 50.0;
    const Explanation told = explained_at_random(Arbitration::budget, max);
    double left = max;
    for (const ExplainedTerm& term : told.terms) {
      const double wanted = length_of(term.weighted), granted = length_of(term.granted);
      RC_ASSERT(std::abs(granted - std::min(wanted, std::max(left, 0.0))) < 1e-5 * (wanted + max));
      const double along =
          double{term.weighted[0]} * term.granted[0] + double{term.weighted[1]} * term.granted[1];
      RC_ASSERT(along >= 0.9999 * wanted * granted - 1e-12);
      left -= wanted;
    }
  }));
}

TEST(Explain, FirstGrantsOneTermAndWeightedGrantsAll) {
  EXPECT_TRUE(rc::check([] {
    const Explanation first = explained_at_random(Arbitration::first, 1);
    bool is_over = false;
    for (const ExplainedTerm& term : first.terms) {
      const Point expected = is_over ? Point{} : term.weighted;
      RC_ASSERT(term.granted == expected);
      is_over = is_over || length_of(term.weighted) > 0;
    }
    const Explanation all = explained_at_random(Arbitration::weighted, 1);
    for (const ExplainedTerm& term : all.terms) RC_ASSERT(term.granted == term.weighted);
  }));
}

// By hand: neighbours at (3, 4) and (0, -2), and one beyond the radius.
TEST(Explain, OneTermByHand) {
  ScenarioDef scenario = bare();
  scenario.flocks.front().separation = {{.weight = 2, .radius = 10}};
  const Explanation told =
      take(world_of(scenario, {{{0, 0}, {0, 1}}, {{3, 4}}, {{0, -2}}, {{0, 11}}}).explain(0));
  const ExplainedTerm& term = told.terms.front();
  EXPECT_EQ(term.name, "separation");
  EXPECT_EQ(term.neighbours, 2u);
  EXPECT_FLOAT_EQ(term.radius, 10);
  // -(3, 4)/25 - (0, -2)/4
  EXPECT_NEAR(term.felt[0], -0.12, 1e-6);
  EXPECT_NEAR(term.felt[1], 0.34, 1e-6);
  EXPECT_NEAR(told.acceleration[1], 0.68, 1e-6);
  ASSERT_EQ(told.neighbours.size(), 2u);
  EXPECT_EQ(told.neighbours[0].id, 2u);
  EXPECT_EQ(told.neighbours[1].id, 1u);
  EXPECT_FLOAT_EQ(told.neighbours[1].distance, 5);
  EXPECT_NEAR(told.neighbours[0].bearing.value(), 180, 1e-4);
  EXPECT_NEAR(told.neighbours[1].bearing.value(), std::atan2(4, 3) * 180 / 3.14159265358979 - 90, 1e-4);
}

TEST(Explain, NeighboursAreSeenAcrossTheSeamAndBlindAnglesHold) {
  ScenarioDef scenario = bare();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  scenario.flocks.front().cohesion = {{.radius = 50, .field_of_view = 180}};
  const Explanation told =
      take(world_of(scenario, {{{995, 0}, {1, 0}}, {{-995, 0}}, {{990, 0}}, {{997, 7}}}).explain(0));
  ASSERT_EQ(told.neighbours.size(), 2u);  // ahead over the seam, and one to the left
  expect_same(told.neighbours[1].offset, {10, 0, 0}, "over the seam");
  EXPECT_NEAR(told.neighbours[0].bearing.value(), 74.0546, 1e-4);
  EXPECT_NEAR(told.terms.front().field_of_view, 180, 1e-3);
}

// A hunter that goes to the right, and prey: one ahead to the left, one ahead, one behind, one too far.
ScenarioDef a_hunt() {
  ScenarioDef scenario = bare();
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks.front().name = "hunters";
  scenario.flocks.back().name = "prey";
  Hunt& hunt = scenario.flocks.front().hunt.emplace();
  hunt.prey = {"prey"};
  hunt.sight = 15;
  hunt.field_of_view = 180;
  return scenario;
}

State hunter_and_prey() {
  State state = state_of(2, {{{0, 0}, {1, 0}}, {{6, 8}}, {{5, 0}}, {{-4, 0}}, {{16, 0}}});
  std::fill(state.flock.begin() + 1, state.flock.end(), std::uint8_t{1});
  return state;
}

TEST(Explain, AHunterIsToldItsPreyInView) {
  const Explanation told = take(world_from(a_hunt(), hunter_and_prey()).explain(0));
  const ExplainedTerm& term = told.terms.front();
  EXPECT_EQ(term.kind, "hunt");
  EXPECT_EQ(term.neighbours, 2u);
  EXPECT_FLOAT_EQ(term.radius, 15);
  EXPECT_NEAR(term.field_of_view, 180, 1e-3);
  // The mean of (0.6, 0.8) and (1, 0), less the heading.
  EXPECT_NEAR(term.felt[0], -0.2, 1e-6);
  EXPECT_NEAR(term.felt[1], 0.4, 1e-6);
  ASSERT_EQ(told.neighbours.size(), 2u);
  EXPECT_EQ(told.neighbours[0].id, 2u);
  EXPECT_EQ(told.neighbours[1].id, 1u);
  expect_counts(told, "prey in view");
}

TEST(Explain, AHunterWithAFocusIsToldThatOneAlone) {
  ScenarioDef scenario = a_hunt();
  scenario.flocks.front().hunt->choose = HuntChoice::nearest;
  const Explanation told = take(world_from(scenario, hunter_and_prey()).explain(0));
  ASSERT_EQ(told.neighbours.size(), 1u);
  EXPECT_EQ(told.neighbours[0].id, 2u);
  EXPECT_EQ(told.terms.front().neighbours, 1u);
}

TEST(Explain, AFullHunterChasesNobody) {
  ScenarioDef scenario = a_hunt();
  scenario.flocks.front().hunger = Hunger{};
  State state = hunter_and_prey();
  state.life.full.assign(state.size(), 0);
  state.life.full[0] = 50;
  const Explanation told = take(world_from(scenario, state).explain(0));
  EXPECT_EQ(told.terms.front().neighbours, 0u);
  EXPECT_TRUE(told.neighbours.empty());
}

TEST(Explain, TermsHaveNamesFormulasAndSources) {
  const ScenarioDef scenario = everything(2, BoundaryKind::turn);
  const Explanation told = take(start(scenario).explain(0));
  std::vector<std::string> names;
  for (const ExplainedTerm& term : told.terms) {
    names.push_back(term.name);
    if (term.kind == "custom") continue;
    EXPECT_NE(term.formula, "") << term.name;
    EXPECT_NE(term.source, "") << term.name;
  }
  for (const char* name : {"separation.0", "separation.1", "alignment.1", "cohesion", "flee", "cruise",
                           "wander", "noise", "pointer", "external"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  for (const ParameterRow& row : parameter_rows()) {
    if (row.path == "flock.NAME.cohesion.weight") {
      const auto place = std::find(names.begin(), names.end(), "cohesion") - names.begin();
      EXPECT_EQ(told.terms[static_cast<std::size_t>(place)].formula, row.about.formula);
    }
  }
}

TEST(Explain, RulesOfOnesOwnComeByTheirNames) {
  Simulation simulation = world_of(bare(), {{{0, 0}, {1, 0}}, {{5, 0}}});
  simulation.add_rule("wind", -1, [](const View& view, Accelerations& out) {
    for (std::size_t i = 0; i < view.size(); ++i) out.add(i, 0.25f * static_cast<float>(view.id(i) + 1), 0);
  });
  simulation.external().add(*simulation.view().slot(1), 0, 2);
  const Explanation told = take(simulation.explain(1));
  EXPECT_EQ(told.terms.front().name, "wind");
  expect_same(told.terms.front().granted, {0.5f, 0, 0}, "wind");
  expect_same(told.acceleration, {0.5f, 2, 0}, "both");
  simulation.step();
  expect_same(velocity_of(simulation, 1), {0.5f, 2, 0}, "the step");
}

TEST(Explain, WhoIsNotThereOrOutOfPlayGetsASentence) {
  State state = state_of(2, {{{0, 0}, {1, 0}}, {{5, 0}}});
  state.velocity[1][1] = 2e15f;
  const Simulation simulation = world_from(bare(), state);
  EXPECT_EQ(simulation.explain(7).error(), "there is no boid with id 7 at step 0\n");
  EXPECT_EQ(simulation.explain(1).error(),
            "boid 1 is out of play because it met a bad number: it feels nothing\n");
  EXPECT_TRUE(take(simulation.explain(0)).neighbours.empty());
}

}  // namespace
}  // namespace sturnus::test
