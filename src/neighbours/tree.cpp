// Quadtree in 2D, octree in 3D: nodes are halved at their midpoint until a leaf holds few boids or lies deep
// enough. Built anew each step from the boids' sorted Z-order keys: a node is a stretch of them that have the
// same first bits.
#include <algorithm>
#include <cmath>

#include "neighbours/batches.h"
#include "neighbours/branches.h"
#include "neighbours/index.h"
#include "neighbours/morton.h"

namespace sturnus {
namespace {

// No cell is finer than this part of the reach: whoever is nearer is asked about together in any case.
constexpr double cells_per_reach = 256;

// Where the boids are so many times farther apart than most of them, the outermost are strays.
constexpr double most_sizes = 4096;

constexpr std::uint64_t hidden_key = std::uint64_t{1} << 63;

class Tree : public NeighbourIndex {
 public:
  Tree(std::int64_t leaf_size, std::int64_t depth_limit)
      : limits_{static_cast<std::uint32_t>(leaf_size), static_cast<int>(depth_limit)} {}

  void build(const Cloud& cloud, float reach, const Workers& workers,
             std::vector<std::uint32_t>& order) override {
    cloud_ = cloud;
    reach_ = padded_reach(cloud, reach);
    choose_cube(workers);
    sort(workers, order);
    line_up(workers);
    axes() == 3 ? grow(solid_, workers) : grow(flat_, workers);
  }

  void spans(const std::array<float, 3>& low, const std::array<float, 3>& high, float reach,
             std::vector<Span>& spans) const override {
    Near near{{low, high}, padded_reach(cloud_, reach), cloud_.wraps, {}};
    for (std::size_t axis = 0; axis < 3; ++axis) near.size[axis] = cloud_.max[axis] - cloud_.min[axis];
    spans.clear();
    axes() == 3 ? solid_.walk(near, spans) : flat_.walk(near, spans);
  }

  void batches(std::vector<Span>& batches) const override { batches = cutter_.batches(); }

  void boxes(std::vector<IndexBox>& boxes) const override {
    boxes.clear();
    const auto add = [&](const Leaf& leaf) { boxes.push_back(cell_of(leaf)); };
    axes() == 3 ? solid_.for_leaves(add) : flat_.for_leaves(add);
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(cloud_.dimensions); }

  // The space, made larger where boids are outside.
  void find_bounds(const Workers& workers) {
    parts_.assign(static_cast<std::size_t>(workers.count()), {cloud_.min, cloud_.max});
    workers.for_ranges(cloud_.count, [this](std::size_t begin, std::size_t end, int part) {
      for (std::size_t axis = 0; axis < axes(); ++axis)
        widen(axis, begin, end, parts_[static_cast<std::size_t>(part)]);
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = cloud_.min[axis];
      high_[axis] = cloud_.max[axis];
      for (const IndexBox& part : parts_) {
        low_[axis] = std::min(low_[axis], double{part.min[axis]});
        high_[axis] = std::max(high_[axis], double{part.max[axis]});
      }
    }
  }

  void widen(std::size_t axis, std::size_t begin, std::size_t end, IndexBox& box) const {
    float low = box.min[axis];
    float high = box.max[axis];
    for (std::size_t i = begin; i < end; ++i) {
      const float at = cloud_.hidden[i] != 0 ? low : cloud_.position[axis][i];
      low = at < low ? at : low;
      high = at > high ? at : high;
    }
    box.min[axis] = low;
    box.max[axis] = high;
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

  void choose_cube(const Workers& workers) {
    find_bounds(workers);
    if (longest_side() > most_sizes * reach_) leave_out_strays();
    const double side = longest_side() > 0 ? longest_side() : 1;
    const double cells = side * (cells_per_reach / reach_);
    const int most = axes() == 3 ? most_levels<3> : most_levels<2>;
    int levels = 0;
    while (levels < most && std::ldexp(1.0, levels) < cells) ++levels;
    cube_ = {low_, side, levels};
  }

  // Hidden boids come last, by a bit above all others; their places may be anything.
  template <int D>
  void find_keys(std::size_t begin, std::size_t end) {
    cube_.for_keys<D>(cloud_.position, begin, end, [this](std::size_t i, std::uint64_t key) {
      keyed_[i] = {cloud_.hidden[i] != 0 ? hidden_key : key, static_cast<std::uint32_t>(i)};
    });
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
    while (seen_ > 0 && keyed_[seen_ - 1].key == hidden_key) --seen_;
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

  template <int D>
  void grow(Branches<D>& branches, const Workers& workers) {
    branches.build({keyed_.data(), &line_, seen_}, cube_.levels, limits_, workers);
    room_.resize(seen_);
    branches.for_leaves([this](const Leaf& leaf) {
      const double side = std::min(std::ldexp(cube_.side, -leaf.level) / reach_, 1e9);
      const double room = (D == 3 ? side : 1) * side * side / (leaf.boids.end - leaf.boids.begin);
      std::fill(room_.begin() + leaf.boids.begin, room_.begin() + leaf.boids.end, static_cast<float>(room));
    });
    cutter_.cut({D, &line_, seen_, reach_, room_.data()}, workers);
  }

  // The midpoint-halved cell of a leaf, as far as it lies within the bounds; with the strays that count as on
  // its border.
  IndexBox cell_of(const Leaf& leaf) const {
    IndexBox box;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      double min = cube_.min[axis];
      for (int level = 1; level <= leaf.level; ++level) {
        const int bit = (cube_.levels - level) * cloud_.dimensions + static_cast<int>(axis);
        if ((keyed_[leaf.boids.begin].key >> bit & 1) != 0) min += std::ldexp(cube_.side, -level);
      }
      const double max = std::min(min + std::ldexp(cube_.side, -leaf.level), high_[axis]);
      box.min[axis] = std::min(static_cast<float>(min), leaf.box.min[axis]);
      box.max[axis] = std::max(static_cast<float>(max), leaf.box.max[axis]);
    }
    return box;
  }

  Limits limits_;
  Cloud cloud_;
  double reach_ = 0;
  std::array<double, 3> low_{}, high_{};  ///< bounds of the cube that cells are cut from
  KeyCube cube_;
  std::uint32_t seen_ = 0;       ///< boids that are not hidden
  std::vector<IndexBox> parts_;  ///< bounds of each thread's boids
  std::vector<float> sample_;
  std::vector<Keyed> keyed_;
  KeySort sorter_;
  Line line_;
  Branches<2> flat_;
  Branches<3> solid_;
  std::vector<float> room_;  ///< the share of space of each boid, in boxes of the reach
  BatchCutter cutter_;
};

}  // namespace

std::unique_ptr<NeighbourIndex> make_tree(std::int64_t leaf_size, std::int64_t depth_limit) {
  return std::make_unique<Tree>(leaf_size, depth_limit);
}

}  // namespace sturnus
