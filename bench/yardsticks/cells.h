// Cells for the yardsticks that keep their boids in order of place: rows of height radius, cells of a quarter
// radius along x, sorted by counting.
#pragma once

#include <algorithm>
#include <cstdint>

#include "rules.h"

namespace bench {
namespace {

template <int D>
class Cells {
 public:
  explicit Cells(const Numbers& numbers) : min_(numbers.min) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      const float side = axis == 0 ? numbers.radius / 4 : numbers.radius;
      count_[axis] = std::max(1, static_cast<int>(numbers.size[axis] / side));
      per_length_[axis] = static_cast<float>(count_[axis]) / numbers.size[axis];
    }
  }

  int count(std::size_t axis) const { return count_[axis]; }

  int along(std::size_t axis, float at) const {
    return std::clamp(static_cast<int>((at - min_[axis]) * per_length_[axis]), 0, count_[axis] - 1);
  }

  /// The cell with these coordinates, x running fastest.
  std::size_t cell(const std::array<int, 3>& at) const {
    return static_cast<std::size_t>((at[2] * count_[1] + at[1]) * count_[0] + at[0]);
  }

  std::array<int, 3> coordinates(const Vector<D>& place) const {
    std::array<int, 3> out{};
    for (std::size_t axis = 0; axis < D; ++axis) out[axis] = along(axis, place[axis]);
    return out;
  }

  /// Where each boid goes so that all stand in order of cells; fills `begin()`.
  template <class PlaceOf>
  const std::vector<std::uint32_t>& order(std::size_t boids, const PlaceOf& place_of) {
    begin_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    cell_of_.resize(boids);
    target_.resize(boids);
    for (std::size_t i = 0; i < boids; ++i) {
      cell_of_[i] = static_cast<std::uint32_t>(cell(coordinates(place_of(i))));
      ++begin_[cell_of_[i] + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    next_ = begin_;
    for (std::size_t i = 0; i < boids; ++i) target_[i] = next_[cell_of_[i]]++;
    return target_;
  }

  /// The first boid of a cell, as of the last `order`; that of the cell after it is the end.
  std::uint32_t begin(std::size_t cell) const { return begin_[cell]; }

 private:
  std::array<float, 3> min_;
  std::array<int, 3> count_ = {1, 1, 1};
  std::array<float, 3> per_length_{};
  std::vector<std::uint32_t> begin_, next_, cell_of_, target_;
};

}  // namespace
}  // namespace bench
