// Laws of plots: round ticks, ink for data, and none for what is not there.
#include "draw/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "draw/axis.h"

namespace sturnus {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Theme& dark = theme(ThemeName::dark);

Plot plot_of(std::vector<double> values) {
  Plot plot;
  for (std::size_t i = 0; i < values.size(); ++i) plot.x.push_back(static_cast<double>(i));
  plot.panels.push_back({"polarisation", "", {{"birds", std::move(values)}}});
  return plot;
}

Image picture(const Plot& plot, Size size = {640, 240}) {
  return draw_plot(plot, dark, size, Workers(1));
}

// A line between two rows of pixels covers neither whole.
bool is_line_colour(Rgba c) {
  const Rgba line = dark.flock(0);
  return std::abs(c.r - line.r) < 40 && std::abs(c.g - line.g) < 40 && std::abs(c.b - line.b) < 40;
}

// Pixels in about the colour of the first line, in columns from and to as parts of the width.
int line_pixels(const Image& image, double from = 0.15, double to = 1) {
  int count = 0;
  for (int y = 60; y < image.height; ++y) {
    for (int x = static_cast<int>(from * image.width); x < static_cast<int>(to * image.width); ++x) {
      count += is_line_colour(image.at(x, y)) ? 1 : 0;
    }
  }
  return count;
}

TEST(Axis, TicksAreRoundAndInside) {
  for (const auto& [low, high] :
       {std::pair{0.0, 1.0}, {-3.7, 12.2}, {1e-7, 3e-7}, {4e8, 9e8}, {-5.0, -4.99}}) {
    for (const bool widen : {false, true}) {
      const Axis axis = nice_axis(low, high, 4, widen);
      const std::vector<double> ticks = axis.ticks();
      ASSERT_GE(ticks.size(), 2u) << low;
      EXPECT_LE(ticks.size(), 9u) << low;
      const double mantissa = axis.step / std::pow(10.0, std::floor(std::log10(axis.step) + 1e-9));
      EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                  std::abs(mantissa - 2.5) < 1e-6 || std::abs(mantissa - 5) < 1e-6)
          << axis.step;
      EXPECT_LE(axis.low, low + 1e-9 * (high - low));
      EXPECT_GE(axis.high, high - 1e-9 * (high - low));
      for (const double tick : ticks) {
        EXPECT_GE(tick, axis.low - 1e-6 * axis.step);
        EXPECT_LE(tick, axis.high + 1e-6 * axis.step);
      }
    }
  }
}

TEST(Axis, NeighbouringTicksAreWrittenDifferently) {
  for (const auto& [low, high] :
       {std::pair{0.0, 1.0}, {0.0, 0.005}, {11000.0, 12000.0}, {2.4e6, 2.6e6}, {-1.0, 1.0}}) {
    const Axis axis = nice_axis(low, high, 5, true);
    const std::vector<double> ticks = axis.ticks();
    for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_NE(axis.text(ticks[i - 1]), axis.text(ticks[i]));
  }
  EXPECT_EQ(nice_axis(0, 1, 2, true).text(0.5), "0.5");
  EXPECT_EQ(nice_axis(11000, 12000, 2, true).text(11500), "11.5k");
}

TEST(Axis, AConstantSeriesGetsRoom) {
  for (const double value : {0.0, 5.0, -3.0, 1e12}) {
    const Axis axis = nice_axis(value, value, 3, true);
    EXPECT_LT(axis.low, axis.high);
    EXPECT_LE(axis.low, value);
    EXPECT_GT(axis.high, value);
  }
}

TEST(Axis, NumbersAreShort) {
  EXPECT_EQ(short_number(0.93412), "0.9341");
  EXPECT_EQ(short_number(12345), "12.35k");
  EXPECT_EQ(short_number(3), "3");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(nan), "–");
}

TEST(Plot, ALineHasInk) {
  EXPECT_GT(line_pixels(picture(plot_of({0, 1, 0.5, 0.7}))), 200);
}

TEST(Plot, AGapHasNone) {
  const Image image = picture(plot_of({1, 1, 1, nan, nan, nan, 1, 1, 1}));
  EXPECT_GT(line_pixels(image, 0.15, 0.3), 20);
  EXPECT_EQ(line_pixels(image, 0.42, 0.65), 0);
  EXPECT_GT(line_pixels(image, 0.8, 0.95), 20);
}

TEST(Plot, AValueBetweenGapsIsADot) {
  EXPECT_GT(line_pixels(picture(plot_of({nan, nan, 0.5, nan, nan})), 0.4, 0.7), 5);
}

TEST(Plot, NothingToShowIsNoFailure) {
  EXPECT_EQ(line_pixels(picture(plot_of({}))), 0);
  EXPECT_EQ(line_pixels(picture(plot_of({nan, nan}))), 0);
  EXPECT_GT(line_pixels(picture(plot_of({3}))), 5);
  EXPECT_GT(line_pixels(picture(plot_of({0, 0, 0}))), 100);
  EXPECT_GT(line_pixels(picture(plot_of({1, std::numeric_limits<double>::infinity(), 1.2, 1.2, 2}))), 20);
  EXPECT_EQ(picture(Plot(), {300, 100}).size(), (Size{300, 100}));
  EXPECT_EQ(picture(plot_of({1, 2}), {16, 16}).size(), (Size{16, 16}));
}

TEST(Plot, HigherValuesAreHigherInThePicture) {
  const auto top = [](const Image& image, int x) {
    for (int y = 60; y < image.height; ++y) {
      if (is_line_colour(image.at(x, y))) return y;
    }
    return -1;
  };
  const Image image = picture(plot_of({0, 1}));
  EXPECT_GT(top(image, 200), top(image, 400));
  EXPECT_GT(top(image, 400), top(image, 600));
}

TEST(Plot, ASpikeInALongSeriesIsNotLost) {
  std::vector<double> values(100000, 0.2);
  values[50001] = 1;
  const Image image = picture(plot_of(values));
  const Image without = picture(plot_of(std::vector<double>(100000, 0.2)));
  EXPECT_GT(line_pixels(image, 0.5, 0.6), line_pixels(without, 0.5, 0.6));
}

TEST(Plot, ThePictureIsTheSameForAnyNumberOfWorkers) {
  const Plot plot = plot_of({0.1, 0.5, nan, 0.2, 0.9});
  const Image one = picture(plot);
  for (const int count : {2, 3, 8}) EXPECT_EQ(one, draw_plot(plot, dark, {640, 240}, Workers(count)));
}

}  // namespace
}  // namespace sturnus
