// Rules that meet: one scenario with everything switched on, for every index and every way of summing.
#include "everything.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef with_everything() {
  return take(parse_scenario(everything, "everything"));
}

// A world in the thick of it: all events done, boids eaten and born.
State later() {
  Simulation simulation = start(with_everything());
  simulation.run(40);
  return simulation.view().state();
}

ScenarioDef searched(IndexKind index, SumPath path) {
  ScenarioDef scenario = with_everything();
  scenario.run.events.clear();
  scenario.index.kind = index;
  scenario.index.path = path;
  return scenario;
}

TEST(Everything, ReallyHappens) {
  Simulation simulation = start(with_everything());
  simulation.run(100);
  const StepReport report = simulation.report();
  EXPECT_GT(report.eaten, 5u);
  EXPECT_GT(report.born, 5u);
  EXPECT_GT(report.starved, 0u);
  EXPECT_EQ(report.quarantined, 0u);
  EXPECT_EQ(report.commands_in_vain, 0u);
  EXPECT_TRUE(all_finite(simulation.view().state()));
}

TEST(Everything, HasTheSameBitsOnAnyThreadsAndInstructionSet) {
  const IsaGuard guard;
  ASSERT_TRUE(use_isa(Isa::plain));
  Simulation plain = start(with_everything());
  plain.run(60);
  for (const NamedIsa& isa : wide_isas) {
    if (!use_isa(isa.isa)) continue;
    for (const int threads : {1, 2, 3, 8}) {
      Simulation wide = start(with_everything(), threads);
      wide.run(60);
      EXPECT_EQ(wide.hash(), plain.hash()) << isa.name << ", " << threads << " threads";
    }
  }
}

// Whom each term of each boid counts, by id.
std::vector<std::vector<std::uint64_t>> counted(const Simulation& simulation) {
  std::vector<std::vector<std::uint64_t>> out;
  for (const std::uint32_t slot : simulation.view().slots_by_id()) {
    const auto told = simulation.explain(simulation.view().id(slot));
    if (!told) continue;
    for (std::size_t term = 0; term < told->terms.size(); ++term) {
      std::vector<std::uint64_t>& ids = out.emplace_back();
      for (const ExplainedNeighbour& other : told->neighbours) {
        if (std::find(other.terms.begin(), other.terms.end(), term) != other.terms.end())
          ids.push_back(other.id);
      }
    }
  }
  return out;
}

TEST(Everything, FindsTheSameNeighboursWithEveryIndex) {
  const State state = later();
  const auto known = counted(world_from(searched(IndexKind::all_pairs, SumPath::sparse), state));
  EXPECT_GT(known.size(), 1000u);
  for (const IndexKind index : {IndexKind::grid, IndexKind::tree})
    EXPECT_EQ(counted(world_from(searched(index, SumPath::sparse), state)), known);
}

TEST(Everything, FeelsTheSameWithEveryIndexAndPath) {
  const State state = later();
  Simulation known = world_from(searched(IndexKind::all_pairs, SumPath::sparse), state);
  known.step();
  for (const IndexKind index : {IndexKind::all_pairs, IndexKind::grid, IndexKind::tree}) {
    for (const SumPath path : {SumPath::sparse, SumPath::dense, SumPath::automatic}) {
      Simulation other = world_from(searched(index, path), state);
      other.step();
      ASSERT_EQ(other.view().size(), known.view().size());
      for (const std::uint32_t slot : known.view().slots_by_id()) {
        const std::uint64_t id = known.view().id(slot);
        ASSERT_TRUE(other.view().slot(id)) << id;
        EXPECT_LT(distance(velocity_of(other, id), velocity_of(known, id)), 1e-5) << "boid " << id;
      }
    }
  }
}

}  // namespace
}  // namespace sturnus::test
