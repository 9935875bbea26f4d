// Where food lies: a small grid of its own, so that many boids may ask about few pieces.
#pragma once

#include <sturnus/view.h>

#include <vector>

#include "neighbours/offset.h"

namespace sturnus {

/// Pieces of food sorted into cells.
class Pieces {
 public:
  /// Sorts the food for questions of mostly up to `reach` (length). `low` is the lower corner of the space,
  /// which matters where it wraps.
  void build(const Food& food, int dimensions, const Wrapping& image, const std::array<float, 3>& low,
             float reach);

  /// Keeps memory for so many pieces.
  void reserve(std::size_t count);

  /// Calls f(piece, kind, offset) for every piece with distance <= `radius`, always in the same order.
  template <int D, class F>
  void visit(const Vec<D>& at, float radius, F&& f) const {
    if (slot_.empty()) return;
    std::array<Range, 3> ranges{};
    for (std::size_t axis = 0; axis < D; ++axis)
      ranges[axis] = range(axis, at[static_cast<int>(axis)], radius);
    for (int k = 0; k < ranges[2].count; ++k) {
      for (int j = 0; j < ranges[1].count; ++j) {
        for (int i = 0; i < ranges[0].count; ++i) {
          const std::size_t cell =
              (cell_on(2, ranges[2], k) * cells_[1] + cell_on(1, ranges[1], j)) * cells_[0] +
              cell_on(0, ranges[0], i);
          visit_cell(cell, at, radius, f);
        }
      }
    }
  }

  /// Pieces [begin, end) in the order of the cells.
  struct Run {
    std::uint32_t begin, end;
  };
  /// The runs of pieces that may be within the radius of somebody in the box from `low` to `high`. For each
  /// who stands there they come in the order in which `visit` tells of them; false where that can't be had,
  /// and `runs` means nothing.
  bool find_runs(const std::array<float, 3>& low, const std::array<float, 3>& high, float radius,
                 std::vector<Run>& runs) const;
  /// Of the piece at a place in that order.
  std::uint8_t kind_at(std::uint32_t i) const { return kind_[i]; }
  float coordinate_at(std::size_t axis, std::uint32_t i) const { return position_[axis][i]; }

  /// Fills all with garbage.
  void spoil();

 private:
  /// `count` cells of an axis from `first` on; over the seam where it wraps.
  struct Range {
    int first = 0, count = 1;
  };
  Range range(std::size_t axis, float coordinate, float radius) const {
    return range(axis, coordinate, coordinate, radius);
  }
  Range range(std::size_t axis, float low, float high, float radius) const;
  void add_runs(std::size_t row, const Range& along, std::vector<Run>& runs) const;
  std::size_t cell_on(std::size_t axis, const Range& range, int i) const {
    const auto cell = static_cast<std::size_t>(range.first + i);
    return cell < cells_[axis] ? cell : cell - cells_[axis];
  }
  std::size_t cell_at(std::size_t axis, float coordinate) const;
  void lay_out(const Food& food, int dimensions, const std::array<float, 3>& low, float reach);
  std::size_t cell_of(const Food& food, std::size_t piece) const;

  template <int D, class F>
  void visit_cell(std::size_t cell, const Vec<D>& at, float radius, F& f) const {
    for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
      Vec<D> place;
      for (int axis = 0; axis < D; ++axis) place[axis] = position_[static_cast<std::size_t>(axis)][i];
      const Vec<D> o = offset(at, place, image_);
      if (dot(o, o) <= radius * radius) f(slot_[i], kind_[i], o);
    }
  }

  int dimensions_ = 2;
  Wrapping image_;
  std::array<double, 3> low_{}, width_{};
  std::array<std::size_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> begin_;  ///< of each cell in the arrays below
  std::vector<std::uint32_t> slot_;   ///< place of a piece in the state
  std::vector<std::uint8_t> kind_;
  Columns position_;
};

}  // namespace sturnus
