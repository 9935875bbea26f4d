// Yardstick: all pairs over an array of structs, the first thing that anybody writes.
#include <algorithm>

#include "rules.h"
#include "yardstick.h"

namespace bench {
namespace {

// The squared distance, in a wrapped space to the nearest image, by comparison; most pairs need no more. Of
// five spellings this one was the fastest: with branches for the image, all pairs take six times as long.
template <int D, Course course>
float distance_squared(const Numbers& numbers, const Vector<D>& from, const Vector<D>& to) {
  float sum = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    float gap = std::fabs(to[axis] - from[axis]);
    if constexpr (course == Course::wrapped) gap = std::min(gap, numbers.size[axis] - gap);
    sum += gap * gap;
  }
  return sum;
}

template <int D, Course course>
class Naive : public Yardstick {
 public:
  Naive(const Numbers& numbers, const Flock& start)
      : numbers_(numbers), boids_(boids_of<D>(start)), next_(boids_) {}

  void step() override {
    const Numbers numbers = numbers_;  // so that the compiler sees that nothing changes them
    const float reach_squared = numbers.radius * numbers.radius;
    for (std::size_t i = 0; i < boids_.size(); ++i) {
      const Boid<D> me = boids_[i];
      Sums<D> sums;
      for (std::size_t j = 0; j < boids_.size(); ++j) {
        if (j == i) continue;
        if (distance_squared<D, course>(numbers, me.position, boids_[j].position) >= reach_squared) continue;
        const auto offset = offset_between<D, course>(numbers, me.position, boids_[j].position);
        add_neighbour<D, course>(numbers, me.velocity, offset, boids_[j].velocity, sums);
      }
      next_[i] = moved<D, course>(numbers, me, sums);
    }
    boids_.swap(next_);
  }

  Flock flock() const override { return flock_of<D>(boids_); }

 private:
  Numbers numbers_;
  std::vector<Boid<D>> boids_, next_;
};

}  // namespace

std::unique_ptr<Yardstick> make_naive(const Numbers& numbers, const Flock& start) {
  if (numbers.course == Course::sighted) return std::make_unique<Naive<2, Course::sighted>>(numbers, start);
  if (numbers.dimensions == 3) return std::make_unique<Naive<3, Course::wrapped>>(numbers, start);
  return std::make_unique<Naive<2, Course::wrapped>>(numbers, start);
}

}  // namespace bench
