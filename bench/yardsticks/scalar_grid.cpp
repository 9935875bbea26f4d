// Yardstick: a good scalar loop over the cell grid that the engine uses too, boids as a struct of arrays in
// order of cells.
#include "cells.h"
#include "rules.h"
#include "yardstick.h"

namespace bench {
namespace {

template <int D>
class ScalarGrid : public Yardstick {
 public:
  ScalarGrid(const Numbers& numbers, const Flock& start)
      : numbers_(numbers), cells_(numbers), now_(start), next_(start), rank_(start.size()), spare_(rank_) {
    for (std::size_t i = 0; i < rank_.size(); ++i) rank_[i] = static_cast<std::uint32_t>(i);
  }

  void step() override {
    sort();
    for (std::size_t i = 0; i < rank_.size(); ++i) {
      const Boid<D> me = boid_at<D>(now_, i);
      put<D>(next_, i, moved<D, Course::wrapped>(numbers_, me, sums_of(me, i)));
    }
    std::swap(now_, next_);
  }

  Flock flock() const override {
    Flock out = empty_flock<D>(rank_.size());
    for (std::size_t i = 0; i < rank_.size(); ++i) put<D>(out, rank_[i], boid_at<D>(now_, i));
    return out;
  }

 private:
  void sort() {
    const auto& target =
        cells_.order(rank_.size(), [&](std::size_t i) { return boid_at<D>(now_, i).position; });
    for (std::size_t axis = 0; axis < D; ++axis) {
      for (std::size_t i = 0; i < target.size(); ++i)
        next_.position[axis][target[i]] = now_.position[axis][i];
      for (std::size_t i = 0; i < target.size(); ++i)
        next_.velocity[axis][target[i]] = now_.velocity[axis][i];
    }
    for (std::size_t i = 0; i < target.size(); ++i) spare_[target[i]] = rank_[i];
    std::swap(now_, next_);
    rank_.swap(spare_);
  }

  Sums<D> sums_of(const Boid<D>& me, std::size_t self) const {
    Sums<D> sums;
    const auto at = cells_.coordinates(me.position);
    const int layers = D == 3 ? 1 : 0;
    for (int layer = at[2] - layers; layer <= at[2] + layers; ++layer) {
      for (int row = at[1] - 1; row <= at[1] + 1; ++row) add_row(me, self, {0, row, layer}, sums);
    }
    return sums;
  }

  // Rows beyond the seam are those of the other side, seen from a place moved by the size of the space.
  void add_row(const Boid<D>& me, std::size_t self, std::array<int, 3> at, Sums<D>& sums) const {
    Vector<D> from = me.position;
    for (std::size_t axis = 1; axis < D; ++axis) {
      const int count = cells_.count(axis);
      if (at[axis] < 0) from[axis] += numbers_.size[axis];
      if (at[axis] >= count) from[axis] -= numbers_.size[axis];
      at[axis] = (at[axis] + count) % count;
    }
    const float low = from[0] - numbers_.radius;
    const float high = from[0] + numbers_.radius;
    add_cells(me, self, from, at, low, high, sums);
    if (low < numbers_.min[0]) {
      from[0] = me.position[0] + numbers_.size[0];
      add_cells(me, self, from, at, low + numbers_.size[0], numbers_.max[0], sums);
    }
    if (high > numbers_.max[0]) {
      from[0] = me.position[0] - numbers_.size[0];
      add_cells(me, self, from, at, numbers_.min[0], high - numbers_.size[0], sums);
    }
  }

  // One run of cells of a row, which stands in memory in one piece.
  void add_cells(const Boid<D>& me, std::size_t self, const Vector<D>& from, std::array<int, 3> at, float low,
                 float high, Sums<D>& sums) const {
    at[0] = cells_.along(0, low);
    const std::uint32_t begin = cells_.begin(cells_.cell(at));
    at[0] = cells_.along(0, high);
    const std::uint32_t end = cells_.begin(cells_.cell(at) + 1);
    for (std::uint32_t j = begin; j < end; ++j) {
      if (j == self) continue;
      Vector<D> offset, velocity;
      for (std::size_t axis = 0; axis < D; ++axis) {
        offset[axis] = now_.position[axis][j] - from[axis];
        velocity[axis] = now_.velocity[axis][j];
      }
      add_neighbour<D, Course::wrapped>(numbers_, me.velocity, offset, velocity, sums);
    }
  }

  Numbers numbers_;
  Cells<D> cells_;
  Flock now_, next_;
  std::vector<std::uint32_t> rank_, spare_;  // of the ids, by slot
};

}  // namespace

std::unique_ptr<Yardstick> make_scalar_grid(const Numbers& numbers, const Flock& start) {
  if (numbers.dimensions == 3) return std::make_unique<ScalarGrid<3>>(numbers, start);
  return std::make_unique<ScalarGrid<2>>(numbers, start);
}

}  // namespace bench
