// The sums over neighbours: the one place where boids meet.
#pragma once

#include <span>

#include "neighbours/index.h"
#include "neighbours/offset.h"

namespace sturnus {

/// Some boids that stand one after the other.
struct Stretch {
  std::uint64_t flocks = 0;  ///< a bit for every flock that has somebody visible here
  std::uint64_t next = 0;    ///< number of the next stretch with other flocks
};

/// Boids as the kernel sees them; pointers are to `count` values, null where unused.
struct Boids {
  std::size_t count = 0;
  std::array<const float*, 3> position{};
  std::array<const float*, 3> velocity{};
  std::array<const float*, 3> heading{};
  std::array<const float*, 3> colour{};
  const std::uint64_t* id = nullptr;  ///< global: a boid is its own neighbour by id, not by place
  const std::uint8_t* flock = nullptr;
  const std::uint8_t* hidden = nullptr;  ///< 1: a boid that nobody may see; null where nobody is hidden
  std::uint64_t flocks = 0;              ///< a bit for every flock that a boid may belong to
  const Stretch* stretches = nullptr;    ///< of `batch_size` boids each; null: nobody has looked

  bool is_hidden(std::size_t i) const { return hidden != nullptr && hidden[i] != 0; }
  /// 1 << flock, or 0 for a boid that nobody may see.
  std::uint64_t flock_bit(std::size_t i) const { return is_hidden(i) ? 0 : std::uint64_t{1} << flock[i]; }
  /// All flocks that somebody visible of [begin, end) belongs to, and maybe some of those who stand beside.
  std::uint64_t flocks_in(std::size_t begin, std::size_t end) const {
    if (stretches == nullptr) return flocks;
    std::uint64_t found = 0;
    for (std::size_t i = begin / batch_size; i * batch_size < end; i = stretches[i].next)
      found |= stretches[i].flocks;
    return found;
  }
};

/// Finds which flocks are present in each stretch of the boids.
void find_stretches(const Boids& boids, const Workers& workers, std::vector<Stretch>& stretches);

/// One row's answer for one boid.
struct NeighbourSum {
  std::array<float, 3> value{};
  std::uint32_t count = 0;
};

/// The sums of a stretch of boids, in columns: what the kernels write and the rules read.
class SumBlock {
 public:
  /// Makes room for that many rows of each of the boids [begin, end); what was there is lost. Columns may be
  /// written up to a batch beyond the last boid.
  void fit(std::size_t rows, std::size_t begin, std::size_t end) {
    begin_ = begin;
    stride_ = end - begin + batch_size;
    values_.resize(rows * 3 * stride_);
    counts_.resize(rows * stride_);
  }
  /// The columns of a row from the boid's place on.
  float* value(std::size_t row, std::size_t axis, std::size_t boid) {
    return values_.data() + (row * 3 + axis) * stride_ + (boid - begin_);
  }
  std::uint32_t* count(std::size_t row, std::size_t boid) {
    return counts_.data() + row * stride_ + (boid - begin_);
  }
  void put(std::size_t row, std::size_t boid, const NeighbourSum& sum) {
    for (std::size_t axis = 0; axis < 3; ++axis) *value(row, axis, boid) = sum.value[axis];
    *count(row, boid) = sum.count;
  }
  NeighbourSum at(std::size_t row, std::size_t boid) const {
    const std::size_t i = row * 3 * stride_ + (boid - begin_);
    return {{values_[i], values_[i + stride_], values_[i + 2 * stride_]},
            counts_[row * stride_ + (boid - begin_)]};
  }
  void spoil();

 private:
  std::size_t begin_ = 0;
  std::size_t stride_ = 0;
  std::vector<float> values_;
  std::vector<std::uint32_t> counts_;
};

/// Population totals of one flock, in double.
struct Totals {
  double count = 0;
  std::array<double, 3> position{}, velocity{}, heading{}, colour{};
};

/// Adds one boid.
template <int D>
void add_boid(Totals& totals, const Boids& boids, std::size_t i);

/// What a row sums: the boids' own values and the totals of them.
struct Summed {
  const std::array<const float*, 3>& own;
  const std::array<double, 3> Totals::*total;
  std::size_t components;
};
template <int D>
Summed summed_by(const NeighbourRow& row, const Boids& boids);

/// Sums of the whole population, flock by flock. Fixed blocks in storage order, so that no thread count
/// matters; `parts` is working memory.
template <int D>
void population_totals(const Boids& boids, std::size_t flocks, const Workers& workers,
                       std::vector<Totals>& parts, std::vector<Totals>& totals);

class Passes;
struct SumPass;

/// Everything that one call needs besides the boids.
struct NeighbourQuestion {
  const Model* model = nullptr;
  const NeighbourIndex* index = nullptr;  ///< over the sources; null where no row has a finite reach
  Wrapping image;
  std::span<const Totals> totals;  ///< of each flock, where a row looks at the whole population
  std::uint64_t step = 0;          ///< for the sampling of neighbours
  const Passes* passes = nullptr;
};

/// Contributions to a sum are floats, and where a batch has few candidates so are the sums. With more, so
/// many candidates' are added in float, then folded into a double, which is rounded once; and what fades with
/// distance is added in double at once: a swarm of hundreds around a boid pushes from all sides, a near one
/// thousands of times as hard as a far one, and what is left of the push must not be the rounding of the sum.
/// Candidates count whether they turn out to be neighbours or not, so that every kernel does the same.
inline constexpr std::uint32_t few_candidates[] = {256,
                                                   512};   // in 2D and in 3D, where fewer of them are near
inline constexpr std::uint32_t few_of_a_plain_sum = 1024;  // where nothing fades
inline constexpr std::uint32_t candidates_in_float = 64;

/// A sum in the making.
struct RunningSum {
  std::array<float, 3> part{};
  std::array<double, 3> whole{};
  std::uint32_t count = 0;

  void fold() {
    for (std::size_t axis = 0; axis < 3; ++axis) whole[axis] += double{part[axis]};
    part = {};
  }
};

/// Whether the sums of a pass over so many candidates stay in float.
template <int D>
bool is_few(std::size_t candidates, const SumPass& pass);

/// How many candidates the spans hold.
inline std::size_t candidates(std::span<const Span> spans) {
  std::size_t count = 0;
  for (const Span& span : spans) count += span.end - span.begin;
  return count;
}

/// A box that holds boids.
struct Box {
  std::array<float, 3> low{}, high{};
};

/// Working memory of one thread.
struct KernelScratch {
  std::vector<Span> spans;
  std::vector<RunningSum> running;
  RingParts ring;
  std::vector<CellRun> own_runs;
  std::uint64_t pairs = 0;  ///< of a boid and a candidate, since somebody set it to 0
};

/// For the targets of each batch: every row of the target's flock, summed over its neighbours among the
/// sources. Targets and sources may be different boids: what comes from elsewhere is a source only.
/// Neighbours are added in the order of the index's spans for the batch. `sums` holds all boids of the
/// batches; those of hidden targets mean nothing.
template <int D>
void neighbour_sums(const Boids& targets, std::span<const Span> batches, const Boids& sources,
                    const NeighbourQuestion& question, KernelScratch& scratch, SumBlock& sums);

/// The plain kernel for one pass of one batch whose candidates lie in the spans: one boid, one neighbour, one
/// row at a time.
template <int D>
void sum_batch(const Boids& targets, Span batch, const Boids& sources, std::span<const Span> spans,
               const NeighbourQuestion& question, const SumPass& pass, KernelScratch& scratch,
               SumBlock& sums);

/// Whether a row of target j's flock counts source i as its neighbour, for those who need names.
template <int D>
bool is_counted(const NeighbourRow& row, const Boids& targets, std::size_t j, const Boids& sources,
                std::size_t i, const NeighbourQuestion& question);

/// The rows of a batch that look at the whole population.
template <int D>
void add_populations(const Boids& targets, Span batch, const NeighbourQuestion& question, SumBlock& sums);

}  // namespace sturnus
