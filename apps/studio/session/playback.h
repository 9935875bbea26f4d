// The clock of the view: how far the world should be, and how much of the way to the frame's step is shown.
#pragma once

#include <cstdint>

#include "session/session.h"

namespace studio {

class Playback {
 public:
  static constexpr double steps_per_second = 30;  ///< at a speed of 1, as in the videos
  static constexpr double slowest = 0.1, fastest = 100;

  void play(bool on) { is_playing_ = on; }
  bool is_playing() const { return is_playing_; }
  void set_speed(double speed);
  double speed() const { return speed_; }
  /// One step, and no further.
  void step_once() { single_ = true; }

  /// Lets so much time go by, and asks the session for the steps that are due. Steps that come too late are
  /// not made up for.
  void advance(double seconds, const Frame& frame, Session& session);
  /// Where between the frame's previous places (0) and its places (1) things are shown.
  float part(const Frame& frame) const;

 private:
  bool is_playing_ = true;
  bool single_ = false;
  double speed_ = 1;
  double at_ = 0;  // steps
  std::uint64_t generation_ = 0;
};

}  // namespace studio
