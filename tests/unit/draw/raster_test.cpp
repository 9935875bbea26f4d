// Laws of the rasteriser: who hides whom, how much of a pixel is covered, and that threads leave no trace.
#include "draw/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sturnus {
namespace {

constexpr Rgba ground = rgb(0x0f1419);
constexpr Rgba red = rgb(0xff0000);
constexpr Rgba green = rgb(0x00ff00);

TriangleShape triangle_at(float nearness, Rgba colour, float shift = 0) {
  return {{Spot{4 + shift, 4, nearness}, Spot{60 + shift, 6, nearness}, Spot{30 + shift, 60, nearness}},
          colour};
}

Image paint_shapes(const std::vector<Shape>& shapes, bool depth, int supersampling = 3,
                   Rgba background = ground) {
  Canvas canvas;
  if (depth) canvas.use_depth();
  for (const Shape& shape : shapes) canvas.add(shape);
  return paint(canvas, {64, 64}, background, supersampling, Workers(1));
}

// Sum of the red channel, in units of one full pixel.
double red_pixels(const Image& image) {
  double sum = 0;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) sum += image.rgb[at];
  return sum / 255;
}

// One of everything, crossing every band.
Canvas crowded_canvas() {
  Canvas canvas;
  canvas.use_depth();
  for (int i = 0; i < 200; ++i) {
    const auto x = static_cast<float>(i * 37 % 200);
    const auto y = static_cast<float>(i * 53 % 150);
    const float near = 0.01f + 0.001f * static_cast<float>(i * 7 % 31);
    const Rgba colour{static_cast<std::uint8_t>(i), 200, static_cast<std::uint8_t>(255 - i), 255};
    canvas.add(
        TriangleShape{{Spot{x, y, near}, Spot{x + 21, y + 5, near * 2}, Spot{x + 4, y + 33, near}}, colour});
    canvas.add(BallShape{{y, x, near}, 6, 1, colour, red});
    canvas.add(DartShape{{x, y, near}, 0.6f, 0.8f, 9, 7, 3, 5, with_alpha(colour, 0.8f)});
    canvas.add(DiscShape{{x + 9, y, near}, 11, 9, colour});
    canvas.add(LineShape{{x, y, near}, {y, x, near}, 1.5f, colour, 0.1f, 0.9f});
    canvas.add(BarShape{x, y, x + 3, y + 40, 1.5f, with_alpha(colour, 0.3f)});
  }
  canvas.text("murmuration", 20, 70, 24, red);
  return canvas;
}

TEST(Raster, ThePictureIsTheSameForAnyNumberOfWorkers) {
  const Canvas canvas = crowded_canvas();
  for (const int supersampling : {1, 2, 3, 4}) {
    const Image one = paint(canvas, {201, 153}, ground, supersampling, Workers(1));
    for (const int count : {2, 3, 8}) {
      EXPECT_EQ(one, paint(canvas, {201, 153}, ground, supersampling, Workers(count))) << count << " workers";
    }
  }
}

TEST(Raster, ANearerTriangleHidesAFartherOneWhateverTheOrder) {
  const TriangleShape near = triangle_at(0.5f, red);
  const TriangleShape far = triangle_at(0.1f, green, 2);
  const Image first = paint_shapes({near, far}, true);
  EXPECT_EQ(first, paint_shapes({far, near}, true));
  EXPECT_EQ(first.at(30, 20), red);
}

TEST(Raster, WithoutDepthTheLaterShapeIsOnTop) {
  const TriangleShape near = triangle_at(0.5f, red);
  const TriangleShape far = triangle_at(0.1f, green);
  EXPECT_EQ(paint_shapes({near, far}, false).at(30, 20), green);
  EXPECT_EQ(paint_shapes({far, near}, false).at(30, 20), red);
}

TEST(Raster, TrianglesThatPierceEachOtherMeetInALine) {
  const TriangleShape left_near{{Spot{0, 0, 0.9f}, Spot{0, 63, 0.9f}, Spot{63, 31, 0.1f}}, red};
  const TriangleShape right_near{{Spot{63, 0, 0.9f}, Spot{63, 63, 0.9f}, Spot{0, 31, 0.1f}}, green};
  const Image image = paint_shapes({left_near, right_near}, true);
  EXPECT_EQ(image.at(20, 31), red);
  EXPECT_EQ(image.at(43, 31), green);
}

TEST(Raster, TrianglesThatShareAnEdgeLeaveNoGapAndCoverTheSquare) {
  const Spot a{8.3f, 9.1f}, b{50.7f, 12.9f}, c{47.2f, 55.5f}, d{11.6f, 51.4f};
  const Image whole = paint_shapes({TriangleShape{{a, b, c}, red}, TriangleShape{{a, c, d}, red}}, false);
  for (int y = 20; y < 45; ++y) {
    for (int x = 20; x < 40; ++x) ASSERT_EQ(whole.at(x, y), red) << x << ' ' << y;
  }
}

TEST(Raster, ASampleIsTheMiddleOfItsSquare) {
  const Spot a{10, 10}, b{20, 10}, c{20, 20}, d{10, 20};
  const std::vector<Shape> square{TriangleShape{{a, b, c}, red}, TriangleShape{{a, c, d}, red}};
  for (const int supersampling : {1, 2, 3, 4}) {
    const Image image = paint_shapes(square, false, supersampling, rgb(0));
    EXPECT_EQ(red_pixels(image), 100) << supersampling;
    EXPECT_EQ(image.at(10, 10), red);
    EXPECT_EQ(image.at(19, 19), red);
  }
}

TEST(Raster, ShapesCoverTheirArea) {
  constexpr Rgba black = rgb(0);
  constexpr float pi = 3.14159265f;
  const auto area = [&](const Shape& shape) { return red_pixels(paint_shapes({shape}, false, 2, black)); };
  EXPECT_NEAR(area(DiscShape{{31.3f, 30.8f}, 20, -1, red}), pi * 400, 3);
  EXPECT_NEAR(area(DiscShape{{31.3f, 30.8f}, 20, 15, red}), pi * (400 - 225), 3);
  EXPECT_NEAR(area(BarShape{3.25f, 5.5f, 40.75f, 21, 0, red}), 37.5 * 15.5, 3);
  EXPECT_NEAR(area(BarShape{3, 5, 43, 25, 6, red}), 40 * 20 - (4 - pi) * 36, 3);
  EXPECT_NEAR(area(LineShape{{5, 7}, {55, 47}, 3, red, 0.999f, 0.999f}), 3 * std::sqrt(50.0 * 50 + 40 * 40),
              3);
  EXPECT_NEAR(area(LineShape{{5, 30}, {55, 31}, 0.25f, red, 0.999f, 0.999f}), 0.25 * 50, 1);
  EXPECT_NEAR(area(DartShape{{30, 30}, 0.8f, 0.6f, 20, 16, 16, 12, red}), 36 * 12, 4);
  EXPECT_NEAR(area(DartShape{{30, 30}, 0.8f, 0.6f, 20, 16, 8, 12, red}), (36 - 8) * 12, 4);
  EXPECT_NEAR(area(triangle_at(0.5f, red)), 0.5 * (56 * 56 - 26 * 2), 12);
}

TEST(Raster, ATrailFadesAlongItsLengthWithoutBeads) {
  std::vector<Shape> trail;
  for (int i = 0; i < 6; ++i) {
    const float x = 2 + 10 * static_cast<float>(i);
    trail.push_back(LineShape{
        {x, 32}, {x + 10, 32}, 4, red, 0.1f * static_cast<float>(i), 0.1f * static_cast<float>(i + 1)});
  }
  const Image image = paint_shapes(trail, false, 3, rgb(0));
  for (int x = 5; x < 60; ++x) EXPECT_GE(image.at(x, 32).r + 2, image.at(x - 1, 32).r) << x;
  EXPECT_GT(image.at(58, 32).r, 120);
}

TEST(Raster, ALineBehindATriangleIsHiddenAndOneInFrontIsNot) {
  const TriangleShape middle = triangle_at(0.5f, green);
  const auto line = [](float nearness) {
    return LineShape{{0, 20, nearness}, {63, 20, nearness}, 2, red, 1, 1};
  };
  EXPECT_EQ(paint_shapes({middle, line(0.1f)}, true).at(30, 20), green);
  EXPECT_EQ(paint_shapes({middle, line(0.9f)}, true).at(30, 20), red);
  EXPECT_EQ(paint_shapes({middle, line(on_top)}, true).at(30, 20), red);
}

TEST(Raster, WhatIsNoNumberOrFarOutsideLeavesNoInk) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float inf = std::numeric_limits<float>::infinity();
  const Image empty({64, 64}, ground);
  for (const float bad : {nan, inf, -inf, 1e20f, -1e20f, 1e9f}) {
    EXPECT_EQ(empty,
              paint_shapes({TriangleShape{{Spot{bad, 4, 1}, Spot{60, 6, 1}, Spot{30, bad, 1}}, red}}, true));
    EXPECT_EQ(empty, paint_shapes({DiscShape{{bad, bad}, 5, -1, red}, BallShape{{bad, 3, 1}, 5, 1, red, red}},
                                  true));
    EXPECT_EQ(empty, paint_shapes({LineShape{{bad, 3}, {bad, bad}, 2, red, 1, 1}}, false));
    EXPECT_EQ(
        empty,
        paint_shapes({DartShape{{bad, 3}, 1, 0, 3, 3, 1, 2, red}, BarShape{bad, 1, bad, 9, 0, red}}, false));
  }
}

TEST(Raster, ShapesTooLargeForExactArithmeticAreLeftOut) {
  const Image empty({64, 64}, ground);
  EXPECT_EQ(empty, paint_shapes({DiscShape{{32, 32}, 1e9f, -1, red}}, false));
  EXPECT_EQ(empty,
            paint_shapes({TriangleShape{{Spot{-1e6f, -10}, Spot{1e6f, -10}, Spot{0, 1e6f}}, red}}, false));
}

TEST(Raster, EmptyPicturesAreEmpty) {
  EXPECT_TRUE(paint(crowded_canvas(), {0, 10}, ground, 2, Workers(2)).rgb.empty());
  EXPECT_EQ(paint(Canvas(), {1, 1}, ground, 2, Workers(2)).at(0, 0), ground);
}

}  // namespace
}  // namespace sturnus
