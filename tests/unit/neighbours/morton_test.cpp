// Z-order keys and their sort: halving by halving, stable, the same for any number of threads.
#include "neighbours/morton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace sturnus::test {
namespace {

template <int D>
std::uint64_t key_of(const KeyCube& cube, std::array<float, 3> place) {
  std::uint64_t found = 0;
  cube.for_keys<D>({&place[0], &place[1], &place[2]}, 0, 1,
                   [&](std::size_t, std::uint64_t key) { found = key; });
  return found;
}

TEST(KeyCube, SaysHalvingByHalvingInWhichHalfAPlaceLies) {
  const KeyCube cube{{10, 20, 30}, 8, 3};
  EXPECT_EQ(key_of<2>(cube, {10, 20, 0}), 0u);
  EXPECT_EQ(key_of<2>(cube, {14, 20, 0}), 0b01'00'00u);
  EXPECT_EQ(key_of<2>(cube, {10, 24, 0}), 0b10'00'00u);
  EXPECT_EQ(key_of<2>(cube, {15.5f, 22, 0}), 0b01'10'01u);
  EXPECT_EQ(key_of<3>(cube, {14, 20, 30}), 0b001'000'000u);
  EXPECT_EQ(key_of<3>(cube, {13, 27.5f, 34}), 0b110'011'011u);
}

TEST(KeyCube, HasRoomForTheLastCell) {
  const KeyCube flat{{}, 1, most_levels<2>};
  const KeyCube solid{{}, 1, most_levels<3>};
  EXPECT_EQ(key_of<2>(flat, {1, 1, 0}), (std::uint64_t{1} << 62) - 1);
  EXPECT_EQ(key_of<3>(solid, {1, 1, 1}), (std::uint64_t{1} << 63) - 1);
}

TEST(KeyCube, TakesPlacesOutsideAsOnItsBorder) {
  const KeyCube cube{{0, 0, 0}, 8, 3};
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_EQ(key_of<2>(cube, {-most, 1e15f, 0}), key_of<2>(cube, {0, 7.5f, 0}));
  EXPECT_EQ(key_of<3>(cube, {most, -1, 9}), key_of<3>(cube, {7.5f, 0, 7.5f}));
  EXPECT_EQ(key_of<2>(cube, {std::nanf(""), 3, 0}), key_of<2>(cube, {0, 3, 0}));
}

std::vector<Keyed> random_keys(std::size_t count, std::uint64_t mask) {
  std::mt19937_64 random(count);
  std::vector<Keyed> keyed;
  for (std::uint32_t i = 0; i < count; ++i) keyed.push_back({random() & mask, i});
  return keyed;
}

TEST(KeySort, IsStableForAnyNumberOfThreads) {
  KeySort sorter;  // one for all, as a step after the other would use it
  for (const std::uint64_t mask : {~std::uint64_t{0}, std::uint64_t{0x8000000000000007}, std::uint64_t{0xf00},
                                   std::uint64_t{0x1ffe00ffe0}, std::uint64_t{0}}) {
    for (const std::size_t count : {0u, 1u, 2u, 300u, 5000u, 60000u}) {
      auto expected = random_keys(count, mask);
      std::sort(expected.begin(), expected.end(), [](const Keyed& a, const Keyed& b) {
        return a.key != b.key ? a.key < b.key : a.slot < b.slot;
      });
      for (const int threads : {1, 3, 8}) {
        auto keyed = random_keys(count, mask);
        sorter.sort(keyed, Workers(threads));
        ASSERT_EQ(keyed.size(), expected.size());
        for (std::size_t i = 0; i < count; ++i) {
          ASSERT_EQ(keyed[i].key, expected[i].key) << "mask " << mask << ", " << threads << " threads";
          ASSERT_EQ(keyed[i].slot, expected[i].slot) << "mask " << mask << ", " << threads << " threads";
        }
      }
    }
  }
}

}  // namespace
}  // namespace sturnus::test
