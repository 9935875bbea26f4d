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
  Wrapping image;
  std::span<const Totals> totals;  ///< of each flock, where a row looks at the whole population
  std::uint64_t step = 0;          ///< for the sampling of neighbours
};

/// Contributions to a sum are floats; so many candidates' are added in float, then folded into a double,
/// which is rounded once. Candidates count whether they turn out to be neighbours or not, so that every
/// kernel folds at the same places. What fades with distance is added in double at once: a swarm of hundreds
/// around a boid pushes from all sides, a near one thousands of times as hard as a far one, and what is left
/// of the push must not be the rounding of the sum.
inline constexpr std::uint32_t candidates_in_float = 64;

/// For the targets of each batch: every row of the target's flock, summed over its neighbours among the
/// sources, into sums[target * most_rows + row]. Targets and sources may be different boids: what comes from
/// elsewhere is a source only. Neighbours are added in the order of the index's spans for the batch.
template <int D>
void neighbour_sums(const Boids& targets, std::span<const Span> batches, const Boids& sources,
                    const NeighbourQuestion& question, std::span<NeighbourSum> sums);

/// The plain kernel for one batch whose candidates lie in the spans: one boid, one neighbour, one row at a
/// time.
template <int D>
void sum_batch(const Boids& targets, Span batch, const Boids& sources, std::span<const Span> spans,
               const NeighbourQuestion& question, std::span<NeighbourSum> sums);

/// The rows of a batch that look at the whole population.
template <int D>
void add_populations(const Boids& targets, Span batch, const NeighbourQuestion& question,
                     std::span<NeighbourSum> sums);

}  // namespace sturnus
