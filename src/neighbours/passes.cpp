// Which rows are summed together.
#include "neighbours/passes.h"

#include <sturnus/isa.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sturnus {
namespace {

// The rows of a flock that look at a finite part of the space.
std::uint64_t finite_rows(const FlockModel& flock) {
  std::uint64_t rows = 0;
  for (std::size_t r = 0; r < flock.rows.size(); ++r) {
    if (!flock.rows[r].whole_population) rows |= std::uint64_t{1} << r;
  }
  return rows;
}

// Whether a row is a plain sum over a ring: every neighbour adds what it would add anywhere in there.
bool is_plain_sum(const NeighbourRow& row) {
  if (row.whole_population || !row.sees_all || row.sample_below != 0 || row.flocks == 0) return false;
  return row.quantity != Quantity::offset || row.strength == Strength::grows;
}

// Whether such a row sees so many that cells pay; by measurement. Sooner where a flock also has rows of
// another kind, because in a crowd those cost most, and are relieved of the wider walk.
bool is_crowded(const NeighbourRow& row, const FlockModel& flock, const Model& model, const Crowd& crowd) {
  const double share = std::sqrt(double{row.outer_squared}) / double{model.reach};
  const double in_ring = crowd.density * (model.dimensions == 3 ? share * share * share : share * share);
  const double seen = std::min(in_ring, static_cast<double>(crowd.boids));
  const bool is_alone = std::all_of(flock.rows.begin(), flock.rows.end(), is_plain_sum);
  const double enough = is_alone ? 500 : 200;
  return seen >= (model.dimensions == 3 ? 1.6 * enough : enough);
}

std::uint64_t dense_rows(const FlockModel& flock, const Model& model, const Crowd& crowd) {
  std::uint64_t rows = 0;
  for (std::size_t r = 0; r < flock.rows.size(); ++r) {
    const NeighbourRow& row = flock.rows[r];
    if (!is_plain_sum(row) || model.index.path == SumPath::sparse) continue;
    if (model.index.path == SumPath::dense || is_crowded(row, flock, model, crowd))
      rows |= std::uint64_t{1} << r;
  }
  return rows;
}

float length_of(float squared) {
  return std::nextafter(std::sqrt(squared), FlockModel::infinity_f);
}

float reach_of(const FlockModel& flock, std::uint64_t rows) {
  float squared = 0;
  for (std::size_t r = 0; r < flock.rows.size(); ++r) {
    if ((rows >> r & 1) != 0) squared = std::max(squared, flock.rows[r].outer_squared);
  }
  return squared > 0 ? length_of(squared) : 0;
}

bool filter_alike(const NeighbourRow& one, const NeighbourRow& other) {
  return one.inner_squared == other.inner_squared && one.outer_squared == other.outer_squared &&
         one.flocks == other.flocks;
}

// Those of the rows that filter like one of them, as many as a wide program takes.
std::uint64_t alike_rows(const FlockModel& flock, std::uint64_t rows, const NeighbourRow& one) {
  std::uint64_t alike = 0;
  std::size_t count = 0;
  for (std::size_t r = 0; r < flock.rows.size() && count < WideProgram::most; ++r) {
    if ((rows >> r & 1) == 0 || !filter_alike(flock.rows[r], one)) continue;
    alike |= std::uint64_t{1} << r;
    ++count;
  }
  return alike;
}

}  // namespace

void SumPass::clear(std::size_t flocks) {
  reach = inner = 0;
  steered = looked_at = 0;
  is_dense = false;
  rows.assign(flocks, 0);
  programs.clear();
}

SumPass& Passes::next(std::size_t flocks) {
  if (count_ == passes_.size()) passes_.emplace_back();
  passes_[count_].clear(flocks);
  return passes_[count_++];
}

bool Passes::has_dense() const {
  return std::any_of(passes_.begin(), passes_.begin() + static_cast<std::ptrdiff_t>(count_),
                     [](const SumPass& pass) { return pass.is_dense; });
}

// One pass for the rows that filter like the first of those left, and so on.
void Passes::plan_dense(const FlockModel& flock, std::size_t number, const Model& model, std::uint64_t rows) {
  while (rows != 0) {
    const NeighbourRow& first = flock.rows[static_cast<std::size_t>(std::countr_zero(rows))];
    SumPass& pass = next(model.flocks.size());
    pass.is_dense = true;
    pass.steered = std::uint64_t{1} << number;
    pass.looked_at = first.flocks;
    pass.inner = std::sqrt(first.inner_squared);
    pass.rows[number] = alike_rows(flock, rows, first);
    rows &= ~pass.rows[number];
    pass.reach = std::min(model.reach, reach_of(flock, pass.rows[number]));
    if (!wide_) continue;
    pass.programs.resize(model.flocks.size());
    pass.programs[number] = *wide_program(flock, pass.rows[number]);
  }
}

void Passes::plan_sparse(const Model& model, std::size_t flock) {
  SumPass* pass = nullptr;
  for (std::size_t p = 0; p < count_ && pass == nullptr; ++p) {
    const auto like = static_cast<std::size_t>(std::countr_zero(passes_[p].steered));
    if (!passes_[p].is_dense && same_shape(programs_[flock], programs_[like])) pass = &passes_[p];
  }
  if (pass == nullptr) pass = &next(model.flocks.size());
  pass->reach = std::min(model.reach, std::max(pass->reach, reach_of(model.flocks[flock], sparse_[flock])));
  pass->steered |= std::uint64_t{1} << flock;
  pass->rows[flock] = sparse_[flock];
  if (wide_) pass->programs = programs_;
}

void Passes::plan(const Model& model, bool may_be_wide, const Crowd& crowd) {
  const std::size_t flocks = model.flocks.size();
  count_ = 0;
  bool all_have_programs = true;
  sparse_.assign(flocks, 0);
  programs_.assign(flocks, {});
  for (std::size_t f = 0; f < flocks; ++f) {
    sparse_[f] = finite_rows(model.flocks[f]) & ~dense_rows(model.flocks[f], model, crowd);
    const auto program = wide_program(model.flocks[f], sparse_[f]);
    all_have_programs = all_have_programs && program.has_value();
    if (program) programs_[f] = *program;
  }
  if (!all_have_programs) programs_.assign(flocks, {});
  wide_ = may_be_wide && all_have_programs;
  for (std::size_t f = 0; f < flocks; ++f) {
    if (sparse_[f] != 0) plan_sparse(model, f);
    plan_dense(model.flocks[f], f, model, dense_rows(model.flocks[f], model, crowd));
  }
}

}  // namespace sturnus
