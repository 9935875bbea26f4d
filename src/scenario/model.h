// The compiled scenario: constant during a step, in the numbers that the step computes with.
#pragma once

#include <sturnus/scenario.h>

#include <array>
#include <cstdint>
#include <optional>

#include "scenario/behaviour_model.h"

namespace sturnus {

/// What a neighbour contributes to a sum.
enum class Quantity { offset, velocity, heading, colour };

/// One sum over neighbours, for the members of one flock: a row of data over the one kernel.
struct NeighbourRow {
  Quantity quantity = Quantity::offset;
  Strength strength = Strength::grows;  ///< of an offset
  float inner_squared = 0;              ///< inner² <= d²
  float outer_squared = 0;              ///< d² < outer²; a closed edge is the next float
  float cos_half_view = -1;
  bool sees_all = true;
  bool whole_population = false;   ///< totals minus self, no ring
  std::uint32_t sample_below = 0;  ///< a neighbour counts when its hash lies below; 0: all count
  std::uint64_t flocks = 0;        ///< a bit for every flock that is looked at
};

enum class TermKind {
  separation,
  alignment,
  cohesion,
  flee,
  cruise,
  wander,
  noise,
  targets,
  pointer,
  custom,
  avoid_obstacles,
  pursue,
  evade,
  follow_path,
  follow_wall,
  flow,
  follow_leader,
  avoid_collisions,
  queue,
  hunt,
  feed,
  hide
};

/// What a scenario file calls such terms.
constexpr const char* name_of(TermKind kind) {
  switch (kind) {
    case TermKind::separation:
      return "separation";
    case TermKind::alignment:
      return "alignment";
    case TermKind::cohesion:
      return "cohesion";
    case TermKind::flee:
      return "flee";
    case TermKind::cruise:
      return "cruise";
    case TermKind::wander:
      return "wander";
    case TermKind::noise:
      return "noise";
    case TermKind::targets:
      return "targets";
    case TermKind::pointer:
      return "pointer";
    case TermKind::custom:
      return "custom";
    case TermKind::avoid_obstacles:
      return "avoid_obstacles";
    case TermKind::pursue:
      return "pursue";
    case TermKind::evade:
      return "evade";
    case TermKind::follow_path:
      return "follow_path";
    case TermKind::follow_wall:
      return "follow_wall";
    case TermKind::flow:
      return "flow";
    case TermKind::follow_leader:
      return "follow_leader";
    case TermKind::avoid_collisions:
      return "avoid_collisions";
    case TermKind::queue:
      return "queue";
    case TermKind::feed:
      return "feed";
    case TermKind::hunt:
      return "hunt";
    case TermKind::hide:
      return "hide";
  }
  return "";
}
/// Whether the row of such terms is one of the flock's sums over neighbours.
constexpr bool sums_neighbours(TermKind kind) {
  switch (kind) {
    case TermKind::separation:
    case TermKind::alignment:
    case TermKind::cohesion:
    case TermKind::flee:
      return true;
    case TermKind::cruise:
    case TermKind::wander:
    case TermKind::noise:
    case TermKind::targets:
    case TermKind::pointer:
    case TermKind::custom:
    case TermKind::avoid_obstacles:
    case TermKind::pursue:
    case TermKind::evade:
    case TermKind::follow_path:
    case TermKind::follow_wall:
    case TermKind::flow:
    case TermKind::follow_leader:
    case TermKind::avoid_collisions:
    case TermKind::queue:
    case TermKind::hunt:
    case TermKind::feed:
    case TermKind::hide:
      return false;
  }
  return false;
}

/// One steering term of a flock.
struct TermModel {
  TermKind kind = TermKind::separation;
  int row = -1;  ///< its neighbour row, or the number of a custom rule
  float weight = 1;
  Combine combine = Combine::mean;
  Match match = Match::velocity;
  bool count_self = false;
  bool relative = true;
  SteeringForm form = SteeringForm::heading;
  float amount = 0;  ///< cruise: speed · wander: rate · noise: acceleration
  ObstacleForm obstacle_form = ObstacleForm::sweep;
  float look_ahead = 0;  ///< avoid_obstacles: length; for the form heading the radius
  float clearance = 0;   ///< avoid_obstacles: length
  std::int64_t priority = 0;
  int order = 0;
};

/// A cone of sight.
struct SightModel {
  float distance_squared = 0;  ///< d² < this
  float cos_half_view = -1;
  bool sees_all = true;
};

struct HuntModel {
  std::uint64_t prey = 0;  ///< a bit for every flock that is hunted
  SightModel sight;
  HuntChoice choose = HuntChoice::average;
  HuntAim aim = HuntAim::heading;
  float time = 0;
  float factor = 0;
  float confusion = 0;
};

struct JumpModel {
  float speed = 0;
  float end_speed = 0;
  double duration = 0;
  double cooldown = 0;
  SightModel trigger;
};

struct HungerModel {
  double full_for = 0;
  double starves_after = infinity;
};

struct FeedModel {
  std::uint8_t kind = 0;  ///< of food
  float radius = 0;
  SteeringForm form = SteeringForm::heading;
  std::size_t births = 0;  ///< for each piece
};

struct FoodModel {
  float body_radius = 0;
  double every = 0;  ///< time; 0: never
  std::size_t count = 0;
  std::size_t most = 0;  ///< pieces beyond which none comes
};

struct FlockModel {
  std::vector<NeighbourRow> rows;
  std::vector<TermModel> terms;  ///< in order of priority, then of the file
  BehavioursModel behaviours;
  float reach_squared = 0;  ///< beyond it no row of this flock counts a neighbour
  float min_speed = 0;
  float max_speed = infinity_f;
  float max_acceleration = infinity_f;
  Arbitration arbitration = Arbitration::weighted;
  float noise_turn = 0;  ///< radians, full width
  int colour_row = -1;
  float colour_averaging = 0;
  float colour_noise = 0;
  float body_radius = 0;          ///< length
  bool is_hunter = false;         ///< also where the hunt is switched off
  std::optional<HuntModel> hunt;  ///< empty where switched off; so is the jump
  std::optional<JumpModel> jump;
  std::optional<HungerModel> hunger;
  std::optional<FeedModel> feed;
  std::size_t population_cap = 0;  ///< no births beyond; the count where none are born

  static constexpr float infinity_f = std::numeric_limits<float>::infinity();
};

struct PointerModel {
  float weight = 0;
  float radius = 0;
  float repel_radius = 0;
  SteeringForm form = SteeringForm::heading;
  float slowing = 0;
};

struct TargetModel {
  TargetKind kind = TargetKind::attract;
  SteeringForm form = SteeringForm::heading;
  float weight = 0;
  float radius = 0;
  float slowing = 0;
  std::uint64_t felt_by = 0;  ///< a bit for every flock
  TargetMotion motion = TargetMotion::still;
  std::array<double, 3> at{}, velocity{};
  double circle = 0;
  double period = 1;
};

struct Model {
  int dimensions = 2;
  std::uint64_t seed = 0;
  float dt = 1;
  double tick = 1;  ///< dt as it is written, by which clocks run
  Integrator integrator = Integrator::semi_implicit_euler;
  BoundaryKind boundary = BoundaryKind::open;
  std::array<float, 3> min{}, max{}, size{}, margin{};
  float turn_strength = 0;
  Index index;
  float reach = 0;  ///< length; largest finite radius over which any row looks
  PointerModel pointer;
  std::vector<TargetModel> targets;
  std::vector<FlockModel> flocks;
  std::size_t most_rows = 0;  ///< of any flock
  std::uint64_t watched = 0;  ///< a bit for every flock whose members are looked at by name
  bool uses_lists = false;    ///< somebody asks the index for each neighbour
  bool uses_totals = false;
  bool uses_headings = false;
  bool uses_wander = false;
  bool uses_colour = false;
  bool is_solid = false;     ///< boids are kept out of obstacles
  float obstacle_reach = 0;  ///< length; how far from a boid a step usually asks for obstacles
  bool uses_hunger = false;  ///< some flock's life has the clocks of eating
  bool uses_jump = false;
  bool uses_focus = false;
  bool has_hunters = false;
  bool has_feeders = false;
  std::vector<FoodModel> food;

  bool wraps() const { return boundary == BoundaryKind::wrap; }
};

/// Compiles a scenario that has passed `check`.
Model compile(const ScenarioDef& scenario);

/// Red, green and blue of "#rrggbb", each 0 to 1 (as written, not linearised).
std::array<float, 3> colour_of_hex(const std::string& hex);

/// Adds a term to every flock and puts the terms in their order.
void add_term(Model& model, const TermModel& term);

}  // namespace sturnus
