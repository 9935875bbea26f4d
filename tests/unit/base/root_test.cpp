// Roots and angles of the project's own against the C library's.
#include "base/root.h"

#include <gtest/gtest.h>

namespace sturnus {
namespace {

TEST(Root, CosineAndSineAreExactToTheThirteenthPlace) {
  for (int i = -100000; i <= 100000; ++i) {
    const double angle = 2 * pi * i / 100000;
    const CosSin own = cos_sin(angle);
    ASSERT_NEAR(own.cos, std::cos(angle), 1e-13) << angle;
    ASSERT_NEAR(own.sin, std::sin(angle), 1e-13) << angle;
  }
}

TEST(Root, CosineOfDegreesMeetsTheWellKnownAngles) {
  EXPECT_EQ(cosine_of_degrees(0), 1);
  EXPECT_NEAR(cosine_of_degrees(60), 0.5, 1e-14);
  EXPECT_NEAR(cosine_of_degrees(90), 0, 1e-14);
  EXPECT_NEAR(cosine_of_degrees(120), -0.5, 1e-14);
  EXPECT_NEAR(cosine_of_degrees(180), -1, 1e-14);
}

TEST(Root, CubeRootOfWhatIsCubed) {
  for (double x = 1e-12; x < 1e12; x *= 1.37) EXPECT_NEAR(cube_root(x * x * x), x, 4e-16 * x);
  for (double x = 1e-300; x < 1e300; x *= 1e7) EXPECT_NEAR(cube_root(x), std::cbrt(x), 1e-15 * std::cbrt(x));
  EXPECT_EQ(cube_root(0), 0);
  EXPECT_EQ(cube_root(27), 3);
}

TEST(Root, CubeRootOfWhatHasNoneIsZero) {
  EXPECT_EQ(cube_root(-8), 0);
  EXPECT_EQ(cube_root(std::nan("")), 0);
}

TEST(Root, SquareRootIsTheMachines) {
  EXPECT_EQ(square_root(2), std::sqrt(2.0));
}

}  // namespace
}  // namespace sturnus
