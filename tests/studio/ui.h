// A studio without a display, and a hand that presses its keys and moves its mouse, frame by frame.
#pragma once

#include <SDL.h>
#include <gtest/gtest.h>
#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "studio.h"

namespace studio::test {

class Ui : public ::testing::Test {
 protected:
  virtual sturnus::Size window_size() const { return {1280, 800}; }

  void SetUp() override {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    here_ = std::filesystem::current_path();
    folder_ = std::filesystem::temp_directory_path() /
              ("sturnus-studio-" + std::to_string(getpid()) + "-" +
               std::filesystem::path(::testing::UnitTest::GetInstance()->current_test_info()->name())
                   .filename()
                   .string());
    std::filesystem::create_directories(folder_);
    std::filesystem::current_path(folder_);
  }

  void TearDown() override {
    keep_picture();
    studio_.reset();
    std::filesystem::current_path(here_);
    std::filesystem::remove_all(folder_);
  }

  /// Opens a shipped scenario, with so many boids in its first flock.
  void open(const std::string& name, std::int64_t count = 200) {
    auto scenario = sturnus::load_scenario(name);
    ASSERT_TRUE(scenario) << scenario.error();
    scenario->flocks[0].count = count;
    open(*scenario);
  }
  void open(const sturnus::ScenarioDef& scenario) {
    auto simulation = sturnus::open_simulation(scenario, 1);
    ASSERT_TRUE(simulation) << simulation.error();
    StudioOptions options;
    options.memory = memory_;
    options.points = window_size();
    options.threads = 1;
    options.history_bytes = std::size_t{64} << 20;
    options.in_lockstep = true;
    auto opened = Studio::open(std::move(*simulation), options);
    ASSERT_TRUE(opened) << opened.error();
    studio_ = std::move(*opened);
    frames(2);
  }

  void frames(int count = 1) {
    for (int i = 0; i < count; ++i) studio_->frame();
  }
  void pause() {
    desk().playback.play(false);
    frames(3);
  }

  void key(SDL_Keycode code, int mod = KMOD_NONE) {
    for (const Uint32 type : {SDL_KEYDOWN, SDL_KEYUP}) {
      SDL_Event event{};
      event.type = type;
      event.key.keysym.sym = code;
      event.key.keysym.scancode = SDL_GetScancodeFromKey(code);
      event.key.keysym.mod = static_cast<Uint16>(mod);
      event.key.state = type == SDL_KEYDOWN ? SDL_PRESSED : SDL_RELEASED;
      SDL_SetModState(static_cast<SDL_Keymod>(mod));
      SDL_PushEvent(&event);
      frames();
    }
    SDL_SetModState(KMOD_NONE);
    frames();
  }
  void move(float x, float y) {
    push_motion(x, y);
    frames();
  }
  void push_motion(float x, float y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = static_cast<int>(x);
    event.motion.y = static_cast<int>(y);
    event.motion.xrel = event.motion.x - static_cast<int>(x_);
    event.motion.yrel = event.motion.y - static_cast<int>(y_);
    x_ = x;
    y_ = y;
    SDL_PushEvent(&event);
  }
  void button(bool down, Uint8 which = SDL_BUTTON_LEFT) {
    SDL_Event event{};
    event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
    event.button.button = which;
    event.button.x = static_cast<int>(x_);
    event.button.y = static_cast<int>(y_);
    SDL_PushEvent(&event);
    frames();
  }
  void click(float x, float y, Uint8 which = SDL_BUTTON_LEFT) {
    move(x, y);
    button(true, which);
    button(false, which);
    frames();
  }
  void drag(float x, float y, float to_x, float to_y, Uint8 which = SDL_BUTTON_LEFT, int steps = 8) {
    move(x, y);
    button(true, which);
    for (int i = 1; i <= steps; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(steps);
      move(x + (to_x - x) * part, y + (to_y - y) * part);
    }
    button(false, which);
    frames();
  }
  void wheel(int notches, int mod = KMOD_NONE) {
    SDL_Event event{};
    event.type = SDL_MOUSEWHEEL;
    event.wheel.y = notches;
    SDL_SetModState(static_cast<SDL_Keymod>(mod));
    SDL_PushEvent(&event);
    frames(2);
    SDL_SetModState(KMOD_NONE);
  }
  /// Clicks a widget by its name.
  void press(const std::string& item) {
    ASSERT_TRUE(desk().items.count(item)) << "there is no " << item;
    const Box box = desk().items[item];
    click(box.x + box.width / 2, box.y + box.height / 2);
  }
  void drag_item(const std::string& item, float dx, float from = 0.5f) {
    ASSERT_TRUE(desk().items.count(item)) << "there is no " << item;
    const Box box = desk().items[item];
    const float x = box.x + box.width * from, y = box.y + box.height / 2;
    drag(x, y, x + dx, y);
  }

  /// Where in the window a place of the world is, points.
  std::array<float, 2> seen(const Point& at) {
    const Point pixel = desk().camera.project(at);
    return {pixel[0] / desk().density, pixel[1] / desk().density};
  }

  Desk& desk() { return studio_->desk(); }
  const Frame& world() { return *desk().frame; }
  /// What the simulation's thread has, asked between two steps.
  template <class Question>
  auto ask(Question question) {
    decltype(question(std::declval<World&>())) answer{};
    desk().session.order([&](World& asked) {
      answer = question(asked);
      return sturnus::Status();
    });
    desk().session.settle();
    return answer;
  }
  std::uint64_t hash() {
    return ask([](World& asked) { return asked.simulation().hash(); });
  }
  std::string value(const std::string& path) { return *sturnus::get_parameter(*world().scenario, path); }

  std::unique_ptr<Studio> studio_;
  std::string memory_;  ///< of an earlier visit: a first visit unless told

 private:
  // Where $STURNUS_SHOTS names a folder, as ctest does, what a test saw last is kept there.
  void keep_picture() {
    const char* shots = std::getenv("STURNUS_SHOTS");
    if (shots == nullptr || !studio_) return;
    const auto& test = *::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test.test_suite_name()) + "." + test.name() + ".png";
    std::replace(name.begin(), name.end(), '/', '-');
    std::filesystem::create_directories(shots);
    EXPECT_TRUE(sturnus::save_picture(std::string(shots) + "/" + name, studio_->picture(true)));
  }

  std::filesystem::path here_, folder_;
  float x_ = 0, y_ = 0;
};

}  // namespace studio::test
