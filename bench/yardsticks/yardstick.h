// What every yardstick is: another program's way to make the same step, on the same flock.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace bench {

/// The rules that are computed. `wrapped`: scenarios bench-2d and bench-3d, separation 1/d, a wrapped space.
/// `sighted`: scenario quadtree without its noise, separation d, a view to either side, a turn at the
/// margins.
enum class Course { wrapped, sighted };

/// The numbers of the rules, as float32 like the engine's.
struct Numbers {
  Course course = Course::wrapped;
  int dimensions = 2;
  std::array<float, 3> min{}, max{}, size{};          ///< length; the space
  float radius = 0;                                   ///< length; of alignment and cohesion
  float separation_radius = 0;                        ///< length
  float separation = 0, alignment = 0, cohesion = 0;  ///< weights
  float max_acceleration = 0;                         ///< length per time squared
  float min_speed = 0, max_speed = 0;                 ///< length per time
  float dt = 1;                                       ///< time
  float cos_half_view = -1;                           ///< sighted only
  float margin = 0, turn = 0;                         ///< sighted only: length, length per time squared
};

/// Boids by rank of id, the order in which flocks are compared. In two dimensions the third column is empty.
struct Flock {
  std::array<std::vector<float>, 3> position, velocity;
  std::size_t size() const { return position[0].size(); }
};

class Yardstick {
 public:
  virtual ~Yardstick() = default;
  /// One whole step: index, neighbours, rules, limits, motion, edge.
  virtual void step() = 0;
  /// The flock as it stands, in the order in which it was given.
  virtual Flock flock() const = 0;
};

/// All pairs over an array of structs.
std::unique_ptr<Yardstick> make_naive(const Numbers& numbers, const Flock& start);
/// A quadtree or octree of nodes on the heap, built anew in each step, as students write it.
std::unique_ptr<Yardstick> make_pointer_tree(const Numbers& numbers, const Flock& start);
/// A scalar loop over a cell grid sorted by counting. Course `wrapped` only.
std::unique_ptr<Yardstick> make_scalar_grid(const Numbers& numbers, const Flock& start);
/// nanoflann's k-d tree over points kept in order of cells, built anew in each step. Course `wrapped` only.
std::unique_ptr<Yardstick> make_nanoflann(const Numbers& numbers, const Flock& start);

}  // namespace bench
