// A virtual screen for programs with a window: an X server in memory, and hands that type and point.
#pragma once

#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "program.h"

namespace program_test {

/// A variable of the surroundings, for as long as this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { before_.empty() ? unsetenv(name_) : setenv(name_, before_.c_str(), 1); }

 private:
  const char* name_;
  std::string before_;
};

/// The words of a line with single spaces between them.
inline Words split(const std::string& line) {
  Words words;
  std::size_t begin = 0;
  while (begin < line.size()) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    if (end > begin) words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Asks again and again, for half a minute.
template <class Question>
bool wait_for(const Question& question) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!question()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

/// Every test has a screen of its own; without Xvfb or xdotool it is skipped.
class ScreenTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (!is_installed("Xvfb")) GTEST_SKIP() << "there is no Xvfb (package xvfb)";
    if (!is_installed("xdotool")) GTEST_SKIP() << "there is no xdotool (package xdotool)";
    server_ = std::make_unique<Running>(
        Words{"/bin/sh", "-c",
              "exec Xvfb -displayfd 3 -screen 0 800x600x24 -fbdir . -nolisten tcp 3>display"},
        here());
    ASSERT_TRUE(wait_for([&] { return exists("display") && line_count(read("display")) == 1; }));
    const std::string number = read("display");
    display_ = std::make_unique<Variable>("DISPLAY", ":" + number.substr(0, number.size() - 1));
  }

  void TearDown() override {
    if (server_) {  // asked to end, it takes its lock on the display with it
      kill(server_->id(), SIGTERM);
      server_->wait();
    }
    server_.reset();
    ProgramTest::TearDown();
  }

  std::string xdotool(const std::string& line) const {
    return Running(split("xdotool " + line), here()).wait().out;
  }
  void press(const std::string& key) const { xdotool("key " + key); }
  /// The window whose title matches; empty while there is none.
  std::string find_window(const std::string& title) const {
    const std::string found = xdotool("search --onlyvisible --name " + title);
    return found.substr(0, found.find('\n'));
  }

 private:
  static bool is_installed(const char* program) {
    return Running({"/bin/sh", "-c", std::string("command -v ") + program}, {}).wait().code == 0;
  }

  std::unique_ptr<Running> server_;
  std::unique_ptr<Variable> display_;
};

}  // namespace program_test
