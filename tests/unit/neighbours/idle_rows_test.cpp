// Rows that look at nobody who is near: which they are, and what is left of a program without them.
#include <gtest/gtest.h>

#include "base/workers.h"
#include "neighbours/wide.h"

namespace sturnus {
namespace {

constexpr std::uint64_t own = 1, hunters = 2;

NeighbourRow row(Quantity quantity, float outer_squared, std::uint64_t flocks) {
  NeighbourRow out;
  out.quantity = quantity;
  out.outer_squared = outer_squared;
  out.flocks = flocks;
  return out;
}

/// Three rows among the own and one of flight in between.
WideProgram program_with_flight() {
  FlockModel flock;
  flock.rows = {row(Quantity::offset, 25, own), row(Quantity::offset, 81, hunters),
                row(Quantity::velocity, 100, own), row(Quantity::offset, 100, own)};
  return *wide_program(flock, 0b1111);
}

TEST(IdleRows, AreThoseThatLookAtNobodyNear) {
  EXPECT_TRUE(has_idle_rows(program_with_flight(), own));
  EXPECT_TRUE(has_idle_rows(program_with_flight(), hunters));
  EXPECT_FALSE(has_idle_rows(program_with_flight(), own | hunters));
}

TEST(IdleRows, BecomeNobodysSumsAndTheOthersKeepTheirFilters) {
  const WideProgram full = program_with_flight();
  const WideProgram left = without_idle_rows(full, own);
  EXPECT_EQ(left.empty_rows, full.empty_rows | 0b10u);
  ASSERT_EQ(left.row_count, 3u);
  ASSERT_EQ(left.filter_count, 2u);
  FlockModel alone;
  alone.rows = {row(Quantity::offset, 25, own), row(Quantity::offset, 81, 0),
                row(Quantity::velocity, 100, own), row(Quantity::offset, 100, own)};
  const WideProgram wanted = *wide_program(alone, 0b1111);
  EXPECT_TRUE(same_shape(left, wanted));
  for (std::size_t f = 0; f < 2; ++f) EXPECT_EQ(left.filters[f], wanted.filters[f]) << f;
}

TEST(Stretches, TellTheFlocksOfAnyRange) {
  std::vector<std::uint8_t> flock(100, 0), hidden(100, 0);
  flock[40] = 1;
  flock[99] = 2;
  hidden[99] = 1;
  Boids boids;
  boids.count = flock.size();
  boids.flock = flock.data();
  boids.hidden = hidden.data();
  boids.flocks = 7;
  EXPECT_EQ(boids.flocks_in(0, 5), 7u) << "nobody has looked yet";
  std::vector<Stretch> stretches;
  find_stretches(boids, Workers(2), stretches);
  boids.stretches = stretches.data();
  EXPECT_EQ(boids.flocks_in(0, 32), 1u);
  EXPECT_EQ(boids.flocks_in(0, 100), 3u) << "the hidden belong to no flock";
  EXPECT_EQ(boids.flocks_in(33, 34), 3u) << "one beside may count";
  EXPECT_EQ(boids.flocks_in(48, 100), 1u);
}

}  // namespace
}  // namespace sturnus
