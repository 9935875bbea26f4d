// What can be wrong with a definition beyond the range of one number, whether it was read or filled in by
// hand.
#include <gtest/gtest.h>

#include <functional>

#include "support.h"

namespace sturnus::test {
namespace {

/// Expects an error about that key with that part of a sentence.
void expect_error(const std::function<void(ScenarioDef&)>& spoil, const std::string& key,
                  const std::string& part) {
  ScenarioDef scenario;
  ASSERT_FALSE(has_errors(check(scenario)));
  spoil(scenario);
  for (const Problem& problem : check(scenario)) {
    if (!problem.is_warning && problem.key == key && problem.text.find(part) != std::string::npos) return;
  }
  ADD_FAILURE() << "nothing about " << key << " (" << part << ") in\n" << to_text(check(scenario));
}

FlockDef& flock_of(ScenarioDef& scenario) {
  return scenario.flocks.front();
}

TEST(Check, Limits) {
  expect_error([](ScenarioDef& s) { flock_of(s).max_speed = 0.5; }, "flock.boids.max_speed",
               "below min_speed 1");
  expect_error([](ScenarioDef& s) { s.time.dt = 0; }, "time.dt", "above 0");
  expect_error([](ScenarioDef& s) { s.time.dt = std::nan(""); }, "time.dt", "nan");
  expect_error([](ScenarioDef& s) { flock_of(s).max_acceleration = -1; }, "flock.boids.max_acceleration",
               "negative");
  expect_error([](ScenarioDef& s) { flock_of(s).field_of_view = 361; }, "flock.boids.field_of_view",
               "at most 360");
  expect_error([](ScenarioDef& s) { flock_of(s).separation.front().sample = 1.5; },
               "flock.boids.separation.sample", "at most 1");
  expect_error([](ScenarioDef& s) { flock_of(s).cohesion.front().field_of_view = std::nan(""); },
               "flock.boids.cohesion.field_of_view", "nan");
  expect_error([](ScenarioDef& s) { s.space.dimensions = 4; }, "space.dimensions", "at most 3");
  expect_error([](ScenarioDef& s) { s.space.dimensions = -1; }, "space.dimensions", "at least 2");
}

TEST(Check, Space) {
  expect_error([](ScenarioDef& s) { s.space.min = {0, 0}; }, "space.max", "missing");
  expect_error([](ScenarioDef& s) { s.space.max = {0, 0}; }, "space.min", "missing");
  expect_error(
      [](ScenarioDef& s) {
        s.space.min = {0, 0, 0}, s.space.max = {1, 1};
      },
      "space.min", "2 numbers");
  expect_error(
      [](ScenarioDef& s) {
        s.space.min = {0, 5}, s.space.max = {1, 5};
      },
      "space.max", "5 is not above 5");
  expect_error(
      [](ScenarioDef& s) {
        s.space.min = {0, 0}, s.space.max = {1, infinity};
      },
      "space.max", "finite");
  expect_error(
      [](ScenarioDef& s) {
        s.space.min = {0, 0}, s.space.max = {1, 1e16};
      },
      "space.max", "beyond 1e15");
  expect_error([](ScenarioDef& s) { s.space.per_boid = 1e300; }, "space.per_boid", "beyond 1e15");
  expect_error([](ScenarioDef& s) { s.space.per_boid = 0; }, "space.per_boid", "above 0");
  expect_error(
      [](ScenarioDef& s) {
        s.space.boundary.margin = {1, 2, 3};
      },
      "space.boundary.margin", "2 numbers");
}

TEST(Check, CrossingMarginsAreAWarning) {
  ScenarioDef scenario;
  scenario.space.min = {0, 0};
  scenario.space.max = {100, 50};
  scenario.space.boundary = {BoundaryKind::turn, {30}, 1};
  const Problems problems = check(scenario);
  ASSERT_EQ(problems.size(), 1u) << to_text(problems);
  EXPECT_TRUE(problems.front().is_warning);
  EXPECT_NE(problems.front().text.find("cross on the y axis"), std::string::npos);
  scenario.space.boundary.margin = {25};
  EXPECT_TRUE(check(scenario).empty());
}

TEST(Check, Rings) {
  expect_error([](ScenarioDef& s) { flock_of(s).separation.front().inner = 20; },
               "flock.boids.separation.radius", "below the inner radius 20");
  expect_error([](ScenarioDef& s) { flock_of(s).alignment.front().inner = -1; },
               "flock.boids.alignment.radius", "negative");
}

TEST(Check, AnInfiniteRadiusMeansTheWholePopulation) {
  const auto open = [](ScenarioDef& s) { s.space.boundary.kind = BoundaryKind::open; };
  ScenarioDef fine;
  open(fine);
  flock_of(fine).cohesion.front().radius = flock_of(fine).alignment.front().radius = infinity;
  EXPECT_FALSE(has_errors(check(fine))) << to_text(check(fine));
  expect_error([&](ScenarioDef& s) { open(s), flock_of(s).separation.front().radius = infinity; },
               "flock.boids.separation.radius", "strength \"d\"");
  expect_error([](ScenarioDef& s) { flock_of(s).cohesion.front().radius = infinity; },
               "flock.boids.cohesion.radius", "wrapped space");
  expect_error([&](ScenarioDef& s) { open(s), flock_of(s).cohesion = {{.radius = infinity, .inner = 1}}; },
               "flock.boids.cohesion.radius", "inner radius");
  expect_error([&](ScenarioDef& s) { open(s), flock_of(s).cohesion = {{.radius = infinity, .sample = 0.5}}; },
               "flock.boids.cohesion.radius", "sampled");
  expect_error(
      [&](ScenarioDef& s) {
        open(s), flock_of(s).alignment = {{.radius = infinity, .field_of_view = 200.0}};
      },
      "flock.boids.alignment.radius", "field of view of 360");
  expect_error(
      [&](ScenarioDef& s) {
        flock_of(s).alignment.front().radius = infinity;
        flock_of(s).field_of_view = 200;
      },
      "flock.boids.alignment.radius", "field of view of 360");
  expect_error([](ScenarioDef& s) { flock_of(s).flee = {{.from = {"boids"}, .radius = infinity}}; },
               "flock.boids.flee.radius", "finite");
}

TEST(Check, Names) {
  expect_error([](ScenarioDef& s) { flock_of(s).name = "a.b"; }, "flock.a.b.name", "letters");
  expect_error([](ScenarioDef& s) { flock_of(s).name = "own"; }, "flock.own.name", "meaning of its own");
  expect_error([](ScenarioDef& s) { s.flocks.push_back(s.flocks.front()); }, "flock.boids.name",
               "two flocks");
  expect_error([](ScenarioDef& s) { s.flocks.clear(); }, "flock", "no flock");
  expect_error(
      [](ScenarioDef& s) {
        flock_of(s).cohesion.front().of = {Whose::Kind::named, {"boid"}};
      },
      "flock.boids.cohesion.of", "did you mean \"boids\"?");
  expect_error([](ScenarioDef& s) { flock_of(s).flee = {Flee{}}; }, "flock.boids.flee.from", "nobody");
  expect_error([](ScenarioDef& s) { flock_of(s).flee = {{.from = {"hawks"}}}; }, "flock.boids.flee.from",
               "hawks");
  expect_error([](ScenarioDef& s) { s.flocks.assign(65, FlockDef{}); }, "flock", "64");
}

TEST(Check, TermsOverNeighbours) {
  const auto terms = [](std::size_t count) {
    return [count](ScenarioDef& s) { flock_of(s).separation.assign(count, Separation{}); };
  };
  expect_error(terms(62), "flock.boids", "there are 64 terms over neighbours; a flock can have 63");
  ScenarioDef most;
  terms(61)(most);
  EXPECT_FALSE(has_errors(check(most)));
}

TEST(Check, Start) {
  const auto start = [](ScenarioDef& s) -> Start& { return s.flocks.front().start; };
  expect_error([&](ScenarioDef& s) { start(s).region = StartRegion::box; }, "flock.boids.start.region",
               "min and max");
  expect_error(
      [&](ScenarioDef& s) {
        start(s).region = StartRegion::box, start(s).min = {1, 1}, start(s).max = {0, 2};
      },
      "flock.boids.start.max", "below min");
  expect_error([&](ScenarioDef& s) { start(s).region = StartRegion::ring, start(s).inner = 2; },
               "flock.boids.start.inner", "above its radius");
  expect_error([&](ScenarioDef& s) { start(s).heading = {1}; }, "flock.boids.start.heading", "2 numbers");
  expect_error([&](ScenarioDef& s) { start(s).min_speed = 9; }, "flock.boids.start.speed", "smaller");
  expect_error([&](ScenarioDef& s) { start(s).radius = infinity; }, "flock.boids.start.radius", "finite");
}

TEST(Check, ColourAndCamera) {
  expect_error([](ScenarioDef& s) { flock_of(s).colour.start = "red"; }, "flock.boids.colour.start",
               "#rrggbb");
  expect_error([](ScenarioDef& s) { flock_of(s).colour.start = "#12345g"; }, "flock.boids.colour.start",
               "#rrggbb");
  expect_error([](ScenarioDef& s) { s.camera.eye = {1, 2}; }, "camera.eye", "3 numbers");
  expect_error(
      [](ScenarioDef& s) {
        s.camera.eye = s.camera.target = {1, 2, 3};
      },
      "camera.eye", "where the target is");
}

TEST(Check, EventsAgainstTheScenarioAsItThenStands) {
  expect_error(
      [](ScenarioDef& s) {
        s.run.events = {{5, AddBoids{"birds", 1, {0, 0}, 0}}};
      },
      "run.events.0", "the event of step 5: there is no flock");
  expect_error(
      [](ScenarioDef& s) {
        s.run.events = {{5, SetParameter{"flock.boids.min_speed", "9"}}};
      },
      "run.events.0", "max_speed");
  ScenarioDef scenario;
  scenario.run.events = {{5, SetParameter{"flock.boids.max_speed", "20"}},
                         {6, SetParameter{"flock.boids.min_speed", "9"}}};
  EXPECT_FALSE(has_errors(check(scenario))) << to_text(check(scenario));
}

// No file can crash or hang the program: extreme values are refused, or they run.
TEST(Check, ExtremeValuesAreRefusedOrRun) {
  for (const ParameterRow& row : parameter_rows()) {
    if (row.path.ends_with(".count") || row.path == "format") continue;
    std::string path = row.path;
    if (const auto name = path.find("NAME"); name != std::string::npos) path.replace(name, 4, "boids");
    for (const char* value : {"0", "-1", "1e-300", "1e-40", "1e-12", "1e12", "1e38", "1e300", "inf", "-1e300",
                              "[0, 0]", "[1e300, 1e301]", "[-1e38, 1e38]", "[0, 1e-40]"}) {
      for (const bool wraps : {true, false}) {
        ScenarioDef scenario;
        scenario.flocks.front().count = 20;
        scenario.flocks.front().noise = Noise{.acceleration = 0.1, .turn = 10};
        scenario.flocks.front().wander = Wander{};
        scenario.space.boundary.kind = wraps ? BoundaryKind::wrap : BoundaryKind::bounce;
        if (row.path.starts_with("space.m")) scenario.space.min = {-20, -20}, scenario.space.max = {20, 20};
        if (!set_parameter(scenario, path, parse_value(value))) continue;
        SCOPED_TRACE(path + " = " + value);
        auto simulation = Simulation::create(scenario, {.threads = 1, .tables = {}});
        if (!simulation) continue;
        simulation->run(2);
        EXPECT_TRUE(all_finite(simulation->view().state()));
      }
    }
  }
}

}  // namespace
}  // namespace sturnus::test
