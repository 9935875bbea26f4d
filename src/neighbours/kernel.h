// The sums over neighbours: the one place where boids meet.
#pragma once

#include <span>

#include "neighbours/index.h"
#include "neighbours/offset.h"

namespace sturnus {

/// Boids as the kernel sees them; pointers are to `count` values, null where unused.
struct Boids {
  std::size_t count = 0;
  std::array<const float*, 3> position{};
  std::array<const float*, 3> velocity{};
  std::array<const float*, 3> heading{};
  std::array<const float*, 3> colour{};
  const std::uint64_t* id = nullptr;  ///< global: a boid is its own neighbour by id, not by place
  const std::uint8_t* flock = nullptr;
  const std::uint64_t* flock_bit = nullptr;  ///< 1 << flock, or 0 for a boid that nobody may see
};

/// One row's answer for one boid.
struct NeighbourSum {
  std::array<float, 3> value{};
  std::uint32_t count = 0;
};

/// Population totals of one flock, in double.
struct Totals {
  double count = 0;
  std::array<double, 3> position{}, velocity{}, heading{}, colour{};
};

/// Sums of the whole population, flock by flock. Fixed blocks in storage order, so that no thread count
/// matters.
template <int D>
void population_totals(const Boids& boids, std::size_t flocks, const Workers& workers,
                       std::vector<Totals>& totals);

/// Everything that one call needs besides the boids.
struct NeighbourQuestion {
  const Model* model = nullptr;
  const NeighbourIndex* index = nullptr;  ///< over the sources; null where no row has a finite reach
  Image image;
  std::span<const Totals> totals;  ///< of each flock, where a row looks at the whole population
  std::uint64_t step = 0;          ///< for the sampling of neighbours
};

/// For targets [begin, end): every row of the target's flock, summed over its neighbours among the sources,
/// into sums[target * most_rows + row]. Targets and sources may be different boids: what comes from elsewhere
/// is a source only. Neighbours are added in the order of the index's spans.
template <int D>
void neighbour_sums(const Boids& targets, std::size_t begin, std::size_t end, const Boids& sources,
                    const NeighbourQuestion& question, std::span<NeighbourSum> sums);

}  // namespace sturnus
