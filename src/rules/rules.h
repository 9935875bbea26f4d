// Every steering term of one boid, as functions; each rule has its own file. Rules see no files, threads or
// clocks.
#pragma once

#include <sturnus/steering.h>
#include <sturnus/view.h>

#include <span>

#include "neighbours/kernel.h"
#include "neighbours/pieces.h"
#include "rules/arbitration.h"
#include "rules/neighbour_terms.h"
#include "rules/others.h"
#include "rules/self.h"
#include "world/obstacle_index.h"

namespace sturnus {

/// Away from the neighbours; like the three terms of neighbour_terms.h before the weight.
template <int D>
Vec<D> flee(const TermModel& term, const NeighbourSum& sum, const Self<D>& self, float max_speed);

/// (speed - |v|) v/|v|: keeps a cruising speed. Zero at rest.
template <int D>
Vec<D> cruise(const TermModel& term, const Self<D>& self);

/// The next direction of a wandering boid: unit(w + rate u).
template <int D>
Vec<D> wandered(const TermModel& term, const Self<D>& self, const Vec<D>& wander, const Moment& moment);

/// A random acceleration, each component uniform in [-A, A].
template <int D>
Vec<D> noise_acceleration(const TermModel& term, const Self<D>& self, const Moment& moment);

/// The velocity turned by a uniform angle in [-eta/2, eta/2]; in 3D about a random perpendicular.
template <int D>
Vec<D> turned_at_random(const Vec<D>& velocity, float eta, std::uint64_t id, const Moment& moment);

/// Seek where the nearest quarry will be, or arrive at a place beside it; flee it.
template <int D>
Vec<D> pursuit(const PursuitModel& model, const Others<D>& others, const Self<D>& self, float max_speed);
template <int D>
Vec<D> evasion(const PursuitModel& model, const Others<D>& others, const Self<D>& self, float max_speed);

/// Behind the obstacle that hides from the nearest hunter, or away from where that will be.
template <int D>
Vec<D> hiding(const HideModel& hide, const Model& model, const ObstacleIndex& obstacles,
              const Others<D>& others, const Self<D>& self, float max_speed);

/// Along a path, and along a wall; in a space that wraps, by the image from which they are nearest.
template <int D>
Vec<D> path_following(const LineModel& model, const Wrapping& image, const Self<D>& self, float max_speed);
template <int D>
Vec<D> wall_following(const LineModel& model, const Wrapping& image, const Self<D>& self, float max_speed);

/// The field's velocity where the boid will be, minus its own.
template <int D>
Vec<D> flow_following(const FlowModel& model, const Wrapping& image, const Self<D>& self);

/// Behind the nearest leader and out of its way.
template <int D>
Vec<D> leader_following(const LeaderModel& model, const Others<D>& others, const Self<D>& self,
                        float max_speed);

/// A unit vector aside from whom it will first come too near to; of equals the one with the lowest id.
template <int D>
Vec<D> collision_avoidance(const AvoidanceModel& model, const Others<D>& others, const Self<D>& self);

/// A brake for the nearest one ahead; of equals the one with the lowest id.
template <int D>
Vec<D> queuing(const QueueModel& model, const Others<D>& others, const Self<D>& self);
/// Where a hunter steers for one prey: the direction to where it will be by the aim, a unit vector.
template <int D>
Vec<D> aimed(const HuntModel& hunt, const Vec<D>& offset, const Vec<D>& prey_velocity, float max_speed);

/// What a hunter feels whose prey lies in the mean direction `toward`.
template <int D>
Vec<D> chase(const HuntModel& hunt, const Vec<D>& toward, const Vec<D>& velocity, float max_speed);

/// Toward the food of its kind within the radius; zero where there is none.
template <int D>
Vec<D> feed(const FeedModel& feed, const Pieces& pieces, const Self<D>& self, float max_speed);

/// What the pressed pointer makes a boid feel.
template <int D>
Vec<D> pointer_pull(const PointerModel& model, const PointerState& pointer, const Self<D>& self,
                    const Wrapping& image, float max_speed);

/// What the targets at those places make a boid of that flock feel: the sum of their pulls; those of form
/// "heading" are averaged first, the attracting and the repelling ones each for themselves.
template <int D>
Vec<D> targets_pull(const Model& model, const std::vector<std::array<float, 3>>& places, std::size_t flock,
                    const Self<D>& self, const Wrapping& image);

/// Around obstacles: sideways from the first in the way, or the mean away from those that are near.
template <int D>
Vec<D> avoid_obstacles(const TermModel& term, const FlockModel& flock, const Model& model,
                       const ObstacleIndex& obstacles, const Self<D>& self);

/// The same where it is known that no others than these matter; their numbers are ascending.
template <int D>
Vec<D> avoid_listed(const TermModel& term, const FlockModel& flock, const Model& model,
                    const ObstacleIndex& obstacles, std::span<const std::uint32_t> numbers,
                    const Self<D>& self);

/// Turn: the acceleration inward for every margin that the place is in.
template <int D>
Vec<D> boundary_turn(const Model& model, const Vec<D>& position);

/// Wrap and bounce: brings a place back into the space, mirroring the velocity where it bounces.
template <int D>
void keep_inside(const Model& model, Vec<D>& position, Vec<D>& velocity);

/// The next colour: toward the neighbours' mean, plus noise, clamped to [0, 1].
Vec<3> drifted_colour(const FlockModel& flock, const Vec<3>& colour, const NeighbourSum& neighbours,
                      std::uint64_t id, const Moment& moment);

}  // namespace sturnus
