// The camera's promises: pixels and places answer each other, and the hand keeps what it holds.
#include "view/camera.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace studio {
namespace {

const sturnus::Extent plane{{-40, 10}, {360, 260}};
const sturnus::Extent room{{-40, 10, -70}, {360, 260, 110}};

Camera camera(int dimensions) {
  Camera out;
  out.resize({1000, 600});
  out.fit(dimensions == 2 ? plane : room, dimensions);
  return out;
}

// What the card makes of the matrix, as pixels.
Point through_matrix(const Camera& camera, const Point& at) {
  const auto m = camera.matrix();
  double clip[4];
  for (std::size_t row = 0; row < 4; ++row)
    clip[row] =
        double{m[row]} * at[0] + double{m[4 + row]} * at[1] + double{m[8 + row]} * at[2] + m[12 + row];
  const sturnus::Size size = camera.pixels();
  return {static_cast<float>((clip[0] / clip[3] + 1) / 2 * size.width),
          static_cast<float>((1 - clip[1] / clip[3]) / 2 * size.height), static_cast<float>(clip[3])};
}

void expect_near(const Point& a, const Point& b, float within) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], within) << "axis " << axis;
}

class Cameras : public testing::TestWithParam<int> {};

TEST_P(Cameras, FitShowsEveryCorner) {
  for (const sturnus::Size size : {sturnus::Size{1000, 600}, sturnus::Size{300, 900}}) {
    Camera c;
    c.resize(size);
    c.fit(GetParam() == 2 ? plane : room, GetParam());
    float widest = 0;
    for (int i = 0; i < 8; ++i) {
      const Point at{(i & 1) != 0 ? 360.f : -40.f, (i & 2) != 0 ? 260.f : 10.f,
                     GetParam() == 2 ? 0 : ((i & 4) != 0 ? 110.f : -70.f)};
      const Point pixel = c.project(at);
      EXPECT_GT(pixel[2], 0);
      const float across = std::abs(2 * pixel[0] / static_cast<float>(size.width) - 1);
      const float upwards = std::abs(2 * pixel[1] / static_cast<float>(size.height) - 1);
      widest = std::max({widest, across, upwards});
    }
    EXPECT_LE(widest, 1);
    EXPECT_GT(widest, 0.9f) << "not as large as it fits";
  }
}

TEST_P(Cameras, FillCentresWhatWasSeenBesidePanelsAndShowsAllOfIt) {
  Camera c;
  const std::array<float, 4> covered{60, 50, 320, 200};
  c.resize({1000, 600}, covered);
  c.fit(GetParam() == 2 ? plane : room, GetParam());
  Camera filled = c;
  filled.fill();
  const float free_x = 1000 - covered[0] - covered[2], free_y = 600 - covered[1] - covered[3];
  const float larger = std::min(1000 / free_x, 600 / free_y);
  for (int i = 0; i < 8; ++i) {
    const Point at{(i & 1) != 0 ? 360.f : -40.f, (i & 2) != 0 ? 260.f : 10.f,
                   GetParam() == 2 ? 0 : ((i & 4) != 0 ? 110.f : -70.f)};
    const Point was = c.project(at), is = filled.project(at);
    EXPECT_NEAR(is[0] - 500, (was[0] - covered[0] - free_x / 2) * larger, 0.5f);
    EXPECT_NEAR(is[1] - 300, (was[1] - covered[1] - free_y / 2) * larger, 0.5f);
  }
}

TEST_P(Cameras, PlaceAndProjectAnswerEachOther) {
  Camera c = camera(GetParam());
  c.orbit(130, 40);
  c.zoom(1.7f, 200, 500);
  const Point through{20, 60, 30};
  for (const auto& [x, y] : {std::pair{10.f, 20.f}, {500.f, 300.f}, {930.f, 580.f}}) {
    const Point pixel = c.project(c.place(x, y, through));
    EXPECT_NEAR(pixel[0], x, 0.02f);
    EXPECT_NEAR(pixel[1], y, 0.02f);
    EXPECT_NEAR(distance(c.ray(x, y), c.place(x, y, through)), 0, 0.01f);
  }
  if (GetParam() == 3) {
    EXPECT_NEAR(c.project(c.place(10, 20, through))[2], c.project(through)[2], 0.05f);
  }
}

TEST_P(Cameras, MatrixAgreesWithProject) {
  Camera c = camera(GetParam());
  c.orbit(-50, 90);
  c.fly(0.1f, 0.05f, 0.2f);
  for (const Point& at : {Point{0, 20, 0}, Point{150, 100, 20}, Point{-30, 250, -60}}) {
    const Point flat{at[0], at[1], GetParam() == 2 ? 0 : at[2]};
    expect_near(c.project(flat), through_matrix(c, flat), 0.05f);
  }
}

TEST_P(Cameras, ZoomKeepsWhatIsUnderTheCursor) {
  Camera c = camera(GetParam());
  const Point held = c.place(700, 150, c.middle());
  const float before = c.pixel_length(held);
  c.zoom(3, 700, 150);
  const Point pixel = c.project(held);
  EXPECT_NEAR(pixel[0], 700, 0.05f);
  EXPECT_NEAR(pixel[1], 150, 0.05f);
  EXPECT_NEAR(c.pixel_length(held), before / 3, before * 0.01f);
}

TEST_P(Cameras, PanMovesWhatIsUnderTheHand) {
  Camera c = camera(GetParam());
  const Point held = c.place(500, 300, c.middle());
  c.pan(37, -21);
  const Point pixel = c.project(held);
  EXPECT_NEAR(pixel[0], 537, 0.05f);
  EXPECT_NEAR(pixel[1], 279, 0.05f);
}

TEST_P(Cameras, FollowBringsAPointToTheMiddle) {
  Camera c = camera(GetParam());
  const Point boid{200, 200, GetParam() == 2 ? 0 : 50.f};
  c.follow(boid);
  EXPECT_NEAR(c.project(boid)[0], 500, 0.05f);
  EXPECT_NEAR(c.project(boid)[1], 300, 0.05f);
}

TEST_P(Cameras, PixelLengthIsAPixel) {
  const Camera c = camera(GetParam());
  const Point at{100, 100, GetParam() == 2 ? 0 : 20.f};
  const Point beside = at + c.right() * c.pixel_length(at);
  EXPECT_NEAR(c.project(beside)[0] - c.project(at)[0], 1, 0.01f);
}

INSTANTIATE_TEST_SUITE_P(PlaneAndSpace, Cameras, testing::Values(2, 3));

TEST(Camera, OrbitKeepsTheMiddleAndLookKeepsTheEye) {
  Camera c = camera(3);
  const Point middle = c.middle();
  c.orbit(200, 900);
  expect_near(c.middle(), middle, 0);
  const Point eye = c.eye();
  c.look(-120, 60);
  expect_near(c.eye(), eye, 0.01f);
  EXPECT_GT(length(c.middle() - middle), 1);
  EXPECT_GT(c.up()[1], 0) << "space has to stay upright";
}

TEST(Camera, WhatIsBehindTheEyeSaysSo) {
  const Camera c = camera(3);
  EXPECT_LT(c.project(c.eye() - c.forward() * 5.0f)[2], 0);
}

TEST(Camera, DistanceFromARay) {
  const Ray ray{{1, 2, 3}, {0, 0, -1}};
  EXPECT_FLOAT_EQ(distance(ray, {4, 6, -50}), 5);
  EXPECT_FLOAT_EQ(distance(ray, {1, 2, 90}), 0);
}

}  // namespace
}  // namespace studio
