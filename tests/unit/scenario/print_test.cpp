// Scenarios as text and back: the effective scenario loads again to the same definition.
#include <gtest/gtest.h>

#include "scenario/events.h"
#include "support.h"

namespace sturnus::test {
namespace {

void expect_fixed_point(const ScenarioDef& scenario) {
  const std::string text = to_toml(scenario);
  const auto read = parse_scenario(text, scenario.file.empty() ? "again.toml" : scenario.file);
  ASSERT_TRUE(static_cast<bool>(read)) << read.error() << text;
  EXPECT_EQ(to_toml(*read), text);
}

TEST(ToToml, OfTheDefaultsLoadsAgain) {
  expect_fixed_point({});
}

TEST(ToToml, OfEveryShippedScenarioLoadsAgainAndRunsTheSame) {
  for (const ShippedScenario& shipped : shipped_scenarios()) {
    SCOPED_TRACE(shipped.name);
    ScenarioDef scenario = take(parse_scenario(shipped.text, shipped.name));
    expect_fixed_point(scenario);
    for (FlockDef& flock : scenario.flocks) flock.count = std::min<std::int64_t>(flock.count, 60);
    Simulation one = start(scenario), other = start(take(parse_scenario(to_toml(scenario), shipped.name)));
    one.run(5);
    other.run(5);
    EXPECT_EQ(one.hash(), other.hash());
  }
}

TEST(ToToml, KeepsListsOrdersNamesAndEvents) {
  const ScenarioDef scenario = take(parse_scenario(R"(
title = "a \"title\" with \\ and \t"
try = ["one", "two"]
[space]
min = [0, 0, 0]
max = [10, 20, 30]
dimensions = 3
boundary = { kind = "turn", margin = [1, 2, 3], strength = 0.5 }
[run]
events = [[3, "pointer", "repel", [1, 2, 3]], [1, "set", "flock.fish.max_speed", inf], [2, "erase", [1, 2, 3], 4]]
[[flock]]
name = "fish"
noise = { acceleration = 1 }
cohesion = [{ ring = [1, 2] }, { radius = inf, of = ["fish", "crabs"] }]
separation = { radius = 3, field_of_view = 200 }
glyph = "circle"
[[flock]]
name = "crabs"
like = "fish"
flee = { from = ["fish"], radius = 3 }
alignment = []
)",
                                                   "fish.toml"));
  expect_fixed_point(scenario);
  const ScenarioDef again = take(parse_scenario(to_toml(scenario), "fish.toml"));
  EXPECT_EQ(again.title, "a \"title\" with \\ and \t");
  ASSERT_EQ(again.run.events.size(), 3u);
  EXPECT_EQ(again.run.events[0].step, 1u);
  EXPECT_TRUE(std::holds_alternative<MovePointer>(again.run.events[2].command));
  const FlockDef& fish = again.flocks[0];
  EXPECT_LT(fish.noise->order, fish.cohesion[0].order);
  EXPECT_LT(fish.cohesion[1].order, fish.separation[0].order);
  EXPECT_EQ(fish.cohesion[1].of.names, (std::vector<std::string>{"fish", "crabs"}));
  EXPECT_EQ(again.flocks[1].flee.front().from, (std::vector<std::string>{"fish"}));
}

// With "first" only the first term that asks for anything counts, so it matters who stands where.
TEST(ToToml, KeepsTheOrderOfTermsWhereAnotherStandsBetweenTwoOfAKind) {
  const ScenarioDef scenario = take(parse_scenario(R"(
[[flock]]
name = "fish"
count = 40
arbitration = "first"
alignment = []
[[flock.separation]]
radius = 3
[flock.noise]
acceleration = 0.01
[[flock.cohesion]]
radius = 100
[[flock.separation]]
radius = 200
edge = "closed"
[flock.cruise]
speed = 2
[[flock]]
name = "crabs"
like = "fish"
[[food]]
)",
                                                   "fish.toml"));
  expect_fixed_point(scenario);
  const ScenarioDef again = take(parse_scenario(to_toml(scenario), "fish.toml"));
  for (const FlockDef& flock : again.flocks) {
    ASSERT_EQ(flock.separation.size(), 2u);
    const std::vector<int> orders = {flock.separation[0].order, flock.noise->order, flock.cohesion[0].order,
                                     flock.separation[1].order, flock.cruise->order};
    EXPECT_TRUE(std::is_sorted(orders.begin(), orders.end())) << flock.name;
    EXPECT_TRUE(flock.alignment.empty());
    EXPECT_EQ(flock.separation[1].edge, Edge::closed);
  }
  Simulation one = start(scenario), other = start(again);
  one.run(20);
  other.run(20);
  EXPECT_EQ(one.hash(), other.hash());
}

TEST(ToToml, OfAFlockThatFeelsNothingDoesNotBringBackTheDefaults) {
  const ScenarioDef read = take(parse_scenario(to_toml(bare()), "bare.toml"));
  EXPECT_TRUE(read.flocks.front().separation.empty());
  EXPECT_TRUE(read.flocks.front().alignment.empty());
  EXPECT_TRUE(read.flocks.front().cohesion.empty());
  EXPECT_TRUE(std::isinf(read.flocks.front().max_speed));
}

Event round_trip(const Event& event) {
  const auto read = event_from(to_value(event));
  if (const auto* error = std::get_if<std::string>(&read)) throw std::runtime_error(*error);
  return std::get<Event>(read);
}

TEST(Events, ReadBackAsTheyWerePrinted) {
  const Event set = round_trip({7, SetParameter{"flock.boids.separation.ring", "[1, 2]"}});
  EXPECT_EQ(set.step, 7u);
  EXPECT_EQ(std::get<SetParameter>(set.command).value, "[1, 2]");
  const auto add = std::get<AddBoids>(round_trip({0, AddBoids{"fish", 3, {1.5, 2}, 0.1}}).command);
  EXPECT_EQ(add.flock, "fish");
  EXPECT_EQ(add.count, 3);
  EXPECT_EQ(add.at, (Coordinates{1.5, 2}));
  EXPECT_EQ(add.radius, 0.1);
  const auto erase = std::get<EraseBoids>(round_trip({1, EraseBoids{{1, 2, 3}, 4}}).command);
  EXPECT_EQ(erase.at, (Coordinates{1, 2, 3}));
  EXPECT_EQ(erase.radius, 4);
  const auto move = std::get<MoveBoid>(round_trip({1, MoveBoid{9, {1, 2}, {3, 4}}}).command);
  EXPECT_EQ(move.id, 9u);
  EXPECT_EQ(move.to, (Coordinates{1, 2}));
  EXPECT_EQ(move.velocity, (Coordinates{3, 4}));
  const auto pointer =
      std::get<MovePointer>(round_trip({1, MovePointer{PointerMode::repel, {1, 2}, true}}).command);
  EXPECT_EQ(pointer.mode, PointerMode::repel);
  EXPECT_TRUE(pointer.pressed);
  EXPECT_FALSE(
      std::get<MovePointer>(round_trip({1, MovePointer{PointerMode::attract, {1, 2}, false}}).command)
          .pressed);
}

TEST(Events, SayWhatIsWrongWithThem) {
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {"5", "list"},
           {"[]", "ends before its step"},
           {"[1.5, \"set\"]", "whole number"},
           {"[-1, \"set\"]", "whole number"},
           {"[1, \"sett\"]", "did you mean \"set\"?"},
           {"[1, \"set\", \"seed\"]", "needs a value"},
           {"[1, 2]", "must be text"},
           {"[1, \"set\", 5, 6]", "must be text"},
           {"[1, \"add\", \"a\", 2.5, [0]]", "whole number"},
           {"[1, \"erase\", [0, \"a\"], 1]", "list of numbers"},
           {"[1, \"erase\", [0, 0]]", "ends before its radius"},
           {"[1, \"erase\", [0, 0], 1, 2]", "direction must be a list"},
           {"[1, \"erase\", [0, 0], 1, [0, 1], 2]", "more parts"},
           {"[1, \"pointer\", \"push\", [0, 0]]", "\"push\""},
           {"[1, \"move\", 1e300, [0, 0], [0, 0]]", "whole number"}}) {
    const auto event = event_from(parse_value(text));
    ASSERT_TRUE(std::holds_alternative<std::string>(event)) << text;
    EXPECT_NE(std::get<std::string>(event).find(part), std::string::npos)
        << text << ": " << std::get<std::string>(event);
  }
}

TEST(Events, AreToldWithTheirLine) {
  const auto result = parse_scenario(
      "[run]\nevents = [\n  [1, \"erase\", [0, 0], 1],\n  [2, \"erace\", [0, 0], 1],\n]\n[[flock]]\n",
      "a.toml");
  ASSERT_FALSE(result);
  EXPECT_TRUE(result.error().starts_with("a.toml:4: run.events: ")) << result.error();
  EXPECT_FALSE(parse_scenario("[run]\nevents = 5\n[[flock]]\n", "a.toml"));
  EXPECT_FALSE(
      parse_scenario("[run]\nevents = [[1, \"set\", \"title\", 1979-05-27]]\n[[flock]]\n", "a.toml"));
}

TEST(Extent, FollowsTheCornersOrTheNumberOfBoids) {
  ScenarioDef scenario;
  scenario.flocks.front().count = 3;
  scenario.space.per_boid = 300;
  EXPECT_EQ(extent_of(scenario).max, (Coordinates{15, 15}));  // a square of 900
  scenario.space.dimensions = 3;
  scenario.space.per_boid = 9;
  EXPECT_EQ(extent_of(scenario).min, (Coordinates{-1.5, -1.5, -1.5}));  // a cube of 27
  scenario.space.min = {0, 1, 2};
  scenario.space.max = {9, 8, 7};
  EXPECT_EQ(extent_of(scenario).max, (Coordinates{9, 8, 7}));
}

}  // namespace
}  // namespace sturnus::test
