// A whole studio without a display, in a folder of its own, and files to put there.
#pragma once

#include <SDL.h>
#include <gtest/gtest.h>
#include <sturnus/files.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "studio.h"

namespace studio {

/// What a command of the shell prints.
inline std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  char buffer[4096];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, got);
  pclose(pipe);
  return text;
}

/// Stands in an empty folder, with a list of recent files there too.
class InFolder : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/sturnus-studio-XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    setenv("XDG_STATE_HOME", (folder_ + "/state").c_str(), 1);
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  static void write(const std::string& name, const std::string& text) {
    ASSERT_TRUE(sturnus::write_text(name, text));
  }
  static std::string read(const std::string& name) {
    const auto text = sturnus::read_text(name);
    return text ? *text : "";
  }

 private:
  std::string folder_;
  std::filesystem::path before_;
};

class StudioTest : public InFolder {
 protected:
  /// A small world in lockstep; `scenario` is a shipped name or a file.
  void open(const std::string& scenario, std::int64_t count = 50) {
    auto def = sturnus::load_scenario(scenario);
    ASSERT_TRUE(def) << def.error();
    if (count > 0) def->flocks[0].count = count;
    auto simulation = sturnus::open_simulation(*def, 1);
    ASSERT_TRUE(simulation) << simulation.error();
    StudioOptions options;
    options.points = {640, 400};
    options.threads = 1;
    options.in_lockstep = true;
    auto opened = Studio::open(std::move(*simulation), options);
    ASSERT_TRUE(opened) << opened.error();
    studio_ = std::move(*opened);
    studio_->desk().files.watch(studio_->desk(), *def);
    frames(2);
  }
  void TearDown() override {
    studio_.reset();
    InFolder::TearDown();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(studio_->frame());
  }
  Desk& desk() { return studio_->desk(); }
  Studio& studio() { return *studio_; }
  const sturnus::ScenarioDef& scenario() { return desk().scenario(); }
  void press(SDL_Keycode key, int mod = 0) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    event.key.keysym.mod = static_cast<Uint16>(mod);
    SDL_PushEvent(&event);
    frames(2);
  }
  /// Clicks a widget by its name.
  void click(const std::string& item) {
    const Box box = desk().items.at(item);
    for (const Uint32 type : {SDL_MOUSEMOTION, SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP}) {
      SDL_Event event{};
      event.type = type;
      const int x = static_cast<int>(box.x + box.width / 2), y = static_cast<int>(box.y + box.height / 2);
      if (type == SDL_MOUSEMOTION) {
        event.motion.x = x;
        event.motion.y = y;
      } else {
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = x;
        event.button.y = y;
      }
      SDL_PushEvent(&event);
      frames(2);
    }
  }
  void drop(const std::string& file) {
    SDL_Event event{};
    event.type = SDL_DROPFILE;
    event.drop.file = SDL_strdup(file.c_str());
    SDL_PushEvent(&event);
    frames(2);
  }
  /// All that is said at the moment.
  std::string said() {
    std::string text;
    for (const ShownNote& shown : desk().notes) text += shown.note.text + "\n";
    return text;
  }
  /// The state's hash, from the simulation's own thread.
  std::uint64_t hash() {
    std::uint64_t out = 0;
    desk().session.order([&out](World& world) {
      out = world.simulation().hash();
      return sturnus::Status();
    });
    desk().session.settle();
    return out;
  }

 private:
  std::unique_ptr<Studio> studio_;
};

#define EXPECT_SAYS(text, part) \
  EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text) << "\nmissing: " << (part)

}  // namespace studio
