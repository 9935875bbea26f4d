// Small vectors: sums, lengths, and the direction of what has none.
#include "base/vec.h"

#include <gtest/gtest.h>

namespace sturnus {
namespace {

TEST(Vec, AddsAndScalesByAxis) {
  const Vec<3> a{{1, 2, 3}}, b{{10, 20, 30}};
  EXPECT_EQ(a + b, (Vec<3>{{11, 22, 33}}));
  EXPECT_EQ(b - a, (Vec<3>{{9, 18, 27}}));
  EXPECT_EQ(a * 2.0f, (Vec<3>{{2, 4, 6}}));
  EXPECT_EQ(dot(a, b), 140);
  EXPECT_EQ(length(Vec<2>{{3, 4}}), 5);
}

TEST(Vec, UnitOfNothingIsNothing) {
  EXPECT_EQ(unit(Vec<2>{}), (Vec<2>{}));
  EXPECT_EQ(unit(Vec<2>{{0, -7}}), (Vec<2>{{0, -1}}));
  EXPECT_NEAR(length(unit(Vec<3>{{1, -2, 3}})), 1, 1e-7);
}

}  // namespace
}  // namespace sturnus
