// Scenario text: short forms, lists of terms, `like`, and one clear sentence for everything that is wrong.
#include <gtest/gtest.h>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef read(const std::string& text) {
  return take(parse_scenario(text, "folder/fish.toml"));
}

/// All sentences about a text that must be refused.
std::string refusal(const std::string& text) {
  const Result<ScenarioDef> result = parse_scenario(text, "fish.toml");
  EXPECT_FALSE(result) << text;
  return result.error();
}

void expect_refusal(const std::string& text, const std::string& start, const std::string& part) {
  const std::string sentences = refusal(text);
  EXPECT_NE(("\n" + sentences).find("\n" + start), std::string::npos)
      << "no sentence starts with " << start << "\n"
      << sentences;
  EXPECT_NE(sentences.find(part), std::string::npos) << "no sentence says " << part << "\n" << sentences;
}

TEST(Parse, TheShortestFile) {
  const ScenarioDef scenario = read("[[flock]]\ncount = 300\n");
  EXPECT_EQ(scenario.name, "fish");
  EXPECT_EQ(scenario.file, "folder/fish.toml");
  ASSERT_EQ(scenario.flocks.size(), 1u);
  const FlockDef& flock = scenario.flocks.front();
  EXPECT_EQ(flock.name, "boids");
  EXPECT_EQ(flock.count, 300);
  EXPECT_EQ(flock.separation.size() + flock.alignment.size() + flock.cohesion.size(), 3u);
}

TEST(Parse, WhoNamesOneNeighbourTermNamesThemAll) {
  const FlockDef flock = read("[[flock]]\ncohesion = { weight = 1 }\n").flocks.front();
  EXPECT_TRUE(flock.separation.empty());
  EXPECT_TRUE(flock.alignment.empty());
  EXPECT_EQ(flock.cohesion.size(), 1u);
  EXPECT_EQ(read("[[flock]]\ncruise = { speed = 3 }\n").flocks.front().separation.size(), 1u);
}

TEST(Parse, ShortForms) {
  const ScenarioDef scenario = read(R"(
index = "tree"
[space]
boundary = "bounce"
[run]
measure = 25
[[flock]]
start = "ring"
colour = "#ff8000"
separation = { radius = 7 }
)");
  EXPECT_EQ(scenario.index.kind, IndexKind::tree);
  EXPECT_EQ(scenario.space.boundary.kind, BoundaryKind::bounce);
  EXPECT_EQ(scenario.run.measure_every, 25);
  EXPECT_EQ(scenario.flocks.front().start.region, StartRegion::ring);
  EXPECT_EQ(scenario.flocks.front().colour.start, "#ff8000");
  EXPECT_EQ(scenario.flocks.front().separation.front().radius, 7);
}

TEST(Parse, ShortFormsSayWhichKeyTheyMean) {
  expect_refusal("[space]\nboundary = \"wrapp\"\n[[flock]]\n",
                 "fish.toml:2: space.boundary.kind: ", "did you mean \"wrap\"?");
  expect_refusal("index = 5\n[[flock]]\n", "fish.toml:1: index.kind: ", "must be one of");
  expect_refusal("[[flock]]\nstart = true\n", "fish.toml:2: flock.boids.start.region: ", "must be one of");
  expect_refusal("space = 5\n[[flock]]\n", "fish.toml:1: space: ", "must be a table");
}

TEST(Parse, RingsAndRadii) {
  const FlockDef flock = read(
                             "[[flock]]\nseparation = { ring = [2, 9] }\ncohesion = { radius = inf "
                             "}\n[space]\nboundary = 'open'\n")
                             .flocks.front();
  EXPECT_EQ(flock.separation.front().inner, 2);
  EXPECT_EQ(flock.separation.front().radius, 9);
  EXPECT_TRUE(std::isinf(flock.cohesion.front().radius));
  expect_refusal("[[flock]]\nseparation = { ring = [2, 9], radius = 5 }\n",
                 "fish.toml:2: flock.boids.separation.ring: ", "not both");
  expect_refusal("[[flock]]\nseparation = { ring = [9, 2] }\n",
                 "fish.toml:2: flock.boids.separation.radius: ", "smaller first");
  expect_refusal("[[flock]]\nseparation = { ring = [2] }\n",
                 "fish.toml:2: flock.boids.separation.radius: ", "two numbers");
  expect_refusal("[[flock]]\nseparation = { radius = -1 }\n",
                 "fish.toml:2: flock.boids.separation.radius: ", "negative");
}

TEST(Parse, ListsOfTerms) {
  const ScenarioDef scenario = read(R"([[flock]]
separation = [
  { radius = 3 },
  { radius = 30, weight = 0.1, strength = "d" },
]
alignment = []
[[flock.cohesion]]
radius = 5
[[flock.cohesion]]
radius = 6
)");
  const FlockDef& flock = scenario.flocks.front();
  ASSERT_EQ(flock.separation.size(), 2u);
  EXPECT_EQ(flock.separation[1].strength, Strength::grows);
  EXPECT_LT(flock.separation[0].order, flock.separation[1].order);
  EXPECT_TRUE(flock.alignment.empty());
  EXPECT_EQ(flock.cohesion[1].radius, 6);
  expect_refusal("[[flock]]\nseparation = [\n  { radius = 3 },\n  { radius = nan },\n]\n",
                 "fish.toml:4: flock.boids.separation.1.radius: ", "nan");
  expect_refusal("[[flock]]\nseparation = 5\n", "fish.toml:2: flock.boids.separation: ", "list of tables");
  expect_refusal("[[flock]]\ncruise = [{}, {}]\n", "fish.toml:2: flock.boids.cruise: ", "table");
}

TEST(Parse, LikeTakesEverythingElseFromAnEarlierFlock) {
  const ScenarioDef scenario = read(R"(
[[flock]]
name = "fish"
count = 70
max_speed = 3
separation = { radius = 7, weight = 2 }
cruise = { speed = 2.5 }
[[flock]]
name = "more"
like = "fish"
count = 5
separation = { radius = 8 }
)");
  const FlockDef& more = scenario.flocks[1];
  EXPECT_EQ(more.name, "more");
  EXPECT_EQ(more.count, 5);
  EXPECT_EQ(more.max_speed, 3);
  EXPECT_EQ(more.separation.front().radius, 8);
  EXPECT_EQ(more.separation.front().weight, 2);
  EXPECT_TRUE(more.alignment.empty());
  ASSERT_TRUE(more.cruise.has_value());
  EXPECT_EQ(more.cruise->speed, 2.5);
  expect_refusal("[[flock]]\nname = \"fish\"\n[[flock]]\nlike = \"fsh\"\n",
                 "fish.toml:4: flock.like: ", "did you mean \"fish\"?");
  expect_refusal("[[flock]]\nlike = \"boids\"\n", "fish.toml:2: flock.like: ", "no earlier flock");
}

TEST(Parse, FlocksWithoutNamesGetSome) {
  const ScenarioDef scenario = read("[[flock]]\n[[flock]]\n[[flock]]\nname = 'c'\n");
  EXPECT_EQ(scenario.flocks[0].name, "boids");
  EXPECT_EQ(scenario.flocks[1].name, "boids-2");
  EXPECT_EQ(scenario.flocks[2].name, "c");
}

TEST(Parse, UnknownKeysAtEveryLevel) {
  expect_refusal("sed = 5\n[[flock]]\n", "fish.toml:1: sed: ", "did you mean \"seed\"?");
  expect_refusal("[spce]\n[[flock]]\n", "fish.toml:1: spce: ", "did you mean \"space\"?");
  expect_refusal("[space]\nmni = [0, 0]\n[[flock]]\n", "fish.toml:2: space.mni: ", "did you mean \"min\"?");
  expect_refusal("[[flock]]\nmax_sped = 3\n",
                 "fish.toml:2: flock.boids.max_sped: ", "did you mean \"max_speed\"?");
  expect_refusal("[[flock]]\ncohesion = { radus = 3 }\n",
                 "fish.toml:2: flock.boids.cohesion.radus: ", "did you mean \"radius\"?");
}

TEST(Parse, SyntaxErrorsNameTheirLine) {
  EXPECT_TRUE(refusal("seed = 5\nseed = \n").starts_with("fish.toml:2: "));
  const std::string broken_term = refusal("[[flock]]\nseparation = { radius = 3,\n  weight = 2 }\n");
  EXPECT_TRUE(broken_term.starts_with("fish.toml:2: ") || broken_term.starts_with("fish.toml:3: "))
      << broken_term;
  EXPECT_NE(broken_term.find("on one line"), std::string::npos) << broken_term;
}

TEST(Parse, SaysAllProblemsAtOnce) {
  const Problems problems =
      parse_scenario("sed = 1\n[space]\ndimensions = 4\n[[flock]]\ncount = -3\nmax_speed = \"fast\"\n",
                     "fish.toml")
          .problems();
  EXPECT_GE(problems.size(), 4u) << to_text(problems);
}

TEST(Parse, AFileWithoutAFlockIsNone) {
  expect_refusal("", "fish.toml: flock: ", "[[flock]] with count = 300");
  expect_refusal("title = 'a'\n", "fish.toml: flock: ", "[[flock]]");
}

TEST(Parse, WarningsStopNothingAndAreTold) {
  Problems problems;
  const auto result = parse_scenario(R"([space]
min = [0, 0]
max = [100, 100]
boundary = { kind = "turn", margin = 60, strength = 1 }
[[flock]]
)",
                                     "fish.toml", &problems);
  ASSERT_TRUE(static_cast<bool>(result)) << result.error();
  ASSERT_FALSE(problems.empty());
  EXPECT_TRUE(problems.front().is_warning);
  EXPECT_TRUE(problems.front().sentence().starts_with("fish.toml:4: space.boundary.margin: warning: "))
      << problems.front().sentence();
  EXPECT_NE(problems.front().text.find("cross"), std::string::npos);
}

TEST(Parse, CornersOrASpacePerBoidButNotBoth) {
  expect_refusal("[space]\nmin = [0, 0]\nmax = [9, 9]\nper_boid = 3\n[[flock]]\n",
                 "fish.toml:4: space.per_boid: ", "not both");
  expect_refusal("[space]\nmin = [0, 0]\n[[flock]]\n", "fish.toml:1: space.max: ", "go together");
}

}  // namespace
}  // namespace sturnus::test
