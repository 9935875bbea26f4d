// The wide kernel: sixteen boids in lanes against one candidate after the other, on the machine's widest
// registers.
//
// It gives the same bits as the plain kernel in kernel.cpp, on every instruction set.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "neighbours/kernel.h"

namespace sturnus {

/// What a neighbour must pass; rows of a flock that filter alike share one.
struct WideFilter {
  float inner_squared = 0;
  float outer_squared = 0;
  std::uint64_t flocks = 0;
  bool sees_all = true;
  float cos_half_view = -1;
  friend bool operator==(const WideFilter&, const WideFilter&) = default;
};

/// What a neighbour adds to a row's sum.
enum class WideAddend : std::uint8_t { fades, constant, heading, velocity, grows, colour };

struct WideRow {
  std::uint8_t filter = 0;
  WideAddend addend = WideAddend::grows;
  std::uint8_t row = 0;  ///< of the flock
  friend bool operator==(const WideRow&, const WideRow&) = default;
};

/// Some finite rows of one flock as the wide kernel takes them, the smallest filter first.
struct WideProgram {
  static constexpr std::size_t most = 8;
  std::array<WideFilter, most> filters{};
  std::array<WideRow, most> rows{};
  std::size_t filter_count = 0;
  std::size_t row_count = 0;
  std::uint64_t empty_rows = 0;  ///< a bit for every row that is nobody's sum
};

/// The program for those rows of a flock, given as bits; nothing where the plain kernel has to do it: with
/// sampling, or very many rows.
std::optional<WideProgram> wide_program(const FlockModel& flock, std::uint64_t rows);

/// Whether two programs differ in numbers only, so that their boids can stand in lanes side by side.
bool same_shape(const WideProgram& one, const WideProgram& other);

/// Whether some row looks at nobody of those flocks.
bool has_idle_rows(const WideProgram& program, std::uint64_t flocks);
/// The program without such rows: they are nobody's sums.
WideProgram without_idle_rows(const WideProgram& program, std::uint64_t flocks);

/// One batch: targets and sources are the same boids, in the same arrays.
struct WideBatch {
  const Boids* boids = nullptr;
  Span targets{};
  const Box* box = nullptr;               ///< that holds the targets
  std::span<const Span> spans;            ///< of candidates
  bool few = false;                       ///< see `few_candidates`
  const Wrapping* image = nullptr;        ///< `wraps` only where some candidate may be near over the seam
  std::uint64_t near = 0;                 ///< the flocks that candidates within reach may belong to
  const WideProgram* programs = nullptr;  ///< of each flock
  const WideProgram* program = nullptr;   ///< of the steered; in a mixed batch it has the shape of them all
  std::uint64_t steered = 0;              ///< the flocks whose boids get sums; their programs have one shape
  bool is_mixed = false;                  ///< the batch also holds boids of others, or of several
  std::size_t row = 0, filter = 0;        ///< of the program, from which on it is summed
  SumBlock* sums = nullptr;
};

/// Whether steps use the wide kernel: an instruction set is in use, not the plain loop.
bool is_wide_in_use();

/// Sums of the batch's targets that belong to the steered flocks.
template <int D>
void wide_sums(const WideBatch& batch);

/// The box of a batch's targets, the hidden included.
template <int D>
Box wide_box(const Boids& boids, Span batch);

}  // namespace sturnus
