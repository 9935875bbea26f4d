// Who is near: one interface over all pairs, the cell grid and the tree.
//
// An index first says in which order the boids should stand (so that near ones stand together), then answers
// with spans of that order. A span may hold boids that are too far; it never leaves one out. The distance
// test is the kernel's alone, so every index finds the same neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/workers.h"
#include "scenario/model.h"

namespace sturnus {

/// Where boids are, as an index needs to know it. Pointers are to `count` values; the third is null in 2D.
struct Cloud {
  int dimensions = 2;
  std::size_t count = 0;
  std::array<const float*, 3> position{};
  const std::uint8_t* hidden = nullptr;  ///< 1: a quarantined boid, which nobody finds
  bool hides = true;                     ///< false where nobody is hidden
  bool wraps = false;
  std::array<float, 3> min{}, max{};  ///< of the space
  int fineness = 1;                   ///< grid: rows of cells in one reach; more for crowds
};

/// Over which end of a wrapped space somebody is seen, on one axis.
enum class Seam : std::uint8_t { none, low, high, unknown };

/// Boids [begin, end) of the order. In a space that wraps all that matter of them are seen from the box that
/// was asked for as `seam` says.
struct Span {
  std::uint32_t begin, end;
  std::array<Seam, 3> seam = {Seam::unknown, Seam::unknown, Seam::unknown};
};

/// Cells [first, last) of one row, seen from over the seam of the space where the shift is not zero.
struct CellRun {
  std::uint32_t first, last;
  std::array<float, 3> shift;
};

/// The neighbourhood of a box in two parts: cells whose boids are all neighbours of every place in the box,
/// and spans of those that have to be asked one by one.
struct RingParts {
  std::vector<CellRun> whole;
  std::vector<Span> edge;
};

/// How cells lie in the order.
struct CellLayout {
  std::span<const std::uint32_t> begin;  ///< of each cell; one more for the end of the last
  std::size_t cells_in_row = 0;
  std::size_t rows = 0;
  bool has_border = false;  ///< a row's first and last cell hold whoever is beyond, and are never whole
};

/// A part of space, for pictures of the index.
struct IndexBox {
  std::array<float, 3> min{}, max{};
};

/// Boids that the kernel steers at once, whatever the width of the machine's registers.
inline constexpr std::uint32_t batch_size = 16;

/// Cuts [begin, end) into batches.
void cut(std::uint32_t begin, std::uint32_t end, std::vector<Span>& batches);

class NeighbourIndex {
 public:
  virtual ~NeighbourIndex() = default;

  /// Sorts the cloud for questions of up to `reach` (length, above 0). `order` becomes the order in which
  /// boids should stand, or empty where they may stand as they do. Ties keep the order that was.
  virtual void build(const Cloud& cloud, float reach, const Workers& workers,
                     std::vector<std::uint32_t>& order) = 0;

  /// Keeps memory for clouds of up to so many boids, sorted in so many parts; one that doesn't asks for it as
  /// a cloud grows.
  virtual void reserve(std::size_t count, std::size_t parts) {
    static_cast<void>(count);
    static_cast<void>(parts);
  }

  /// Spans that hold every boid within `reach`, at most that of `build`, of any place in the box from `low`
  /// to `high`, which lies inside the space. Always in the same order; no boid twice. `spans` is cleared
  /// first.
  virtual void spans(const std::array<float, 3>& low, const std::array<float, 3>& high, float reach,
                     std::vector<Span>& spans) const = 0;

  /// Cuts the order into batches of at most `batch_size` boids that stand near one another, to be asked about
  /// together; one follows the other without a gap. Hidden boids may be left out. `batches` is cleared first.
  virtual void batches(std::vector<Span>& batches) const = 0;

  /// The neighbourhood of the box between two distances, as `spans` has it. Whole cells hold nobody nearer
  /// than `inner` or as far as `outer`, rounding included; an index without cells has none.
  virtual void ring(const std::array<float, 3>& low, const std::array<float, 3>& high, float inner,
                    float outer, RingParts& parts) const {
    static_cast<void>(inner);
    parts.whole.clear();
    spans(low, high, outer, parts.edge);
  }

  /// The cells of `ring`; nothing where there are none.
  virtual CellLayout layout() const { return {}; }

  /// How many neighbours a boid would have within the reach, on average, if all of that were as crowded as
  /// the cell it stands in: so it may be more than there are. Finer cells see more of a small clump. 0 where
  /// it can't be told.
  virtual double crowding() const { return 0; }

  /// The cells or leaves that hold boids.
  virtual void boxes(std::vector<IndexBox>& boxes) const = 0;
};

/// The index that fits: the wanted kind, or all pairs where a wrapped space is shorter than three reaches.
std::unique_ptr<NeighbourIndex> make_index(const Index& wanted, const Cloud& cloud, float reach);

std::unique_ptr<NeighbourIndex> make_all_pairs();
std::unique_ptr<NeighbourIndex> make_grid();
std::unique_ptr<NeighbourIndex> make_tree(std::int64_t leaf_size, std::int64_t depth_limit);

/// The reach with room for the rounding of offsets and distances in float.
double padded_reach(const Cloud& cloud, float reach);

/// True where grid and tree may be used: not in a wrapped space shorter than three reaches.
bool may_divide(const Cloud& cloud, float reach);

}  // namespace sturnus
