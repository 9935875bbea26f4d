// Which obstacles may be near a place: a uniform grid over their surroundings. Derived from State and Model
// alone, and built again only when these change.
#pragma once

#include <vector>

#include "world/obstacle_columns.h"
#include "world/solids.h"

namespace sturnus {

class ObstacleIndex {
 public:
  /// Makes the index that of these obstacles, for questions up to `reach` (length) away.
  void fit(const Model& model, const std::vector<Obstacle>& obstacles, float reach);
  /// Forgets all, so that the next `fit` builds anew.
  void forget();

  bool empty() const { return obstacles_.empty(); }
  const Obstacle& obstacle(std::uint32_t number) const { return obstacles_[number]; }
  /// All of them; good until the next `fit`.
  const ObstacleColumns& columns() const { return columns_; }

  /// Calls f(obstacle) in the order of the obstacles for all whose surface is within `reach` of a place of
  /// the space, and for some others.
  template <int D, class F>
  void visit(const Vec<D>& at, double reach, F&& f) const;

 private:
  struct Bounds {
    std::array<double, 3> low{}, high{};
  };
  struct Cells {
    std::array<std::uint32_t, 3> low{}, high{};
  };

  void divide(const Model& model);
  void fill(const Model& model);
  Bounds bounds_of(const Obstacle& obstacle) const;
  std::vector<Cells> cells_of(const Model& model, const Obstacle& obstacle) const;
  std::uint32_t row_of(std::size_t axis, double at) const;
  std::size_t number_of(const std::array<std::uint32_t, 3>& cell) const {
    return (cell[2] * counts_[1] + cell[1]) * std::size_t{counts_[0]} + cell[0];
  }
  std::size_t cell_count() const { return std::size_t{counts_[0]} * counts_[1] * counts_[2]; }
  template <class F>
  void for_each_entry(const Model& model, F&& f) const;

  int dimensions_ = 2;
  std::vector<Obstacle> obstacles_;
  ObstacleColumns columns_;
  bool wraps_ = false;
  std::array<float, 3> min_{}, size_{};
  float reach_ = -1;
  std::array<double, 3> low_{}, high_{}, rows_per_length_{};
  std::array<std::uint32_t, 3> counts_{1, 1, 1};
  std::vector<std::uint32_t> everywhere_;  ///< planes, and what is as large as the world
  std::vector<std::uint32_t> begins_;      ///< of each cell's stretch of entries_, and the end
  std::vector<std::uint32_t> entries_;     ///< ascending within a cell
};

template <int D, class F>
void ObstacleIndex::visit(const Vec<D>& at, double reach, F&& f) const {
  if (obstacles_.empty()) return;
  if (!(reach <= double{reach_})) {
    for (const Obstacle& obstacle : obstacles_) f(obstacle);
    return;
  }
  const std::uint32_t* one = everywhere_.data();
  const std::uint32_t* const end_of_one = one + everywhere_.size();
  const std::uint32_t* two = entries_.data();
  const std::uint32_t* end_of_two = two;
  std::array<std::uint32_t, 3> cell{};
  bool is_outside = begins_.empty();
  for (int axis = 0; axis < D && !is_outside; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    is_outside = !(double{at[axis]} >= low_[i] && double{at[axis]} <= high_[i]);
    if (!is_outside) cell[i] = row_of(i, double{at[axis]});
  }
  if (!is_outside) {
    const std::size_t number = number_of(cell);
    end_of_two = two + begins_[number + 1];
    two += begins_[number];
  }
  while (one != end_of_one || two != end_of_two) {
    const bool takes_one = two == end_of_two || (one != end_of_one && *one < *two);
    f(obstacles_[takes_one ? *one++ : *two++]);
  }
}

}  // namespace sturnus
