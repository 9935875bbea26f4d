// The wide kernel: sixteen boids in lanes against one candidate after the other, on the machine's widest
// registers.
//
// It gives the same bits as the plain kernel in kernel.cpp, on every instruction set.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/kernel.h"

namespace sturnus {

/// What a neighbour must pass; rows of a flock that filter alike share one.
struct WideFilter {
  float inner_squared = 0;
  float outer_squared = 0;
  std::uint64_t flocks = 0;
  bool sees_all = true;
  float cos_half_view = -1;
};

/// What a neighbour adds to a row's sum.
enum class WideAddend : std::uint8_t { fades, constant, grows, velocity, heading, colour };

struct WideRow {
  std::uint8_t filter = 0;
  WideAddend addend = WideAddend::grows;
  std::uint8_t row = 0;  ///< of the flock
};

/// The finite rows of one flock as the wide kernel takes them.
struct WideProgram {
  static constexpr std::size_t most = 8;
  std::vector<WideFilter> filters;
  std::vector<WideRow> rows;
  bool fits = true;  ///< false where the plain kernel has to do it: sampling, or very many rows
};

WideProgram wide_program(const FlockModel& flock);

/// One batch: targets and sources are the same boids, in the same arrays.
struct WideBatch {
  const Boids* boids = nullptr;
  Span targets{};
  std::span<const Span> spans;  ///< of candidates
  Wrapping image;               ///< `wraps` only where some candidate may be near over the seam
  std::uint64_t checked = 0;    ///< flocks that boids here may belong to; 0: some boid is hidden
  std::size_t flock = 0;        ///< steers the targets of this flock only
  const WideProgram* program = nullptr;
  std::size_t most_rows = 0;
  NeighbourSum* sums = nullptr;  ///< of all boids, most_rows each
};

/// Sums of the batch's targets of one flock.
template <int D>
void wide_sums(const WideBatch& batch);

}  // namespace sturnus
