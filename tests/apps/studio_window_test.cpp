// The studio as its user meets it: a real window on a (virtual) screen, real keys and a real mouse.
#include "screen.h"

namespace program_test {
namespace {

class StudioWindow : public ScreenTest {
 protected:
  // Opens the window and gives it the keyboard.
  void SetUp() override {
    ScreenTest::SetUp();
    if (IsSkipped()) return;
    program_ = std::make_unique<Running>(Words{STURNUS_STUDIO, "ucsd", "--size", "780x560", "--threads", "1"},
                                         here());
    ASSERT_TRUE(wait_for([&] { return !(window_ = find_window("^ucsd")).empty(); }));
    xdotool("windowfocus " + window_);
    ASSERT_TRUE(wait_for([&] { return xdotool("getwindowfocus") == window_ + "\n"; }));
  }
  void TearDown() override {
    program_.reset();
    ScreenTest::TearDown();
  }

  // The names of the pictures that were saved, after one more.
  std::set<std::string> pictures_after(const std::string& key) const {
    const std::size_t before = pictures().size();
    press(key);
    EXPECT_TRUE(wait_for([&] { return pictures().size() > before; }));
    return pictures();
  }
  std::set<std::string> pictures() const {
    std::set<std::string> found;
    for (const std::string& name : files()) {
      if (name.ends_with(".png")) found.insert(name);
    }
    return found;
  }

  // What "save session" of the gallery writes. The buttons are at its lower right: a hand that does not know
  // where tries from below.
  std::string saved_session() const {
    press("g");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    std::string found;
    const auto has_session = [&] {
      for (const std::string& name : files()) {
        if (name.ends_with(".toml") && read(name).find("events") != std::string::npos) found = read(name);
      }
      return !found.empty();
    };
    for (int y = 530; y > 470 && !has_session(); y -= 10) {
      for (int x = 490; x < 760 && !has_session(); x += 30) {
        xdotool("mousemove --window " + window_ + " " + std::to_string(x) + " " + std::to_string(y) +
                " click 1");
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
      }
    }
    EXPECT_TRUE(has_session()) << "no session was saved";
    return found;
  }

  std::unique_ptr<Running> program_;
  std::string window_;
};

TEST_F(StudioWindow, KeysAndMouseReachTheWorldAndCtrlQEndsIt) {
  const std::string first = *pictures_after("w").begin();
  EXPECT_TRUE(first.starts_with("ucsd-")) << first;
  EXPECT_TRUE(is_png(read(first)));
  press("space");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(pictures_after("w").size(), 2u) << "a later step";
  press("period");  // one step more, and its number is the picture's name
  EXPECT_EQ(pictures_after("w").size(), 3u);
  xdotool("mousemove --window " + window_ + " 300 250 key 2 click 1");
  const std::string session = saved_session();
  EXPECT_NE(session.find("\"obstacle\""), std::string::npos) << "the click put an obstacle there:\n"
                                                             << session;
  EXPECT_EQ(session.find("\"obstacle\""), session.rfind("\"obstacle\"")) << "one click, one obstacle:\n"
                                                                         << session;
  press("Escape");
  press("Escape");
  xdotool("key ctrl+q");
  const Ended ended = program_->wait(std::chrono::seconds(60));
  EXPECT_EQ(ended.code, 0) << ended.err;
}

}  // namespace
}  // namespace program_test
