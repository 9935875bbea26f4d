// Time between steps.
#include "session/playback.h"

#include <algorithm>
#include <cmath>

namespace studio {

void Playback::set_speed(double speed) {
  speed_ = std::clamp(speed, slowest, fastest);
}

void Playback::advance(double seconds, const Frame& frame, Session& session) {
  const auto step = static_cast<double>(frame.step);
  if (frame.generation != generation_) {
    generation_ = frame.generation;
    at_ = step;
  }
  if (single_ && !is_playing_) at_ = step + 1;
  if (is_playing_) {
    const double due = seconds * speed_ * steps_per_second;
    at_ = std::min(at_ + due, step + std::max(1.0, due));
  } else if (!single_) {
    at_ = std::max(std::ceil(at_), step);
  }
  single_ = false;
  session.run_to(static_cast<std::uint64_t>(std::ceil(at_)), frame.generation);
}

float Playback::part(const Frame& frame) const {
  return static_cast<float>(std::clamp(at_ - static_cast<double>(frame.step) + 1, 0.0, 1.0));
}

}  // namespace studio
