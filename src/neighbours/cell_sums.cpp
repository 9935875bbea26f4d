// Sums over whole cells.
#include "neighbours/cell_sums.h"

#include <algorithm>
#include <bit>

#include "neighbours/passes.h"

namespace sturnus {
namespace {

void add_difference(std::array<double, 3>& to, const std::array<double, 3>& before,
                    const std::array<double, 3>& after) {
  for (std::size_t axis = 0; axis < 3; ++axis) to[axis] += after[axis] - before[axis];
}

// Whether a boid stands in one of the runs.
bool is_within(std::span<const CellRun> runs, const CellLayout& layout, std::size_t boid) {
  return std::any_of(runs.begin(), runs.end(), [&](const CellRun& run) {
    return layout.begin[run.first] <= boid && boid < layout.begin[run.last];
  });
}

// The runs that hold boids of the batch.
void find_own_runs(std::span<const CellRun> runs, const CellLayout& layout, Span batch,
                   std::vector<CellRun>& own) {
  own.clear();
  for (const CellRun& run : runs) {
    if (layout.begin[run.first] < batch.end && batch.begin < layout.begin[run.last]) own.push_back(run);
  }
}

}  // namespace

template <int D>
void CellSums::build(const CellLayout& layout, const Boids& boids, std::uint64_t looked_at,
                     const Workers& workers) {
  cells_in_row_ = layout.cells_in_row;
  before_.resize(layout.rows * (cells_in_row_ + 1));
  workers.for_ranges(layout.rows, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t row = begin; row < end; ++row) build_row<D>(layout, boids, looked_at, row);
  });
}

template <int D>
void CellSums::build_row(const CellLayout& layout, const Boids& boids, std::uint64_t looked_at,
                         std::size_t row) {
  Totals sum;
  Totals* const before = before_.data() + row * (cells_in_row_ + 1);
  for (std::size_t i = 0; i < cells_in_row_; ++i) {
    before[i] = sum;
    // Who is far beyond the border would take the digits of all others.
    if (layout.has_border && (i == 0 || i + 1 == cells_in_row_)) continue;
    const std::size_t cell = row * cells_in_row_ + i;
    for (std::size_t boid = layout.begin[cell]; boid < layout.begin[cell + 1]; ++boid) {
      if ((boids.flock_bit(boid) & looked_at) != 0) add_boid<D>(sum, boids, boid);
    }
  }
  before[cells_in_row_] = sum;
}

template <int D>
Totals CellSums::total(std::span<const CellRun> runs) const {
  Totals total;
  for (const CellRun& run : runs) {
    const std::size_t row = run.first / cells_in_row_;
    const Totals& before = before_[run.first + row];
    const Totals& after = before_[run.last + row];
    total.count += after.count - before.count;
    add_difference(total.position, before.position, after.position);
    for (std::size_t axis = 0; axis < D; ++axis)
      total.position[axis] += (after.count - before.count) * double{run.shift[axis]};
    add_difference(total.velocity, before.velocity, after.velocity);
    add_difference(total.heading, before.heading, after.heading);
    add_difference(total.colour, before.colour, after.colour);
  }
  return total;
}

namespace {

// One row of the boids that steer by it; `itself` is 1 for those who are in the total and do not count.
template <int D>
void add_total(const Boids& boids, Span batch, std::size_t row, const NeighbourRow& what, const Totals& total,
               const std::array<float, batch_size>& itself, SumBlock& sums) {
  const Summed summed = summed_by<D>(what, boids);
  const std::size_t size = batch.end - batch.begin;
  std::uint32_t* const counts = sums.count(row, batch.begin);
  for (std::size_t axis = 0; axis < summed.components; ++axis) {
    float* const values = sums.value(row, axis, batch.begin);
    const float* const own = summed.own[axis] + batch.begin;
    const double all = (total.*summed.total)[axis];
    const double share = what.quantity == Quantity::offset ? total.count : 0;
    for (std::size_t i = 0; i < size; ++i) {
      // With itself the offset's own part is zero.
      const double mine = double{own[i]} * (share > 0 ? share : double{itself[i]});
      values[i] = static_cast<float>(double{values[i]} + (all - mine));
    }
  }
  for (std::size_t i = 0; i < size; ++i)
    counts[i] += static_cast<std::uint32_t>(total.count - double{itself[i]});
}

}  // namespace

template <int D>
void add_whole_cells(const Boids& boids, Span batch, const NeighbourQuestion& question, const SumPass& pass,
                     std::span<const CellRun> runs, KernelScratch& scratch, SumBlock& sums) {
  if (runs.empty()) return;
  const CellLayout layout = question.index->layout();
  const Totals total = pass.cells.total<D>(runs);
  find_own_runs(runs, layout, batch, scratch.own_runs);
  const auto number = static_cast<std::size_t>(std::countr_zero(pass.steered));
  const FlockModel& flock = question.model->flocks[number];
  const bool looks_at_its_own = (pass.looked_at & pass.steered) != 0;
  // Runs of those who steer, which are all unless flocks stand mixed.
  for (std::uint32_t begin = batch.begin; begin < batch.end;) {
    std::uint32_t end = begin;
    std::array<float, batch_size> itself{};
    for (; end < batch.end && (boids.flock_bit(end) & pass.steered) != 0; ++end)
      itself[end - begin] = looks_at_its_own && is_within(scratch.own_runs, layout, end) ? 1.0f : 0.0f;
    for (std::size_t r = 0; r < flock.rows.size(); ++r) {
      if ((pass.rows[number] >> r & 1) != 0)
        add_total<D>(boids, {begin, end}, r, flock.rows[r], total, itself, sums);
    }
    begin = end + 1;
  }
}

template void CellSums::build<2>(const CellLayout&, const Boids&, std::uint64_t, const Workers&);
template void CellSums::build<3>(const CellLayout&, const Boids&, std::uint64_t, const Workers&);
template Totals CellSums::total<2>(std::span<const CellRun>) const;
template Totals CellSums::total<3>(std::span<const CellRun>) const;
template void add_whole_cells<2>(const Boids&, Span, const NeighbourQuestion&, const SumPass&,
                                 std::span<const CellRun>, KernelScratch&, SumBlock&);
template void add_whole_cells<3>(const Boids&, Span, const NeighbourQuestion&, const SumPass&,
                                 std::span<const CellRun>, KernelScratch&, SumBlock&);

}  // namespace sturnus
