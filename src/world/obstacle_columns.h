// Obstacles in columns, so that many can be ruled out at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenario/model.h"
#include "sturnus/view.h"

namespace sturnus {

/// Each obstacle with a box of its own along the axes that holds it, a little larger because places are
/// rounded. What is beyond `count` is nowhere near.
struct ObstacleColumns {
  std::array<std::vector<float>, 3> at;      ///< length; the middle of the box
  std::array<std::vector<float>, 3> extent;  ///< length; half the box's sides
  std::vector<float> radius;                 ///< length; of a sphere, with room for rounding; else infinite
  std::vector<float> number;                 ///< of the obstacle, its bits
  std::size_t count = 0;
  static constexpr std::size_t spare = 16;  ///< room beyond the last for whole registers

  /// Makes room for so many; there is none yet.
  void fit(std::size_t most);
  void fill(const Model& model, const std::vector<Obstacle>& obstacles);
  void spoil();
};

}  // namespace sturnus
