// Bodies that move: what swims, flaps and bites changes with time alone, and nothing else does.
#include <gtest/gtest.h>

#include <algorithm>

#include "studio/support.h"
#include "view/colours.h"

namespace studio {
namespace {

constexpr sturnus::Size size{480, 320};
constexpr float body_length = 240;

/// A part of the body: from and to in lengths of it, x ahead and y to the left.
struct Part {
  float from_x, to_x, from_y, to_y;
};
constexpr Part everywhere{-0.9f, 0.9f, -0.6f, 0.6f};

class Animation : public testing::Test {
 protected:
  void SetUp() override {
    window_ = testing_support::offscreen(size);
    if (!window_) GTEST_SKIP() << "no OpenGL 3.3 here: nothing of the view was tested";
    auto view = View::create();
    ASSERT_TRUE(view) << view.problems().front().text;
    view_.emplace(std::move(*view));
    sturnus::ScenarioDef scenario;
    scenario.flocks.resize(1);
    scenario.flocks[0].size = double{body_length};
    scenario.flocks[0].max_speed = 4;
    frame_.dimensions = 2;
    frame_.extent = {{0, 0}, {480, 320}};
    frame_.scenario = std::make_shared<sturnus::ScenarioDef>(scenario);
    Instance boid{};
    boid.position[0] = boid.previous[0] = 240;
    boid.position[1] = boid.previous[1] = 160;
    boid.velocity[0] = 2;
    frame_.boids = {boid};
    camera_.resize(size);
    camera_.fit(frame_.extent, 2);
    options_.outline = false;
  }

  sturnus::Image at(float seconds) {
    Moment moment;
    moment.seconds = seconds;
    view_->upload(frame_);
    view_->draw(frame_, camera_, options_, moment, Shapes(camera_, 1));
    return read_pixels(size);
  }

  // The share of a part's pixels that differ by more than a shade.
  double difference(const sturnus::Image& a, const sturnus::Image& b, const Part& part) const {
    const Point low = camera_.project({240 + part.from_x * body_length, 160 + part.from_y * body_length, 0});
    const Point high = camera_.project({240 + part.to_x * body_length, 160 + part.to_y * body_length, 0});
    int differing = 0, all = 0;
    for (int y = std::max(0, static_cast<int>(high[1])); y < std::min(size.height, static_cast<int>(low[1]));
         ++y) {
      for (int x = std::max(0, static_cast<int>(low[0])); x < std::min(size.width, static_cast<int>(high[0]));
           ++x) {
        const sturnus::Rgba one = a.at(x, y), other = b.at(x, y);
        ++all;
        differing +=
            std::max({std::abs(one.r - other.r), std::abs(one.g - other.g), std::abs(one.b - other.b)}) > 3;
      }
    }
    return all == 0 ? 0 : static_cast<double>(differing) / all;
  }

  // How far to the left of its axis the body is seen within a part, in pixels.
  float middle_of(const sturnus::Image& image, const Part& part) const {
    const Point low = camera_.project({240 + part.from_x * body_length, 160 + part.from_y * body_length, 0});
    const Point high = camera_.project({240 + part.to_x * body_length, 160 + part.to_y * body_length, 0});
    float sum = 0, count = 0;
    for (int y = static_cast<int>(high[1]); y < static_cast<int>(low[1]); ++y) {
      for (int x = static_cast<int>(low[0]); x < static_cast<int>(high[0]); ++x) {
        if (image.at(x, y) == image.at(2, 2)) continue;
        sum += 0.5f * (low[1] + high[1]) - static_cast<float>(y);
        ++count;
      }
    }
    return count > 0 ? sum / count : 0;
  }

  std::unique_ptr<Window> window_;
  std::optional<View> view_;
  Frame frame_;
  Camera camera_;
  ViewOptions options_;
};

TEST_F(Animation, TheSameTimeShowsTheSamePicture) {
  for (const Look look : {Look::fish, Look::birds, Look::arrows}) {
    options_.look = look;
    const sturnus::Image once = at(1.25f);
    at(3);
    EXPECT_EQ(once.rgb, at(1.25f).rgb) << static_cast<int>(look);
  }
}

TEST_F(Animation, AFishSwimsWithItsTailAndHardlyMovesItsHead) {
  options_.look = Look::fish;
  const Part ahead{0.55f, 0.9f, -0.5f, 0.5f}, behind{-0.9f, -0.6f, -0.5f, 0.5f};
  const sturnus::Image rest = at(0);
  float tail_low = 1e9f, tail_high = -1e9f, head_low = 1e9f, head_high = -1e9f;
  for (const float seconds : {0.0f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}) {
    const sturnus::Image now = at(seconds);
    const float tail = middle_of(now, {-0.48f, -0.38f, -0.5f, 0.5f}),
                head = middle_of(now, {0.35f, 0.45f, -0.5f, 0.5f});
    tail_low = std::min(tail_low, tail), tail_high = std::max(tail_high, tail);
    head_low = std::min(head_low, head), head_high = std::max(head_high, head);
    EXPECT_EQ(difference(rest, now, ahead), 0);
    EXPECT_EQ(difference(rest, now, behind), 0);
  }
  EXPECT_GT(tail_high - tail_low, 0.1f * body_length);
  EXPECT_LT(head_high - head_low, 0.05f * body_length);
}

TEST_F(Animation, ABirdFlapsItsWingsAndNothingElse) {
  options_.look = Look::birds;
  const Part head{0.21f, 0.45f, -0.06f, 0.06f}, tail{-0.5f, -0.16f, -0.15f, 0.15f};
  const Part left{-0.15f, 0.2f, 0.1f, 0.6f}, right{-0.15f, 0.2f, -0.6f, -0.1f};
  const sturnus::Image rest = at(0);
  double most_left = 0, most_right = 0;
  for (const float seconds : {0.05f, 0.1f, 0.15f, 0.2f, 0.3f}) {
    const sturnus::Image now = at(seconds);
    most_left = std::max(most_left, difference(rest, now, left));
    most_right = std::max(most_right, difference(rest, now, right));
    EXPECT_EQ(difference(rest, now, head), 0) << seconds;
    EXPECT_EQ(difference(rest, now, tail), 0) << seconds;
  }
  EXPECT_GT(most_left, 0.05);
  EXPECT_GT(most_right, 0.05);
}

TEST_F(Animation, AJumpingFishBitesWithItsJawsAlone) {
  options_.look = Look::fish;
  const Part jaws{0.3f, 0.6f, -0.3f, 0.3f}, rest{-0.9f, 0.29f, -0.6f, 0.6f};
  const sturnus::Image shut = at(0.1f);
  frame_.boids[0].flags = is_jumping;
  const sturnus::Image open = at(0.1f);
  EXPECT_GT(difference(shut, open, jaws), 0.02);
  EXPECT_EQ(difference(shut, open, rest), 0);
  EXPECT_GT(difference(open, at(0.4f), jaws), 0.01) << "it opens and shuts";
}

TEST_F(Animation, AnArrowStandsStill) {
  options_.look = Look::arrows;
  EXPECT_EQ(difference(at(0), at(0.37f), everywhere), 0);
}

// A fish of a few pixels is a patch of its flock's colour, without eyes and stripes.
TEST_F(Animation, SmallBodiesHaveTheirFlocksColourAndSomeBreadth) {
  auto scenario = *frame_.scenario;
  scenario.flocks[0].size = 8;
  frame_.scenario = std::make_shared<sturnus::ScenarioDef>(scenario);
  for (const Look look : {Look::fish, Look::birds}) {
    options_.look = look;
    for (const sturnus::ThemeName theme : {sturnus::ThemeName::dark, sturnus::ThemeName::light}) {
      options_.theme = theme;
      const sturnus::Image image = at(0);
      const sturnus::Rgba own = flock_colour(scenario, 0, theme), ground = colours(theme).background;
      int covered = 0;
      for (int y = 140; y < 180; ++y) {
        for (int x = 220; x < 260; ++x) {
          const sturnus::Rgba seen = image.at(x, y);
          if (seen == ground) continue;
          ++covered;
          // The flock's colour in more or less light, or mixed with the ground at the body's edge.
          if (theme == sturnus::ThemeName::dark) {
            EXPECT_LE(seen.r, own.r + 40) << "an eye or a belly";
          }
        }
      }
      EXPECT_GE(covered, 18) << static_cast<int>(look) << ": thinner than can be seen";
    }
  }
}

TEST_F(Animation, TheTrackedUnitIsSeenInADenseFlock) {
  frame_.dimensions = 3;
  frame_.extent = {{0, 0, 0}, {480, 320, 300}};
  auto scenario = *frame_.scenario;
  scenario.flocks[0].size = 30;
  frame_.scenario = std::make_shared<sturnus::ScenarioDef>(scenario);
  camera_.fit(frame_.extent, 3);
  const Point middle = camera_.middle();
  frame_.boids.clear();
  for (int i = 0; i < 60; ++i) {
    const Point place = middle - camera_.forward() * static_cast<float>(3 * i);
    Instance boid{};
    for (std::size_t axis = 0; axis < 3; ++axis) boid.position[axis] = boid.previous[axis] = place[axis];
    boid.velocity[0] = 2;
    frame_.boids.push_back(boid);
  }
  for (const Look look : {Look::arrows, Look::fish, Look::birds, Look::points}) {
    options_.look = look;
    Moment moment;
    moment.tracked = 0;  // behind all others
    view_->upload(frame_);
    view_->draw(frame_, camera_, options_, moment, Shapes(camera_, 1));
    const sturnus::Image image = read_pixels(size);
    const Point pixel = camera_.project(middle);
    const sturnus::Rgba seen = image.at(static_cast<int>(pixel[0]), static_cast<int>(pixel[1]));
    EXPECT_GT(seen.r, seen.g + 60) << "not red with look " << static_cast<int>(look);
    EXPECT_GT(seen.r, seen.b + 60) << "not red with look " << static_cast<int>(look);
  }
}

}  // namespace
}  // namespace studio
