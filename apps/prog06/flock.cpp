// Sets the six arguments and the settings in the scenario "prog06".
#include "flock.h"

#include <sturnus/files.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace prog06 {
namespace {

using sturnus::FlockDef;
using sturnus::Problem;
using sturnus::Problems;
using sturnus::ScenarioDef;
using sturnus::Status;

void make_a_cube(ScenarioDef& scenario) {
  scenario.space.dimensions = 3;
  scenario.space.min.push_back(-0.5);
  scenario.space.max.push_back(0.5);
}

// The mouse pulls as cohesion does, twice as hard as the assignment's weight of it.
void set_pointer(ScenarioDef& scenario) {
  scenario.pointer.form = sturnus::SteeringForm::linear;
  scenario.pointer.weight = 2;
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::string path_of(const Parameter& parameter) {
  return trimmed(parameter.text.substr(0, parameter.text.find('=')));
}

// What is wrong with a parameter, told where it was said.
Problem problem_of(const Parameter& parameter, const std::string& text) {
  if (parameter.file.empty()) return {"prog06", 0, "--set " + path_of(parameter), text, false};
  return {parameter.file, parameter.line, "set: " + path_of(parameter), text, false};
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t no_count = -1;

// Empties what an argument or an option fills: no parameter can be these values.
void empty_the_owned(ScenarioDef& scenario) {
  FlockDef& boids = scenario.flocks[0];
  boids.count = scenario.seed = no_count;
  boids.separation[0].radius = boids.separation[0].weight = no_number;
  boids.alignment[0].weight = boids.cohesion[0].weight = no_number;
}

void fill_the_owned(const Choices& choices, std::int64_t seed, ScenarioDef& scenario) {
  FlockDef& boids = scenario.flocks[0];
  boids.count = choices.boids;
  boids.separation[0].radius = choices.radius;
  boids.separation[0].weight = choices.separation;
  boids.alignment[0].weight = choices.alignment;
  boids.cohesion[0].weight = choices.cohesion;
  scenario.seed = choices.seed.value_or(seed);
}

// The argument or option whose place a parameter took; empty when it took nobody's.
std::string owner_of_the_filled(const ScenarioDef& scenario, int dimensions) {
  const FlockDef& boids = scenario.flocks[0];
  if (boids.count != no_count) return "N";
  if (!std::isnan(boids.separation[0].radius)) return "R";
  if (!std::isnan(boids.separation[0].weight)) return "ws";
  if (!std::isnan(boids.alignment[0].weight)) return "wa";
  if (!std::isnan(boids.cohesion[0].weight)) return "wc";
  if (scenario.seed != no_count) return "--seed";
  return scenario.space.dimensions == dimensions ? "" : "--dimensions";
}

Problems set_parameters(const Choices& choices, ScenarioDef& scenario) {
  Problems problems;
  for (const Parameter& parameter : choices.parameters) {
    ScenarioDef changed = scenario;
    const std::string value = trimmed(parameter.text.substr(parameter.text.find('=') + 1));
    const Status status = sturnus::set_parameter(changed, path_of(parameter), sturnus::parse_value(value));
    const std::string owner = owner_of_the_filled(changed, choices.dimensions);
    if (!status) {
      problems.push_back(problem_of(parameter, status.problems().front().text));
    } else if (!owner.empty()) {
      problems.push_back(problem_of(parameter, "is chosen by " + owner));
    } else {
      scenario = std::move(changed);
    }
  }
  return problems;
}

// The argument that fills a parameter; empty for others.
std::string argument_of(const std::string& path, const ScenarioDef& scenario) {
  const std::string boids = "flock." + scenario.flocks[0].name + ".";
  if (path == "flock.count" || path == boids + "count") return "N";
  if (path == boids + "separation.radius") return "R";
  if (path == boids + "separation.weight") return "ws";
  if (path == boids + "alignment.weight") return "wa";
  if (path == boids + "cohesion.weight") return "wc";
  return {};
}

// The library speaks of the scenario; its user said arguments and parameters.
Problem in_words_of_the_user(Problem problem, const Choices& choices, const ScenarioDef& scenario) {
  problem.file = "prog06";
  const std::string argument = argument_of(problem.key, scenario);
  if (!argument.empty()) {
    problem.key = argument;
    return problem;
  }
  const auto said =
      std::find_if(choices.parameters.rbegin(), choices.parameters.rend(),
                   [&](const Parameter& parameter) { return path_of(parameter) == problem.key; });
  return said == choices.parameters.rend() ? problem : problem_of(*said, problem.text);
}

}  // namespace

sturnus::Result<sturnus::Simulation> open_flock(const Choices& choices) {
  auto scenario = sturnus::load_scenario("prog06");
  if (!scenario) return scenario.problems();
  const std::int64_t seed = scenario->seed;
  if (choices.dimensions == 3) make_a_cube(*scenario);
  set_pointer(*scenario);
  empty_the_owned(*scenario);
  Problems problems = set_parameters(choices, *scenario);
  if (!problems.empty()) return problems;
  fill_the_owned(choices, seed, *scenario);
  auto flock = sturnus::open_simulation(*scenario);
  if (flock) return flock;
  for (const Problem& problem : flock.problems()) {
    problems.push_back(in_words_of_the_user(problem, choices, *scenario));
  }
  return problems;
}

void hold(sturnus::Simulation& flock, sturnus::PointerMode mode, const sturnus::Point3& at, bool pressed) {
  sturnus::Coordinates place = {at[0], at[1]};
  if (flock.view().dimensions() == 3) place.push_back(at[2]);
  // It can't be refused: the place is finite and has as many coordinates as the space.
  (void)flock.push(sturnus::MovePointer{mode, place, pressed});
}

}  // namespace prog06
