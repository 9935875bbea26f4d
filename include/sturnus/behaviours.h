// What Reynolds' steering behaviours need to know, as a flock's tables say it: plain structs with defaults.
//
// Lengths are in the scenario's length unit, times in its time unit. Each behaviour asks for an acceleration,
// its full speed being the flock's max_speed; the weight is per time. The formulas are those of
// <sturnus/steering.h>, after Reynolds, "Steering behaviors for autonomous characters" (1999).
#pragma once

#include <sturnus/vocabulary.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sturnus {

/// How far ahead a pursuer looks (VUW CGRA 354, S2-22): a fixed time; a time that grows with the distance;
/// or the time in which full speed meets a quarry that keeps its velocity (constant bearing, S2-23).
enum class Prediction { constant, distance, intercept };

enum class FlowKind { vortex, shear, uniform };

/// What every behaviour has: how much it counts, and when.
struct Behaviour {
  double weight = 1.0;        ///< per time
  std::int64_t priority = 0;  ///< lower comes first under arbitration "budget" and "first"
  bool on = true;             ///< a switch that keeps the weight
  int order = 0;              ///< place in the file, which breaks ties of priority
};

/// Seek, or flee, where the nearest of some flocks will be.
struct Pursuit : Behaviour {
  std::vector<std::string> of;  ///< names of the flocks that are pursued or evaded
  Prediction prediction = Prediction::intercept;
  double time = 10.0;          ///< time; constant: so far ahead
  double per_length = 0.3;     ///< time per length; distance, and intercept where there is none
  double radius = infinity;    ///< length; who is farther is not seen
  std::vector<double> offset;  ///< pursuit: ahead, left and up of the quarry, length; given: arrive there
  double slowing = 20.0;       ///< pursuit of an offset: length; slower within this
};

/// Go behind the obstacle that hides from the nearest of some flocks; evade it where there is none.
struct Hide : Behaviour {
  std::vector<std::string> from;  ///< names of the flocks that are hidden from
  double radius = infinity;       ///< length; who is farther is not seen
  double reach = 200.0;           ///< length; an obstacle whose surface is farther is not sought
  double margin = 15.0;           ///< length; from the obstacle's surface to the place behind it
  double slowing = 20.0;          ///< length; slower within this of the place
  double time = 10.0;             ///< time; where nothing hides, flee the place where it will be so far ahead
};

/// Stay near a line and go along it.
struct FollowPath : Behaviour {
  std::vector<std::vector<double>> points;  ///< length; corners in order
  bool loop = false;                        ///< the last corner is joined to the first
  double radius = 10.0;                     ///< length; half of the path's width
  double ahead = 20.0;  ///< length; so far beyond the nearest point lies the one that is sought
  double time = 10.0;   ///< time; the place that must be on the path is so far ahead
};

/// Go along a wall at a distance, on the side where one is.
struct FollowWall : Behaviour {
  std::vector<std::vector<double>> points;  ///< length; corners in order, [x, y] each
  bool loop = false;                        ///< the last corner is joined to the first
  double distance = 20.0;                   ///< length; from the wall
  double radius = 3.0;                      ///< length; how far off that distance nothing is done
  double ahead = 20.0;                      ///< length; as of a path
  double time = 10.0;                       ///< time; as of a path
};

/// Take the velocity of a field.
struct FollowFlow : Behaviour {
  FlowKind kind = FlowKind::vortex;
  std::vector<double>
      centre;           ///< length; of the vortex, or where a shear stands still; not given: the origin
  double speed = 2.0;   ///< length per time; vortex: at the core's edge
  double core = 100.0;  ///< length; vortex: radius of the fastest ring
  double rate = 0.01;   ///< per time; shear: velocity along x for each length of y
  std::vector<double> velocity;  ///< length per time; uniform
  double time = 5.0;             ///< time; the field is looked up so far ahead
};

/// Arrive behind a leader and keep out of its way.
struct FollowLeader : Behaviour {
  std::string leader;       ///< name of the flock whose nearest member leads
  double distance = 20.0;   ///< length; behind it, and how far ahead its way is kept free
  double clearance = 15.0;  ///< length; half of the width of its way
  double slowing = 30.0;    ///< length; slower within this of the place
};

/// Step aside from whoever will come too near.
struct AvoidCollisions : Behaviour {
  double radius = 60.0;  ///< length; who is farther now does not count
  double gap = 12.0;     ///< length; nearer than this at the nearest approach is too near
  double time = 40.0;    ///< time; a nearest approach later than this does not count
};

/// Brake for whoever is ahead.
struct Queue : Behaviour {
  double distance = 20.0;  ///< length; who is farther is not waited for
  double angle = 60.0;     ///< degrees; full angle of the cone around the heading
};

}  // namespace sturnus
