// Every steering term of one boid, as functions; each rule has its own file. Rules see no files, threads or
// clocks.
#pragma once

#include <sturnus/steering.h>
#include <sturnus/view.h>

#include "neighbours/kernel.h"
#include "rules/self.h"

namespace sturnus {

/// Separation, alignment, cohesion and flee: what the sums over neighbours come to, before the weight.
template <int D>
Vec<D> separation(const TermModel& term, const NeighbourSum& sum);
template <int D>
Vec<D> alignment(const TermModel& term, const NeighbourSum& sum, const Self<D>& self);
template <int D>
Vec<D> cohesion(const TermModel& term, const NeighbourSum& sum);
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

/// What the pressed pointer makes a boid feel.
template <int D>
Vec<D> pointer_pull(const PointerModel& model, const PointerState& pointer, const Self<D>& self,
                    const Image& image, float max_speed);

/// Turn: the acceleration inward for every margin that the place is in.
template <int D>
Vec<D> boundary_turn(const Model& model, const Vec<D>& position);

/// Wrap and bounce: brings a place back into the space, mirroring the velocity where it bounces.
template <int D>
void keep_inside(const Model& model, Vec<D>& position, Vec<D>& velocity);

/// The next colour: toward the neighbours' mean, plus noise, clamped to [0, 1].
Vec<3> drifted_colour(const FlockModel& flock, const Vec<3>& colour, const NeighbourSum* neighbours,
                      std::uint64_t id, const Moment& moment);

/// At most `longest` long.
template <int D>
Vec<D> capped(const Vec<D>& v, float longest);

/// Speed limits; a boid at rest stays at rest.
template <int D>
Vec<D> limited(const Vec<D>& velocity, float min_speed, float max_speed);

/// Adds weighted terms as the arbitration of a flock says, one after the other in their order.
template <int D>
class Arbiter {
 public:
  Arbiter(Arbitration arbitration, float max_acceleration)
      : arbitration_(arbitration), max_(max_acceleration), left_(max_acceleration) {}
  void add(const Vec<D>& weighted);
  /// No further term can change the result.
  bool is_done() const { return done_; }
  /// The sum of what was granted, capped.
  Vec<D> result() const { return capped(sum_, max_); }

 private:
  Arbitration arbitration_;
  float max_;
  float left_;
  bool done_ = false;
  Vec<D> sum_;
};

}  // namespace sturnus
