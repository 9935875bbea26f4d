// The cheapest next batch, again and again, in blocks that threads may share.
#include "neighbours/batches.h"

#include <algorithm>
#include <functional>

namespace sturnus {
namespace {

// Boids in which batches are cut apart from all others, whatever the number of threads.
constexpr std::size_t block_size = 4096;

// The end of the batch from `begin` that has the least space within reach for each of its boids.
template <std::size_t axes>
std::size_t cheapest_end(const Line& line, std::size_t begin, std::size_t end, float reach) {
  float low[axes], high[axes];
  for (std::size_t axis = 0; axis < axes; ++axis) low[axis] = high[axis] = line[axis][begin];
  std::size_t best = begin + 1;
  float least = 0;
  for (std::size_t i = begin; i < std::min(end, begin + batch_size); ++i) {
    float space = 1;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      low[axis] = std::min(low[axis], line[axis][i]);
      high[axis] = std::max(high[axis], line[axis][i]);
      space *= high[axis] - low[axis] + 2 * reach;
    }
    space /= static_cast<float>(i + 1 - begin);
    if (i > begin && !(space <= least)) continue;
    least = space;
    best = i + 1;
  }
  return best;
}

template <std::size_t axes>
std::size_t cut_block(const Line& line, std::size_t begin, std::size_t end, float reach, Span* batches) {
  std::size_t count = 0;
  while (begin < end) {
    const std::size_t next = cheapest_end<axes>(line, begin, end, reach);
    batches[count++] = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(next)};
    begin = next;
  }
  return count;
}

}  // namespace

void BatchCutter::cut(const Line& line, std::size_t axes, std::size_t count, float reach,
                      const Workers& workers) {
  const std::size_t blocks = (count + block_size - 1) / block_size;
  batches_.resize(count);
  counts_.resize(blocks);
  const auto cut_blocks = [&](std::size_t first, std::size_t last, int) {
    for (std::size_t block = first; block < last; ++block) {
      const std::size_t begin = block * block_size;
      const std::size_t end = std::min(count, begin + block_size);
      const auto cut_one = axes == 3 ? cut_block<3> : cut_block<2>;
      counts_[block] = static_cast<std::uint32_t>(cut_one(line, begin, end, reach, &batches_[begin]));
    }
  };
  workers.for_ranges(blocks, std::ref(cut_blocks));
  std::size_t kept = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto from = batches_.begin() + static_cast<std::ptrdiff_t>(block * block_size);
    std::copy(from, from + counts_[block], batches_.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += counts_[block];
  }
  batches_.resize(kept);
}

}  // namespace sturnus
