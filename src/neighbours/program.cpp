// From the rows of a flock to the wide kernel's program, and the choice of the kernel.
#include <sturnus/isa.h>

#include <hwy/targets.h>

#include <atomic>

#include "neighbours/wide.h"

namespace sturnus {
namespace {

std::atomic<Isa> in_use{Isa::best};

// The instruction sets that have names of their own here.
struct Named {
  Isa isa;
  const char* name;
  std::int64_t target;
};
constexpr Named named[] = {{Isa::sse4, "sse4", HWY_SSE4},
                           {Isa::avx2, "avx2", HWY_AVX2},
                           {Isa::avx512, "avx512", HWY_AVX3},
                           {Isa::neon, "neon", HWY_NEON}};

// 0: whatever is best.
std::int64_t target_of(Isa isa) {
  for (const Named& one : named) {
    if (one.isa == isa) return one.target;
  }
  return 0;
}

WideAddend addend_of(const NeighbourRow& row) {
  switch (row.quantity) {
    case Quantity::velocity:
      return WideAddend::velocity;
    case Quantity::heading:
      return WideAddend::heading;
    case Quantity::colour:
      return WideAddend::colour;
    case Quantity::offset:
      break;
  }
  if (row.strength == Strength::fades) return WideAddend::fades;
  return row.strength == Strength::constant ? WideAddend::constant : WideAddend::grows;
}

bool filters_alike(const WideFilter& filter, const NeighbourRow& row) {
  return filter.inner_squared == row.inner_squared && filter.outer_squared == row.outer_squared &&
         filter.flocks == row.flocks && filter.sees_all == row.sees_all &&
         (row.sees_all || filter.cos_half_view == row.cos_half_view);
}

std::size_t filter_for(const NeighbourRow& row, std::vector<WideFilter>& filters) {
  for (std::size_t f = 0; f < filters.size(); ++f) {
    if (filters_alike(filters[f], row)) return f;
  }
  filters.push_back({row.inner_squared, row.outer_squared, row.flocks, row.sees_all, row.cos_half_view});
  return filters.size() - 1;
}

}  // namespace

WideProgram wide_program(const FlockModel& flock) {
  WideProgram program;
  for (std::size_t r = 0; r < flock.rows.size(); ++r) {
    const NeighbourRow& row = flock.rows[r];
    if (row.whole_population || row.flocks == 0) continue;
    program.fits &= row.sample_below == 0;
    const std::size_t filter = filter_for(row, program.filters);
    program.rows.push_back({static_cast<std::uint8_t>(filter), addend_of(row), static_cast<std::uint8_t>(r)});
  }
  program.fits &= program.rows.size() <= WideProgram::most;
  return program;
}

bool use_isa(Isa isa) {
  hwy::SetSupportedTargetsForTest(0);
  const std::int64_t wanted = target_of(isa);
  const bool has = wanted == 0 || (hwy::SupportedTargets() & HWY_TARGETS & wanted) != 0;
  if (has) in_use = isa;
  hwy::SetSupportedTargetsForTest(target_of(in_use));
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return has;
}

std::string isa_in_use() {
  if (in_use == Isa::plain) return "plain";
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  const std::int64_t best = usable & -usable;
  for (const Named& one : named) {
    if (one.target == best) return one.name;
  }
  return hwy::TargetName(best);
}

}  // namespace sturnus
