// Builds the branches from sorted keys: a node is a stretch of boids whose keys have the same first bits.
#include "neighbours/branches.h"

#include <algorithm>
#include <bit>

namespace sturnus {
namespace {

constexpr float nowhere = FlockModel::infinity_f;

// The box that holds nobody, and is far from everybody.
template <int D>
void clear_box(Branch<D>& branch, std::size_t child) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    branch.low[axis][child] = nowhere;
    branch.high[axis][child] = -nowhere;
  }
}

void add(Span span, std::vector<Span>& spans) {
  if (!spans.empty() && spans.back().end == span.begin) {
    spans.back().end = span.end;
  } else {
    spans.push_back(span);
  }
}

// How far two stretches of an axis are apart: by how much one begins after the other's end. No std::max here,
// nor branches: the compiler then keeps all children in one register.
float gap(float after, float before) {
  const float more = after > before ? after : before;
  return more > 0 ? more : 0.0f;
}

// The same by the nearest image, where a turn of the space is not 0.
float gap(float after, float before, float turn) {
  const float here = gap(after, before);
  const float up = gap(after + turn, before - turn);
  const float down = gap(after - turn, before + turn);
  const float image = up < down ? up : down;
  return here < image ? here : image;
}

// Whether all boids of a child are near, so that there is nobody below it to leave out.
template <int D>
bool is_all_near(const Branch<D>& branch, std::size_t child, const Near& near) {
  float far = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float one = std::max(
        {near.box.min[axis] - branch.low[axis][child], branch.high[axis][child] - near.box.max[axis], 0.0f});
    far += one * one;
  }
  return far <= static_cast<float>(near.reach * near.reach);
}

}  // namespace

template <int D>
void Branches<D>::build(const SortedBoids& boids, int levels, const Limits& limits, const Workers& workers) {
  boids_ = boids;
  levels_ = levels;
  limits_ = limits;
  branches_.resize(1);
  divide(0, 0, boids.count, 0);
  workers.for_ranges(branches_.size(), [this](std::size_t begin, std::size_t end, int) {
    for (std::size_t at = begin; at < end; ++at) fit_leaves(branches_[at]);
  });
  for (std::size_t at = branches_.size(); at-- > 0;) fit_around_children(branches_[at]);
  box_ = box_around(branches_.front());
}

// Boids [begin, end) become the children of the branch `at`, or its only child where they are not divided.
// A halving that parts nobody makes no branch, and does not count as depth.
template <int D>
void Branches<D>::divide(std::size_t at, std::uint32_t begin, std::uint32_t end, int depth) {
  branches_[at].count = 0;
  branches_[at].begin[0] = begin;
  int below = levels_;
  if (is_divided(begin, end, depth))
    below = (static_cast<int>(std::bit_width(boids_.keyed[begin].key ^ boids_.keyed[end - 1].key)) - 1) / D;
  while (begin < end) {
    const std::uint32_t child_end = end_of_cell(begin, end, below);
    add_child(branches_[at], child_end, below);
    if (is_divided(begin, child_end, depth + 1)) {
      branches_[at].below[branches_[at].count - 1] = static_cast<std::uint32_t>(branches_.size());
      branches_.emplace_back();
      divide(branches_.size() - 1, begin, child_end, depth + 1);
    }
    begin = child_end;
  }
  for (std::size_t child = branches_[at].count; child < Branch<D>::most; ++child)
    clear_box(branches_[at], child);
}

template <int D>
bool Branches<D>::is_divided(std::uint32_t begin, std::uint32_t end, int depth) const {
  return end - begin > limits_.leaf_size && depth < limits_.depth &&
         boids_.keyed[begin].key != boids_.keyed[end - 1].key;
}

template <int D>
void Branches<D>::add_child(Branch<D>& branch, std::uint32_t end, int below) const {
  branch.below[branch.count] = 0;
  branch.level[branch.count] = static_cast<std::uint8_t>(levels_ - below);
  branch.begin[++branch.count] = end;
}

// The end of the cell that the first of [begin, end) is in, `below` halvings above the finest.
template <int D>
std::uint32_t Branches<D>::end_of_cell(std::uint32_t begin, std::uint32_t end, int below) const {
  const auto cell = [=](const Keyed& one) { return one.key >> (below * D); };
  const Keyed* first = boids_.keyed + begin;
  const Keyed* found = std::partition_point(first, boids_.keyed + end,
                                            [&](const Keyed& one) { return cell(one) == cell(*first); });
  return begin + static_cast<std::uint32_t>(found - first);
}

template <int D>
void Branches<D>::fit_leaves(Branch<D>& branch) const {
  for (std::size_t child = 0; child < branch.count; ++child) {
    if (branch.below[child] != 0) continue;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::vector<float>& line = (*boids_.line)[axis];
      float low = nowhere;
      float high = -nowhere;
      for (std::size_t i = branch.begin[child]; i < branch.begin[child + 1]; ++i) {
        low = std::min(low, line[i]);
        high = std::max(high, line[i]);
      }
      branch.low[axis][child] = low;
      branch.high[axis][child] = high;
    }
  }
}

template <int D>
IndexBox Branches<D>::box_around(const Branch<D>& branch) {
  IndexBox box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.min[axis] = *std::min_element(branch.low[axis], branch.low[axis] + Branch<D>::most);
    box.max[axis] = *std::max_element(branch.high[axis], branch.high[axis] + Branch<D>::most);
  }
  return box;
}

template <int D>
void Branches<D>::fit_around_children(Branch<D>& branch) const {
  for (std::size_t child = 0; child < branch.count; ++child) {
    if (branch.below[child] == 0) continue;
    const IndexBox box = box_around(branches_[branch.below[child]]);
    for (std::size_t axis = 0; axis < D; ++axis) {
      branch.low[axis][child] = box.min[axis];
      branch.high[axis][child] = box.max[axis];
    }
  }
}

// How long a turn of a wrapped space is on each axis; 0 where nobody is near over the seam.
template <int D>
std::array<float, D> Branches<D>::turns_of(const Near& near) const {
  std::array<float, D> turns{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double size = double{near.size[axis]};
    if (near.box.min[axis] - near.reach <= box_.max[axis] - size ||
        near.box.max[axis] + near.reach >= box_.min[axis] + size)
      turns[axis] = near.size[axis];
  }
  return turns;
}

// One bit for each child that may hold somebody near. Differences are taken in float as the kernel takes
// them: rounding never swaps two, so no boid is nearer than the box around it.
template <int D>
unsigned Branches<D>::near_children(const Branch<D>& branch, const Near& near,
                                    const std::array<float, D>& turns) {
  float squared[Branch<D>::most];
  for (std::size_t child = 0; child < Branch<D>::most; ++child) {
    float sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const float one = gap(branch.low[axis][child] - near.box.max[axis],
                            near.box.min[axis] - branch.high[axis][child], turns[axis]);
      sum += one * one;
    }
    squared[child] = sum;
  }
  const auto reach_squared = static_cast<float>(near.reach * near.reach);
  unsigned found = 0;
  for (unsigned child = 0; child < Branch<D>::most; ++child)
    found |= unsigned{squared[child] <= reach_squared} << child;
  return found & ((1u << branch.count) - 1);
}

template <int D>
void Branches<D>::walk(const Near& near, std::vector<Span>& spans) const {
  struct Open {
    const Branch<D>* branch;
    unsigned left;  ///< children that are still to be looked at
  };
  const std::array<float, D> turns = near.wraps ? turns_of(near) : std::array<float, D>{};
  Open open[most_levels<D> + 1];
  open[0] = {branches_.data(), near_children(branches_.front(), near, turns)};
  for (int depth = 0; depth >= 0;) {
    if (open[depth].left == 0) {
      --depth;
      continue;
    }
    const auto child = static_cast<std::size_t>(std::countr_zero(open[depth].left));
    open[depth].left &= open[depth].left - 1;
    const Branch<D>& branch = *open[depth].branch;
    if (branch.below[child] == 0 || is_all_near(branch, child, near)) {
      add({branch.begin[child], branch.begin[child + 1]}, spans);
    } else {
      const Branch<D>& below = branches_[branch.below[child]];
      open[++depth] = {&below, near_children(below, near, turns)};
    }
  }
}

template class Branches<2>;
template class Branches<3>;

}  // namespace sturnus
