// Mixing of bits: every input bit counts, and so does the order.
#include "base/hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace sturnus {
namespace {

TEST(Mix, EveryInputBitMovesAboutHalfOfTheOutput) {
  for (std::uint64_t x : {0ull, 1ull, 0x123456789abcdefull}) {
    for (int bit = 0; bit < 64; ++bit) {
      const int moved = std::popcount(mix(x) ^ mix(x ^ (1ull << bit)));
      EXPECT_GE(moved, 10) << x << " bit " << bit;
      EXPECT_LE(moved, 54) << x << " bit " << bit;
    }
  }
}

TEST(Fold, ValueAndOrderMatter) {
  EXPECT_NE(fold(0, 1), fold(0, 2));
  EXPECT_NE(fold(fold(0, 1), 2), fold(fold(0, 2), 1));
  std::set<std::uint64_t> seen;
  for (std::uint64_t a = 0; a < 30; ++a) {
    for (std::uint64_t b = 0; b < 30; ++b) seen.insert(fold(fold(0, a), b));
  }
  EXPECT_EQ(seen.size(), 900u);
}

TEST(BitsOf, TellsZerosApart) {
  EXPECT_EQ(bits_of(1.0f), 0x3f800000u);
  EXPECT_NE(bits_of(0.0f), bits_of(-0.0f));
}

}  // namespace
}  // namespace sturnus
