// The words that definitions are written in: choices, places, and whose members a term looks at.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace sturnus {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point or vector of two or three components, as many as `space.dimensions`; empty means "not given".
using Coordinates = std::vector<double>;

enum class Edge { open, closed };                ///< is a neighbour exactly on the outer radius one? open: no
enum class Strength { grows, constant, fades };  ///< one neighbour's pull over distance d: "d", "1", "1/d"
enum class Combine { sum, mean };                ///< of the neighbours' contributions
enum class Match { velocity, heading };          ///< what alignment averages
enum class Arbitration { weighted, budget, first };
/// What a place makes a boid feel, o being the offset to it. heading: unit(o) - heading. seek:
/// unit(o)·max_speed minus the own velocity. linear: o. arrive: as seek, with the speed max_speed·min(1,
/// |o|/slowing). orbit: unit(o)·max_speed, the desired velocity itself.
enum class SteeringForm { heading, seek, linear, arrive, orbit };
enum class TargetKind { attract, repel };
enum class TargetMotion { still, line, circle };
enum class PointerMode { attract, repel };
enum class BoundaryKind { open, wrap, turn, bounce };
enum class Integrator { semi_implicit_euler, explicit_euler };
enum class IndexKind { grid, tree, all_pairs };
/// How sums over neighbours are made: `sparse` looks at every neighbour, `dense` takes those well inside a
/// radius together, `automatic` chooses from the model and the state.
enum class SumPath { automatic, sparse, dense };
enum class StartRegion { space, box, ball, ring };
enum class GlyphStyle { dart, cone, circle };
enum class CameraFit { space, flock };
/// How a boid avoids obstacles. sweep: sideways, out of the way of the first that it would hit (VUW);
/// heading: away from all that are near (CS 184).
enum class ObstacleForm { sweep, heading };
enum class HuntChoice { average, nearest };  ///< all prey in view together, or one in focus
/// Where a hunter steers: turns toward its prey, goes at full speed toward it, or toward where it will be
/// after a constant time, a time that grows with the distance, or the time that catching it takes.
enum class HuntAim { heading, seek, constant, distance, intercept };

/// Whose members a term looks at: its own flock's, everybody's, or those of the named flocks.
struct Whose {
  enum class Kind { own, all, named };
  Kind kind = Kind::own;
  std::vector<std::string> names;  ///< used when kind is `named`

  friend bool operator==(const Whose&, const Whose&) = default;
};

}  // namespace sturnus
