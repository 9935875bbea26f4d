// Workers: every index once, in contiguous parts, with the floating-point settings that results depend on.
#include "base/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace sturnus {
namespace {

TEST(Workers, CoverARangeOnceInContiguousParts) {
  for (const int count : {1, 2, 3, 8}) {
    const Workers workers(count);
    EXPECT_EQ(workers.count(), count);
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{1000}}) {
      std::vector<std::atomic<int>> seen(n);
      std::atomic<int> parts = 0;
      workers.for_ranges(n, [&](std::size_t begin, std::size_t end, int part) {
        EXPECT_LT(begin, end);
        EXPECT_GE(part, 0);
        EXPECT_LT(part, count);
        ++parts;
        for (std::size_t i = begin; i < end; ++i) ++seen[i];
      });
      EXPECT_LE(parts, count);
      for (const auto& times : seen) EXPECT_EQ(times, 1);
    }
  }
}

TEST(Workers, ZeroMeansTheMachinesCores) {
  EXPECT_GE(Workers(0).count(), 1);
}

TEST(Workers, RoundToNearestWhateverTheCallerHasSet) {
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  std::atomic<int> wrong = 0;
  Workers(2).for_ranges(
      2, [&](std::size_t, std::size_t, int) { wrong += std::fegetround() != FE_TONEAREST ? 1 : 0; });
  const int after = std::fegetround();
  std::fesetround(before);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(after, FE_UPWARD);
}

#if defined(__SSE2__)
TEST(Workers, KeepDenormalsWhateverTheCallerHasSet) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040u);
  std::atomic<int> wrong = 0;
  Workers(1).for_ranges(
      1, [&](std::size_t, std::size_t, int) { wrong += (_mm_getcsr() & 0x8040u) != 0 ? 1 : 0; });
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(after & 0x8040u, 0x8040u);
}
#endif

}  // namespace
}  // namespace sturnus
