// What the view draws stands where the camera says, in the colour that it should have. Without OpenGL these
// tests are skipped, and say so.
#include "view/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "studio/support.h"
#include "view/boids.h"
#include "view/colours.h"

namespace studio {
namespace {

using sturnus::Rgba;
constexpr sturnus::Size size{400, 300};

Instance boid(Point at, Point previous, std::uint8_t flock) {
  Instance out{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.position[axis] = at[axis];
    out.previous[axis] = previous[axis];
  }
  out.velocity[0] = 2;
  out.flock = flock;
  return out;
}

int difference(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

class Views : public testing::Test {
 protected:
  void SetUp() override {
    window_ = testing_support::offscreen(size);
    if (!window_) GTEST_SKIP() << "no OpenGL 3.3 here: nothing of the view was tested";
    auto view = View::create();
    ASSERT_TRUE(view) << view.problems().front().text;
    view_.emplace(std::move(*view));
    make(2);
  }

  // Three boids of two flocks in a space of 400 by 300.
  void make(int dimensions) {
    sturnus::ScenarioDef scenario;
    scenario.flocks.resize(2);
    for (auto& flock : scenario.flocks) flock.size = 20;
    frame_ = {};
    frame_.dimensions = dimensions;
    frame_.extent =
        dimensions == 2 ? sturnus::Extent{{0, 0}, {400, 300}} : sturnus::Extent{{0, 0, 0}, {400, 300, 300}};
    frame_.scenario = std::make_shared<sturnus::ScenarioDef>(scenario);
    const float z = dimensions == 2 ? 0.0f : 150.0f;
    frame_.boids = {boid({100, 100, z}, {60, 100, z}, 0), boid({200, 200, z}, {160, 200, z}, 1),
                    boid({300, 80, z}, {260, 80, z}, 0)};
    camera_.resize(size);
    camera_.fit(frame_.extent, dimensions);
  }

  sturnus::Image picture(const Shapes& shapes) {
    view_->upload(frame_);
    view_->draw(frame_, camera_, options_, moment_, shapes);
    return read_pixels(size);
  }
  sturnus::Image picture() { return picture(Shapes(camera_, 1)); }

  Rgba at(const sturnus::Image& image, const Point& place) const {
    const Point pixel = camera_.project(place);
    return image.at(static_cast<int>(pixel[0]), static_cast<int>(pixel[1]));
  }
  Rgba own(std::size_t flock) const { return flock_colour(*frame_.scenario, flock, options_.theme); }
  Rgba ground() const { return colours(options_.theme).surface; }
  Point place(std::size_t i) const {
    const Instance& b = frame_.boids[i];
    return {b.position[0], b.position[1], b.position[2]};
  }
  Point before(std::size_t i) const {
    const Instance& b = frame_.boids[i];
    return {b.previous[0], b.previous[1], b.previous[2]};
  }

  std::unique_ptr<Window> window_;
  std::optional<View> view_;
  Frame frame_;
  Camera camera_;
  ViewOptions options_;
  Moment moment_;
};

TEST_F(Views, EveryBoidIsAtItsPixelInItsFlocksColour) {
  const sturnus::Image image = picture();
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LE(difference(at(image, place(i)), own(frame_.boids[i].flock)), 2) << "boid " << i;
  EXPECT_LE(difference(at(image, {200, 100, 0}), ground()), 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Views, AFlocksOwnColourIsTaken) {
  auto scenario = *frame_.scenario;
  scenario.flocks[1].colour.start = "#12e0a4";
  frame_.scenario = std::make_shared<sturnus::ScenarioDef>(scenario);
  EXPECT_LE(difference(at(picture(), place(1)), sturnus::rgb(0x12e0a4)), 2);
}

TEST_F(Views, BetweenTwoStepsABoidIsOnItsWay) {
  for (const float part : {0.0f, 0.5f, 1.0f}) {
    moment_.part = part;
    const sturnus::Image image = picture();
    const Point there = before(1) + (place(1) - before(1)) * part;
    EXPECT_LE(difference(at(image, there), own(1)), 2) << part;
    if (part != 1) {
      EXPECT_LE(difference(at(image, place(1)), ground()), 1) << part;
    }
    if (part != 0) {
      EXPECT_LE(difference(at(image, before(1)), ground()), 1) << part;
    }
  }
}

TEST_F(Views, TheTrackedBoidIsRedAndHuntersSayHowTheyAre) {
  moment_.tracked = 2;
  frame_.boids[0].flags = is_hunter | is_full;
  frame_.boids[1].flags = is_hunter;
  frame_.boids[1].starving = 255;
  const sturnus::Image image = picture();
  const Colours& theme = colours(options_.theme);
  EXPECT_LE(difference(at(image, place(2)), theme.tracked), 2);
  EXPECT_LE(difference(at(image, place(0)), theme.full), 2);
  EXPECT_LE(difference(at(image, place(1)), theme.starved), 2);
}

TEST_F(Views, DriftingColoursAndQuarantineShow) {
  const Rgba drifted{10, 200, 90, 255};
  frame_.boids[0].colour[0] = drifted.r;
  frame_.boids[0].colour[1] = drifted.g;
  frame_.boids[0].colour[2] = drifted.b;
  frame_.boids[0].colour[3] = 255;
  frame_.boids[1].flags = is_quarantined;
  const sturnus::Image image = picture();
  EXPECT_LE(difference(at(image, place(0)), drifted), 2);
  EXPECT_LE(difference(at(image, place(1)), colours(options_.theme).quarantined), 2);
}

TEST_F(Views, TheFlocksColourAndTheDriftingOneAreTwoThings) {
  for (Instance& each : frame_.boids) {
    each.colour[0] = 10, each.colour[1] = 200, each.colour[2] = 90, each.colour[3] = 255;
  }
  const Rgba drifted{10, 200, 90, 255};
  for (const auto& [by, wanted] :
       {std::pair{ColourBy::automatic, drifted}, {ColourBy::drifting, drifted}, {ColourBy::flock, own(0)}}) {
    options_.colour_by = by;
    EXPECT_LE(difference(at(picture(), place(0)), wanted), 2) << static_cast<int>(by);
  }
  for (Instance& each : frame_.boids) each.colour[3] = 0;
  options_.colour_by = ColourBy::drifting;
  EXPECT_LE(difference(at(picture(), place(0)), own(0)), 2) << "nothing drifts here";
}

TEST_F(Views, ColourByHeadingAndSpeedTellBoidsApart) {
  frame_.boids[2].velocity[0] = -1.6f;
  for (const ColourBy by : {ColourBy::heading, ColourBy::speed}) {
    options_.colour_by = by;
    const sturnus::Image image = picture();
    EXPECT_GT(difference(at(image, place(0)), at(image, place(2))), 40);
    EXPECT_LE(difference(at(image, place(0)), at(image, place(1))), 2) << "equal motion, equal colour";
  }
}

TEST_F(Views, TrailsStayForSomeStepsAndAnotherGenerationForgetsThem) {
  options_.trails = true;
  view_->upload(frame_);
  frame_.step = 1;
  const Point old = before(1) + (place(1) - before(1)) * 0.4f;
  for (Instance& b : frame_.boids) {
    std::copy(b.position, b.position + 3, b.previous);
    b.position[0] += 40;
  }
  EXPECT_GT(difference(at(picture(), old), ground()), 8) << "the step before last is gone";
  options_.trails = false;
  EXPECT_LE(difference(at(picture(), old), ground()), 1);
  options_.trails = true;
  frame_.generation = 1;
  EXPECT_LE(difference(at(picture(), old), ground()), 1) << "a jump left a trail";
}

TEST_F(Views, ShapesLieAboveBoids) {
  Shapes shapes(camera_, 1);
  const Rgba green = sturnus::rgb(0x00ff00);
  shapes.line(place(1) - Point{30, 0, 0}, place(1) + Point{30, 0, 0}, green, 4);
  const sturnus::Image image = picture(shapes);
  EXPECT_LE(difference(at(image, place(1)), green), 2);
  EXPECT_LE(difference(at(image, place(0)), own(0)), 2);
}

TEST_F(Views, TheLightThemeHasAWhiteGround) {
  options_.theme = sturnus::ThemeName::light;
  const sturnus::Image image = picture();
  EXPECT_EQ(image.at(1, 1), (Rgba{255, 255, 255, 255}));
  EXPECT_LE(difference(at(image, place(1)), own(1)), 2);
}

TEST_F(Views, InSpaceTheNearerHides) {
  make(3);
  for (Instance& b : frame_.boids) b = boid(camera_.middle(), camera_.middle(), 0);
  // Flock 1 stands before flock 0, and is uploaded first and last in turn.
  const Point nearer = camera_.middle() - camera_.forward() * 60.0f;
  for (const std::size_t front : {0u, 2u}) {
    Frame kept = frame_;
    frame_.boids[front] = boid(nearer, nearer, 1);
    const Rgba seen = at(picture(), nearer);
    EXPECT_GT(seen.r, seen.b) << "orange stands before blue, uploaded as number " << front;
    frame_ = kept;
  }
}

TEST_F(Views, EveryLookShowsEveryBoid) {
  for (const int dimensions : {2, 3}) {
    make(dimensions);
    for (const Look look : {Look::automatic, Look::arrows, Look::fish, Look::birds, Look::points}) {
      options_.look = look;
      const sturnus::Image image = picture();
      const Rgba empty = dimensions == 2 ? ground() : colours(options_.theme).background;
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GT(difference(at(image, place(i)), empty), 20)
            << dimensions << "D, look " << static_cast<int>(look);
    }
  }
}

// A pixel of which a body covers a part is ground without several samples, and neither ground nor body with
// them.
TEST_F(Views, EdgesOfBodiesAreSmoothUnlessTheyAreNotWanted) {
  options_.look = Look::birds;
  const sturnus::Image smooth = picture();
  options_.smooth = false;
  const sturnus::Image rough = picture();
  int touched = 0, faint = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (difference(rough.at(x, y), ground()) > 1) continue;
      const int strength = difference(smooth.at(x, y), ground());
      touched += strength > 4 ? 1 : 0;
      faint += strength > 4 && 2 * strength < difference(own(0), ground()) ? 1 : 0;
    }
  }
  EXPECT_GT(touched, 30);
  EXPECT_GT(4 * faint, 3 * touched) << "of what they touch, bodies cover less than half";
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Views, WhatIsDrawnAfterASmoothWorldLiesAboveIt) {
  options_.look = Look::birds;
  picture();
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 10, 10);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  const sturnus::Image image = read_pixels(size);
  EXPECT_EQ(image.at(5, size.height - 6), (Rgba{255, 0, 0, 255}));
  EXPECT_GT(difference(at(image, place(0)), ground()), 20) << "the world is not there";
}

TEST_F(Views, VeryManyBoidsAndFlatFiguresTakeNoSamples) {
  EXPECT_FALSE(has_rough_edges(frame_, Look::automatic));
  EXPECT_TRUE(has_rough_edges(frame_, Look::fish));
  make(3);
  EXPECT_TRUE(has_rough_edges(frame_, Look::automatic));
  frame_.boids.resize(20'001);
  EXPECT_FALSE(has_rough_edges(frame_, Look::automatic));
}

TEST_F(Views, SceneryIsDrawn) {
  const Colours& theme = colours(options_.theme);
  frame_.food.push_back({{50, 250, 0}, 12, 0});
  frame_.targets.push_back({{350, 250, 0}, true, 20});
  sturnus::Obstacle block;
  block.kind = sturnus::ObstacleKind::box;
  block.at = {200, 40, 0};
  block.half = {20, 20, 0};
  frame_.obstacles.push_back(block);
  const sturnus::Image image = picture();
  EXPECT_LE(difference(at(image, {50, 250, 0}), theme.food), 2);
  EXPECT_LE(difference(at(image, {350, 250, 0}), theme.repels), 2);
  EXPECT_GT(difference(at(image, {200, 40, 0}), ground()), 20);
}

TEST_F(Views, AnEmptyWorldIsDrawnToo) {
  frame_.boids.clear();
  EXPECT_LE(difference(at(picture(), {200, 100, 0}), ground()), 1);
}

TEST(Past, MemoryIsBounded) {
  for (const std::size_t boids : {1u, 1000u, 20'000u, 500'000u}) {
    EXPECT_GE(steps_kept(boids), 1u);
    if (steps_kept(boids) > 1) {
      EXPECT_LE(steps_kept(boids) * boids * sizeof(Instance), std::size_t{64} << 20);
    }
  }
  EXPECT_EQ(steps_kept(4'000'000), 1u);
}

// Figures for the documents; no limit is checked, because they depend on the machine.
class FullViews : public Views {};

TEST_F(FullViews, Figures) {
  for (const std::size_t boids : {1'000u, 10'000u, 100'000u, 1'000'000u}) {
    frame_.boids.resize(boids);
    for (std::size_t i = 0; i < boids; ++i) {
      const Point at{400 * std::fmod(static_cast<float>(i) * 0.618034f, 1.0f),
                     300 * std::fmod(static_cast<float>(i) * 0.754878f, 1.0f), 0};
      frame_.boids[i] = boid(at, at, 0);
    }
    picture();
    constexpr int rounds = 3;
    double upload = 0, whole = 0;
    for (int i = 0; i < rounds; ++i) {
      ++frame_.step;
      const auto start = std::chrono::steady_clock::now();
      picture();
      whole += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      upload += view_->times().upload / 1e6;
    }
    std::printf("%8zu boids: upload %.2f ms, frame %.2f ms\n", boids, upload / rounds, whole / rounds);
  }
}

}  // namespace
}  // namespace studio
