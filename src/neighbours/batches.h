// Cuts a line of boids into batches where that leaves the kernel the least work.
#pragma once

#include <array>
#include <vector>

#include "neighbours/index.h"

namespace sturnus {

/// Places of boids in the order in which they stand; the third is empty in 2D.
using Line = std::array<std::vector<float>, 3>;

/// Batches are cut so that the space within `reach` of a batch's box is small for each boid in it: a batch
/// ends early where the line jumps. Keeps its memory for the next time.
class BatchCutter {
 public:
  void cut(const Line& line, std::size_t axes, std::size_t count, float reach, const Workers& workers);
  const std::vector<Span>& batches() const { return batches_; }

 private:
  std::vector<Span> batches_;
  std::vector<std::uint32_t> counts_;  ///< batches in each block
};

}  // namespace sturnus
