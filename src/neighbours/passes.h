// The passes over the neighbours: which rows of which flocks are summed together, over how far, and how.
#pragma once

#include <span>
#include <vector>

#include "neighbours/cell_sums.h"
#include "neighbours/wide.h"

namespace sturnus {

/// Rows of one or more flocks that are summed in one walk over the candidates.
struct SumPass {
  float reach = 0;            ///< length; nobody farther away counts
  std::uint64_t steered = 0;  ///< flocks that have rows in this pass
  /// For each flock, a bit for every row of it that belongs here.
  std::vector<std::uint64_t> rows;
  std::vector<WideProgram> programs;  ///< for each flock; empty for the plain kernel

  /// Where this is set the pass has one flock and one filter: boids in cells that lie wholly inside its ring
  /// are not asked one by one, but come from sums of cells.
  bool is_dense = false;
  float inner = 0;  ///< length
  std::uint64_t looked_at = 0;
  CellSums cells;

  void clear(std::size_t flocks);
};

/// How crowded a world is.
struct Crowd {
  double density = 0;  ///< boids in a ball of the model's reach, as `NeighbourIndex::crowding` tells
  std::size_t boids = 0;
};

/// All passes of a step. The memory of earlier steps is used again.
class Passes {
 public:
  /// The passes of a model, the same for every kernel: how a sum is rounded depends on who is a candidate.
  /// Flocks whose programs have one shape share one, and where a flock has no program all do. A row that
  /// is a plain sum over a ring gets a dense pass of its own where the model asks for it, or where it sees
  /// very many in such a crowd.
  void plan(const Model& model, bool may_be_wide, const Crowd& crowd = {});
  std::span<const SumPass> all() const { return std::span(passes_).first(count_); }
  std::span<SumPass> all() { return std::span(passes_).first(count_); }
  bool has_dense() const;
  bool are_wide() const { return wide_; }

 private:
  SumPass& next(std::size_t flocks);
  void plan_dense(const FlockModel& flock, std::size_t number, const Model& model, std::uint64_t rows);
  void plan_sparse(const Model& model, std::size_t flock);
  std::vector<SumPass> passes_;
  std::vector<std::uint64_t> sparse_;  ///< for each flock, a bit for every row that is summed boid by boid
  std::vector<WideProgram> programs_;  ///< of each flock's sparse rows
  std::size_t count_ = 0;
  bool wide_ = false;
};

}  // namespace sturnus
