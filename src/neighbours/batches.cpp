// The cheapest next batch, again and again, in blocks that threads may share.
#include "neighbours/batches.h"

#include <algorithm>
#include <functional>

namespace sturnus {
namespace {

// Boids in which batches are cut apart from all others, whatever the number of threads.
constexpr std::size_t block_size = 4096;

// Asking for a batch's neighbours takes about as long as looking at so many of them.
constexpr double trouble = 20;

// The end of the batch from `begin` that is expected to cost least for each of its boids.
template <std::size_t axes>
std::size_t cheapest_end(const Row& row, std::size_t begin, std::size_t end) {
  const Line& line = *row.line;
  float low[axes], high[axes];
  for (std::size_t axis = 0; axis < axes; ++axis) low[axis] = high[axis] = line[axis][begin];
  const double boxes_per_length = 1 / row.reach;
  std::size_t best = begin + 1;
  double least = infinity;
  double room = 0;
  for (std::size_t i = begin; i < std::min(end, begin + batch_size); ++i) {
    double space = 1;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const float at = line[axis][i];
      low[axis] = at < low[axis] ? at : low[axis];
      high[axis] = at > high[axis] ? at : high[axis];
      space *= (double{high[axis]} - double{low[axis]}) * boxes_per_length + 2;
    }
    room += double{row.room[i]};
    const auto count = static_cast<double>(i + 1 - begin);
    // trouble / count + space / room, by one division
    const double cost = (trouble * room + space * count) / (room * count);
    if (!(cost <= least)) continue;
    least = cost;
    best = i + 1;
  }
  return best;
}

template <std::size_t axes>
std::size_t cut_block(const Row& row, std::size_t begin, std::size_t end, Span* batches) {
  std::size_t count = 0;
  while (begin < end) {
    const std::size_t next = cheapest_end<axes>(row, begin, end);
    batches[count++] = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(next)};
    begin = next;
  }
  return count;
}

}  // namespace

void BatchCutter::cut(const Row& row, const Workers& workers) {
  const std::size_t blocks = (row.count + block_size - 1) / block_size;
  batches_.resize(row.count);
  counts_.resize(blocks);
  const auto cut_blocks = [&](std::size_t first, std::size_t last, int) {
    for (std::size_t block = first; block < last; ++block) {
      const std::size_t begin = block * block_size;
      const std::size_t end = std::min(row.count, begin + block_size);
      const auto cut_one = row.dimensions == 3 ? cut_block<3> : cut_block<2>;
      counts_[block] = static_cast<std::uint32_t>(cut_one(row, begin, end, &batches_[begin]));
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
