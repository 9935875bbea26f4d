// Which rows are summed together.
#include "neighbours/passes.h"

#include <sturnus/isa.h>

#include <algorithm>
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

}  // namespace

void SumPass::clear(std::size_t flocks) {
  reach = 0;
  steered = 0;
  rows.assign(flocks, 0);
  programs.clear();
}

SumPass& Passes::next(std::size_t flocks) {
  if (count_ == passes_.size()) passes_.emplace_back();
  passes_[count_].clear(flocks);
  return passes_[count_++];
}

void Passes::plan(const Model& model, bool may_be_wide) {
  count_ = 0;
  wide_ = may_be_wide;
  programs_.assign(model.flocks.size(), {});
  for (std::size_t f = 0; f < model.flocks.size() && wide_; ++f) {
    const auto program = wide_program(model.flocks[f], finite_rows(model.flocks[f]));
    wide_ = program.has_value();
    if (wide_) programs_[f] = *program;
  }
  for (std::size_t f = 0; f < model.flocks.size(); ++f) {
    if (finite_rows(model.flocks[f]) == 0) continue;
    SumPass* pass = nullptr;
    for (std::size_t p = 0; p < count_ && pass == nullptr; ++p) {
      const auto like = static_cast<std::size_t>(std::countr_zero(passes_[p].steered));
      if (!wide_ || same_shape(programs_[f], programs_[like])) pass = &passes_[p];
    }
    if (pass == nullptr) pass = &next(model.flocks.size());
    pass->reach = std::max(pass->reach, model.reach);
    pass->steered |= std::uint64_t{1} << f;
    pass->rows[f] = finite_rows(model.flocks[f]);
    if (wide_) pass->programs = programs_;
  }
}

}  // namespace sturnus
