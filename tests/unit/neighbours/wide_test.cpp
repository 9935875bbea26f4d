// The wide kernel against the plain one, bit for bit: random worlds with every option of a row in turn and
// together, on every instruction set of this machine.
#include "neighbours/passes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "isas.h"
#include "scene.h"

namespace sturnus::test {
namespace {

/// What a world may have besides the three classic rows of one flock.
enum class Option {
  none,
  rings,
  edges,
  views,
  strengths,
  headings,
  colours,
  flocks,
  hidden,
  coincident,
  all,
  crowd  ///< more candidates than are summed in float alone
};
constexpr Option every_option[] = {Option::none,      Option::rings,      Option::edges,   Option::views,
                                   Option::strengths, Option::headings,   Option::colours, Option::flocks,
                                   Option::hidden,    Option::coincident, Option::all,     Option::crowd};

bool has(Option scene, Option wanted) {
  return scene == wanted || scene == Option::all || (scene == Option::crowd && wanted == Option::views);
}

float random_number() {
  return static_cast<float>(*rc::gen::inRange(-1 << 20, 1 << 20)) * 0x1p-19f;
}

NeighbourRow random_row(Option option, Quantity quantity, float reach, std::uint64_t flocks) {
  NeighbourRow row;
  row.quantity = quantity;
  row.strength = *rc::gen::element(Strength::fades, Strength::fades, Strength::grows);
  if (has(option, Option::strengths))
    row.strength = *rc::gen::element(Strength::fades, Strength::constant, Strength::grows);
  const float outer = reach * *rc::gen::element(0.25f, 0.5f, 1.0f, 1.0f);
  row.outer_squared = outer * outer;
  row.flocks = flocks;
  if (has(option, Option::rings)) {
    const float inner = outer * *rc::gen::element(0.0f, 0.25f, 0.5f, 0.9f);
    row.inner_squared = inner * inner;
  }
  if (has(option, Option::edges) && *rc::gen::arbitrary<bool>())
    row.outer_squared = std::nextafter(row.outer_squared, FlockModel::infinity_f);
  if (has(option, Option::views) && *rc::gen::inRange(0, 4) != 0) {
    row.sees_all = false;
    row.cos_half_view = *rc::gen::element(-0.9f, -0.5f, 0.0f, 0.7071f, 1.0f);
  }
  if (has(option, Option::flocks)) row.flocks = *rc::gen::inRange<std::uint64_t>(0, 8);
  return row;
}

// One row of each kind, then as many more as the option brings.
FlockModel random_flock(Option option, float reach) {
  FlockModel flock;
  const std::uint64_t all = has(option, Option::flocks) ? 7 : 1;
  for (const Quantity quantity : {Quantity::offset, Quantity::velocity, Quantity::offset})
    flock.rows.push_back(random_row(option, quantity, reach, all));
  if (*rc::gen::arbitrary<bool>()) flock.rows.back().strength = Strength::grows;
  if (has(option, Option::headings)) flock.rows.push_back(random_row(option, Quantity::heading, reach, all));
  if (has(option, Option::colours)) flock.rows.push_back(random_row(option, Quantity::colour, reach, all));
  if (option != Option::none && *rc::gen::arbitrary<bool>()) flock.rows.erase(flock.rows.begin());
  for (const NeighbourRow& row : flock.rows)
    flock.reach_squared = std::max(flock.reach_squared, row.outer_squared);
  return flock;
}

Model random_model(Option option, const RandomWorld& world) {
  Model model;
  model.dimensions = world.dimensions;
  model.boundary = world.wraps ? BoundaryKind::wrap : BoundaryKind::open;
  model.min = world.min;
  model.max = world.max;
  model.size = world.image().size;
  model.reach = world.reach;
  const int flocks = has(option, Option::flocks) ? 3 : 1;
  for (int i = 0; i < flocks; ++i) {
    model.flocks.push_back(random_flock(option, world.reach));
    model.most_rows = std::max(model.most_rows, model.flocks.back().rows.size());
  }
  return model;
}

void move_onto_others(RandomWorld& world) {
  for (std::size_t i = 1; i < world.size(); i += 3) {
    for (std::size_t axis = 0; axis < world.axes(); ++axis)
      world.position[axis][i] = world.position[axis][i - 1];
  }
}

Scene random_scene(Option option, bool wraps) {
  Scene scene;
  RandomWorld& world = scene.world = random_world(wraps, option == Option::crowd ? 900 : 250);
  if (has(option, Option::coincident)) move_onto_others(world);
  if (!has(option, Option::hidden)) std::fill(world.hidden.begin(), world.hidden.end(), 0);
  scene.model = random_model(option, world);
  Index wanted;
  wanted.kind = *rc::gen::element(IndexKind::grid, IndexKind::tree, IndexKind::all_pairs);
  wanted.leaf_size = *rc::gen::inRange(1, 40);
  scene.index = make_index(wanted, world.cloud(), world.reach);
  std::vector<std::uint32_t> order;
  scene.index->build(world.cloud(), world.reach, Workers(1), order);
  world.reorder_as(order);
  for (std::size_t i = 0; i < world.size(); ++i) {
    for (Columns* columns : {&scene.velocity, &scene.heading, &scene.colour}) {
      const bool is_zero = *rc::gen::inRange(0, 30) == 0;  // at rest
      for (auto& column : *columns) column.push_back(is_zero ? 0 : random_number());
    }
    scene.flock.push_back(
        static_cast<std::uint8_t>(*rc::gen::inRange<int>(0, static_cast<int>(scene.model.flocks.size()))));
  }
  return scene;
}

/// The sums on the instruction set in use.
std::vector<NeighbourSum> sums_of(const Scene& scene) {
  Passes passes;
  passes.plan(scene.model, isa_in_use() != "plain");
  return sums_by(scene, passes);
}

/// Where the plain kernel and an instruction set first give other bits; empty where they never do.
std::string first_difference(const Scene& scene) {
  const IsaGuard guard;
  if (!use_isa(Isa::plain)) return "there is no plain kernel";
  const auto plain = sums_of(scene);
  for (const NamedIsa& isa : wide_isas) {
    if (!use_isa(isa.isa)) continue;
    const auto wide = sums_of(scene);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      if (std::memcmp(&wide[i], &plain[i], sizeof plain[i]) == 0) continue;
      return std::string(isa.name) + ", boid " + std::to_string(i / scene.model.most_rows) + " of " +
             std::to_string(scene.world.size()) + ", row " + std::to_string(i % scene.model.most_rows) +
             ": " + std::to_string(wide[i].value[0]) + " for " + std::to_string(plain[i].value[0]) +
             ", count " + std::to_string(wide[i].count) + " for " + std::to_string(plain[i].count);
    }
  }
  return "";
}

void try_every_option(bool wraps) {
  for (const Option option : every_option) {
    const std::string difference = first_difference(random_scene(option, wraps));
    if (!difference.empty())
      RC_FAIL("option " + std::to_string(static_cast<int>(option)) + " on " + difference);
  }
}

RC_GTEST_PROP(WideKernel, GivesTheBitsOfThePlainOneInOpenWorlds, ()) {
  try_every_option(false);
}
RC_GTEST_PROP(WideKernel, GivesTheBitsOfThePlainOneInWrappedWorlds, ()) {
  try_every_option(true);
}

// A wrapped cube of 4.2 reaches with boids all over it, in so many rows of cells a reach: spans are seen over
// every seam.
Scene cube_scene(int count, int fineness) {
  constexpr float reaches = 4.2f;
  Scene scene;
  RandomWorld& world = scene.world;
  world.dimensions = 3;
  world.wraps = true;
  std::mt19937 random(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    world.max[axis] = reaches;
    for (int i = 0; i < count; ++i)
      world.position[axis].push_back(reaches * static_cast<float>(random() >> 8) * 0x1p-24f);
  }
  for (int i = 0; i < count; ++i) world.ids.push_back(static_cast<std::uint64_t>(i));
  world.hidden.assign(world.size(), 0);
  scene.velocity = scene.heading = scene.colour = world.position;
  scene.flock.assign(world.size(), 0);
  scene.model.dimensions = 3;
  scene.model.boundary = BoundaryKind::wrap;
  scene.model.max = world.max;
  scene.model.size = world.image().size;
  scene.model.reach = 1;
  scene.model.flocks.resize(1);
  FlockModel& flock = scene.model.flocks[0];
  flock.reach_squared = 1;
  for (const Quantity quantity : {Quantity::offset, Quantity::velocity, Quantity::offset}) {
    flock.rows.emplace_back();
    flock.rows.back().quantity = quantity;
    flock.rows.back().outer_squared = flock.rows.size() == 1 ? 0.25f : 1.0f;
    flock.rows.back().strength = flock.rows.size() == 1 ? Strength::fades : Strength::grows;
    flock.rows.back().flocks = 1;
  }
  scene.model.most_rows = flock.rows.size();
  scene.index = make_grid();
  Cloud cloud = world.cloud();
  cloud.fineness = fineness;
  std::vector<std::uint32_t> order;
  scene.index->build(cloud, world.reach, Workers(1), order);
  world.reorder_as(order);
  return scene;
}

// The most spans of a batch, and the fewest candidates.
struct Asked {
  std::size_t most_spans = 0, fewest_candidates = ~std::size_t{0};
};

Asked asked_by(const Scene& scene) {
  std::vector<Span> batches, spans;
  scene.index->batches(batches);
  Asked asked;
  for (const Span& batch : batches) {
    const Box box = wide_box<3>(scene.boids(), batch);
    scene.index->spans(box.low, box.high, 1, spans);
    asked.most_spans = std::max(asked.most_spans, spans.size());
    asked.fewest_candidates = std::min(asked.fewest_candidates, candidates(spans));
  }
  return asked;
}

TEST(WideKernel, SeesMoreSpansThanItListsAtOnce) {
  const Scene scene = cube_scene(800, 4);
  EXPECT_GT(asked_by(scene).most_spans, 64u);
  EXPECT_LT(asked_by(scene).fewest_candidates, few_candidates[1]);
  EXPECT_EQ(first_difference(scene), "");
}

TEST(WideKernel, SeesSpansOverASeamThatAreListedInPieces) {
  const Scene scene = cube_scene(4000, 1);
  EXPECT_LT(asked_by(scene).most_spans, 64u);
  EXPECT_GT(asked_by(scene).fewest_candidates, few_candidates[1]);
  EXPECT_EQ(first_difference(scene), "");
}

TEST(WideKernel, RowsThatFilterAlikeShareAFilter) {
  FlockModel flock;
  for (const float outer : {1.0f, 4.0f, 4.0f}) {
    flock.rows.emplace_back();
    flock.rows.back().outer_squared = outer;
    flock.rows.back().flocks = 1;
  }
  EXPECT_EQ(wide_program(flock, 7)->filter_count, 2u);
  flock.rows[2].cos_half_view = 0;
  flock.rows[2].sees_all = false;
  EXPECT_EQ(wide_program(flock, 7)->filter_count, 3u);
  EXPECT_EQ(wide_program(flock, 6)->row_count, 2u);
}

TEST(WideKernel, LeavesSamplingAndVeryManyRowsToThePlainOne) {
  FlockModel flock;
  flock.rows.resize(WideProgram::most + 1);
  for (NeighbourRow& row : flock.rows) row.flocks = 1;
  EXPECT_FALSE(wide_program(flock, ~std::uint64_t{0}));
  flock.rows.resize(1);
  EXPECT_TRUE(wide_program(flock, ~std::uint64_t{0}));
  flock.rows[0].sample_below = 5;
  EXPECT_FALSE(wide_program(flock, ~std::uint64_t{0}));
}

TEST(UseIsa, RefusesWhatTheMachineLacksAndChangesNothingThen) {
  const IsaGuard guard;
  // No machine has both.
  EXPECT_FALSE(use_isa(Isa::sse4) && use_isa(Isa::neon));
  for (const NamedIsa& isa : wide_isas) {
    for (const Isa before : {Isa::plain, Isa::best}) {
      ASSERT_TRUE(use_isa(before));
      const std::string was = isa_in_use();
      if (use_isa(isa.isa)) {
        if (isa.isa != Isa::best) {
          EXPECT_EQ(isa_in_use(), isa.name);
        }
      } else {
        EXPECT_EQ(isa_in_use(), was) << isa.name;
      }
    }
  }
  ASSERT_TRUE(use_isa(Isa::plain));
  EXPECT_EQ(isa_in_use(), "plain");
}

}  // namespace
}  // namespace sturnus::test
