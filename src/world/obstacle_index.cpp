// Cells with the numbers of all obstacles in reach of them: one look at a cell answers a boid.
#include "world/obstacle_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sturnus {
namespace {

// As many rows of cells as memory and building are glad to have.
double most_rows(int dimensions) {
  return dimensions == 3 ? 64 : 512;
}

// An obstacle in more cells than this is asked everywhere.
constexpr std::size_t most_cells = 4096;

}  // namespace

void ObstacleIndex::forget() {
  *this = ObstacleIndex();
}

void ObstacleIndex::fit(const Model& model, const std::vector<Obstacle>& obstacles, float reach) {
  const bool is_the_same = dimensions_ == model.dimensions && wraps_ == model.wraps() && min_ == model.min &&
                           size_ == model.size && reach_ == reach && obstacles_ == obstacles;
  if (is_the_same) return;
  dimensions_ = model.dimensions;
  wraps_ = model.wraps();
  min_ = model.min;
  size_ = model.size;
  reach_ = reach;
  obstacles_ = obstacles;
  everywhere_.clear();
  begins_.clear();
  entries_.clear();
  columns_.fill(model, obstacles);
  if (obstacles_.empty()) return;
  divide(model);
  fill(model);
}

// What of space an obstacle concerns, a little more than its reach because places are rounded.
ObstacleIndex::Bounds ObstacleIndex::bounds_of(const Obstacle& obstacle) const {
  Bounds out;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
    const double at = double{obstacle.at[axis]};
    const double half =
        obstacle.kind == ObstacleKind::sphere ? double{obstacle.radius} : double{obstacle.half[axis]};
    const double slack = 1e-5 * (std::abs(at) + half + double{reach_} + double{size_[axis]});
    out.low[axis] = at - half - double{reach_} - slack;
    out.high[axis] = at + half + double{reach_} + slack;
  }
  return out;
}

void ObstacleIndex::divide(const Model& model) {
  bool is_first = true;
  for (const Obstacle& obstacle : obstacles_) {
    if (obstacle.kind == ObstacleKind::plane) continue;
    const Bounds bounds = bounds_of(obstacle);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = is_first ? bounds.low[axis] : std::min(low_[axis], bounds.low[axis]);
      high_[axis] = is_first ? bounds.high[axis] : std::max(high_[axis], bounds.high[axis]);
    }
    is_first = false;
  }
  counts_ = {1, 1, 1};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
    if (model.wraps()) {
      low_[axis] = double{model.min[axis]};
      high_[axis] = double{model.max[axis]};
    }
    const double size = high_[axis] - low_[axis];
    const double rows = reach_ > 0 ? size / (0.5 * double{reach_}) : infinity;
    counts_[axis] = static_cast<std::uint32_t>(std::clamp(rows, 1.0, most_rows(dimensions_)));
    rows_per_length_[axis] = size > 0 ? counts_[axis] / size : 0;
  }
}

std::uint32_t ObstacleIndex::row_of(std::size_t axis, double at) const {
  const double row = (at - low_[axis]) * rows_per_length_[axis];
  return static_cast<std::uint32_t>(std::clamp(row, 0.0, counts_[axis] - 1.0));
}

// The cells that an obstacle and its images concern.
std::vector<ObstacleIndex::Cells> ObstacleIndex::cells_of(const Model& model,
                                                          const Obstacle& obstacle) const {
  std::vector<Cells> out{Cells{}};
  const Bounds bounds = bounds_of(obstacle);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
    std::vector<Cells> more;
    for (int image = model.wraps() ? -1 : 0; image <= (model.wraps() ? 1 : 0); ++image) {
      const double low = bounds.low[axis] + image * double{size_[axis]};
      const double high = bounds.high[axis] + image * double{size_[axis]};
      if (high < low_[axis] || low > high_[axis]) continue;
      for (Cells cells : out) {
        cells.low[axis] = row_of(axis, low);
        cells.high[axis] = row_of(axis, high);
        more.push_back(cells);
      }
    }
    out = std::move(more);
  }
  return out;
}

// Calls f(cell, obstacle) once for each that belong together, obstacle after obstacle.
template <class F>
void ObstacleIndex::for_each_entry(const Model& model, F&& f) const {
  std::vector<std::uint32_t> last(cell_count(), 0);
  std::size_t skip = 0;
  for (std::uint32_t number = 0; number < obstacles_.size(); ++number) {
    if (skip < everywhere_.size() && everywhere_[skip] == number) {
      ++skip;
      continue;
    }
    for (const Cells& cells : cells_of(model, obstacles_[number])) {
      std::array<std::uint32_t, 3> at{};
      for (at[2] = cells.low[2]; at[2] <= cells.high[2]; ++at[2]) {
        for (at[1] = cells.low[1]; at[1] <= cells.high[1]; ++at[1]) {
          for (at[0] = cells.low[0]; at[0] <= cells.high[0]; ++at[0]) {
            // Images may share a cell.
            if (std::exchange(last[number_of(at)], number + 1) != number + 1) f(number_of(at), number);
          }
        }
      }
    }
  }
}

void ObstacleIndex::fill(const Model& model) {
  for (std::uint32_t number = 0; number < obstacles_.size(); ++number) {
    std::size_t sum = 0;
    if (obstacles_[number].kind != ObstacleKind::plane) {
      for (const Cells& cells : cells_of(model, obstacles_[number])) {
        std::size_t content = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) content *= cells.high[axis] - cells.low[axis] + 1;
        sum += content;
      }
    }
    if (sum == 0 || sum > most_cells) everywhere_.push_back(number);
  }
  begins_.assign(cell_count() + 1, 0);
  for_each_entry(model, [&](std::size_t cell, std::uint32_t) { ++begins_[cell + 1]; });
  for (std::size_t cell = 0; cell < cell_count(); ++cell) begins_[cell + 1] += begins_[cell];
  entries_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for_each_entry(model, [&](std::size_t cell, std::uint32_t number) { entries_[next[cell]++] = number; });
}

}  // namespace sturnus
