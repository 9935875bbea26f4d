// Laws of triangles in space: what hides what, light, cutting, and frames from a single vector.
#include <gtest/gtest.h>
#include <sturnus/triangles.h>

#include <cmath>
#include <limits>

namespace sturnus {
namespace {

constexpr Rgba red = rgb(0xff0000);
constexpr Rgba green = rgb(0x00ff00);
constexpr Rgba ground = rgb(0x0f1419);
constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

PictureOptions small() {
  PictureOptions options;
  options.size = {120, 80};
  return options;
}

SpaceCamera from_above() {
  SpaceCamera camera;
  camera.eye = {0, 0, 4};
  camera.field_of_view = 60;
  return camera;
}

// A triangle around the middle of the picture at height z.
Triangle at_height(float z, Rgba colour) {
  return {{{{-1, -1, z}, {1, -1, z}, {0, 1, z}}}, colour};
}

Image draw(const std::vector<Triangle>& triangles, const SpaceCamera& camera = from_above(),
           int threads = 1) {
  return draw_triangles(triangles, {}, camera, small(), threads);
}

TEST(Triangles, TheNearerHidesTheFartherInAnyOrder) {
  const Triangle low = at_height(0, red), high = at_height(1, green);
  for (const Image& image : {draw({low, high}), draw({high, low})}) {
    EXPECT_EQ(image.at(60, 40).r, 0);
    EXPECT_GT(image.at(60, 40).g, 100);
  }
  EXPECT_EQ(draw({low}).at(1, 1), ground);
}

TEST(Triangles, ALineIsHiddenByWhatIsInFrontOfIt) {
  const Line3 line{{-3, 0, 0}, {3, 0, 0}, green, 3};
  const Image open = draw_triangles({}, {line}, from_above(), small(), 1);
  const Image hidden = draw_triangles({at_height(1, red)}, {line}, from_above(), small(), 1);
  EXPECT_EQ(open.at(60, 40).g, 255);
  EXPECT_EQ(hidden.at(60, 40).g, 0);
  EXPECT_EQ(hidden.at(15, 40).g, 255);
}

TEST(Triangles, BothSidesAreLitByTheFaceAndNotByTheOrderOfCorners) {
  const Triangle one = at_height(0, red);
  const Triangle reversed{{one.corners[2], one.corners[1], one.corners[0]}, red};
  EXPECT_EQ(draw({one}), draw({reversed}));
  // Tilted away from the light, which is above the viewer's left shoulder, it is darker.
  const Triangle up{{{{-1, -1, 1}, {1, -1, 1}, {0, 1, -1}}}, red};
  const Triangle down{{{{-1, -1, -1}, {1, -1, -1}, {0, 1, 1}}}, red};
  EXPECT_GT(draw({up}).at(60, 40).r, draw({down}).at(60, 40).r + 20);
}

TEST(Triangles, WhatReachesBehindTheViewerIsCutOffAndNotLost) {
  // A floor under the viewer, from far ahead to far behind.
  SpaceCamera camera;
  camera.eye = {0, 1, 0};
  camera.target = {0, 1, -1};
  camera.field_of_view = 60;
  const Triangle floor{{{{-1e4f, 0, 1e4f}, {1e4f, 0, 1e4f}, {0, 0, -1e6f}}}, red};
  const Image image = draw({floor}, camera);
  for (int x = 0; x < 120; x += 7) {
    EXPECT_GT(image.at(x, 79).r, 100) << x;
    EXPECT_EQ(image.at(x, 10), ground) << x;
  }
  const Triangle behind{{{{-1, 0, 5}, {1, 0, 5}, {0, 2, 5}}}, red};
  EXPECT_EQ(draw({behind}, camera), draw({}, camera));
}

TEST(Triangles, ACornerThatIsNoNumberLeavesItsTriangleOut) {
  for (const float bad : {none, endless, -endless}) {
    Triangle triangle = at_height(0, red);
    triangle.corners[1][2] = bad;
    EXPECT_EQ(draw({triangle}), draw({}));
    EXPECT_EQ(draw({triangle, at_height(1, green)}), draw({at_height(1, green)}));
  }
}

TEST(Triangles, DistanceFadesWhereTheCameraSaysSo) {
  SpaceCamera hazy = from_above();
  hazy.fade_from = 3;
  hazy.fade_to = 6;
  EXPECT_LT(draw({at_height(0, red)}, hazy).at(60, 40).r, draw({at_height(0, red)}).at(60, 40).r - 20);
  EXPECT_EQ(draw({at_height(1, red)}, hazy).at(60, 40), draw({at_height(1, red)}).at(60, 40));
}

TEST(Triangles, ThePictureDoesNotDependOnTheThreads) {
  std::vector<Triangle> many;
  for (int i = 0; i < 200; ++i) {
    const auto shift = static_cast<float>(i % 20) * 0.1f - 1;
    many.push_back({{{{shift, -1, 0.1f * shift}, {1, shift, 0}, {0, 1, -shift}}}, i % 2 == 0 ? red : green});
  }
  EXPECT_EQ(draw(many, from_above(), 1), draw(many, from_above(), 3));
}

TEST(Triangles, ADirectionThroughAPixelMeetsWhatIsDrawnThere) {
  SpaceCamera camera = from_above();
  camera.eye = {1, 2, 3};
  const Point3 along = direction_through(camera, small().size, 30.5f, 20.5f);
  Point3 place;
  for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = camera.eye[axis] + 3 * along[axis];
  const Line3 dot{{place[0] - 0.01f, place[1], place[2]}, {place[0] + 0.01f, place[1], place[2]}, green, 2};
  const Image image = draw_triangles({}, {dot}, camera, small(), 1);
  EXPECT_GT(image.at(30, 20).g, 200);
  EXPECT_EQ(image.at(40, 20), ground);
}

double dot(const Point3& a, const Point3& b) {
  return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
}

TEST(Frame, IsOrthonormalRightHandedAndAlongAnyDirection) {
  const float values[] = {0, 1, -1, 0.3f, -7, 1e-30f, 1e-44f, 3e38f};
  for (const float x : values) {
    for (const float y : values) {
      for (const float z : values) {
        const auto frame = frame_along({x, y, z});
        if (x == 0 && y == 0 && z == 0) {
          EXPECT_FALSE(frame.has_value());
          continue;
        }
        ASSERT_TRUE(frame.has_value()) << x << ' ' << y << ' ' << z;
        const auto& [u, v, w] = *frame;
        EXPECT_NEAR(dot(u, u), 1, 1e-6);
        EXPECT_NEAR(dot(v, v), 1, 1e-6);
        EXPECT_NEAR(dot(w, w), 1, 1e-6);
        EXPECT_NEAR(dot(u, v), 0, 1e-6);
        EXPECT_NEAR(dot(v, w), 0, 1e-6);
        EXPECT_NEAR(dot(w, u), 0, 1e-6);
        EXPECT_NEAR(u[1] * v[2] - u[2] * v[1], w[0], 1e-6);
        EXPECT_NEAR(u[2] * v[0] - u[0] * v[2], w[1], 1e-6);
        EXPECT_NEAR(u[0] * v[1] - u[1] * v[0], w[2], 1e-6);
        const double size = std::sqrt(double{x} * x + double{y} * y + double{z} * z);
        EXPECT_NEAR(w[0], x / size, 1e-6);
        EXPECT_NEAR(w[1], y / size, 1e-6);
        EXPECT_NEAR(w[2], z / size, 1e-6);
      }
    }
  }
}

TEST(Frame, ThereIsNoneWithoutADirection) {
  EXPECT_FALSE(frame_along({none, 0, 0}));
  EXPECT_FALSE(frame_along({1, none, 0}));
  EXPECT_FALSE(frame_along({0, endless, 1}));
  EXPECT_FALSE(frame_along({-0.0f, 0, 0}));
}

}  // namespace
}  // namespace sturnus
