// Solid obstacles: after a step's motion the way from the old place to the new one is swept, and every place
// is looked at once more, as it is rounded, before a boid may stand there.
#include "step/motion.h"
#include "world/columns.h"
#include "world/solid_body.h"

namespace sturnus {

template <int D>
void keep_out(Motion<D>& motion, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (motion.state.quarantined[i] != 0) continue;
    const FlockModel& flock = motion.model.flocks[motion.state.flock[i]];
    const Solids<D> solids(motion.model, motion.scratch.obstacles, flock.body_radius);
    auto position = at<D>(motion.scratch.previous_position, i);
    auto velocity = at<D>(motion.scratch.previous_velocity, i);
    solids.keep_out(at<D>(motion.state.position, i), position, velocity);
    put(motion.scratch.previous_position, i, position);
    put(motion.scratch.previous_velocity, i, velocity);
  }
}

template void keep_out<2>(Motion<2>&, std::size_t, std::size_t);
template void keep_out<3>(Motion<3>&, std::size_t, std::size_t);

}  // namespace sturnus
