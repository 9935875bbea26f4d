// The uniform cell grid: rows of height reach along x, cells of a quarter reach in a row, sorted by counting.
#include <algorithm>
#include <cmath>
#include <limits>

#include "neighbours/index.h"

namespace sturnus {
namespace {

// Cells along one axis. Places outside fall into the first or last cell, which keeps near ones near. The cell
// of a place is found in float, by the same operations for boids and for questions, so that it never falls
// when the place rises; what rounding does beside that is in the padding of the reach.
struct Axis {
  float min = 0;
  float cells_per_length = 1;
  std::int32_t cells = 1;

  float place(float at) const { return (at - min) * cells_per_length; }
  std::uint32_t cell(float at) const {
    const float most = static_cast<float>(cells - 1);
    const float p = place(at);
    const float up = p > 0 ? p : 0.0f;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(up < most ? up : most));
  }
  std::int64_t unbounded_cell(double at) const {
    const float p = std::clamp(place(static_cast<float>(at)), -1e9f, 1e9f);
    const auto whole = static_cast<std::int64_t>(p);  // towards zero; std::floor would be a call
    return whole - (p < static_cast<float>(whole) ? 1 : 0);
  }
  double edge(std::int64_t cell) const {
    return double{min} + static_cast<double>(cell) / double{cells_per_length};
  }
};

// One or two runs of cells: a question may reach over the seam of a wrapped space.
struct Runs {
  std::int64_t first[2], last[2];
  Seam seam[2];
  int count = 0;
  void add(std::int64_t from, std::int64_t to, Seam over) {
    if (from > to) return;
    first[count] = from;
    last[count] = to;
    seam[count++] = over;
  }
};

constexpr double infinity = std::numeric_limits<double>::infinity();

class Grid : public NeighbourIndex {
 public:
  void build(const Cloud& cloud, float reach, const Workers& workers,
             std::vector<std::uint32_t>& order) override {
    cloud_ = cloud;
    reach_ = padded_reach(cloud, reach);
    choose_axes();
    find_cells(workers);
    sort(workers, order);
  }

  void reserve(std::size_t count, std::size_t parts) override {
    constexpr std::size_t very_many = 1 << 25;  // what few worlds need is not kept for all that might
    const auto cells = std::min(static_cast<std::size_t>(most_cells(count)) + 1, very_many);
    cells_.reserve(count);
    counts_.reserve(std::min(parts * cells, very_many));
    begin_.reserve(cells + 1);
    sums_.reserve(parts + 1);
    pairs_.reserve(parts);
  }

  void spans(const std::array<float, 3>& from, const std::array<float, 3>& to, float reach,
             std::vector<Span>& spans) const override {
    spans.clear();
    const double far = padded_reach(cloud_, reach);
    const Runs x = runs(0, from[0] - far, to[0] + far);
    const Runs y = runs(1, from[1] - far, to[1] + far);
    const Runs z = cloud_.dimensions == 3 ? runs(2, from[2] - far, to[2] + far) : Runs{{0, 0}, {0, 0}, {}, 1};
    for (int i = 0; i < z.count; ++i) {
      for (std::int64_t layer = z.first[i]; layer <= z.last[i]; ++layer) {
        for (int j = 0; j < y.count; ++j) {
          for (std::int64_t row = y.first[j]; row <= y.last[j]; ++row)
            add_row(layer, row, x, y.seam[j], z.seam[i], spans);
        }
      }
    }
  }

  void ring(const std::array<float, 3>& low, const std::array<float, 3>& high, float inner, float outer,
            RingParts& parts) const override {
    parts.whole.clear();
    parts.edge.clear();
    double extent = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis)
      extent =
          std::max(extent, std::abs(axes_[axis].edge(0)) + std::abs(axes_[axis].edge(axes_[axis].cells)));
    const double room = padded_reach(cloud_, outer) - double{outer} + extent * 1e-6;
    const RingQuestion question{low, high, inner, outer, room};
    const Run y = run(1, low[1], high[1], question);
    const Run z = cloud_.dimensions == 3 ? run(2, low[2], high[2], question) : Run{0, 0};
    const Run x = run(0, low[0], high[0], question);
    const bool meets_itself = y.last - y.first + 1 >= axes_[1].cells ||
                              z.last - z.first + 1 > axes_[2].cells || x.last - x.first + 1 >= axes_[0].cells;
    if (cloud_.wraps && meets_itself) return spans(low, high, outer, parts.edge);
    for (std::int64_t layer = z.first; layer <= z.last; ++layer) {
      for (std::int64_t row = y.first; row <= y.last; ++row) ring_row(question, layer, row, parts);
    }
  }

  CellLayout layout() const override {
    return {std::span(begin_).first(begin_.size() - 1), static_cast<std::size_t>(axes_[0].cells),
            static_cast<std::size_t>(row_count()), has_strays_};
  }

  // From the boids that share a cell.
  double crowding() const override {
    double pairs = 0;
    for (const std::uint64_t part : pairs_) pairs += static_cast<double>(part);
    double cells_in_ball = cloud_.dimensions == 3 ? 4.18879 : 3.14159;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis)
      cells_in_ball *= reach_ * double{axes_[axis].cells_per_length};
    const double count = std::max<double>(1, static_cast<double>(cloud_.count));
    return (pairs / count - 1) * std::max(1.0, cells_in_ball);
  }

  void batches(std::vector<Span>& batches) const override {
    batches.clear();
    for (std::int64_t row = 0; row < row_count(); ++row) {
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
                                              cell / (std::int64_t{axes_[0].cells} * axes_[1].cells)};
      IndexBox box;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis) {
        box.min[axis] = static_cast<float>(axes_[axis].edge(at[axis]));
        box.max[axis] = static_cast<float>(axes_[axis].edge(at[axis] + 1));
      }
      boxes.push_back(box);
    }
  }

 private:
  std::int64_t cell_count() const { return row_count() * axes_[0].cells; }
  std::int64_t row_count() const { return std::int64_t{axes_[1].cells} * axes_[2].cells; }

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

  static std::int64_t most_cells(std::size_t boids) {
    return std::max<std::int64_t>(4096, 8 * static_cast<std::int64_t>(boids));
  }

  // Where crowds are summed cell by cell, a row is cut as finely as pays.
  double cells_in_reach() const { return cloud_.fineness == 1 ? 4 : 4 * cloud_.fineness; }

  static constexpr double most_along_an_axis = 1 << 22;  // cells that a float still tells apart
  // Sets the cells over the given stretch of each axis, `scale` times as large as they would be; returns how
  // many.
  double lay(const std::array<std::array<double, 2>, 3>& stretch, double scale) {
    double total = 1;
    axes_[2] = {};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(cloud_.dimensions); ++axis) {
      const double wanted = (axis == 0 ? reach_ / cells_in_reach() : reach_ / cloud_.fineness) * scale;
      const double length = stretch[axis][1] - stretch[axis][0];
      const double cells = std::clamp(std::floor(length / wanted), 1.0, most_along_an_axis);
      axes_[axis].min = static_cast<float>(stretch[axis][0]);
      axes_[axis].cells = static_cast<std::int32_t>(cells);
      axes_[axis].cells_per_length = length > 0 ? static_cast<float>(cells / length) : 1;
      total *= cells;
    }
    return total;
  }

  void choose_axes() {
    std::array<std::array<double, 2>, 3> stretch{};
    const auto axes = static_cast<std::size_t>(cloud_.dimensions);
    const auto limit = static_cast<double>(most_cells(cloud_.count));
    for (std::size_t axis = 0; axis < axes; ++axis) {
      stretch[axis] =
          cloud_.wraps ? std::array<double, 2>{cloud_.min[axis], cloud_.max[axis]} : reach_of_boids(axis);
    }
    has_strays_ = !cloud_.wraps && lay(stretch, 1) > limit;
    if (has_strays_) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const auto most = reach_of_most(axis);
        stretch[axis] = {std::max(stretch[axis][0], most[0]), std::min(stretch[axis][1], most[1])};
      }
    }
    double scale = 1;
    while (lay(stretch, scale) > limit) scale *= 1.25;
  }

  template <int D>
  void find_cells_in(std::size_t begin, std::size_t end) {
    const Axis x = axes_[0], y = axes_[1], z = axes_[2];
    const float* const px = cloud_.position[0];
    const float* const py = cloud_.position[1];
    const float* const pz = cloud_.position[2];
    std::uint32_t* const cells = cells_.data();
    for (std::size_t i = begin; i < end; ++i) {
      std::uint32_t row = y.cell(py[i]);
      if (D == 3) row += z.cell(pz[i]) * static_cast<std::uint32_t>(y.cells);
      cells[i] = row * static_cast<std::uint32_t>(x.cells) + x.cell(px[i]);
    }
  }

  // Hidden boids come last, in a cell that nobody asks for.
  void find_cells(const Workers& workers) {
    cells_.resize(cloud_.count);
    workers.for_ranges(cloud_.count, [this](std::size_t begin, std::size_t end, int) {
      cloud_.dimensions == 3 ? find_cells_in<3>(begin, end) : find_cells_in<2>(begin, end);
      if (!cloud_.hides) return;
      for (std::size_t i = begin; i < end; ++i) {
        if (cloud_.hidden[i] != 0) cells_[i] = static_cast<std::uint32_t>(cell_count());
      }
    });
  }

  // Stable counting sort. Every part of the boids counts for itself, so that each knows where in a cell its
  // own begin: after those of the parts before it.
  void sort(const Workers& workers, std::vector<std::uint32_t>& order) {
    const auto cells = static_cast<std::size_t>(cell_count()) + 1;
    const auto parts = static_cast<std::size_t>(workers.count());
    counts_.resize(parts * cells);
    workers.for_ranges(parts, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t part = first; part < last; ++part) count_part(part, parts, cells);
    });
    add_up(parts, cells, workers);
    order.resize(cloud_.count);
    workers.for_ranges(parts, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t part = first; part < last; ++part) place_part(part, parts, cells, order);
    });
  }

  void count_part(std::size_t part, std::size_t parts, std::size_t cells) {
    std::uint32_t* const counts = counts_.data() + part * cells;
    std::fill_n(counts, cells, 0u);
    const std::size_t end = cloud_.count * (part + 1) / parts;
    for (std::size_t i = cloud_.count * part / parts; i < end; ++i) ++counts[cells_[i]];
  }

  void place_part(std::size_t part, std::size_t parts, std::size_t cells, std::vector<std::uint32_t>& order) {
    std::uint32_t* const next = counts_.data() + part * cells;
    const std::size_t end = cloud_.count * (part + 1) / parts;
    for (std::size_t i = cloud_.count * part / parts; i < end; ++i)
      order[next[cells_[i]]++] = static_cast<std::uint32_t>(i);
  }

  // From counts to where each cell begins, and in it each part.
  void add_up(std::size_t parts, std::size_t cells, const Workers& workers) {
    begin_.resize(cells + 1);
    sums_.assign(parts + 1, 0);
    pairs_.assign(parts, 0);
    workers.for_ranges(parts, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t range = first; range < last; ++range) {
        std::uint32_t sum = 0;
        for (std::size_t part = 0; part < parts && parts > 1; ++part) {
          const std::uint32_t* const counts = counts_.data() + part * cells;
          for (std::size_t cell = cells * range / parts; cell < cells * (range + 1) / parts; ++cell)
            sum += counts[cell];
        }
        sums_[range + 1] = sum;
      }
    });
    for (std::size_t range = 0; range < parts; ++range) sums_[range + 1] += sums_[range];
    workers.for_ranges(parts, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t range = first; range < last; ++range) lay_out(range, parts, cells);
    });
    begin_[cells] = static_cast<std::uint32_t>(cloud_.count);
  }

  void lay_out(std::size_t range, std::size_t parts, std::size_t cells) {
    std::uint32_t at = sums_[range];
    std::uint64_t pairs = 0;
    for (std::size_t cell = cells * range / parts; cell < cells * (range + 1) / parts; ++cell) {
      begin_[cell] = at;
      const std::uint32_t first = at;
      for (std::size_t part = 0; part < parts; ++part) {
        std::uint32_t& counted = counts_[part * cells + cell];
        const std::uint32_t count = counted;
        counted = at;
        at += count;
      }
      if (cell + 1 < cells) pairs += std::uint64_t{at - first} * (at - first);  // not those of the hidden
    }
    pairs_[range] = pairs;
  }

  // The cells between two places, which may lie outside the space.
  Runs runs(std::size_t axis, double from, double to) const {
    const Axis& cells = axes_[axis];
    Runs out;
    if (!cloud_.wraps) {
      out.add(cells.cell(static_cast<float>(from)), cells.cell(static_cast<float>(to)), Seam::none);
      return out;
    }
    const std::int64_t low = cells.unbounded_cell(from);
    const std::int64_t high = cells.unbounded_cell(to);
    if (high - low + 1 >= cells.cells) {
      out.add(0, cells.cells - 1, Seam::unknown);
    } else if (low < 0) {
      out.add(low + cells.cells, cells.cells - 1, Seam::low);
      out.add(0, high, Seam::none);
    } else {
      out.add(low, std::min<std::int64_t>(high, cells.cells - 1), Seam::none);
      out.add(0, high - cells.cells, Seam::high);
    }
    return out;
  }

  // What `ring` asks, with the room for rounding.
  struct RingQuestion {
    const std::array<float, 3>& low;
    const std::array<float, 3>& high;
    double inner, outer, room;
  };
  // Cells [first, last] along an axis; beyond the ends in a space that wraps.
  struct Run {
    std::int64_t first, last;
    bool has(std::int64_t cell) const { return first <= cell && cell <= last; }
  };

  Run between(std::size_t axis, double from, double to) const {
    const Axis& cells = axes_[axis];
    if (!cloud_.wraps) return {cells.cell(static_cast<float>(from)), cells.cell(static_cast<float>(to))};
    return {cells.unbounded_cell(from), cells.unbounded_cell(to)};
  }

  Run run(std::size_t axis, float low, float high, const RingQuestion& question) const {
    const double far = question.outer + question.room;
    return between(axis, low - far, high + far);
  }

  // The cells that lie between two places with both their ends; none where the places are crossed. Border
  // cells are endless where some boids are beyond; where nobody is, their far ends do not matter.
  Run inside(double from, double to) const {
    if (!(from <= to)) return {1, 0};
    Run run = between(0, from, to);
    const std::int64_t last = axes_[0].cells - 1;
    const bool reaches_all = !cloud_.wraps && !has_strays_;
    if (!reaches_all || run.first > 0 || from > axes_[0].edge(0)) ++run.first;
    if (!reaches_all || run.last < last || to < axes_[0].edge(last + 1)) --run.last;
    return run;
  }

  // The least and the largest distance, squared, from a row to places between low and high.
  struct Distances {
    double least = 0, most = 0;
  };
  Distances distances(std::size_t axis, std::int64_t row, double low, double high) const {
    const bool is_first = has_strays_ && row == 0;
    const bool is_last = has_strays_ && row == axes_[axis].cells - 1;
    const double from = is_first ? -infinity : axes_[axis].edge(row);
    const double to = is_last ? infinity : axes_[axis].edge(row + 1);
    const double gap = std::max({0.0, from - high, low - to});
    const double far = std::max(to - low, high - from);
    return {gap * gap, far * far};
  }

  static double half_chord(double radius, double distance_squared) {
    const double squared = radius > 0 ? radius * radius - distance_squared : -1;
    return squared >= 0 ? std::sqrt(squared) : -infinity;
  }

  // Cuts one row where it enters and leaves the ring, for all places of the box and for some.
  void ring_row(const RingQuestion& q, std::int64_t layer, std::int64_t row, RingParts& parts) const {
    Distances d = distances(1, row, q.low[1], q.high[1]);
    if (cloud_.dimensions == 3) {
      const Distances z = distances(2, layer, q.low[2], q.high[2]);
      d = {d.least + z.least, d.most + z.most};
    }
    const double low = q.low[0];
    const double high = q.high[0];
    const double outermost = half_chord(q.outer + q.room, d.least);
    if (outermost < 0) return;
    const double all_within = half_chord(q.outer - q.room, d.most);
    const double some_nearer = q.inner > 0 ? half_chord(q.inner + q.room, d.least) : -infinity;
    const double all_nearer = half_chord(q.inner - q.room, d.most);
    const Run near = between(0, low - outermost, high + outermost);
    const Run within = inside(high - all_within, low + all_within);
    const Run maybe_hole = some_nearer < 0 ? Run{1, 0} : between(0, low - some_nearer, high + some_nearer);
    if (maybe_hole.first > maybe_hole.last) return add_round(layer, row, near, within, parts);
    const Run hole = inside(high - all_nearer, low + all_nearer);
    std::array<std::int64_t, 8> cuts = {near.first,       near.last + 1,       within.first, within.last + 1,
                                        maybe_hole.first, maybe_hole.last + 1, hole.first,   hole.last + 1};
    for (std::int64_t& cut : cuts) cut = std::clamp(cut, near.first, near.last + 1);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] == cuts[i + 1] || hole.has(cuts[i])) continue;
      const bool is_whole = within.has(cuts[i]) && !maybe_hole.has(cuts[i]);
      add_cells(layer, row, {cuts[i], cuts[i + 1] - 1}, is_whole, parts);
    }
  }

  // One row of a round without a hole.
  void add_round(std::int64_t layer, std::int64_t row, Run near, Run within, RingParts& parts) const {
    within = {std::max(near.first, within.first), std::min(near.last, within.last)};
    if (within.first > within.last) return add_cells(layer, row, near, false, parts);
    add_cells(layer, row, {near.first, within.first - 1}, false, parts);
    add_cells(layer, row, within, true, parts);
    add_cells(layer, row, {within.last + 1, near.last}, false, parts);
  }

  // Where a row or cell beyond the ends of a space that wraps really is.
  struct Place {
    std::int64_t cell;
    float shift;
    Seam seam;
  };
  Place place_of(std::size_t axis, std::int64_t cell) const {
    const std::int64_t cells = axes_[axis].cells;
    const float size = cloud_.max[axis] - cloud_.min[axis];
    if (cell < 0) return {cell + cells, -size, Seam::low};
    if (cell >= cells) return {cell - cells, size, Seam::high};
    return {cell, 0, Seam::none};
  }

  void add_cells(std::int64_t layer, std::int64_t row, Run run, bool is_whole, RingParts& parts) const {
    const Place z = place_of(2, layer);
    const Place y = place_of(1, row);
    const std::int64_t first_of_row = (z.cell * axes_[1].cells + y.cell) * axes_[0].cells;
    while (run.first <= run.last) {
      const Place x = place_of(0, run.first);
      const std::int64_t count = std::min(run.last - run.first + 1, axes_[0].cells - x.cell);
      const auto first = static_cast<std::uint32_t>(first_of_row + x.cell);
      const auto last = first + static_cast<std::uint32_t>(count);
      const Span span{begin_[first], begin_[last], {x.seam, y.seam, z.seam}};
      if (span.begin < span.end && is_whole)
        parts.whole.push_back({first, last, {x.shift, y.shift, z.shift}});
      if (span.begin < span.end && !is_whole) parts.edge.push_back(span);
      run.first += count;
    }
  }

  void add_row(std::int64_t layer, std::int64_t row, const Runs& x, Seam over_y, Seam over_z,
               std::vector<Span>& spans) const {
    const std::int64_t first = (layer * axes_[1].cells + row) * axes_[0].cells;
    for (int i = 0; i < x.count; ++i) {
      const Span span{begin_[static_cast<std::size_t>(first + x.first[i])],
                      begin_[static_cast<std::size_t>(first + x.last[i] + 1)],
                      {x.seam[i], over_y, over_z}};
      if (span.begin < span.end) spans.push_back(span);
    }
  }

  Cloud cloud_;
  double reach_ = 0;
  std::array<Axis, 3> axes_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> begin_;   ///< of each cell, and the end of the last
  std::vector<std::uint32_t> counts_;  ///< of each part, cell by cell; later where its next boid goes
  std::vector<std::uint32_t> sums_;
  std::vector<std::uint64_t> pairs_;  ///< of boids that share a cell, themselves included, in parts
  bool has_strays_ = false;           ///< somebody is beyond the cells at the border, and counts as in them
};

}  // namespace

std::unique_ptr<NeighbourIndex> make_grid() {
  return std::make_unique<Grid>();
}

}  // namespace sturnus
