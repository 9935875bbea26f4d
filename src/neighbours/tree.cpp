// Quadtree in 2D, octree in 3D: nodes are halved at their midpoint until a leaf holds few boids or lies deep
// enough. Built anew each step from the boids' sorted Z-order keys: a node is a stretch of them that have the
// same first bits.
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <type_traits>

#include "neighbours/batches.h"
#include "neighbours/index.h"
#include "neighbours/morton.h"

namespace sturnus {
namespace {

// Nodes stand in the order of a walk: a node, then its first child with all below it, then its second.
struct Node {
  std::array<float, 3> low{}, high{};  ///< the box of its boids, not the cell
  std::uint32_t begin = 0;             ///< its first boid; the last is before the next node's
  std::uint32_t next = 0;              ///< the node after all that is below this one
};

// No cell is finer than this part of the reach: whoever is nearer is asked about together in any case.
constexpr double cells_per_reach = 256;

// Boids so many times farther apart than most of them are strays.
constexpr double most_sizes = 4096;

class Tree : public NeighbourIndex {
 public:
  Tree(std::int64_t leaf_size, std::int64_t depth_limit)
      : leaf_size_(static_cast<std::uint32_t>(leaf_size)), depth_limit_(static_cast<int>(depth_limit)) {}

  void build(const Cloud& cloud, float reach, const Workers& workers,
             std::vector<std::uint32_t>& order) override {
    cloud_ = cloud;
    reach_ = padded_reach(cloud, reach);
    choose_cube();
    sort(workers, order);
    line_up(workers);
    nodes_.clear();
    cell_levels_.clear();
    if (seen_ > 0) divide(0, seen_, cube_.levels, 0);
    nodes_.push_back({{}, {}, seen_, 0});
    fit_boxes(workers);
    cutter_.cut(line_, axes(), seen_, static_cast<float>(reach_), workers);
  }

  void spans(const std::array<float, 3>& low, const std::array<float, 3>& high,
             std::vector<Span>& spans) const override {
    const double reach = reach_;
    spans.clear();
    const bool wraps = cloud_.wraps && is_near_over_the_seam(low, high, reach);
    if (axes() == 3) {
      wraps ? walk<3, true>(low, high, reach, spans) : walk<3, false>(low, high, reach, spans);
    } else {
      wraps ? walk<2, true>(low, high, reach, spans) : walk<2, false>(low, high, reach, spans);
    }
  }

  void batches(std::vector<Span>& batches) const override { batches = cutter_.batches(); }

  void boxes(std::vector<IndexBox>& boxes) const override {
    boxes.clear();
    for (std::size_t at = 0; at + 1 < nodes_.size(); ++at) {
      if (is_leaf(at)) boxes.push_back(cell_of(at));
    }
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(cloud_.dimensions); }
  std::size_t node_count() const { return nodes_.size() - 1; }
  bool is_leaf(std::size_t at) const { return nodes_[at].next == at + 1; }
  std::uint32_t end_of(const Node& node) const { return nodes_[node.next].begin; }

  // The space, made larger where boids are outside.
  void find_bounds() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = cloud_.min[axis];
      high_[axis] = cloud_.max[axis];
    }
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      float low = cloud_.min[axis];
      float high = cloud_.max[axis];
      for (std::size_t i = 0; i < cloud_.count; ++i) {
        const float at = cloud_.hidden[i] != 0 ? low : cloud_.position[axis][i];
        low = std::min(low, at);
        high = std::max(high, at);
      }
      low_[axis] = low;
      high_[axis] = high;
    }
  }

  double longest_side() const {
    double side = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) side = std::max(side, high_[axis] - low_[axis]);
    return side;
  }

  // Where the middle nine tenths of the boids are on one axis, by a sample of them.
  std::array<double, 2> reach_of_most(std::size_t axis) {
    const std::size_t stride = 1 + cloud_.count / 1024;
    sample_.clear();
    for (std::size_t i = 0; i < cloud_.count; i += stride) {
      if (cloud_.hidden[i] == 0) sample_.push_back(cloud_.position[axis][i]);
    }
    if (sample_.empty()) return {low_[axis], high_[axis]};
    std::sort(sample_.begin(), sample_.end());
    return {sample_[sample_.size() / 20], sample_[sample_.size() - 1 - sample_.size() / 20]};
  }

  // One far away must not put all others into one cell: beyond so many times the size of most, places count
  // as on the border.
  void leave_out_strays() {
    std::array<std::array<double, 2>, 3> most{};
    double size = reach_;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      most[axis] = reach_of_most(axis);
      size = std::max(size, most[axis][1] - most[axis][0]);
    }
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      low_[axis] = std::max(low_[axis], most[axis][0] - size * most_sizes / 2);
      high_[axis] = std::min(high_[axis], most[axis][1] + size * most_sizes / 2);
    }
  }

  void choose_cube() {
    find_bounds();
    if (longest_side() > most_sizes * reach_) leave_out_strays();
    cube_.min = low_;
    cube_.side = longest_side();
    if (!(cube_.side > 0)) cube_.side = 1;
    const double cells = cube_.side * (cells_per_reach / reach_);
    const int most = axes() == 3 ? most_levels<3> : most_levels<2>;
    for (cube_.levels = 0; cube_.levels < most && std::ldexp(1.0, cube_.levels) < cells;) ++cube_.levels;
  }

  // Hidden boids come last, by a bit above all others.
  template <int D>
  void find_keys(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool is_hidden = cloud_.hidden[i] != 0;
      keyed_[i] = {is_hidden ? std::uint64_t{1} << 63 : cube_.key<D>(cloud_.position, i),
                   static_cast<std::uint32_t>(i)};
    }
  }

  void sort(const Workers& workers, std::vector<std::uint32_t>& order) {
    keyed_.resize(cloud_.count);
    workers.for_ranges(cloud_.count, [this](std::size_t begin, std::size_t end, int) {
      axes() == 3 ? find_keys<3>(begin, end) : find_keys<2>(begin, end);
    });
    sorter_.sort(keyed_, workers);
    order.resize(cloud_.count);
    for (std::size_t i = 0; i < cloud_.count; ++i) order[i] = keyed_[i].slot;
    seen_ = static_cast<std::uint32_t>(cloud_.count);
    while (seen_ > 0 && keyed_[seen_ - 1].key >> 63 != 0) --seen_;
  }

  // The cloud's own places are moved by whoever asked for the order.
  void line_up(const Workers& workers) {
    for (std::size_t axis = 0; axis < axes(); ++axis) line_[axis].resize(seen_);
    workers.for_ranges(seen_, [this](std::size_t begin, std::size_t end, int) {
      for (std::size_t axis = 0; axis < axes(); ++axis) {
        for (std::size_t i = begin; i < end; ++i) line_[axis][i] = cloud_.position[axis][keyed_[i].slot];
      }
    });
  }

  // Boids [begin, end) are in one cell, `below` halvings above the finest. Halvings that part nobody make no
  // node, and do not count as depth.
  void divide(std::uint32_t begin, std::uint32_t end, int below, int depth) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({{}, {}, begin, 0});
    cell_levels_.push_back(static_cast<std::uint8_t>(cube_.levels - below));
    const std::uint64_t differing = keyed_[begin].key ^ keyed_[end - 1].key;
    if (end - begin > leaf_size_ && depth < depth_limit_ && differing != 0) {
      const int parted = (std::bit_width(differing) - 1) / cloud_.dimensions;
      while (begin < end) {
        const std::uint32_t child_end = end_of_cell(begin, end, parted * cloud_.dimensions);
        divide(begin, child_end, parted, depth + 1);
        begin = child_end;
      }
    }
    nodes_[at].next = static_cast<std::uint32_t>(nodes_.size());
  }

  std::uint32_t end_of_cell(std::uint32_t begin, std::uint32_t end, int shift) const {
    const std::uint64_t cell = keyed_[begin].key >> shift;
    const auto first = keyed_.begin() + begin;
    const auto found = std::partition_point(first, keyed_.begin() + end,
                                            [=](const Keyed& one) { return one.key >> shift == cell; });
    return begin + static_cast<std::uint32_t>(found - first);
  }

  void fit_boxes(const Workers& workers) {
    workers.for_ranges(node_count(), [this](std::size_t begin, std::size_t end, int) {
      for (std::size_t at = begin; at < end; ++at) {
        if (is_leaf(at)) fit_leaf(nodes_[at]);
      }
    });
    for (std::size_t at = node_count(); at-- > 0;) {
      if (!is_leaf(at)) fit_around_children(at);
    }
  }

  void fit_leaf(Node& node) const {
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const auto first = line_[axis].begin() + node.begin;
      float low = *first;
      float high = *first;
      for (auto at = first; at != line_[axis].begin() + end_of(node); ++at) {
        low = std::min(low, *at);
        high = std::max(high, *at);
      }
      node.low[axis] = low;
      node.high[axis] = high;
    }
  }

  void fit_around_children(std::size_t at) {
    Node& node = nodes_[at];
    node.low = nodes_[at + 1].low;
    node.high = nodes_[at + 1].high;
    for (std::size_t child = nodes_[at + 1].next; child < node.next; child = nodes_[child].next) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low[axis] = std::min(node.low[axis], nodes_[child].low[axis]);
        node.high[axis] = std::max(node.high[axis], nodes_[child].high[axis]);
      }
    }
  }

  // The midpoint-halved cell of a node, as far as it lies within the bounds; with the strays that count as on
  // its border.
  IndexBox cell_of(std::size_t at) const {
    const Node& node = nodes_[at];
    const double size = std::ldexp(cube_.side, -int{cell_levels_[at]});
    IndexBox box;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      double min = cube_.min[axis];
      for (int level = 1; level <= cell_levels_[at]; ++level) {
        const int bit = (cube_.levels - level) * cloud_.dimensions + static_cast<int>(axis);
        if ((keyed_[node.begin].key >> bit & 1) != 0) min += std::ldexp(cube_.side, -level);
      }
      const double max = std::min(min + size, high_[axis]);
      box.min[axis] = std::min(static_cast<float>(min), node.low[axis]);
      box.max[axis] = std::max(static_cast<float>(max), node.high[axis]);
    }
    return box;
  }

  double size_of_space(std::size_t axis) const { return double{cloud_.max[axis]} - double{cloud_.min[axis]}; }

  bool is_near_over_the_seam(const std::array<float, 3>& low, const std::array<float, 3>& high,
                             double reach) const {
    const Node& all = nodes_.front();
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const double size = size_of_space(axis);
      if (low[axis] - reach <= all.high[axis] - size || high[axis] + reach >= all.low[axis] + size)
        return true;
    }
    return false;
  }

  // How far a node is from a box on one axis, at least; by the nearest image where the space wraps. Without
  // images float will do: rounding never swaps two differences, so no boid is nearer than its node.
  template <bool wraps, class Number>
  Number gap(const Node& node, Number low, Number high, std::size_t axis) const {
    const Number least = node.low[axis] - high;
    const Number most = low - node.high[axis];
    Number gap = std::max({least, most, Number{0}});
    if constexpr (wraps) {
      const double size = size_of_space(axis);
      gap = std::min(
          {gap, std::max({least + size, most - size, 0.0}), std::max({least - size, most + size, 0.0})});
    }
    return gap;
  }

  template <int D, bool wraps>
  void walk(const std::array<float, 3>& low, const std::array<float, 3>& high, double reach,
            std::vector<Span>& spans) const {
    using Number = std::conditional_t<wraps, double, float>;
    const auto reach_squared = static_cast<Number>(reach * reach);
    for (std::size_t at = 0; at < node_count();) {
      const Node& node = nodes_[at];
      Number near{};
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Number one = gap<wraps, Number>(node, low[axis], high[axis], axis);
        near += one * one;
      }
      const bool is_far = near > reach_squared;
      if (!is_far && !is_leaf(at) && !is_within<D>(node, low, high, reach)) {
        ++at;
        continue;
      }
      if (!is_far) add({node.begin, end_of(node)}, spans);
      at = node.next;
    }
  }

  // Whether all below a node is near, so that there is nothing to leave out.
  template <int D>
  static bool is_within(const Node& node, const std::array<float, 3>& low, const std::array<float, 3>& high,
                        double reach) {
    double far = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const double one =
          std::max({double{low[axis]} - node.low[axis], double{node.high[axis]} - high[axis], 0.0});
      far += one * one;
    }
    return far <= reach * reach;
  }

  static void add(Span span, std::vector<Span>& spans) {
    if (!spans.empty() && spans.back().end == span.begin) {
      spans.back().end = span.end;
    } else {
      spans.push_back(span);
    }
  }

  std::uint32_t leaf_size_;
  int depth_limit_;
  Cloud cloud_;
  double reach_ = 0;
  std::array<double, 3> low_{}, high_{};  ///< bounds of the cube that cells are cut from
  KeyCube cube_;
  std::uint32_t seen_ = 0;  ///< boids that are not hidden
  std::vector<float> sample_;
  std::vector<Keyed> keyed_;
  KeySort sorter_;
  Line line_;
  std::vector<Node> nodes_;  ///< and one after the last
  std::vector<std::uint8_t> cell_levels_;
  BatchCutter cutter_;
};

}  // namespace

std::unique_ptr<NeighbourIndex> make_tree(std::int64_t leaf_size, std::int64_t depth_limit) {
  return std::make_unique<Tree>(leaf_size, depth_limit);
}

}  // namespace sturnus
