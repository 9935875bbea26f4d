// Why one boid turns: every term that it feels, what of it is granted, and the neighbours that each counts.
//
// `Simulation::explain(id)` makes one of the present state, for the step that would come next. Its numbers
// are those that the step computes with, bit for bit, and they add up as the step adds them:
//
//   acceleration = cap_factor · sum + boundary, sum the terms' granted vectors in their order
//   next_velocity = velocity + dt · acceleration, before speed limits and the random turn
//
// Vectors are x, y, z with z = 0 in two dimensions.
#pragma once

#include <sturnus/scenario.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sturnus {

/// One steering term of the boid.
struct ExplainedTerm {
  std::string kind;  ///< "separation" and so on as in scenario files; "custom" for rules from outside
  /// What to call it: its path below the flock, such as "separation" or, where there are several,
  /// "separation.1"; a custom rule's own name, "external" for accelerations from outside.
  std::string name;
  std::array<float, 3> felt{};      ///< what it asks for, before the weight
  float weight = 1;                 ///< as the scenario has it
  std::array<float, 3> weighted{};  ///< weight · felt, length per time squared
  std::array<float, 3> granted{};   ///< what the arbitration lets through, length per time squared
  /// How many neighbours it counted, or prey it chases; nothing for terms that look at none.
  std::optional<std::size_t> neighbours;
  float inner = 0;             ///< length; terms over neighbours, and hunts: nobody nearer counts
  float radius = 0;            ///< length; nor farther; infinity is the whole population
  double field_of_view = 360;  ///< degrees, full angle around the heading
  std::string formula;         ///< from the list of parameters, as `sturnus keys` has it
  std::string source;          ///< course document row or paper
};

/// One boid that some term counted.
struct ExplainedNeighbour {
  std::uint64_t id = 0;
  int flock = 0;                  ///< index in file order, from 0
  float distance = 0;             ///< length
  std::array<float, 3> offset{};  ///< from the boid to it, over the seam where that is nearer; length
  /// Angle between heading and offset in degrees: in the plane -180 to 180, positive counterclockwise, in
  /// space 0 to 180. Nothing at rest and for coincident boids.
  std::optional<double> bearing;
  std::vector<std::size_t> terms;  ///< those that count it, as places in `Explanation::terms`
};

/// All that one boid feels.
struct Explanation {
  std::uint64_t step = 0;  ///< steps done; the next one is explained
  std::uint64_t id = 0;
  int dimensions = 2;
  int flock = 0;  ///< index in file order, from 0
  std::string flock_name;
  std::array<float, 3> position{};  ///< length
  std::array<float, 3> velocity{};  ///< length per time
  std::array<float, 3> heading{};   ///< v/|v|, zero at rest
  Arbitration arbitration = Arbitration::weighted;
  std::vector<ExplainedTerm> terms;            ///< in the order in which they are weighed
  std::vector<ExplainedNeighbour> neighbours;  ///< nearest first, ties by id
  std::array<float, 3> sum{};                  ///< of what was granted, length per time squared
  float max_acceleration = 0;                  ///< the cap on it, length per time squared; may be infinite
  float cap_factor = 1;                        ///< what the cap leaves of the sum, 0 to 1
  std::array<float, 3> boundary{};             ///< the turn at the edge, length per time squared
  std::array<float, 3> acceleration{};         ///< length per time squared
  float dt = 1;                                ///< time units in a step
  bool is_jumping = false;                     ///< a hunter in a jump: it does not obey what it feels
  /// velocity + dt · acceleration, length per time. A step then limits the speed and turns at random. In a
  /// jump it is the jump's, and nothing more is done to it.
  std::array<float, 3> next_velocity{};
};

}  // namespace sturnus
