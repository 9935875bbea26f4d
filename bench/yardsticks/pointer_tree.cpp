// Yardstick: a quadtree or octree of nodes on the heap, built anew in each step, whose range query returns a
// vector of pointers, as in many a student's project.
#include "rules.h"
#include "seam.h"
#include "yardstick.h"

namespace bench {
namespace {

constexpr std::size_t capacity = 16;
constexpr int deepest = 24;  // many boids at one point must not divide for ever

template <int D>
struct Box {
  Vector<D> min, max;
};

template <int D>
class Node {
 public:
  Node(const Box<D>& box, int depth) : box_(box), depth_(depth) {}

  void insert(const Boid<D>* boid) {
    if (children_[0]) return child_of(*boid).insert(boid);
    boids_.push_back(boid);
    if (boids_.size() > capacity && depth_ < deepest) divide();
  }

  void query(const Vector<D>& centre, float radius, std::vector<const Boid<D>*>& found) const {
    if (!touches(centre, radius)) return;
    for (const Boid<D>* boid : boids_) {
      Vector<D> offset;
      for (std::size_t axis = 0; axis < D; ++axis) offset[axis] = boid->position[axis] - centre[axis];
      if (dot<D>(offset, offset) < radius * radius) found.push_back(boid);
    }
    if (!children_[0]) return;
    for (const auto& child : children_) child->query(centre, radius, found);
  }

 private:
  float middle(std::size_t axis) const { return (box_.min[axis] + box_.max[axis]) * 0.5f; }

  Node& child_of(const Boid<D>& boid) {
    std::size_t which = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (boid.position[axis] >= middle(axis)) which |= std::size_t{1} << axis;
    }
    return *children_[which];
  }

  void divide() {
    for (std::size_t which = 0; which < children_.size(); ++which) {
      Box<D> box = box_;
      for (std::size_t axis = 0; axis < D; ++axis) {
        ((which >> axis & 1) != 0 ? box.min : box.max)[axis] = middle(axis);
      }
      children_[which] = std::make_unique<Node>(box, depth_ + 1);
    }
    for (const Boid<D>* boid : boids_) child_of(*boid).insert(boid);
    boids_.clear();
  }

  bool touches(const Vector<D>& centre, float radius) const {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (centre[axis] + radius < box_.min[axis] || centre[axis] - radius > box_.max[axis]) return false;
    }
    return true;
  }

  Box<D> box_;
  int depth_;
  std::vector<const Boid<D>*> boids_;
  std::array<std::unique_ptr<Node>, std::size_t{1} << D> children_;
};

template <int D, Course course>
class PointerTree : public Yardstick {
 public:
  PointerTree(const Numbers& numbers, const Flock& start)
      : numbers_(numbers), boids_(boids_of<D>(start)), next_(boids_) {}

  void step() override {
    Node<D> root(box_of_boids(), 0);
    for (const Boid<D>& boid : boids_) root.insert(&boid);
    for (std::size_t i = 0; i < boids_.size(); ++i) {
      const Sums<D> sums = sums_of(boids_[i], near(root, boids_[i]));
      next_[i] = moved<D, course>(numbers_, boids_[i], sums);
    }
    boids_.swap(next_);
  }

  Flock flock() const override { return flock_of<D>(boids_); }

 private:
  Box<D> box_of_boids() const {
    Box<D> box{boids_.front().position, boids_.front().position};
    for (const Boid<D>& boid : boids_) {
      for (std::size_t axis = 0; axis < D; ++axis) {
        box.min[axis] = std::fmin(box.min[axis], boid.position[axis]);
        box.max[axis] = std::fmax(box.max[axis], boid.position[axis]);
      }
    }
    return box;
  }

  std::vector<const Boid<D>*> near(const Node<D>& root, const Boid<D>& me) const {
    std::vector<const Boid<D>*> found;
    const auto search = [&](const Vector<D>& place) { root.query(place, numbers_.radius, found); };
    if constexpr (course == Course::wrapped) {
      for_images<D>(numbers_, me.position, search);
    } else {
      search(me.position);
    }
    return found;
  }

  Sums<D> sums_of(const Boid<D>& me, const std::vector<const Boid<D>*>& others) const {
    Sums<D> sums;
    for (const Boid<D>* other : others) {
      if (other == &me) continue;
      const auto offset = offset_between<D, course>(numbers_, me.position, other->position);
      add_neighbour<D, course>(numbers_, me.velocity, offset, other->velocity, sums);
    }
    return sums;
  }

  Numbers numbers_;
  std::vector<Boid<D>> boids_, next_;
};

}  // namespace

std::unique_ptr<Yardstick> make_pointer_tree(const Numbers& numbers, const Flock& start) {
  if (numbers.course == Course::sighted) {
    return std::make_unique<PointerTree<2, Course::sighted>>(numbers, start);
  }
  if (numbers.dimensions == 3) return std::make_unique<PointerTree<3, Course::wrapped>>(numbers, start);
  return std::make_unique<PointerTree<2, Course::wrapped>>(numbers, start);
}

}  // namespace bench
