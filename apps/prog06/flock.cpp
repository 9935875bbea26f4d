// Sets the six arguments and the settings in the scenario "prog06".
#include "flock.h"

#include <sturnus/files.h>

namespace prog06 {
namespace {

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

Status set_parameters(const Choices& choices, ScenarioDef& scenario) {
  for (const std::string& text : choices.parameters) {
    const auto equals = text.find('=');
    Status status = sturnus::set_parameter(scenario, trimmed(text.substr(0, equals)),
                                           sturnus::parse_value(trimmed(text.substr(equals + 1))));
    if (!status) return status;
  }
  if (scenario.space.dimensions == choices.dimensions) return {};
  return sturnus::Problem{"prog06", 0, "space.dimensions", "is chosen by --dimensions and not by --set",
                          false};
}

}  // namespace

sturnus::Result<sturnus::Simulation> open_flock(const Choices& choices) {
  auto scenario = sturnus::load_scenario("prog06");
  if (!scenario) return scenario.problems();
  sturnus::FlockDef& boids = scenario->flocks[0];
  boids.count = choices.boids;
  boids.separation[0].radius = choices.radius;
  boids.separation[0].weight = choices.separation;
  boids.alignment[0].weight = choices.alignment;
  boids.cohesion[0].weight = choices.cohesion;
  if (choices.seed) scenario->seed = *choices.seed;
  if (choices.dimensions == 3) make_a_cube(*scenario);
  set_pointer(*scenario);
  if (const Status status = set_parameters(choices, *scenario); !status) return status.problems();
  return sturnus::open_simulation(*scenario);
}

void hold(sturnus::Simulation& flock, sturnus::PointerMode mode, const sturnus::Point3& at, bool pressed) {
  sturnus::Coordinates place = {at[0], at[1]};
  if (flock.view().dimensions() == 3) place.push_back(at[2]);
  // It can't be refused: the place is finite and has as many coordinates as the space.
  (void)flock.push(sturnus::MovePointer{mode, place, pressed});
}

}  // namespace prog06
