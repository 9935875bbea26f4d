// The same bits from every kernel: small worlds with one option after the other, on each instruction set and
// for several thread counts, step by step beside the plain loop on one thread.
#include <gtest/gtest.h>

#include <tuple>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

constexpr NamedIsa every_isa[] = {{Isa::plain, "plain"}, {Isa::best, "best"},     {Isa::sse4, "sse4"},
                                  {Isa::avx2, "avx2"},   {Isa::avx512, "avx512"}, {Isa::neon, "neon"}};

ScenarioDef shipped(const std::string& name, std::int64_t count) {
  for (const ShippedScenario& one : shipped_scenarios()) {
    if (one.name != name) continue;
    ScenarioDef scenario = take(parse_scenario(one.text, one.name));
    scenario.flocks.front().count = count;
    return scenario;
  }
  throw std::runtime_error("no scenario " + name);
}

/// Many boids within a few reaches of one another, in a space that is far larger.
ScenarioDef clump(const char* base, std::int64_t count, double radius) {
  ScenarioDef scenario = shipped(base, count);
  FlockDef& flock = scenario.flocks.front();
  flock.start.region = StartRegion::ball;
  flock.start.radius = radius;
  scenario.space.per_boid = scenario.space.dimensions == 3 ? 4000 : 400;
  return scenario;
}

ScenarioDef dense(ScenarioDef scenario) {
  scenario.index.path = SumPath::dense;
  return scenario;
}

void add_like_the_first(ScenarioDef& scenario, const std::string& name) {
  scenario.flocks.push_back(scenario.flocks.front());
  scenario.flocks.back().name = name;
}

/// Three flocks whose terms differ in number, kind and reach, each with an eye on other flocks than its own.
ScenarioDef three_flocks(ScenarioDef scenario) {
  scenario.flocks.front().name = "starlings";
  add_like_the_first(scenario, "rooks");
  add_like_the_first(scenario, "hawks");
  FlockDef& rooks = scenario.flocks[1];
  rooks.alignment.clear();
  rooks.separation.front().of = {Whose::Kind::named, {"hawks", "rooks"}};
  rooks.cohesion.front().radius *= 0.8;
  FlockDef& hawks = scenario.flocks[2];
  hawks.count /= 8;
  hawks.cohesion.front().of = {Whose::Kind::named, {"starlings"}};
  hawks.alignment.front().match = Match::heading;
  scenario.flocks.front().flee = {{.from = {"hawks"}, .radius = 8}};
  return scenario;
}

struct World {
  const char* name;
  ScenarioDef (*make)(std::int64_t count);
};

template <void (*change)(ScenarioDef&, FlockDef&)>
ScenarioDef bench_with(std::int64_t count) {
  ScenarioDef scenario = shipped("bench-2d", count);
  change(scenario, scenario.flocks.front());
  return scenario;
}

void headings(ScenarioDef&, FlockDef& flock) {
  flock.alignment.front().match = Match::heading;
  flock.alignment.push_back({.weight = 0.02, .match = Match::heading, .relative = false, .count_self = true});
}
void colours(ScenarioDef&, FlockDef& flock) {
  flock.colour = {"random", 0.2, 0.05, {Whose::Kind::all, {}}};
}
void noise(ScenarioDef&, FlockDef& flock) {
  flock.noise = Noise{.acceleration = 0.1};
}
void random_turns(ScenarioDef&, FlockDef& flock) {
  flock.noise = Noise{.acceleration = 0.1, .turn = 20};
}
void wander(ScenarioDef&, FlockDef& flock) {
  flock.wander = Wander{};
}
void turn(ScenarioDef& scenario, FlockDef& flock) {
  scenario.space.boundary = {BoundaryKind::turn, {20}, 0.3};
  flock.cruise = Cruise{};
}
void bounce(ScenarioDef& scenario, FlockDef& flock) {
  scenario.space.boundary.kind = BoundaryKind::bounce;
  flock.max_speed = 40;
  flock.min_speed = 30;
}
void open_space(ScenarioDef& scenario, FlockDef& flock) {
  scenario.space.boundary.kind = BoundaryKind::open;
  flock.cohesion.push_back({.weight = 0.01, .radius = infinity});
}
void budget(ScenarioDef&, FlockDef& flock) {
  flock.arbitration = Arbitration::budget;
  flock.cohesion.front().priority = 2;
}
void first(ScenarioDef&, FlockDef& flock) {
  flock.arbitration = Arbitration::first;
}
void views(ScenarioDef&, FlockDef& flock) {
  flock.field_of_view = 250;
  flock.cohesion.front().field_of_view = 90;
}
void rings(ScenarioDef&, FlockDef& flock) {
  flock.alignment.front().inner = 3;
  flock.cohesion.front().inner = 5;
  flock.cohesion.front().edge = Edge::closed;
}
void strengths(ScenarioDef&, FlockDef& flock) {
  flock.separation = {{.strength = Strength::constant}, {.radius = 3, .strength = Strength::grows}};
  flock.cohesion = {{.strength = Strength::fades}, {.combine = Combine::sum, .count_self = true}};
}
void sampled(ScenarioDef&, FlockDef& flock) {
  flock.cohesion.front().sample = 0.4;
}
void many_rows(ScenarioDef& scenario, FlockDef& flock) {
  flock.cohesion.assign(11, {.weight = 0.001, .radius = 10});
  scenario.index.path = SumPath::dense;
}
void explicit_steps(ScenarioDef& scenario, FlockDef&) {
  scenario.time = {0.3, Integrator::explicit_euler};
}
void tree(ScenarioDef& scenario, FlockDef&) {
  scenario.index.kind = IndexKind::tree;
}
void all_pairs(ScenarioDef& scenario, FlockDef&) {
  scenario.index.kind = IndexKind::all_pairs;
}

const World every_world[] = {
    {"Bench2D", [](std::int64_t n) { return shipped("bench-2d", n); }},
    {"Bench3D", [](std::int64_t n) { return shipped("bench-3d", n); }},
    {"RingsOfThree", [](std::int64_t n) { return shipped("cs184", n); }},
    {"ThreeFlocks", [](std::int64_t n) { return three_flocks(shipped("bench-2d", n / 2)); }},
    {"ThreeFlocksInAClump", [](std::int64_t n) { return three_flocks(clump("bench-2d", n / 2, 20)); }},
    {"ThreeDenseFlocks", [](std::int64_t n) { return three_flocks(dense(clump("bench-2d", n / 2, 20))); }},
    {"DenseClump2D", [](std::int64_t n) { return dense(clump("bench-2d", n, 22)); }},
    {"DenseClump3D", [](std::int64_t n) { return dense(clump("bench-3d", n, 16)); }},
    {"DenseEverywhere", [](std::int64_t n) { return dense(shipped("cs184", n)); }},
    {"ClumpInTheTree",
     [](std::int64_t n) {
       ScenarioDef scenario = clump("bench-3d", n, 16);
       scenario.index.kind = IndexKind::tree;
       return scenario;
     }},
    {"Headings", bench_with<headings>},
    {"Colours", bench_with<colours>},
    {"Noise", bench_with<noise>},
    {"RandomTurns", bench_with<random_turns>},
    {"Wander", bench_with<wander>},
    {"Turn", bench_with<turn>},
    {"Bounce", bench_with<bounce>},
    {"OpenSpace", bench_with<open_space>},
    {"Budget", bench_with<budget>},
    {"First", bench_with<first>},
    {"Views", bench_with<views>},
    {"Rings", bench_with<rings>},
    {"Strengths", bench_with<strengths>},
    {"Sampled", bench_with<sampled>},
    {"ManyRows", bench_with<many_rows>},
    {"ExplicitSteps", bench_with<explicit_steps>},
    {"Tree", bench_with<tree>},
    {"AllPairs", bench_with<all_pairs>},
};

/// For the names of the tests.
void PrintTo(const World& world, std::ostream* out) {
  *out << world.name;
}

class Kernels : public testing::TestWithParam<std::tuple<World, NamedIsa>> {
 protected:
  void run_beside_the_plain_loop(std::int64_t count, int steps) {
    const auto& [world, isa] = GetParam();
    const IsaGuard guard;
    if (!use_isa(isa.isa)) GTEST_SKIP() << "this machine has no " << isa.name;
    const ScenarioDef scenario = world.make(count);
    Simulation plain = start(scenario);
    std::vector<Simulation> worlds;
    for (const int threads : {1, 2, 3, 8}) worlds.push_back(start(scenario, threads));
    for (int step = 1; step <= steps; ++step) {
      ASSERT_TRUE(use_isa(Isa::plain));
      plain.step();
      ASSERT_TRUE(use_isa(isa.isa));
      for (Simulation& wide : worlds) {
        wide.step();
        ASSERT_EQ(wide.hash(), plain.hash()) << "step " << step << ", " << wide.threads() << " threads";
      }
    }
  }
};

class FullKernels : public Kernels {};

TEST_P(Kernels, GiveTheBitsOfThePlainLoop) {
  run_beside_the_plain_loop(1000, 8);
}
TEST_P(FullKernels, GiveTheBitsOfThePlainLoop) {
  run_beside_the_plain_loop(3000, 20);
}

std::string name_of(const testing::TestParamInfo<Kernels::ParamType>& info) {
  return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name;
}
const auto product = testing::Combine(testing::ValuesIn(every_world), testing::ValuesIn(every_isa));
INSTANTIATE_TEST_SUITE_P(EachOption, Kernels, product, name_of);
INSTANTIATE_TEST_SUITE_P(Full, FullKernels, product, name_of);

/// The hash after some steps; with garbage in the working memory before each, where that is wanted.
std::uint64_t hash_after(const ScenarioDef& scenario, bool with_garbage = false, int threads = 2) {
  Simulation simulation = start(scenario, threads);
  for (int step = 0; step < 6; ++step) {
    if (with_garbage) simulation.poison_scratch();
    simulation.step();
  }
  return simulation.hash();
}

ScenarioDef on_path(ScenarioDef scenario, SumPath path) {
  scenario.index.path = path;
  return scenario;
}

TEST(Garbage, InTheWorkingMemoryChangesNoBitOfAnyPath) {
  for (const World& world : every_world) {
    const ScenarioDef scenario = world.make(700);
    for (const int threads : {1, 3})
      EXPECT_EQ(hash_after(scenario, true, threads), hash_after(scenario, false, threads)) << world.name;
  }
}

TEST(AutomaticPath, IsDenseInAClump) {
  for (const ScenarioDef& scenario : {clump("bench-2d", 4000, 22), clump("bench-3d", 8000, 12)}) {
    const std::uint64_t dense_hash = hash_after(on_path(scenario, SumPath::dense));
    EXPECT_EQ(hash_after(scenario), dense_hash);
    EXPECT_NE(hash_after(on_path(scenario, SumPath::sparse)), dense_hash) << "the paths can't be told apart";
  }
}

// All stand within a fraction of the largest radius, and a much smaller one still holds hundreds of them.
TEST(AutomaticPath, SeesHowCrowdedASmallRadiusIsInAClump) {
  for (const char* base : {"bench-2d", "bench-3d"}) {
    ScenarioDef scenario = clump(base, 6000, 2.5);
    FlockDef& flock = scenario.flocks.front();
    flock.start.min_speed = flock.min_speed = 0.001;
    flock.start.max_speed = flock.max_speed = 0.002;
    flock.separation[0].strength = Strength::grows;
    flock.separation[0].radius = flock.cohesion[0].radius / 5;
    const std::uint64_t dense_hash = hash_after(on_path(scenario, SumPath::dense));
    EXPECT_EQ(hash_after(scenario), dense_hash) << base;
    EXPECT_NE(hash_after(on_path(scenario, SumPath::sparse)), dense_hash) << "the paths can't be told apart";
  }
}

TEST(AutomaticPath, IsSparseWhereBoidsStandEvenly) {
  for (const char* name : {"bench-2d", "bench-3d"}) {
    const ScenarioDef scenario = shipped(name, 3000);
    const std::uint64_t sparse_hash = hash_after(on_path(scenario, SumPath::sparse));
    EXPECT_EQ(hash_after(scenario), sparse_hash);
    EXPECT_NE(hash_after(on_path(scenario, SumPath::dense)), sparse_hash) << "the paths can't be told apart";
  }
}

}  // namespace
}  // namespace sturnus::test
