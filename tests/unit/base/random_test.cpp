// Random numbers: Philox's published answers, the layout of its counter, and what the draws look like.
#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sturnus {
namespace {

using Block = r123::Philox4x32::ctr_type;
using Key = r123::Philox4x32::key_type;

// From Random123's file of known answers (kat_vectors), philox4x32 with 10 rounds.
TEST(Philox, GivesThePublishedAnswers) {
  const r123::Philox4x32 philox;
  EXPECT_EQ(philox(Block{{0, 0, 0, 0}}, Key{{0, 0}}),
            (Block{{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox(Block{{ones, ones, ones, ones}}, Key{{ones, ones}}),
            (Block{{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}}));
  EXPECT_EQ(philox(Block{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}}, Key{{0xa4093822, 0x299f31d0}}),
            (Block{{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}));
}

TEST(Draws, BeginWithThePublishedBlock) {
  Draws draws(0, 0, 0, Stream::start_position);
  EXPECT_EQ(draws.bits(), 0x6627e8d5u);
  EXPECT_EQ(draws.bits(), 0xe169c58du);
  EXPECT_EQ(draws.bits(), 0xbc57ac4cu);
  EXPECT_EQ(draws.bits(), 0x9b00dbd8u);
}

TEST(Draws, PutSeedStepIdAndStreamIntoKeyAndCounter) {
  const std::uint64_t seed = 0x1111111122222222, step = 0x3333444444, id = 0x555566666666;
  Draws draws(seed, step, id, Stream::noise_turn);
  const Key key{{0x22222222, 0x11111111}};
  Block counter{{0x33444444, (0x33u << 16) | 0x5555u, 0x66666666,
                 static_cast<std::uint32_t>(Stream::noise_turn) << 24}};
  for (std::uint32_t number = 0; number < 3; ++number) {
    const Block block = r123::Philox4x32()(counter, key);
    for (const std::uint32_t word : block) EXPECT_EQ(draws.bits(), word);
    counter[3] += 1;
  }
}

TEST(Draws, DifferInEveryArgument) {
  std::set<std::uint32_t> firsts;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (std::uint64_t step = 0; step < 3; ++step) {
      for (std::uint64_t id = 0; id < 3; ++id) {
        for (const Stream stream : {Stream::start_position, Stream::wander, Stream::colour}) {
          firsts.insert(Draws(seed, step, id, stream).bits());
        }
      }
    }
  }
  EXPECT_EQ(firsts.size(), 81u);
}

TEST(Draws, UniformLiesInItsRangeWithTheRightMean) {
  double sum = 0, squares = 0;
  float low = 1, high = 0;
  constexpr int count = 100000;
  for (std::uint64_t id = 0; id < count; ++id) {
    const float u = Draws(7, 3, id, Stream::wander).uniform();
    low = std::min(low, u);
    high = std::max(high, u);
    sum += u;
    squares += double{u} * double{u};
  }
  EXPECT_GE(low, 0.0f);
  EXPECT_LT(high, 1.0f);
  EXPECT_LT(low, 1e-4f);
  EXPECT_GT(high, 1 - 1e-4f);
  EXPECT_NEAR(sum / count, 0.5, 0.005);  // five standard errors of sqrt(1/12/n)
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.005);
}

TEST(Draws, BetweenEqualBoundsIsTheBound) {
  Draws draws(1, 2, 3, Stream::start_velocity);
  EXPECT_EQ(draws.between(4.5f, 4.5f), 4.5f);
  for (int i = 0; i < 1000; ++i) {
    const float x = draws.between(-2, 3);
    EXPECT_GE(x, -2.0f);
    EXPECT_LT(x, 3.0f);
  }
}

template <int D>
void expect_directions_everywhere() {
  Vec<D, double> sum;
  constexpr int count = 20000;
  for (std::uint64_t id = 0; id < count; ++id) {
    const Vec<D> v = Draws(1, 0, id, Stream::start_velocity).direction<D>();
    EXPECT_NEAR(length(v), 1, 2e-7);
    for (int axis = 0; axis < D; ++axis) sum[axis] += double{v[axis]} / count;
  }
  EXPECT_LT(length(sum), 0.03);
}

TEST(Draws, DirectionsAreUnitVectorsToAllSides) {
  expect_directions_everywhere<2>();
  expect_directions_everywhere<3>();
}

TEST(Draws, BallIsFilledUniformly) {
  int inner = 0;
  constexpr int count = 20000;
  for (std::uint64_t id = 0; id < count; ++id) {
    const Vec<3> v = Draws(1, 0, id, Stream::start_position).in_ball<3>();
    EXPECT_LE(dot(v, v), 1.0f);
    inner += dot(v, v) < 0.25f ? 1 : 0;  // half the radius, an eighth of the volume
  }
  EXPECT_NEAR(inner / double{count}, 0.125, 0.012);
}

}  // namespace
}  // namespace sturnus
