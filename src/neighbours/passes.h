// The passes over the neighbours: which rows of which flocks are summed together, over how far, and how.
#pragma once

#include <span>
#include <vector>

#include "neighbours/wide.h"

namespace sturnus {

/// Rows of one or more flocks that are summed in one walk over the candidates.
struct SumPass {
  float reach = 0;            ///< length; nobody farther away counts
  std::uint64_t steered = 0;  ///< flocks that have rows in this pass
  /// For each flock, a bit for every row of it that belongs here.
  std::vector<std::uint64_t> rows;
  std::vector<WideProgram> programs;  ///< for each flock; empty for the plain kernel

  void clear(std::size_t flocks);
};

/// All passes of a step. The memory of earlier steps is used again.
class Passes {
 public:
  /// The sparse passes of a model: with the wide kernel one for flocks whose programs have one shape.
  void plan(const Model& model, bool may_be_wide);
  std::span<const SumPass> all() const { return std::span(passes_).first(count_); }
  bool are_wide() const { return wide_; }

 private:
  SumPass& next(std::size_t flocks);
  std::vector<SumPass> passes_;
  std::vector<WideProgram> programs_;  ///< of each flock's finite rows
  std::size_t count_ = 0;
  bool wide_ = false;
};

}  // namespace sturnus
