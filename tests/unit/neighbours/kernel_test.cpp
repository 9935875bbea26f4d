// The sums over neighbours: sampling, population totals, and sources that are not targets.
#include "neighbours/passes.h"

#include <gtest/gtest.h>

#include <set>

#include "support.h"

namespace sturnus::test {
namespace {

/// Boids with everything that the kernel asks for.
struct Crowd {
  Columns position, velocity;
  std::vector<std::uint64_t> id;
  std::vector<std::uint8_t> flock, hidden;

  void add(float x, float y, std::uint64_t own_id, std::uint8_t own_flock = 0) {
    position[0].push_back(x);
    position[1].push_back(y);
    velocity[0].push_back(x + 1);
    velocity[1].push_back(2 * y);
    id.push_back(own_id);
    flock.push_back(own_flock);
    hidden.push_back(0);
  }
  Boids boids() const {
    Boids out;
    out.count = id.size();
    out.position = {position[0].data(), position[1].data(), nullptr};
    out.velocity = {velocity[0].data(), velocity[1].data(), nullptr};
    out.id = id.data();
    out.flock = flock.data();
    out.hidden = hidden.data();
    out.flocks = 3;
    return out;
  }
  Cloud cloud() const {
    Cloud out;
    out.count = id.size();
    out.position = boids().position;
    out.hidden = hidden.data();
    out.min = {-1000, -1000, 0};
    out.max = {1000, 1000, 0};
    return out;
  }
};

Model model_with(const NeighbourRow& row) {
  Model model;
  model.seed = 5;
  model.flocks.resize(1);
  model.flocks[0].rows = {row};
  model.flocks[0].reach_squared = row.outer_squared;
  model.most_rows = 1;
  model.uses_totals = row.whole_population;
  return model;
}

NeighbourRow ring(float outer) {
  NeighbourRow row;
  row.outer_squared = outer * outer;
  row.flocks = 1;
  return row;
}

std::vector<NeighbourSum> sums_of(const Model& model, const Crowd& targets, const Crowd& sources,
                                  std::span<const Totals> totals = {}, std::uint64_t step = 0) {
  const auto index = make_all_pairs();
  std::vector<std::uint32_t> order;
  index->build(sources.cloud(), 1, Workers(1), order);
  Passes passes;
  passes.plan(model, false);
  KernelScratch scratch;
  SumBlock block;
  block.fit(1, 0, targets.id.size());
  const NeighbourQuestion question{&model, index.get(), {}, totals, step, &passes};
  std::vector<Span> batches;
  cut(0, static_cast<std::uint32_t>(targets.id.size()), batches);
  neighbour_sums<2>(targets.boids(), batches, sources.boids(), question, scratch, block);
  std::vector<NeighbourSum> sums;
  for (std::size_t i = 0; i < targets.id.size(); ++i) {
    // What hidden boids sum means nothing.
    sums.push_back(targets.hidden[i] == 0 ? block.at(0, i) : NeighbourSum{});
  }
  return sums;
}

TEST(NeighbourSums, SourcesNeedNotBeTargets) {
  Crowd target, sources;
  target.add(0, 0, 7);
  sources.add(3, 4, 1);
  sources.add(0, 0, 7);  // itself, by its id
  sources.add(-1, 0, 2);
  const NeighbourSum sum = sums_of(model_with(ring(10)), target, sources).front();
  EXPECT_EQ(sum.count, 2u);
  EXPECT_EQ(sum.value, (std::array<float, 3>{2, 4, 0}));
}

TEST(NeighbourSums, NobodySeesTheHidden) {
  Crowd crowd;
  crowd.add(0, 0, 0);
  crowd.add(1, 0, 1);
  crowd.add(2, 0, 2);
  crowd.hidden[1] = 1;
  const auto sums = sums_of(model_with(ring(10)), crowd, crowd);
  EXPECT_EQ(sums[0].count, 1u);
  EXPECT_EQ(sums[0].value[0], 2);
}

Crowd disc(std::size_t count) {
  Crowd crowd;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.399963 * static_cast<double>(i);
    const double r = 5 * std::sqrt(static_cast<double>(i) / static_cast<double>(count));
    crowd.add(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), i);
  }
  return crowd;
}

TEST(Sampling, LooksAtAboutTheShareThatIsAsked) {
  const Crowd crowd = disc(400);
  for (const double share : {0.05, 0.25, 0.5, 0.9}) {
    NeighbourRow row = ring(100);
    row.sample_below = static_cast<std::uint32_t>(share * 4294967296.0);
    double seen = 0;
    for (const NeighbourSum& sum : sums_of(model_with(row), crowd, crowd)) seen += sum.count;
    const double pairs = 400.0 * 399.0;
    EXPECT_NEAR(seen / pairs, share, 5 * std::sqrt(share * (1 - share) / pairs));
  }
}

TEST(Sampling, SumAndCountAreOfTheSameSurvivors) {
  const Crowd crowd = disc(100);
  NeighbourRow row = ring(100);
  row.quantity = Quantity::velocity;
  row.sample_below = 1u << 31;
  Crowd still = crowd;
  std::fill(still.velocity[0].begin(), still.velocity[0].end(), 1.0f);
  for (const NeighbourSum& sum : sums_of(model_with(row), still, still)) {
    EXPECT_EQ(sum.value[0], static_cast<float>(sum.count));
  }
}

TEST(Sampling, ChangesWithStepSeedAndBoid) {
  const Crowd crowd = disc(64);
  NeighbourRow row = ring(100);
  row.sample_below = 1u << 31;
  Model model = model_with(row);
  const auto picture = [&](std::uint64_t step) {
    std::vector<float> all;
    for (const NeighbourSum& sum : sums_of(model, crowd, crowd, {}, step)) all.push_back(sum.value[0]);
    return all;
  };
  const auto first = picture(1);
  EXPECT_EQ(picture(1), first);
  EXPECT_NE(picture(2), first);
  model.seed = 6;
  const auto other_seed = picture(1);
  EXPECT_NE(other_seed, first);
  model.seed = 5;
  EXPECT_NE(picture(2), other_seed);  // the seed is not just a shift of the steps
}

TEST(PopulationTotals, AreTheSumsOfEveryFlockForAnyThreadCount) {
  Crowd crowd;
  for (std::uint64_t i = 0; i < 10000; ++i) {
    crowd.add(static_cast<float>(i) * 0.37f, static_cast<float>(i % 101), i,
              static_cast<std::uint8_t>(i % 3));
  }
  crowd.hidden[4] = 1;
  std::vector<Totals> parts, one, eight;
  population_totals<2>(crowd.boids(), 3, Workers(1), parts, one);
  population_totals<2>(crowd.boids(), 3, Workers(8), parts, eight);
  double count = 0, x = 0;
  for (std::size_t i = 0; i < 10000; ++i) {
    if (i == 4 || i % 3 != 1) continue;
    count += 1;
    x += double{crowd.position[0][i]};
  }
  EXPECT_EQ(one[1].count, count);
  EXPECT_NEAR(one[1].position[0], x, 1e-9 * x);
  for (std::size_t flock = 0; flock < 3; ++flock) {
    EXPECT_EQ(one[flock].position, eight[flock].position);
    EXPECT_EQ(one[flock].velocity, eight[flock].velocity);
  }
}

TEST(WholePopulation, IsTheTotalsMinusOneself) {
  const Crowd crowd = disc(50);
  std::vector<Totals> parts, totals;
  population_totals<2>(crowd.boids(), 1, Workers(1), parts, totals);
  for (const Quantity quantity : {Quantity::offset, Quantity::velocity}) {
    NeighbourRow whole;
    whole.whole_population = true;
    whole.flocks = 1;
    whole.quantity = quantity;
    NeighbourRow wide = ring(1e6f);
    wide.quantity = quantity;
    const auto by_totals = sums_of(model_with(whole), crowd, crowd, totals);
    const auto by_pairs = sums_of(model_with(wide), crowd, crowd);
    for (std::size_t i = 0; i < 50; ++i) {
      EXPECT_EQ(by_totals[i].count, 49u);
      EXPECT_EQ(by_pairs[i].count, 49u);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(by_totals[i].value[axis], by_pairs[i].value[axis], 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace sturnus::test
