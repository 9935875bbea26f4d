// Sums over whole cells: what boids in the middle of a crowd add, without asking each of them.
#pragma once

#include "neighbours/kernel.h"

namespace sturnus {

/// For each row of cells, the sums of count, place, velocity, heading and colour of the boids before each
/// cell, in double; a run of cells is the difference of two.
class CellSums {
 public:
  /// Of those boids whose flock is looked at. `boids` stand in the order of the cells.
  template <int D>
  void build(const CellLayout& layout, const Boids& boids, std::uint64_t looked_at, const Workers& workers);

  /// What the boids in the runs add up to, their places shifted as the runs say.
  template <int D>
  Totals total(std::span<const CellRun> runs) const;

 private:
  template <int D>
  void build_row(const CellLayout& layout, const Boids& boids, std::uint64_t looked_at, std::size_t row);

  std::size_t cells_in_row_ = 1;
  std::vector<Totals> before_;  ///< cells_in_row + 1 for each row
};

/// Adds to the sums of a batch, row by row of the pass, what the boids in the runs add.
template <int D>
void add_whole_cells(const Boids& boids, Span batch, const NeighbourQuestion& question, const SumPass& pass,
                     std::span<const CellRun> runs, KernelScratch& scratch, SumBlock& sums);

}  // namespace sturnus
