// Cuts a line of boids into batches where that leaves the kernel the least work.
#pragma once

#include <array>
#include <vector>

#include "neighbours/branches.h"
#include "neighbours/index.h"

namespace sturnus {

/// Boids in the order in which they stand.
struct Row {
  int dimensions = 2;
  const Line* line = nullptr;
  std::size_t count = 0;
  double reach = 1;
  const float* room = nullptr;  ///< the share of space of each, in boxes of the reach
};

/// Cuts where the kernel has the least work by an estimate: the boids that are expected within the reach of a
/// batch's box, and the trouble of asking for them, over the boids of the batch. So a batch ends early where
/// the line jumps. Keeps its memory for the next time.
class BatchCutter {
 public:
  void cut(const Row& row, const Workers& workers);
  const std::vector<Span>& batches() const { return batches_; }

 private:
  std::vector<Span> batches_;
  std::vector<std::uint32_t> counts_;  ///< batches in each block
};

}  // namespace sturnus
