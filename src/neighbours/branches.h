// The nodes of a quadtree or octree over boids that are sorted by Z-order keys, and the walk through them.
#pragma once

#include <array>
#include <vector>

#include "neighbours/index.h"
#include "neighbours/morton.h"

namespace sturnus {

/// Places of boids in the order in which they stand; the third is empty in 2D.
using Line = std::array<std::vector<float>, 3>;

/// Boids in their order, with their keys.
struct SortedBoids {
  const Keyed* keyed = nullptr;
  const Line* line = nullptr;
  std::uint32_t count = 0;
};

/// When a node is not divided further. Boids in one cell of the finest that keys know are not divided either.
struct Limits {
  std::uint32_t leaf_size = 1;
  int depth = 0;
};

/// Boids of one leaf, the box of their places, and how often the cube was halved on the way to their cell.
struct Leaf {
  Span boids{};
  IndexBox box;
  int level = 0;
};

/// What a walk looks for: boids within `reach` of a box; by the nearest image where the space wraps.
struct Near {
  IndexBox box;
  double reach = 0;
  bool wraps = false;
  std::array<float, 3> size{};  ///< of a space that wraps
};

/// The children of one node, side by side, so that all of them are tested at once.
template <int D>
struct Branch {
  static constexpr std::size_t most = std::size_t{1} << D;
  float low[D][most], high[D][most];  ///< boxes of the children's boids, not their cells
  std::uint32_t begin[most + 1];      ///< first boid of each child, and the end of the last
  std::uint32_t below[most];          ///< the branch of each child; 0 for a leaf
  std::uint8_t level[most];
  std::uint32_t count;  ///< children; a cell without boids is none
};

/// The tree of one cloud. Keeps its memory for the next.
template <int D>
class Branches {
 public:
  void build(const SortedBoids& boids, int levels, const Limits& limits, const Workers& workers);

  /// Adds the spans of all who may be near, in their order.
  void walk(const Near& near, std::vector<Span>& spans) const;

  /// Calls f(Leaf) for each leaf; those of one node in their order.
  template <class F>
  void for_leaves(F&& f) const {
    for (const Branch<D>& branch : branches_) {
      for (std::size_t child = 0; child < branch.count; ++child) {
        if (branch.below[child] == 0) f(leaf(branch, child));
      }
    }
  }

 private:
  static Leaf leaf(const Branch<D>& branch, std::size_t child) {
    return {{branch.begin[child], branch.begin[child + 1]}, box_of(branch, child), branch.level[child]};
  }
  static IndexBox box_of(const Branch<D>& branch, std::size_t child) {
    IndexBox box;
    for (std::size_t axis = 0; axis < D; ++axis) {
      box.min[axis] = branch.low[axis][child];
      box.max[axis] = branch.high[axis][child];
    }
    return box;
  }

  void divide(std::size_t at, std::uint32_t begin, std::uint32_t end, int depth);
  bool is_divided(std::uint32_t begin, std::uint32_t end, int depth) const;
  void add_child(Branch<D>& branch, std::uint32_t end, int below) const;
  std::uint32_t end_of_cell(std::uint32_t begin, std::uint32_t end, int below) const;
  void fit_leaves(Branch<D>& branch) const;
  void fit_around_children(Branch<D>& branch) const;
  static IndexBox box_around(const Branch<D>& branch);
  std::array<float, D> turns_of(const Near& near) const;
  static unsigned near_children(const Branch<D>& branch, const Near& near, const std::array<float, D>& turns);

  SortedBoids boids_;
  int levels_ = 0;
  Limits limits_;
  std::vector<Branch<D>> branches_;
  IndexBox box_;  ///< of all boids
};

}  // namespace sturnus
