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

// As many cells on an axis as are wider than the reach, with room for rounding, but no more than a few for
// each piece.
void Pieces::lay_out(const Food& food, int dimensions, const std::array<float, 3>& low, float reach) {
  const double most = std::clamp(std::sqrt(static_cast<double>(food.size())), 1.0, 64.0);
  cells_ = {1, 1, 1};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    const auto [least, largest] = std::minmax_element(food.position[axis].begin(), food.position[axis].end());
    low_[axis] = image_.wraps ? double{low[axis]} : double{*least};
    const double size = image_.wraps ? double{image_.size[axis]} : double{*largest} - double{*least};
    const double wanted = std::min(size / (1.001 * double{reach}), most);
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

Pieces::Range Pieces::range(int axis, float coordinate) const {
  const auto i = static_cast<std::size_t>(axis);
  const auto count = static_cast<int>(cells_[i]);
  if (image_.wraps) {
    if (count <= 3) return {0, count};
    return {(static_cast<int>(cell_at(i, coordinate)) + count - 1) % count, 3};
  }
  // Outside the pieces' box the clamped cell is at its edge: the neighbours are still within one cell.
  const auto own = static_cast<int>(cell_at(i, coordinate));
  const int first = std::max(own - 1, 0);
  return {first, std::min(own + 1, count - 1) - first + 1};
}

void Pieces::spoil() {
  spoil_array(begin_);
  spoil_array(slot_);
  spoil_array(kind_);
  for (auto& column : position_) spoil_array(column);
}

}  // namespace sturnus
