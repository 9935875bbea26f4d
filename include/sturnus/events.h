// What people and events do to a running world: each command is carried out between two steps and logged.
#pragma once

#include <sturnus/vocabulary.h>

#include <cstdint>
#include <string>
#include <variant>

namespace sturnus {

/// Set a parameter by its path, e.g. "flock.birds.max_speed" to "12": any value as it would stand in a file.
struct SetParameter {
  std::string path;
  std::string value;
};
/// Add `count` boids around a place, spread over a ball of `radius` (length).
struct AddBoids {
  std::string flock;
  std::int64_t count = 1;
  Coordinates at;
  double radius = 0.0;
};
/// Lay out `count` pieces of food around a place, spread over a ball of `radius` (length).
struct AddFood {
  std::string food;
  std::int64_t count = 1;
  Coordinates at;
  double radius = 0.0;
};
/// Remove every boid, target, piece of food and obstacle within `radius` (length) of a place; of an obstacle
/// its centre counts, and planes stay. `along`, a direction of any length, makes the place a line through it,
/// as a hand reaches into space that sees it from one side; not given: the place alone.
struct EraseBoids {
  Coordinates at;
  double radius = 0.0;
  Coordinates along = {};
};
/// Put a boid somewhere with a velocity; the only way out of quarantine.
struct MoveBoid {
  std::uint64_t id = 0;
  Coordinates to;
  Coordinates velocity;
};
/// Move the pointer; `pressed` makes it felt. With `along` it is a line, and the offset to it the shortest.
struct MovePointer {
  PointerMode mode = PointerMode::attract;
  Coordinates at;
  bool pressed = true;
  Coordinates along = {};
};
/// Put a sphere (in 2D a circle) somewhere as an obstacle.
struct PlaceObstacle {
  Coordinates at;
  double radius = 1.0;  ///< length
};

/// Make everyone within `radius` (length) of a place, or of the line `along` through it, fly straight away
/// from it at full speed: a burst.
struct ScatterBoids {
  Coordinates at;
  double radius = 0.0;
  Coordinates along = {};
};
/// Put a target down; from then on it is one of the scenario's, called by the next free name.
struct PlaceTarget {
  TargetKind kind = TargetKind::attract;
  Coordinates at;
  SteeringForm form = SteeringForm::heading;
  double weight = 0.1;
  double radius = infinity;
};

using Command = std::variant<SetParameter, AddBoids, EraseBoids, MoveBoid, MovePointer, ScatterBoids,
                             PlaceTarget, PlaceObstacle, AddFood>;

/// A command and the step before which it is carried out.
struct Event {
  std::uint64_t step = 0;
  Command command;
};

}  // namespace sturnus
