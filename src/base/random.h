// Random numbers that are a function of (seed, step, id, stream, number): the same for any thread count.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace sturnus {

/// Every purpose for which numbers are drawn.
enum class Stream : std::uint32_t {
  start_position,
  start_velocity,
  start_colour,
  start_wander,
  noise_acceleration,
  noise_turn,
  wander,
  colour,
  obstacle,
  food,       ///< where a piece lies, by its own id
  birth,      ///< where a newborn appears, by its own id
  confusion,  ///< whether and to whom a focus slips
};

/// The numbers of one purpose for one boid in one step, one after the other.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t step, std::uint64_t id, Stream stream)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        counter_{
            {static_cast<std::uint32_t>(step),
             static_cast<std::uint32_t>((step >> 32) << 16) | static_cast<std::uint32_t>((id >> 32) & 0xffff),
             static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(stream) << 24}} {}

  /// 32 random bits.
  std::uint32_t bits() {
    if (used_ == 4) {
      block_ = r123::Philox4x32()(counter_, key_);
      counter_[3] += 1;
      used_ = 0;
    }
    return block_[used_++];
  }

  /// Uniform in [0, 1): 24 bits times 2^-24.
  float uniform() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

  /// Uniform in [low, high), or low where they are equal.
  float between(float low, float high) { return low + (high - low) * uniform(); }

  /// Every component uniform in [-1, 1).
  template <int D>
  Vec<D> in_cube() {
    Vec<D> v;
    for (int axis = 0; axis < D; ++axis) v[axis] = between(-1, 1);
    return v;
  }

  /// Uniform in the unit ball, by rejection.
  template <int D>
  Vec<D> in_ball() {
    for (;;) {
      const Vec<D> v = in_cube<D>();
      if (dot(v, v) <= 1) return v;
    }
  }

  /// Uniform direction, by rejection.
  template <int D>
  Vec<D> direction() {
    for (;;) {
      const Vec<D> v = in_ball<D>();
      if (dot(v, v) > 1e-4f) return unit(v);
    }
  }

 private:
  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  unsigned used_ = 4;
};

}  // namespace sturnus
