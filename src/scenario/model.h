// The compiled scenario: constant during a step, in the numbers that the step computes with.
#pragma once

#include <sturnus/scenario.h>

#include <array>
#include <cstdint>
#include <optional>

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
  hunt,
  feed
};

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
  float reach_squared = 0;       ///< beyond it no row of this flock counts a neighbour
  float min_speed = 0;
  float max_speed = infinity_f;
  float max_acceleration = infinity_f;
  Arbitration arbitration = Arbitration::weighted;
  float noise_turn = 0;  ///< radians, full width
  int colour_row = -1;
  float colour_averaging = 0;
  float colour_noise = 0;
  float body_radius = 0;
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
  bool uses_totals = false;
  bool uses_headings = false;
  bool uses_wander = false;
  bool uses_colour = false;
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
