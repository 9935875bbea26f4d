// The uniform cell grid: rows of height reach along x, cells of a quarter reach in a row, sorted by counting.
#include <algorithm>
#include <cmath>

#include "neighbours/index.h"

namespace sturnus {
namespace {

// Cells along one axis. Places outside fall into the first or last cell, which keeps near ones near.
struct Axis {
  double min = 0;
  double cells_per_length = 1;
  std::int64_t cells = 1;

  std::int64_t unbounded_cell(double at) const {
    const double place = std::clamp((at - min) * cells_per_length, -1e15, 1e15);
    const auto cell = static_cast<std::int64_t>(place);  // towards zero; std::floor would be a call
    return cell - (place < static_cast<double>(cell) ? 1 : 0);
  }
  std::int64_t cell(double at) const { return std::clamp<std::int64_t>(unbounded_cell(at), 0, cells - 1); }
  double edge(std::int64_t cell) const { return min + static_cast<double>(cell) / cells_per_length; }
};

// One or two runs of cells: a question may reach over the seam of a wrapped space.
struct Runs {
  std::int64_t first[2], last[2];
  int count = 0;
  void add(std::int64_t from, std::int64_t to) {
    if (from > to) return;
    first[count] = from;
    last[count++] = to;
  }
};

class Grid : public NeighbourIndex {
 public:
  void build(const Cloud& cloud, float reach, const Workers& workers,
             std::vector<std::uint32_t>& order) override {
    cloud_ = cloud;
    reach_ = padded_reach(cloud, reach);
    choose_axes();
    sort(workers, order);
  }

  void spans(const std::array<float, 3>& from, const std::array<float, 3>& to,
             std::vector<Span>& spans) const override {
    spans.clear();
    const Runs x = runs(0, from[0], to[0]);
    const Runs y = runs(1, from[1], to[1]);
    const Runs z = cloud_.dimensions == 3 ? runs(2, from[2], to[2]) : Runs{{0, 0}, {0, 0}, 1};
    for (int i = 0; i < z.count; ++i) {
      for (std::int64_t layer = z.first[i]; layer <= z.last[i]; ++layer) {
        for (int j = 0; j < y.count; ++j) {
          for (std::int64_t row = y.first[j]; row <= y.last[j]; ++row) add_row(layer, row, x, spans);
        }
      }
    }
  }

  void batches(std::vector<Span>& batches) const override {
    batches.clear();
    for (std::int64_t row = 0; row < axes_[1].cells * axes_[2].cells; ++row) {
      const auto first = static_cast<std::size_t>(row * axes_[0].cells);
      cut(begin_[first], begin_[first + static_cast<std::size_t>(axes_[0].cells)], batches);
    }
  }

  void boxes(std::vector<IndexBox>& boxes) const override {
    boxes.clear();
    for (std::int64_t cell = 0; cell < cell_count(); ++cell) {
      const auto i = static_cast<std::size_t>(cell);
      if (begin_[i] == begin_[i + 1]) continue;
      const std::array<std::int64_t, 3> at = {cell % axes_[0].cells, cell / axes_[0].cells % axes_[1].cells,
                                              cell / (axes_[0].cells * axes_[1].cells)};
      IndexBox box;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis) {
        box.min[axis] = static_cast<float>(axes_[axis].edge(at[axis]));
        box.max[axis] = static_cast<float>(axes_[axis].edge(at[axis] + 1));
      }
      boxes.push_back(box);
    }
  }

 private:
  std::int64_t cell_count() const { return axes_[0].cells * axes_[1].cells * axes_[2].cells; }

  // Where the boids are on one axis: lowest and highest of those that are not hidden.
  std::array<double, 2> reach_of_boids(std::size_t axis) const {
    double low = infinity;
    double high = -infinity;
    for (std::size_t i = 0; i < cloud_.count; ++i) {
      if (cloud_.hidden[i] != 0) continue;
      low = std::min(low, double{cloud_.position[axis][i]});
      high = std::max(high, double{cloud_.position[axis][i]});
    }
    if (low > high) return {cloud_.min[axis], cloud_.max[axis]};
    return {low, high};
  }

  // The middle nine tenths of the boids and as much again on either side: a stray far away must not make
  // the cells of all others huge.
  std::array<double, 2> reach_of_most(std::size_t axis) const {
    std::vector<float> at;
    for (std::size_t i = 0; i < cloud_.count; ++i) {
      if (cloud_.hidden[i] == 0) at.push_back(cloud_.position[axis][i]);
    }
    if (at.empty()) return {cloud_.min[axis], cloud_.max[axis]};
    const auto low = at.begin() + static_cast<std::ptrdiff_t>(at.size() / 20);
    std::nth_element(at.begin(), low, at.end());
    const double from = *low;
    const auto high = at.begin() + static_cast<std::ptrdiff_t>(at.size() - 1 - at.size() / 20);
    std::nth_element(at.begin(), high, at.end());
    const double to = *high;
    return {from - (to - from), to + (to - from)};
  }

  std::int64_t most_cells() const {
    return std::max<std::int64_t>(4096, 8 * static_cast<std::int64_t>(cloud_.count));
  }

  // Sets the cells over the given stretch of each axis, `scale` times as large as they would be; returns how
  // many.
  double lay(const std::array<std::array<double, 2>, 3>& stretch, double scale) {
    double total = 1;
    axes_[2] = {};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis) {
      const double wanted = (axis == 0 ? reach_ / 4 : reach_) * scale;
      const double length = stretch[axis][1] - stretch[axis][0];
      const double cells = std::max(1.0, std::floor(length / wanted));
      axes_[axis].min = stretch[axis][0];
      axes_[axis].cells = static_cast<std::int64_t>(std::min(cells, 1e15));
      axes_[axis].cells_per_length = length > 0 ? cells / length : 1;
      total *= cells;
    }
    return total;
  }

  void choose_axes() {
    std::array<std::array<double, 2>, 3> stretch{};
    const auto axes = static_cast<std::size_t>(cloud_.dimensions);
    const auto limit = static_cast<double>(most_cells());
    for (std::size_t axis = 0; axis < axes; ++axis) {
      stretch[axis] =
          cloud_.wraps ? std::array<double, 2>{cloud_.min[axis], cloud_.max[axis]} : reach_of_boids(axis);
    }
    if (!cloud_.wraps && lay(stretch, 1) > limit) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const auto most = reach_of_most(axis);
        stretch[axis] = {std::max(stretch[axis][0], most[0]), std::min(stretch[axis][1], most[1])};
      }
    }
    double scale = 1;
    while (lay(stretch, scale) > limit) scale *= 1.25;
  }

  std::uint32_t cell_of(std::size_t i) const {
    if (cloud_.hidden[i] != 0) return static_cast<std::uint32_t>(cell_count());
    std::int64_t cell = cloud_.dimensions == 3 ? axes_[2].cell(cloud_.position[2][i]) : 0;
    cell = cell * axes_[1].cells + axes_[1].cell(cloud_.position[1][i]);
    cell = cell * axes_[0].cells + axes_[0].cell(cloud_.position[0][i]);
    return static_cast<std::uint32_t>(cell);
  }

  // Stable counting sort; hidden boids come last, in a cell that nobody asks for.
  void sort(const Workers& workers, std::vector<std::uint32_t>& order) {
    cells_.resize(cloud_.count);
    workers.for_ranges(cloud_.count, [this](std::size_t begin, std::size_t end, int) {
      for (std::size_t i = begin; i < end; ++i) cells_[i] = cell_of(i);
    });
    begin_.assign(static_cast<std::size_t>(cell_count()) + 2, 0);
    for (const std::uint32_t cell : cells_) ++begin_[cell + 1];
    for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    next_ = begin_;
    order.resize(cloud_.count);
    for (std::size_t i = 0; i < cloud_.count; ++i) order[next_[cells_[i]]++] = static_cast<std::uint32_t>(i);
  }

  Runs runs(std::size_t axis, float from, float to) const {
    const Axis& cells = axes_[axis];
    Runs out;
    if (!cloud_.wraps) {
      out.add(cells.cell(from - reach_), cells.cell(to + reach_));
      return out;
    }
    const std::int64_t low = cells.unbounded_cell(from - reach_);
    const std::int64_t high = cells.unbounded_cell(to + reach_);
    if (high - low + 1 >= cells.cells) {
      out.add(0, cells.cells - 1);
    } else if (low < 0) {
      out.add(low + cells.cells, cells.cells - 1);
      out.add(0, high);
    } else {
      out.add(low, std::min(high, cells.cells - 1));
      out.add(0, high - cells.cells);
    }
    return out;
  }

  void add_row(std::int64_t layer, std::int64_t row, const Runs& x, std::vector<Span>& spans) const {
    const std::int64_t first = (layer * axes_[1].cells + row) * axes_[0].cells;
    for (int i = 0; i < x.count; ++i) {
      const Span span{begin_[static_cast<std::size_t>(first + x.first[i])],
                      begin_[static_cast<std::size_t>(first + x.last[i] + 1)]};
      if (span.begin < span.end) spans.push_back(span);
    }
  }

  Cloud cloud_;
  double reach_ = 0;
  std::array<Axis, 3> axes_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

std::unique_ptr<NeighbourIndex> make_grid() {
  return std::make_unique<Grid>();
}

}  // namespace sturnus
