// From the rows of a flock to the wide kernel's program, and the choice of the kernel.
#include <sturnus/isa.h>

#include <hwy/targets.h>

#include <algorithm>
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

WideFilter filter_of(const NeighbourRow& row) {
  return {row.inner_squared, row.outer_squared, row.flocks, row.sees_all,
          row.sees_all ? -1 : row.cos_half_view};
}

// The smallest first: plans count on it.
bool comes_before(const NeighbourRow& one, const NeighbourRow& other) {
  return one.outer_squared != other.outer_squared ? one.outer_squared < other.outer_squared
                                                  : addend_of(one) < addend_of(other);
}

void add_row(const NeighbourRow& row, std::size_t number, WideProgram& program) {
  const WideFilter wanted = filter_of(row);
  std::size_t filter = 0;
  while (filter < program.filter_count && !(program.filters[filter] == wanted)) ++filter;
  if (filter == program.filter_count) program.filters[program.filter_count++] = wanted;
  program.rows[program.row_count++] = {static_cast<std::uint8_t>(filter), addend_of(row),
                                       static_cast<std::uint8_t>(number)};
}

}  // namespace

std::optional<WideProgram> wide_program(const FlockModel& flock, std::uint64_t rows) {
  WideProgram program;
  std::array<std::size_t, WideProgram::most> numbers{};
  std::size_t count = 0;
  for (std::size_t r = 0; r < flock.rows.size(); ++r) {
    if ((rows >> r & 1) == 0) continue;
    if (flock.rows[r].flocks == 0) {
      program.empty_rows |= std::uint64_t{1} << r;
      continue;
    }
    if (count == WideProgram::most || flock.rows[r].sample_below != 0) return {};
    const auto end = numbers.begin() + count;
    const auto place = std::upper_bound(numbers.begin(), end, r, [&flock](std::size_t a, std::size_t b) {
      return comes_before(flock.rows[a], flock.rows[b]);
    });
    std::copy_backward(place, end, end + 1);
    *place = r;
    ++count;
  }
  for (std::size_t i = 0; i < count; ++i) add_row(flock.rows[numbers[i]], numbers[i], program);
  return program;
}

bool same_shape(const WideProgram& one, const WideProgram& other) {
  return one.filter_count == other.filter_count && one.empty_rows == other.empty_rows &&
         std::equal(one.rows.begin(), one.rows.begin() + one.row_count, other.rows.begin(),
                    other.rows.begin() + other.row_count);
}

bool has_idle_rows(const WideProgram& program, std::uint64_t flocks) {
  return std::any_of(program.filters.begin(), program.filters.begin() + program.filter_count,
                     [flocks](const WideFilter& filter) { return (filter.flocks & flocks) == 0; });
}

WideProgram without_idle_rows(const WideProgram& program, std::uint64_t flocks) {
  WideProgram out;
  out.empty_rows = program.empty_rows;
  std::array<std::uint8_t, WideProgram::most> numbers{};
  for (std::size_t f = 0; f < program.filter_count; ++f) {
    numbers[f] = static_cast<std::uint8_t>(out.filter_count);
    if ((program.filters[f].flocks & flocks) != 0) out.filters[out.filter_count++] = program.filters[f];
  }
  for (std::size_t r = 0; r < program.row_count; ++r) {
    const WideRow& row = program.rows[r];
    if ((program.filters[row.filter].flocks & flocks) == 0) {
      out.empty_rows |= std::uint64_t{1} << row.row;
    } else {
      out.rows[out.row_count++] = {numbers[row.filter], row.addend, row.row};
    }
  }
  return out;
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

bool is_wide_in_use() {
  return in_use != Isa::plain;
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
