// Rules that meet: one scenario with everything switched on, for every index and every way of summing.
#include "everything.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "isas.h"
#include "neighbours/query.h"
#include "step/step.h"
#include "support.h"
#include "world/columns.h"

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
  // A plain sum over a ring that holds whole cells, and nothing that is seen over more than a third of the
  // space.
  scenario.flocks[4].cohesion = {{.weight = 0.01, .radius = 75, .inner = 10, .of = {Whose::Kind::all, {}}}};
  scenario.flocks[2].hunt->sight = 90;
  return scenario;
}

TEST(Everything, ReallyHappens) {
  for (const auto& [name, scenario] : everything_everywhere()) {
    Simulation simulation = start(scenario);
    simulation.run(100);
    const StepReport report = simulation.report();
    EXPECT_GT(report.eaten, 5u) << name;
    EXPECT_GT(report.born, 5u) << name;
    EXPECT_GT(report.starved, 0u) << name;
    EXPECT_EQ(report.quarantined, 0u) << name;
    EXPECT_EQ(report.commands_in_vain, 0u) << name;
    EXPECT_TRUE(all_finite(simulation.view().state())) << name;
  }
}

TEST(Everything, HasTheSameBitsOnAnyThreadsAndInstructionSet) {
  const IsaGuard guard;
  for (const auto& [name, scenario] : everything_everywhere()) {
    ASSERT_TRUE(use_isa(Isa::plain));
    Simulation plain = start(scenario);
    plain.run(60);
    for (const NamedIsa& isa : wide_isas) {
      if (!use_isa(isa.isa)) continue;
      for (const int threads : {1, 2, 3, 8}) {
        Simulation wide = start(scenario, threads);
        wide.run(60);
        EXPECT_EQ(wide.hash(), plain.hash()) << name << ", " << isa.name << ", " << threads << " threads";
      }
    }
  }
}

/// What an index of a kind makes of a state before anybody moves.
class Searched {
 public:
  Searched(IndexKind index, SumPath path, State state)
      : scenario_(searched(index, path)), model_(compile(scenario_)), state_(std::move(state)), workers_(1) {
    prepare(model_, scenario_, state_, scratch_, {}, workers_);
  }

  const State& state() const { return state_; }
  bool is_dense() const { return scratch_.passes.has_dense(); }
  IndexKind kind() const { return scratch_.indexed_as.kind; }
  std::size_t rows_of(std::size_t slot) const { return model_.flocks[state_.flock[slot]].rows.size(); }

  /// The sums of each row of a boid, as the step has them before it steers.
  std::vector<NeighbourSum> sums_of(std::size_t slot) {
    sum_around<2>(model_, state_, scratch_, slot, workers_);
    std::vector<NeighbourSum> out;
    for (std::size_t row = 0; row < rows_of(slot); ++row)
      out.push_back(scratch_.parts.front().sums.at(row, slot));
    return out;
  }

  /// The ids of all whom the index finds within a radius of a boid.
  std::set<std::uint64_t> near(std::size_t slot, float radius) const {
    const Neighbourhood among{scratch_.index.get(), cloud_of(model_, state_), image_of(model_), state_.id};
    std::set<std::uint64_t> out;
    std::vector<Span> spans;
    visit<2>(among, at<2>(state_.position, slot), radius, spans,
             [&](std::uint32_t other, float) { out.insert(state_.id[other]); });
    return out;
  }

  /// Pairs of a batch and cells that come whole in the ring of a dense row.
  std::size_t whole_cells() {
    std::vector<Span> batches;
    scratch_.index->batches(batches);
    std::size_t count = 0;
    for (const SumPass& pass : scratch_.passes.all()) {
      for (const Span batch : batches) {
        if (!pass.is_dense) continue;
        const Box box = box_of(batch);
        RingParts parts;
        scratch_.index->ring(box.low, box.high, pass.inner, pass.reach, parts);
        count += parts.whole.size();
      }
    }
    return count;
  }

  float reach() const { return model_.reach; }

 private:
  Box box_of(Span batch) const {
    Box box;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto begin = state_.position[axis].begin();
      const auto [low, high] = std::minmax_element(begin + batch.begin, begin + batch.end);
      box.low[axis] = *low;
      box.high[axis] = *high;
    }
    return box;
  }

  ScenarioDef scenario_;
  Model model_;
  State state_;
  Scratch scratch_;
  Workers workers_;
};

/// Slots of a state by id.
std::map<std::uint64_t, std::size_t> slots_of(const State& state) {
  std::map<std::uint64_t, std::size_t> out;
  for (std::size_t i = 0; i < state.size(); ++i) out[state.id[i]] = i;
  return out;
}

/// Who is within a radius, asking everybody, by the shortest way on each axis.
std::set<std::uint64_t> near_by_hand(const State& state, std::size_t slot, double radius) {
  std::set<std::uint64_t> out;
  for (std::size_t i = 0; i < state.size(); ++i) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size = axis == 0 ? 400 : 300;
      const double o = std::abs(double{state.position[axis][i]} - double{state.position[axis][slot]});
      squared += std::min(o, size - o) * std::min(o, size - o);
    }
    if (squared < radius * radius) out.insert(state.id[i]);
  }
  return out;
}

TEST(Everything, FindsTheSameNeighboursWithEveryIndex) {
  const State state = later();
  for (const IndexKind kind : {IndexKind::all_pairs, IndexKind::grid, IndexKind::tree}) {
    const Searched searched(kind, SumPath::dense, state);
    ASSERT_EQ(searched.kind(), kind) << "the index falls back on another";
    std::size_t found = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      for (const float radius : {9.7f, 31.3f, 0.99f * searched.reach()}) {
        const auto near = searched.near(i, radius);
        ASSERT_EQ(near, near_by_hand(searched.state(), i, double{radius})) << "boid " << i;
        found += near.size();
      }
    }
    EXPECT_GT(found, 1000u);
  }
}

TEST(Everything, SumsTheSameWithEveryIndexAndPath) {
  const State state = later();
  Searched known(IndexKind::all_pairs, SumPath::sparse, state);
  const auto known_slots = slots_of(known.state());
  EXPECT_FALSE(known.is_dense());
  for (const IndexKind index : {IndexKind::all_pairs, IndexKind::grid, IndexKind::tree}) {
    for (const SumPath path : {SumPath::sparse, SumPath::dense}) {
      Searched other(index, path, state);
      EXPECT_EQ(other.is_dense(), path == SumPath::dense);
      const bool takes_cells = index == IndexKind::grid && path == SumPath::dense;
      if (takes_cells) {
        EXPECT_GT(other.whole_cells(), 8u) << "nobody comes in a whole cell";
      }
      std::size_t counted = 0;
      for (const auto& [id, slot] : slots_of(other.state())) {
        const auto one = known.sums_of(known_slots.at(id)), two = other.sums_of(slot);
        ASSERT_EQ(one.size(), two.size());
        for (std::size_t row = 0; row < one.size(); ++row) {
          ASSERT_EQ(one[row].count, two[row].count) << "boid " << id << ", row " << row;
          counted += one[row].count;
          for (std::size_t axis = 0; axis < 2; ++axis) {
            const double value = double{one[row].value[axis]};
            const double room = 1e-5 * (1 + std::abs(value) + one[row].count);
            ASSERT_NEAR(value, double{two[row].value[axis]}, room) << "boid " << id << ", row " << row;
          }
        }
      }
      EXPECT_GT(counted, 1000u);
    }
  }
}

}  // namespace
}  // namespace sturnus::test
