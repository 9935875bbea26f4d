// Yardstick: the radius search of nanoflann, whose k-d tree is built anew in each step over points that stand
// in order of cells. Neighbours are summed as they are found, which spares the list of results.
#include <nanoflann.hpp>

#include "cells.h"
#include "rules.h"
#include "seam.h"
#include "yardstick.h"

namespace bench {
namespace {

// What the k-d tree asks of its points.
template <int D>
struct Points {
  const std::vector<Boid<D>>& boids;

  std::size_t kdtree_get_point_count() const { return boids.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return boids[i].position[axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// Takes what a search finds.
template <int D>
class Summing {
 public:
  Summing(const Numbers& numbers, const std::vector<Boid<D>>& boids, std::uint32_t self)
      : numbers_(numbers), boids_(boids), self_(self), radius_squared_(numbers.radius * numbers.radius) {}

  void look_from(const Vector<D>& place) { from_ = place; }
  const Sums<D>& sums() const { return sums_; }

  bool addPoint(float, std::uint32_t j) {
    if (j == self_) return true;
    Vector<D> offset;
    for (std::size_t axis = 0; axis < D; ++axis) offset[axis] = boids_[j].position[axis] - from_[axis];
    add_neighbour<D, Course::wrapped>(numbers_, boids_[self_].velocity, offset, boids_[j].velocity, sums_);
    return true;
  }
  float worstDist() const { return radius_squared_; }
  bool full() const { return true; }
  std::size_t size() const { return static_cast<std::size_t>(sums_.neighbours); }

 private:
  const Numbers& numbers_;
  const std::vector<Boid<D>>& boids_;
  std::uint32_t self_;
  float radius_squared_;
  Vector<D> from_{};
  Sums<D> sums_;
};

template <int D>
class Nanoflann : public Yardstick {
 public:
  Nanoflann(const Numbers& numbers, const Flock& start)
      : numbers_(numbers),
        cells_(numbers),
        boids_(boids_of<D>(start)),
        next_(boids_),
        rank_(start.size()),
        spare_(rank_) {
    for (std::size_t i = 0; i < rank_.size(); ++i) rank_[i] = static_cast<std::uint32_t>(i);
  }

  void step() override {
    sort();
    const Points<D> points{boids_};
    const Tree tree(D, points, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size));
    for (std::size_t i = 0; i < boids_.size(); ++i) {
      next_[i] = moved<D, Course::wrapped>(numbers_, boids_[i], sums_of(tree, i));
    }
    boids_.swap(next_);
  }

  Flock flock() const override {
    Flock out = empty_flock<D>(boids_.size());
    for (std::size_t i = 0; i < boids_.size(); ++i) put<D>(out, rank_[i], boids_[i]);
    return out;
  }

 private:
  using Metric = nanoflann::L2_Simple_Adaptor<float, Points<D>, float, std::uint32_t>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Points<D>, D, std::uint32_t>;
  static constexpr std::size_t leaf_size = 16;

  void sort() {
    const auto& target = cells_.order(boids_.size(), [&](std::size_t i) { return boids_[i].position; });
    for (std::size_t i = 0; i < target.size(); ++i) {
      next_[target[i]] = boids_[i];
      spare_[target[i]] = rank_[i];
    }
    boids_.swap(next_);
    rank_.swap(spare_);
  }

  Sums<D> sums_of(const Tree& tree, std::size_t i) const {
    Summing<D> summing(numbers_, boids_, static_cast<std::uint32_t>(i));
    for_images<D>(numbers_, boids_[i].position, [&](const Vector<D>& place) {
      summing.look_from(place);
      tree.radiusSearchCustomCallback(place.data(), summing, nanoflann::SearchParams(32, 0, false));
    });
    return summing.sums();
  }

  Numbers numbers_;
  Cells<D> cells_;
  std::vector<Boid<D>> boids_, next_;
  std::vector<std::uint32_t> rank_, spare_;  // of the ids, by slot
};

}  // namespace

std::unique_ptr<Yardstick> make_nanoflann(const Numbers& numbers, const Flock& start) {
  if (numbers.dimensions == 3) return std::make_unique<Nanoflann<3>>(numbers, start);
  return std::make_unique<Nanoflann<2>>(numbers, start);
}

}  // namespace bench
