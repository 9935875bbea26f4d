// The dense path: sums of whole cells give what asking each boid gives, on every instruction set and for any
// number of workers. Both are held to a sum over all pairs in double.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstring>

#include "crowds.h"
#include "isas.h"

namespace sturnus::test {
namespace {

/// What one boid gets by the definition of a row.
struct Truth {
  std::array<double, 3> sum{}, size{};  ///< of the contributions and of their absolute values
  std::uint32_t count = 0;
  std::uint32_t borderline = 0;  ///< neighbours or not, by the last digit of a float
};

/// How many boids came in whole cells, of all that were near, and in how many worlds there were such cells.
struct Tally {
  double whole = 0, all = 0;
  int worlds = 0, worlds_with_whole_cells = 0;
};

double offset_on(const RandomWorld& world, std::size_t axis, std::size_t from, std::size_t to) {
  const double o = double{world.position[axis][to]} - double{world.position[axis][from]};
  const double size = double{world.max[axis]} - double{world.min[axis]};
  return world.wraps ? o - size * std::round(o / size) : o;
}

bool sees_one(const NeighbourRow& row, const CrowdScene& scene, std::size_t i, const std::array<double, 3>& o,
              double squared) {
  if (row.sees_all) return true;
  double along = 0, speed = 0;
  for (std::size_t axis = 0; axis < scene.world.axes(); ++axis) {
    const double v = scene.velocity[axis][i];
    along += v * o[axis];
    speed += v * v;
  }
  return along >= double{row.cos_half_view} * std::sqrt(speed) * std::sqrt(squared);
}

double contribution(const NeighbourRow& row, const CrowdScene& scene, std::size_t j, std::size_t axis,
                    const std::array<double, 3>& o, double squared) {
  switch (row.quantity) {
    case Quantity::velocity:
      return scene.velocity[axis][j];
    case Quantity::heading:
      return scene.heading[axis][j];
    case Quantity::colour:
      return scene.colour[axis][j];
    case Quantity::offset:
      break;
  }
  return row.strength == Strength::grows ? o[axis] : squared > 0 ? o[axis] / squared : 0;
}

Truth truth_of(const CrowdScene& scene, std::size_t i, const NeighbourRow& row) {
  const RandomWorld& world = scene.world;
  const std::size_t components = row.quantity == Quantity::colour ? 3 : world.axes();
  Truth truth;
  for (std::size_t j = 0; j < world.size(); ++j) {
    if (j == i || world.hidden[j] != 0 || (row.flocks >> scene.flock[j] & 1) == 0) continue;
    std::array<double, 3> o{};
    double squared = 0;
    for (std::size_t axis = 0; axis < world.axes(); ++axis) {
      o[axis] = offset_on(world, axis, i, j);
      squared += o[axis] * o[axis];
    }
    if (squared > 4 * double{row.outer_squared}) continue;
    const double room = 1e-4 * double{row.outer_squared};
    if (std::abs(squared - double{row.outer_squared}) < room ||
        (row.inner_squared > 0 && std::abs(squared - double{row.inner_squared}) < room) || !row.sees_all)
      ++truth.borderline;
    if (squared < double{row.inner_squared} || squared >= double{row.outer_squared}) continue;
    if (!sees_one(row, scene, i, o, squared)) continue;
    ++truth.count;
    for (std::size_t axis = 0; axis < components; ++axis) {
      const double c = contribution(row, scene, j, axis, o, squared);
      truth.sum[axis] += c;
      truth.size[axis] += std::abs(c);
    }
  }
  return truth;
}

Passes planned(const CrowdScene& scene, SumPath path) {
  Model model = scene.model;
  model.index.path = path;
  Passes passes;
  passes.plan(model, isa_in_use() != "plain");
  for (SumPass& pass : passes.all()) {
    if (!pass.is_dense) continue;
    const Boids boids = scene.boids();
    scene.world.dimensions == 3
        ? pass.cells.build<3>(scene.index->layout(), boids, pass.looked_at, Workers(1))
        : pass.cells.build<2>(scene.index->layout(), boids, pass.looked_at, Workers(1));
  }
  return passes;
}

/// The sums on the instruction set in use.
std::vector<NeighbourSum> sums_by(const CrowdScene& scene, SumPath path) {
  return sums_by(scene, planned(scene, path));
}

/// Counts boids in the rings of the dense passes, and those of them that come in whole cells.
void count_whole(const CrowdScene& scene, Tally& tally) {
  const Passes passes = planned(scene, SumPath::dense);
  std::vector<Span> batches;
  scene.index->batches(batches);
  const CellLayout layout = scene.index->layout();
  RingParts parts;
  const double before = tally.whole;
  for (const SumPass& pass : passes.all()) {
    for (std::size_t i = 0; pass.is_dense && i < batches.size(); ++i) {
      const Box box = scene.world.dimensions == 3 ? wide_box<3>(scene.boids(), batches[i])
                                                  : wide_box<2>(scene.boids(), batches[i]);
      scene.index->ring(box.low, box.high, pass.inner, pass.reach, parts);
      for (const CellRun& run : parts.whole) tally.whole += layout.begin[run.last] - layout.begin[run.first];
      tally.all += static_cast<double>(candidates(parts.edge));
    }
  }
  tally.all += tally.whole - before;
  ++tally.worlds;
  tally.worlds_with_whole_cells += tally.whole > before ? 1 : 0;
}

std::string place_of(const CrowdScene& scene, std::size_t boid, std::size_t row) {
  return "boid " + std::to_string(boid) + " of " + std::to_string(scene.world.size()) + ", row " +
         std::to_string(row) + ", fineness " + std::to_string(scene.fineness) + ", dimensions " +
         std::to_string(scene.world.dimensions) + ", flocks " + std::to_string(scene.model.flocks.size());
}

/// Components that differ from the truth by more than a part in a hundred thousand of all that was added.
void expect_true(const CrowdScene& scene, const NeighbourRow& row, const Truth& truth,
                 const NeighbourSum& sum, const std::string& who) {
  double size = 0;  // of coordinates: an offset over the seam is rounded by their digits
  for (std::size_t axis = 0; axis < scene.world.axes(); ++axis)
    size = std::max({size, std::abs(double{scene.world.min[axis]}), std::abs(double{scene.world.max[axis]})});
  const double of_offsets = row.quantity == Quantity::offset ? 1e-7 * size * truth.count : 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double allowed = 1e-5 * truth.size[axis] + of_offsets + 1e-30;
    if (std::abs(double{sum.value[axis]} - truth.sum[axis]) > allowed)
      RC_FAIL(who + ": " + std::to_string(sum.value[axis]) + " for " + std::to_string(truth.sum[axis]) +
              ", allowed " + std::to_string(allowed));
  }
}

void expect_same_sums(const CrowdScene& scene) {
  const auto sparse = sums_by(scene, SumPath::sparse);
  const auto dense = sums_by(scene, SumPath::dense);
  for (std::size_t i = 0; i < scene.world.size(); ++i) {
    const FlockModel& flock = scene.model.flocks[scene.flock[i]];
    for (std::size_t r = 0; r < flock.rows.size() && scene.world.hidden[i] == 0; ++r) {
      const NeighbourSum& one = sparse[i * scene.model.most_rows + r];
      const NeighbourSum& other = dense[i * scene.model.most_rows + r];
      const std::string who = place_of(scene, i, r);
      if (one.count != other.count)
        RC_FAIL(who + ": count " + std::to_string(other.count) + " for " + std::to_string(one.count));
      if (flock.rows[r].strength == Strength::fades) continue;  // never dense, and tried elsewhere
      if (i % 5 != 0) continue;                                 // the definition is slow
      const Truth truth = truth_of(scene, i, flock.rows[r]);
      if (truth.borderline != 0) continue;
      RC_ASSERT(one.count == truth.count);
      expect_true(scene, flock.rows[r], truth, one, "sparse, " + who);
      expect_true(scene, flock.rows[r], truth, other, "dense, " + who);
    }
  }
}

/// Tries a law on crowds of each kind of space, and sees to it that whole cells played a part in each.
template <class Law>
void try_on_crowds(const char* what, Law&& law) {
  for (const int dimensions : {2, 3}) {
    for (const bool wraps : {false, true}) {
      Tally tally;
      const std::string where =
          std::string(what) + (wraps ? ", wrapped" : ", open") + (dimensions == 3 ? ", 3D" : ", 2D");
      EXPECT_TRUE(rc::check(where, [&] {
        const CrowdScene scene = crowd_scene(dimensions, wraps);
        count_whole(scene, tally);
        law(scene);
      }));
      EXPECT_GT(tally.worlds_with_whole_cells, tally.worlds / 4)
          << where << ": too few whole cells for a proof";
      EXPECT_GT(tally.whole, 0.01 * tally.all) << where << ": too few whole cells for a proof";
    }
  }
}

TEST(DensePath, CountsAndSumsWhatTheSparseOneDoes) {
  try_on_crowds("dense and sparse", expect_same_sums);
}

TEST(DensePath, GivesTheBitsOfThePlainKernelOnEveryInstructionSet) {
  const IsaGuard guard;
  try_on_crowds("plain and wide", [](const CrowdScene& scene) {
    RC_ASSERT(use_isa(Isa::plain));
    const auto plain = sums_by(scene, SumPath::dense);
    for (const NamedIsa& isa : wide_isas) {
      if (!use_isa(isa.isa)) continue;
      const auto wide = sums_by(scene, SumPath::dense);
      for (std::size_t i = 0; i < plain.size(); ++i) {
        if (std::memcmp(&wide[i], &plain[i], sizeof plain[i]) != 0)
          RC_FAIL(std::string(isa.name) + ": " +
                  place_of(scene, i / scene.model.most_rows, i % scene.model.most_rows));
      }
    }
  });
}

/// The sums before each cell of each row, in the bits that they have.
template <int D>
std::vector<Totals> sums_before(const CrowdScene& scene, const Workers& workers) {
  const CellLayout layout = scene.index->layout();
  CellSums sums;
  sums.build<D>(layout, scene.boids(), 0b101, workers);
  std::vector<Totals> out;
  for (std::size_t row = 0; row < layout.rows; ++row) {
    const auto first = static_cast<std::uint32_t>(row * layout.cells_in_row);
    for (std::uint32_t cell = first; cell < first + layout.cells_in_row; ++cell) {
      const CellRun run{first, cell + 1, {}};
      out.push_back(sums.total<D>({&run, 1}));
    }
  }
  return out;
}

template <int D>
void expect_same_for_any_workers(const CrowdScene& scene) {
  const auto one = sums_before<D>(scene, Workers(1));
  for (const int threads : {2, 3, 8}) {
    const auto many = sums_before<D>(scene, Workers(threads));
    RC_ASSERT(many.size() == one.size());
    RC_ASSERT(std::memcmp(many.data(), one.data(), one.size() * sizeof(Totals)) == 0);
  }
}

TEST(CellSums, AreTheSameForAnyNumberOfWorkers) {
  try_on_crowds("workers", [](const CrowdScene& scene) {
    scene.world.dimensions == 3 ? expect_same_for_any_workers<3>(scene)
                                : expect_same_for_any_workers<2>(scene);
  });
}

TEST(DensePath, TakesAnyNumberOfRowsWithOneRing) {
  const IsaGuard guard;
  for (const Isa isa : {Isa::plain, Isa::best}) {
    ASSERT_TRUE(use_isa(isa));
    EXPECT_TRUE(rc::check("many rows", [] {
      CrowdScene scene = crowd_scene(2, true, 200);
      for (FlockModel& flock : scene.model.flocks) {
        NeighbourRow row = crowd_row(Quantity::velocity, scene.world.reach, 7);
        flock.rows.assign(WideProgram::most + 2, row);
        flock.reach_squared = row.outer_squared;
      }
      scene.model.most_rows = WideProgram::most + 2;
      expect_same_sums(scene);
    }));
  }
}

}  // namespace
}  // namespace sturnus::test
