// prog06 as its user meets it: a real window on a real (virtual) screen, real keys, the real file.
#include <signal.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <thread>

#include "prog06_support.h"
#include "screen.h"

namespace program_test {
namespace {

using sturnus::Image;

constexpr sturnus::Size size{320, 240};

class Prog06Window : public ScreenTest {
 protected:
  void SetUp() override {
    ScreenTest::SetUp();
    if (!IsSkipped()) start();
  }

  void TearDown() override {
    program_.reset();
    ScreenTest::TearDown();
  }

  // Opens the window and gives it the keyboard.
  void start() {
    program_ =
        std::make_unique<Running>(prog06_words(split("200 0.4 0.1 0.3 1.0 out.ppm --size 320x240")), here());
    ASSERT_TRUE(wait_for([&] { return !(window_ = find_window("^prog06")).empty(); }));
    ASSERT_TRUE(
        wait_for([&] { return xdotool("getwindowname " + window_) == "prog06: 200 boids, step 0\n"; }));
    xdotool("windowfocus " + window_);
    ASSERT_TRUE(wait_for([&] { return xdotool("getwindowfocus") == window_ + "\n"; }));
  }

  int step() const {
    const std::string title = xdotool("getwindowname " + window_);
    const auto at = title.rfind(' ');
    return at == std::string::npos ? -1 : std::atoi(title.c_str() + at);
  }

  // Presses w and waits for a file that was not there before.
  Image written() const {
    std::filesystem::remove(path("out.ppm"));
    press("w");
    EXPECT_TRUE(wait_for([&] { return exists("out.ppm"); }));
    return ppm_picture(read("out.ppm"));
  }

  int number_of(const std::string& text, const std::string& name) const {
    const auto at = text.find(name + "=");
    return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + name.size() + 1);
  }

  // The window's pixels out of the screen's memory, an XWD file: big-endian header, pixels of blue, green,
  // red.
  Image on_screen() const {
    const std::string geometry = xdotool("getwindowgeometry --shell " + window_);
    const std::string file = read("Xvfb_screen0");
    const auto field = [&](std::size_t i) {
      std::size_t value = 0;
      for (std::size_t byte = 4 * i; byte < 4 * i + 4; ++byte)
        value = value << 8 | static_cast<unsigned char>(file.at(byte));
      return value;
    };
    const std::size_t begin = field(0) + 12 * field(19), row_bytes = field(12);
    EXPECT_EQ(field(11), 32u) << "bits of a pixel";
    const auto left = static_cast<std::size_t>(number_of(geometry, "X"));
    const auto top = static_cast<std::size_t>(number_of(geometry, "Y"));
    EXPECT_EQ(number_of(geometry, "WIDTH"), size.width);
    EXPECT_EQ(number_of(geometry, "HEIGHT"), size.height);
    Image image(size, {});
    for (std::size_t y = 0; y < 240; ++y) {
      for (std::size_t x = 0; x < 320; ++x) {
        const std::size_t pixel = begin + (top + y) * row_bytes + 4 * (left + x);
        for (std::size_t channel = 0; channel < 3; ++channel) {
          image.rgb[3 * (320 * y + x) + channel] = static_cast<std::uint8_t>(file.at(pixel + 2 - channel));
        }
      }
    }
    return image;
  }

  void expect_shown(const Image& image) const {
    EXPECT_EQ(image.size(), size);
    EXPECT_TRUE(wait_for([&] { return on_screen() == image; })) << "the window differs from the file";
  }

  // How often the program went to sleep.
  long rests() const {
    std::ifstream file("/proc/" + std::to_string(program_->id()) + "/status");
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("voluntary_ctxt_switches:")) return std::atol(line.c_str() + line.find(':') + 1);
    }
    return -1;
  }

  std::unique_ptr<Running> program_;
  std::string window_;
};

TEST_F(Prog06Window, TheKeysDoWhatTheAssignmentSays) {
  const Image first = written();
  expect_shown(first);
  EXPECT_EQ(step(), 0);

  press("s");
  ASSERT_TRUE(wait_for([&] { return step() == 1; }));
  const Image second = written();
  EXPECT_NE(second, first);
  expect_shown(second);

  press("a");
  ASSERT_TRUE(wait_for([&] { return step() > 5; }));
  press("a");
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const int stopped = step();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(step(), stopped);
  expect_shown(written());

  press("q");
  const Ended ended = program_->wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_SAYS(ended.out, "out.ppm: step 1\n");
}

TEST_F(Prog06Window, EscapeQuits) {
  press("Escape");
  EXPECT_EQ(program_->wait().code, 0);
  EXPECT_FALSE(exists("out.ppm"));
}

TEST_F(Prog06Window, AnInterruptQuitsAPausedWindow) {
  kill(program_->id(), SIGINT);
  EXPECT_EQ(program_->wait().code, 130);
}

TEST_F(Prog06Window, AMouseButtonHoldsTheBoids) {
  const Image free = written();
  xdotool("mousemove --window " + window_ + " 250 60 mousedown 1");
  ASSERT_TRUE(wait_for([&] { return on_screen() != free; }));  // the cross
  const Image held = written();
  expect_shown(held);
  const sturnus::Rgba cross = held.at(250, 60);
  EXPECT_NEAR(cross.b, 0xe9, 8);
  // Everybody is pulled there: far more of them stand in that corner than before.
  for (int i = 0; i < 60; ++i) press("s");
  ASSERT_TRUE(wait_for([&] { return step() == 60; }));
  expect_shown(written());
  xdotool("mouseup 1");
  ASSERT_TRUE(wait_for([&] { return on_screen().at(250, 60) != cross; }));
}

TEST_F(Prog06Window, KeysOfOneMomentAreTakenInTheirOrder) {
  const Image before = written();
  std::filesystem::remove(path("out.ppm"));
  kill(program_->id(), SIGSTOP);  // so that all three keys wait for it
  xdotool("key s w s");
  kill(program_->id(), SIGCONT);
  ASSERT_TRUE(wait_for([&] { return step() == 2 && exists("out.ppm"); }));
  const Image between = ppm_picture(read("out.ppm"));
  const Image after = written();
  EXPECT_NE(between, before);
  EXPECT_NE(between, after);
  expect_shown(after);
}

TEST_F(Prog06Window, APausedProgramSleepsUntilAnEventComes) {
  const long before = rests();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_GE(before, 1);
  EXPECT_LE(rests() - before, 20);  // sixty, if it drew frames
}

}  // namespace
}  // namespace program_test
