// What a run has at one moment, and how observers look at it.
//
// Boids stand in storage order, which CHANGES FROM STEP TO STEP: the neighbour index sorts them by place.
// A boid's name is its id. Use `View::slot(id)` to find one boid again and `View::slots_by_id()` to go
// through all of them in an order that stays.
#pragma once

#include <sturnus/scenario.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace sturnus {

/// One array for each axis (or colour channel); unused ones are empty.
using Columns = std::array<std::vector<float>, 3>;

/// The pointer as it stands.
struct PointerState {
  PointerMode mode = PointerMode::attract;
  bool pressed = false;
  std::array<float, 3> at{};     ///< length
  std::array<float, 3> along{};  ///< unit vector of the line that it is; zero: a point
};

/// No boid's id.
inline constexpr std::uint64_t nobody = ~std::uint64_t{0};

/// The clocks of those that hunt, in the scenario's time, and whom they have in focus. Every array has one
/// entry for each boid where some flock uses it.
struct Life {
  std::vector<double> full;          ///< how long it still ignores prey; 0: hungry
  std::vector<double> fasting;       ///< time since its last meal, or since it came into the world
  std::vector<double> jump;          ///< what is left of a jump; 0: does not jump
  std::vector<double> rest;          ///< from the end of a jump until the next may begin; 0: ready
  std::vector<std::uint64_t> focus;  ///< id of the prey that it is after, or `nobody`
};

/// Pieces of food, in the order in which they came.
struct Food {
  std::vector<std::uint64_t> id;   ///< from the same numbers as boids
  std::vector<std::uint8_t> kind;  ///< index of the kind in file order, from 0
  Columns position;                ///< length

  std::size_t size() const { return id.size(); }
};

/// Exactly what changes during a run, as a struct of arrays in storage order. Together with the effective
/// scenario it is all there is to know. Every array has one entry for each boid, or none where it is unused.
struct State {
  int dimensions = 2;
  std::uint64_t step = 0;     ///< steps done
  std::uint64_t next_id = 0;  ///< ids are never used twice
  std::vector<std::uint64_t> id;
  std::vector<std::uint8_t> flock;        ///< index in file order, from 0
  std::vector<std::uint8_t> quarantined;  ///< 1: a bad number was met; neither moves nor is seen
  Columns position;                       ///< length
  Columns velocity;                       ///< length per time
  Columns wander;                         ///< unit vectors; empty where no flock wanders
  Columns colour;                         ///< red, green, blue, 0 to 1; empty where colours don't drift
  Life life;
  Food food;  ///< not boids: the only part of the state that has other sizes
  PointerState pointer;
  std::vector<Obstacle>
      obstacles;  ///< as they stand, numbered by their order: that in which they were placed

  std::size_t size() const { return id.size(); }
};

/// A read-only look at a run. Valid until the run steps, is changed or ends.
class View {
 public:
  /// `previous_*`: position and velocity before the last step, in the same order; empty before the first.
  View(const State& state, const ScenarioDef& scenario, const Columns& previous_position,
       const Columns& previous_velocity)
      : state_(&state),
        scenario_(&scenario),
        previous_position_(&previous_position),
        previous_velocity_(&previous_velocity) {}

  std::size_t size() const { return state_->size(); }
  int dimensions() const { return state_->dimensions; }
  std::uint64_t step() const { return state_->step; }
  const State& state() const { return *state_; }
  const ScenarioDef& scenario() const { return *scenario_; }

  std::uint64_t id(std::size_t slot) const { return state_->id[slot]; }
  int flock(std::size_t slot) const { return state_->flock[slot]; }
  bool quarantined(std::size_t slot) const { return state_->quarantined[slot] != 0; }
  /// x, y, z; z is 0 in two dimensions.
  std::array<float, 3> position(std::size_t slot) const { return at(state_->position, slot); }
  std::array<float, 3> velocity(std::size_t slot) const { return at(state_->velocity, slot); }

  /// Whether the last step is known: not before the first step, nor after a restore or a command that adds,
  /// erases or moves boids.
  bool has_previous() const { return size() > 0 && (*previous_position_)[0].size() == size(); }
  std::array<float, 3> previous_position(std::size_t slot) const { return at(*previous_position_, slot); }
  std::array<float, 3> previous_velocity(std::size_t slot) const { return at(*previous_velocity_, slot); }

  /// Where a boid stands now, or nothing when it is gone. Looks through all.
  std::optional<std::size_t> slot(std::uint64_t id) const;
  /// All slots in order of their ids.
  std::vector<std::uint32_t> slots_by_id() const;

 private:
  static std::array<float, 3> at(const Columns& columns, std::size_t slot) {
    std::array<float, 3> out{};
    for (std::size_t axis = 0; axis < 3 && !columns[axis].empty(); ++axis) out[axis] = columns[axis][slot];
    return out;
  }

  const State* state_;
  const ScenarioDef* scenario_;
  const Columns* previous_position_;
  const Columns* previous_velocity_;
};

}  // namespace sturnus
