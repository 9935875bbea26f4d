// A step allocates nothing: after a few steps all working memory is there and is used again. The global
// operator new is replaced to count, so this is an executable of its own.
#include <gtest/gtest.h>

#include <sturnus/files.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <ostream>

#include "support.h"

namespace {

std::atomic<bool> is_counting = false;
std::atomic<std::size_t> count = 0;

void* counted_memory(std::size_t size, std::size_t alignment) {
  if (is_counting) ++count;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory =
      alignment > alignof(std::max_align_t) ? std::aligned_alloc(alignment, whole) : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The other forms of new and delete that the standard library has call these.
void* operator new(std::size_t size) {
  return counted_memory(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted_memory(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace sturnus::test {
namespace {

/// A shipped scenario with some parameters set.
struct Case {
  const char* name;
  const char* scenario;
  std::vector<std::pair<const char*, const char*>> changes;
};

// For GoogleTest, which would print bytes.
void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

const std::vector<Case> cases = {
    {"Bench2d", "bench-2d", {}},
    {"Bench3d", "bench-3d", {}},
    {"Quadtree", "bench-2d", {{"index.kind", "tree"}}},
    {"Octree", "bench-3d", {{"index.kind", "tree"}}},
    {"AllPairs", "bench-2d", {{"index.kind", "all-pairs"}, {"flock.boids.count", "500"}}},
    {"Sparse", "bench-2d", {{"index.path", "sparse"}}},
    {"Dense2d", "bench-2d", {{"index.path", "dense"}}},
    {"Dense3d", "bench-3d", {{"index.path", "dense"}}},
    {"SeveralFlocks", "two-flocks", {}},
    {"Colours", "cs184", {}},
    {"WholePopulation", "prog06", {}},
    {"FieldOfView", "quadtree", {}},
    {"MarginsThatTurn", "ucsd", {}},
    {"Wander", "murmuration", {}},
    {"SolidObstacles", "vuw-challenge", {}},
    {"ObstaclesAllRound", "cs184-bordered", {}},
    {"HuntersOfManyKinds", "cs184-feeding-frenzy", {}},
    {"HawksInSpace", "hawk-and-starlings", {}},
    {"Living2d", "bench-living-2d", {}},
    {"Living3d", "bench-living-3d", {}},
};

std::size_t allocations_of_a_step(const Case& one, int threads) {
  ScenarioDef scenario = take(load_scenario(one.scenario));
  for (const auto& [key, value] : one.changes) set(scenario, key, value);
  Simulation simulation = start(scenario, threads);
  simulation.run(60);  // what grows with the densest place has grown
  count = 0;
  is_counting = true;
  for (int step = 0; step < 10; ++step) simulation.step();
  is_counting = false;
  return count;
}

class StepAllocations : public testing::TestWithParam<std::tuple<Case, int>> {};

TEST_P(StepAllocations, AreNone) {
  const auto& [one, threads] = GetParam();
  EXPECT_EQ(allocations_of_a_step(one, threads), 0u) << "in 10 steps of " << one.scenario;
}

std::string name_of(const testing::TestParamInfo<std::tuple<Case, int>>& test) {
  return std::string(std::get<0>(test.param).name) +
         (std::get<1>(test.param) == 1 ? "OnOneThread" : "OnTwoThreads");
}

INSTANTIATE_TEST_SUITE_P(Of, StepAllocations,
                         testing::Combine(testing::ValuesIn(cases), testing::Values(1, 2)), name_of);

/// A sea that grows from few fish, who are searched one by one, to so many that a grid pays.
ScenarioDef growing_sea() {
  ScenarioDef scenario = take(load_scenario("sharks-and-fish"));
  for (const auto& [key, value] :
       std::vector<std::pair<const char*, const char*>>{{"flock.fish.count", "60"},
                                                        {"flock.fish.feed.population_cap", "500"},
                                                        {"flock.sharks.count", "8"},
                                                        {"flock.sharks.hunger.full_for", "20"},
                                                        {"flock.sharks.hunger.starves_after", "150"},
                                                        {"food.plankton.count", "60"},
                                                        {"food.plankton.random.every", "1"},
                                                        {"food.plankton.random.count", "6"}})
    set(scenario, key, value);
  return scenario;
}

class GrowingSea : public testing::TestWithParam<int> {};

TEST_P(GrowingSea, AllocatesNothingWhileBoidsAreBornAndDie) {
  Simulation sea = start(growing_sea(), GetParam());
  sea.run(5);
  ASSERT_LT(sea.view().size(), 120u);
  const StepReport before = sea.report();
  std::size_t steps_with_births = 0;
  for (int step = 0; step < 400; ++step) {
    const std::size_t born = sea.report().born;
    count = 0;
    is_counting = true;
    sea.step();
    is_counting = false;
    ASSERT_EQ(count, 0u) << "step " << step << ", " << sea.view().size() << " boids";
    steps_with_births += sea.report().born > born ? 1 : 0;
  }
  const StepReport after = sea.report();
  EXPECT_GT(steps_with_births, 100u);
  EXPECT_GT(after.eaten, before.eaten + 3);
  EXPECT_GT(after.starved, before.starved + 3);
  EXPECT_GT(after.births_refused, before.births_refused) << "it reached its cap";
  EXPECT_GT(sea.view().size(), 450u);
}

INSTANTIATE_TEST_SUITE_P(On, GrowingSea, testing::Values(1, 2));

TEST(Allocations, AreCounted) {
  count = 0;
  is_counting = true;
  const std::vector<float> memory(1000, 1.0f);
  is_counting = false;
  EXPECT_EQ(count, 1u);
  EXPECT_EQ(memory.back(), 1.0f);
}

}  // namespace
}  // namespace sturnus::test
