// Quadtree in 2D, octree in 3D: nodes are halved at their midpoint until a leaf holds few boids or lies deep
// enough (boids at one point would divide for ever). Rebuilt each step, kept in flat arrays.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "neighbours/index.h"

namespace sturnus {
namespace {

struct Node {
  std::array<double, 3> min{}, max{};
  std::uint32_t begin = 0, end = 0;  ///< its boids, in the order
  std::uint32_t first_child = 0;     ///< children lie together; 0 for a leaf
};

class Tree : public NeighbourIndex {
 public:
  Tree(std::int64_t leaf_size, std::int64_t depth_limit)
      : leaf_size_(static_cast<std::uint32_t>(leaf_size)), depth_limit_(static_cast<int>(depth_limit)) {}

  void build(const Cloud& cloud, float, const Workers&, std::vector<std::uint32_t>& order) override {
    cloud_ = cloud;
    order.resize(cloud.count);
    std::iota(order.begin(), order.end(), 0u);
    const auto seen = std::stable_partition(order.begin(), order.end(),
                                            [&](std::uint32_t i) { return cloud.hidden[i] == 0; });
    nodes_.assign(1, root(static_cast<std::uint32_t>(seen - order.begin())));
    leaves_.clear();
    divide(0, 0, order);
  }

  void spans(const std::array<float, 3>& from, const std::array<float, 3>& to, float reach,
             std::vector<Span>& spans) const override {
    spans.clear();
    const double far = padded_reach(cloud_, reach);
    visit(0, from, to, far * far, spans);
  }

  void batches(std::vector<Span>& batches) const override {
    batches.clear();
    for (const Span leaf : leaves_) cut(leaf.begin, leaf.end, batches);
  }

  void boxes(std::vector<IndexBox>& boxes) const override {
    boxes.clear();
    for (const Node& node : nodes_) {
      if (node.first_child != 0 || node.begin == node.end) continue;
      IndexBox box;
      for (std::size_t axis = 0; axis < axes(); ++axis) {
        box.min[axis] = static_cast<float>(node.min[axis]);
        box.max[axis] = static_cast<float>(node.max[axis]);
      }
      boxes.push_back(box);
    }
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(cloud_.dimensions); }

  // The space, made larger where boids are outside it.
  Node root(std::uint32_t count) const {
    Node node;
    node.end = count;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      node.min[axis] = cloud_.min[axis];
      node.max[axis] = cloud_.max[axis];
      for (std::size_t i = 0; i < cloud_.count; ++i) {
        if (cloud_.hidden[i] != 0) continue;
        node.min[axis] = std::min(node.min[axis], double{cloud_.position[axis][i]});
        node.max[axis] = std::max(node.max[axis], double{cloud_.position[axis][i]});
      }
    }
    return node;
  }

  static double middle(const Node& node, std::size_t axis) { return (node.min[axis] + node.max[axis]) * 0.5; }

  unsigned child_of(const Node& node, std::uint32_t i) const {
    unsigned child = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      if (cloud_.position[axis][i] >= middle(node, axis)) child |= 1u << axis;
    }
    return child;
  }

  void divide(std::uint32_t at, int depth, std::vector<std::uint32_t>& order) {
    const Node node = nodes_[at];
    if (node.end - node.begin <= leaf_size_ || depth >= depth_limit_) {
      if (node.begin < node.end) leaves_.push_back({node.begin, node.end});
      return;
    }
    const unsigned children = 1u << axes();
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[at].first_child = first;
    std::uint32_t begin = node.begin;
    for (unsigned child = 0; child < children; ++child) {
      const auto from = order.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto to = order.begin() + static_cast<std::ptrdiff_t>(node.end);
      const auto end =
          std::stable_partition(from, to, [&](std::uint32_t i) { return child_of(node, i) == child; });
      nodes_.push_back(child_node(node, child, begin, static_cast<std::uint32_t>(end - order.begin())));
      begin = nodes_.back().end;
    }
    for (unsigned child = 0; child < children; ++child) divide(first + child, depth + 1, order);
  }

  Node child_node(const Node& parent, unsigned child, std::uint32_t begin, std::uint32_t end) const {
    Node node = parent;
    node.begin = begin;
    node.end = end;
    node.first_child = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      ((child >> axis & 1u) != 0 ? node.min : node.max)[axis] = middle(parent, axis);
    }
    return node;
  }

  // From a box to the nearest point of the node, over the seam of a wrapped space where that is shorter.
  double distance_squared(const Node& node, const std::array<float, 3>& from,
                          const std::array<float, 3>& to) const {
    double sum = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const double low = from[axis];
      const double high = to[axis];
      double gap = std::max({node.min[axis] - high, low - node.max[axis], 0.0});
      if (cloud_.wraps && gap > 0) {
        const double size = double{cloud_.max[axis]} - double{cloud_.min[axis]};
        gap = std::min({gap, std::abs(node.min[axis] + size - high), std::abs(low + size - node.max[axis])});
      }
      sum += gap * gap;
    }
    return sum;
  }

  void visit(std::uint32_t at, const std::array<float, 3>& from, const std::array<float, 3>& to, double reach_squared,
             std::vector<Span>& spans) const {
    const Node& node = nodes_[at];
    if (node.begin == node.end || distance_squared(node, from, to) > reach_squared) return;
    if (node.first_child == 0) {
      if (!spans.empty() && spans.back().end == node.begin) {
        spans.back().end = node.end;
      } else {
        spans.push_back({node.begin, node.end});
      }
      return;
    }
    for (unsigned child = 0; child < 1u << axes(); ++child) visit(node.first_child + child, from, to, reach_squared, spans);
  }

  std::uint32_t leaf_size_;
  int depth_limit_;
  Cloud cloud_;
  std::vector<Node> nodes_;
  std::vector<Span> leaves_;
};

}  // namespace

std::unique_ptr<NeighbourIndex> make_tree(std::int64_t leaf_size, std::int64_t depth_limit) {
  return std::make_unique<Tree>(leaf_size, depth_limit);
}

}  // namespace sturnus
