// Laws of the cameras: what is looked at is in the middle, and what is fitted is inside.
#include "draw/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sturnus {
namespace {

constexpr Size size{1280, 720};

TEST(Camera, TheTargetIsInTheMiddle) {
  const Viewpoint view = look_at({{3, 4, 5}}, {{-1, 2, 0}}, {{0, 1, 0}}, 50);
  const Projected at = Projection(view, size).project({{-1, 2, 0}});
  ASSERT_TRUE(at.in_front);
  EXPECT_NEAR(at.x, 640, 1e-2);
  EXPECT_NEAR(at.y, 360, 1e-2);
  EXPECT_NEAR(at.depth, std::sqrt(16.0f + 4 + 25), 1e-4);
}

TEST(Camera, FromPlusZRightIsRightAndUpIsUp) {
  const Projection projection(look_at({{0, 0, 10}}, {{0, 0, 0}}, {{0, 1, 0}}, 90), size);
  const Projected right = projection.project({{1, 0, 0}});
  const Projected above = projection.project({{0, 1, 0}});
  EXPECT_NEAR(right.x, 640 + 36, 1e-3);  // half the height over a slope of 1, at distance 10
  EXPECT_NEAR(right.y, 360, 1e-3);
  EXPECT_NEAR(above.x, 640, 1e-3);
  EXPECT_NEAR(above.y, 360 - 36, 1e-3);
}

TEST(Camera, WhatIsBehindTheEyeOrNoNumberIsNotInFront) {
  const Projection projection(look_at({{0, 0, 10}}, {{0, 0, 0}}, {{0, 1, 0}}), size);
  EXPECT_FALSE(projection.project({{0, 0, 11}}).in_front);
  EXPECT_FALSE(projection.project({{0, 0, 10}}).in_front);
  EXPECT_FALSE(projection.project({{std::numeric_limits<float>::quiet_NaN(), 0, 0}}).in_front);
}

TEST(Camera, ALineThroughTheEyePlaneIsCutInFrontOfIt) {
  const Projection projection(look_at({{0, 0, 10}}, {{0, 0, 0}}, {{0, 1, 0}}), size);
  Vec<3> from{{1, 0, -5}};
  Vec<3> to{{1, 0, 30}};
  ASSERT_TRUE(projection.clip(from, to));
  EXPECT_EQ(from[2], -5);
  EXPECT_TRUE(projection.project(to).in_front);
  EXPECT_NEAR(to[2], 10, 0.1);
  Vec<3> behind{{0, 0, 12}};
  Vec<3> farther{{0, 0, 40}};
  EXPECT_FALSE(projection.clip(behind, farther));
}

TEST(Camera, AFittedBoxIsInsideAndTouchesTheBorderThatIsKeptFree) {
  const Vec<3> low{{-100, -20, 5}};
  const Vec<3> high{{40, 90, 61}};
  for (const Vec<3>& direction :
       {Vec<3>{{0, 0, 1}}, Vec<3>{{1, 1, 1}}, Vec<3>{{-3, 0.5f, 0.2f}}, Vec<3>{{0, 1, 0}}}) {
    const Projection projection(fit_box(low, high, direction, {{0, 1, 0}}, 1280.0f / 720, 40), size);
    float widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Projected at =
          projection.project({{(corner & 1) ? high[0] : low[0], (corner & 2) ? high[1] : low[1],
                               (corner & 4) ? high[2] : low[2]}});
      ASSERT_TRUE(at.in_front);
      widest = std::max({widest, std::abs(at.x - 640) / 640, std::abs(at.y - 360) / 360});
    }
    EXPECT_LE(widest, 0.9401f);
    EXPECT_GE(widest, 0.93f);
  }
}

TEST(Camera, AFittedViewFadesFromItsNearestToItsFarthestCorner) {
  const Viewpoint view = three_quarter_view({{0, 0, 0}}, {{10, 10, 10}}, 1.5f);
  const Projection projection(view, size);
  EXPECT_NEAR(projection.fade(projection.project({{10, 10, 10}}).depth), 0, 1e-4);
  EXPECT_NEAR(projection.fade(projection.project({{0, 0, 0}}).depth), 1, 1e-4);
  EXPECT_EQ(Projection(look_at({{0, 0, 9}}, {{0, 0, 0}}, {{0, 1, 0}}), size).fade(5), 0);
}

TEST(Camera, AFlatViewKeepsTheShapeFillsThePictureAndPointsUp) {
  const Projection projection(flat_view({{-10, 0, 0}}, {{90, 20, 0}}, 40), size);
  const Projected low = projection.project({{-10, 0, 0}});
  const Projected high = projection.project({{90, 20, 0}});
  EXPECT_NEAR(low.x, 40, 1e-3);
  EXPECT_NEAR(high.x, 1240, 1e-3);
  EXPECT_NEAR(low.y - high.y, 240, 1e-3);
  EXPECT_NEAR(0.5f * (low.y + high.y), 360, 1e-3);
  EXPECT_NEAR(low.scale, 12, 1e-5);
}

TEST(Camera, AnEmptyRectangleIsNoDivisionByZero) {
  const Projected at = Projection(flat_view({{5, 5, 0}}, {{5, 5, 0}}), size).project({{5, 5, 0}});
  EXPECT_EQ(at.x, 640);
  EXPECT_EQ(at.y, 360);
}

TEST(Camera, TheBasisIsOrthonormalRightHandedAndAlongTheVector) {
  for (const Vec<3>& along : {Vec<3>{{1, 0, 0}}, Vec<3>{{0, -2, 0}}, Vec<3>{{0, 0, 3}}, Vec<3>{{1, 1, 1}},
                              Vec<3>{{-0.3f, 7, 0.01f}}}) {
    const Basis basis = basis_along(along);
    EXPECT_NEAR(dot(basis.w, unit(along)), 1, 1e-6);
    EXPECT_NEAR(length(basis.u), 1, 1e-6);
    EXPECT_NEAR(dot(basis.u, basis.w), 0, 1e-6);
    const Vec<3> difference = cross(basis.u, basis.v) - basis.w;
    EXPECT_LT(length(difference), 1e-6f);
  }
}

TEST(Camera, TheBasisFollowsTheTextbook) {
  // w = (0.6, 0, 0.8): its smallest component is y, so t = (0.6, 1, 0.8) and u = unit(t x w) = (0.8, 0,
  // -0.6).
  const Basis basis = basis_along({{3, 0, 4}});
  EXPECT_NEAR(basis.u[0], 0.8f, 1e-6);
  EXPECT_NEAR(basis.u[1], 0, 1e-6);
  EXPECT_NEAR(basis.u[2], -0.6f, 1e-6);
  EXPECT_NEAR(basis.v[1], 1, 1e-6);
}

}  // namespace
}  // namespace sturnus
