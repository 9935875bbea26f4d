// A grid over the food: cells by counting, a piece after the other.
#include "neighbours/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace sturnus {
namespace {

template <class T>
void spoil_array(std::vector<T>& array) {
  if (!array.empty()) std::memset(static_cast<void*>(array.data()), 0xff, array.size() * sizeof(T));
}

}  // namespace

void Pieces::reserve(std::size_t count) {
  constexpr std::size_t most_cells = 32 * 32 * 32;  // in 3D, more than 128 * 128 in 2D
  begin_.reserve(most_cells + 2);
  slot_.reserve(count);
  kind_.reserve(count);
  for (auto& column : position_) column.reserve(count);
}

// Cells about half as wide as the reach, but no more than a few for each piece.
void Pieces::lay_out(const Food& food, int dimensions, const std::array<float, 3>& low, float reach) {
  const double root = std::sqrt(static_cast<double>(food.size()));
  const double most = dimensions == 3 ? std::min(2 * root, 32.0) : std::min(4 * root, 128.0);
  cells_ = {1, 1, 1};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    const auto [least, largest] = std::minmax_element(food.position[axis].begin(), food.position[axis].end());
    low_[axis] = image_.wraps ? double{low[axis]} : double{*least};
    const double size = image_.wraps ? double{image_.size[axis]} : double{*largest} - double{*least};
    const double wanted = std::min(2 * size / double{reach}, most);
    cells_[axis] = wanted >= 1 ? static_cast<std::size_t>(wanted) : 1;
    width_[axis] = size > 0 ? size / static_cast<double>(cells_[axis]) : 1;
  }
}

std::size_t Pieces::cell_at(std::size_t axis, float coordinate) const {
  const double cell = std::floor((double{coordinate} - low_[axis]) / width_[axis]);
  const auto last = static_cast<double>(cells_[axis] - 1);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, last));
}

std::size_t Pieces::cell_of(const Food& food, std::size_t piece) const {
  std::size_t cell = 0;
  for (std::size_t axis = static_cast<std::size_t>(dimensions_); axis-- > 0;)
    cell = cell * cells_[axis] + cell_at(axis, food.position[axis][piece]);
  return cell;
}

void Pieces::build(const Food& food, int dimensions, const Wrapping& image, const std::array<float, 3>& low,
                   float reach) {
  dimensions_ = dimensions;
  image_ = image;
  slot_.resize(food.size());
  kind_.resize(food.size());
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
    position_[axis].resize(food.size());
  if (food.size() == 0) return;
  lay_out(food, dimensions, low, reach);
  begin_.assign(cells_[0] * cells_[1] * cells_[2] + 2, 0);
  for (std::size_t i = 0; i < food.size(); ++i) ++begin_[cell_of(food, i) + 2];
  for (std::size_t cell = 2; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  for (std::size_t i = 0; i < food.size(); ++i) {
    const std::uint32_t place = begin_[cell_of(food, i) + 1]++;
    slot_[place] = static_cast<std::uint32_t>(i);
    kind_[place] = food.kind[i];
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
      position_[axis][place] = food.position[axis][i];
  }
}

Pieces::Range Pieces::range(std::size_t axis, float low, float high, float radius) const {
  const auto count = static_cast<double>(cells_[axis]);
  // With room for the rounding of offsets in float.
  const auto wide = [&](double at) {
    return 1.0001 * double{radius} + 1e-6 * (std::abs(at) + std::abs(low_[axis]));
  };
  const double from = double{low} - low_[axis], to = double{high} - low_[axis];
  const double first = std::floor((from - wide(from)) / width_[axis]);
  const double last = std::floor((to + wide(to)) / width_[axis]);
  if (image_.wraps) {
    if (!(last - first + 1 < count)) return {0, static_cast<int>(cells_[axis])};
    return {static_cast<int>(first < 0 ? first + count : first), static_cast<int>(last - first) + 1};
  }
  const double begin = std::clamp(first, 0.0, count - 1);
  return {static_cast<int>(begin), static_cast<int>(std::clamp(last, 0.0, count - 1) - begin) + 1};
}

void Pieces::add_runs(std::size_t row, const Range& along, std::vector<Run>& runs) const {
  const auto add = [&](std::size_t first, std::size_t last) {
    const Run run{begin_[row + first], begin_[row + last]};
    if (run.begin != run.end) runs.push_back(run);
  };
  const auto first = static_cast<std::size_t>(along.first);
  const std::size_t last = first + static_cast<std::size_t>(along.count);
  add(first, std::min(last, cells_[0]));
  if (last > cells_[0]) add(0, last - cells_[0]);
}

bool Pieces::find_runs(const std::array<float, 3>& low, const std::array<float, 3>& high, float radius,
                       std::vector<Run>& runs) const {
  runs.clear();
  runs.reserve(slot_.size());
  if (slot_.empty()) return true;
  std::array<Range, 3> ranges{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
    ranges[axis] = range(axis, low[axis], high[axis], radius);
    // Somebody's own cells may then begin in the middle of these.
    if (image_.wraps && static_cast<std::size_t>(ranges[axis].count) == cells_[axis]) return false;
  }
  for (int k = 0; k < ranges[2].count; ++k) {
    for (int j = 0; j < ranges[1].count; ++j)
      add_runs((cell_on(2, ranges[2], k) * cells_[1] + cell_on(1, ranges[1], j)) * cells_[0], ranges[0],
               runs);
  }
  return true;
}

void Pieces::spoil() {
  spoil_array(begin_);
  spoil_array(slot_);
  spoil_array(kind_);
  for (auto& column : position_) spoil_array(column);
}

}  // namespace sturnus
