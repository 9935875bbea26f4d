// The Z-order: a place as a key whose bits say, halving by halving, in which half of each axis it lies; and a
// stable sort by such keys.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/workers.h"

namespace sturnus {

/// Halvings that a key has room for; a tree is never deeper, whatever its limit. In 2D and 3D bit 63 stays
/// free for those who have no place.
template <int D>
inline constexpr int most_levels = D == 2 ? 31 : 21;

/// Moves the bits of a cell's number apart, so that those of the other axes fit between.
template <int D>
std::uint64_t spread(std::uint64_t bits) {
  if constexpr (D == 2) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffff;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
    bits = (bits | bits << 2) & 0x3333333333333333;
    return (bits | bits << 1) & 0x5555555555555555;
  } else {
    bits = (bits | bits << 32) & 0x001f00000000ffff;
    bits = (bits | bits << 16) & 0x001f0000ff0000ff;
    bits = (bits | bits << 8) & 0x100f00f00f00f00f;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
    return (bits | bits << 2) & 0x1249249249249249;
  }
}

/// A square or cube, halved `levels` times along each axis. Places outside count as on its border.
struct KeyCube {
  std::array<double, 3> min{};
  double side = 1;
  int levels = 0;

  /// Calls f(i, key) for boids [begin, end).
  template <int D, class F>
  void for_keys(const std::array<const float*, 3>& position, std::size_t begin, std::size_t end,
                F&& f) const {
    const auto cells = static_cast<double>(std::int64_t{1} << levels);
    const double cells_per_length = cells / side;
    const std::array<double, 3> low = min;
    for (std::size_t i = begin; i < end; ++i) {
      std::uint64_t key = 0;
      for (std::size_t axis = 0; axis < D; ++axis) {
        const double place = (double{position[axis][i]} - low[axis]) * cells_per_length;
        const auto cell = static_cast<std::int64_t>(place > 0 ? std::min(place, cells - 1) : 0.0);
        key |= spread<D>(static_cast<std::uint64_t>(cell)) << axis;
      }
      f(i, key);
    }
  }
};

/// A boid's key, and where it stood.
struct Keyed {
  std::uint64_t key;
  std::uint32_t slot;
};

/// Sorts by key, stably, digit by digit from the lowest. Keeps its memory for the next time.
class KeySort {
 public:
  void sort(std::vector<Keyed>& keyed, const Workers& workers);

 private:
  struct Digit {
    int shift = 0, bits = 0;
    std::size_t of(std::uint64_t key) const {
      return static_cast<std::size_t>(key >> shift & ((std::uint64_t{1} << bits) - 1));
    }
  };
  void pass(const std::vector<Keyed>& from, std::vector<Keyed>& to, Digit digit, const Workers& workers);

  std::vector<Keyed> spare_;
  std::vector<std::uint32_t> counts_;  ///< of each digit, part by part
};

}  // namespace sturnus
