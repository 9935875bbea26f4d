// How terms share the acceleration: weighted sum, a budget by priority (VUW), or the first that is not zero.
//
// Inline, because every boid comes through here in every step.
#pragma once

#include <cmath>

#include "base/vec.h"
#include "scenario/model.h"

namespace sturnus {

/// |v|, also where its square would overflow.
template <int D>
float safe_length(const Vec<D>& v) {
  const float plain = length(v);
  return std::isfinite(plain) ? plain : length(v * 0x1p-64f) * 0x1p64f;
}

/// What makes v at most `longest` long: 1 where it is.
template <int D>
float cap_factor(const Vec<D>& v, float longest) {
  const float size = safe_length(v);
  // Selected before the division: a branch would be guessed wrong for every other boid. v * 1 is v.
  const bool is_longer = size > longest;
  return (is_longer ? longest : 1.0f) / (is_longer ? size : 1.0f);
}

/// At most `longest` long.
template <int D>
Vec<D> capped(const Vec<D>& v, float longest) {
  return v * cap_factor(v, longest);
}

/// Speed limits; a boid at rest stays at rest.
template <int D>
Vec<D> limited(const Vec<D>& velocity, float min_speed, float max_speed) {
  const float speed = safe_length(velocity);
  if (!(speed > 0) || !std::isfinite(speed)) return velocity;
  // Without a branch, as above.
  const bool is_faster = speed > max_speed;
  const bool is_slower = !is_faster & (speed < min_speed);
  const float wanted = is_faster ? max_speed : min_speed;
  const bool is_limited = is_faster | is_slower;
  return velocity * ((is_limited ? wanted : 1.0f) / (is_limited ? speed : 1.0f));
}

/// Adds weighted terms as the arbitration of a flock says, one after the other in their order.
template <int D>
class Arbiter {
 public:
  Arbiter(Arbitration arbitration, float max_acceleration)
      : arbitration_(arbitration), max_(max_acceleration), left_(max_acceleration) {}
  /// Returns what of the term is granted.
  Vec<D> add(const Vec<D>& weighted);
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

template <int D>
Vec<D> Arbiter<D>::add(const Vec<D>& weighted) {
  Vec<D> granted = weighted;
  switch (arbitration_) {
    case Arbitration::weighted:
      sum_ += weighted;
      break;
    case Arbitration::first:
      sum_ = weighted;
      done_ = !(weighted == Vec<D>{});
      break;
    case Arbitration::budget: {
      const float size = safe_length(weighted);
      done_ = size >= left_;
      if (size > left_) granted = weighted * (left_ / size);
      sum_ += granted;
      left_ -= size;
      break;
    }
  }
  return granted;
}

}  // namespace sturnus
