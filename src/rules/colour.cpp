// Colours that drift toward the neighbours' and blend when flocks meet (CS 184).
#include "rules/rules.h"

namespace sturnus {

Vec<3> drifted_colour(const FlockModel& flock, const Vec<3>& colour, const NeighbourSum& neighbours,
                      std::uint64_t id, const Moment& moment) {
  Vec<3> next = colour;
  if (neighbours.count > 0) {
    const Vec<3> mean = Vec<3>{neighbours.value} * (1.0f / static_cast<float>(neighbours.count));
    next += (mean - colour) * flock.colour_averaging;
  }
  if (flock.colour_noise > 0) {
    Draws draws(moment.seed, moment.step, id, Stream::colour);
    next += draws.in_cube<3>() * flock.colour_noise;
  }
  for (int channel = 0; channel < 3; ++channel) {
    if (next[channel] < 0) next[channel] = 0;
    if (next[channel] > 1) next[channel] = 1;
  }
  return next;
}

}  // namespace sturnus
