// Runs the built program as a person would: words in, exit code, two streams and files out.
#pragma once

#include <gtest/gtest.h>

#include <sys/types.h>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace program_test {

using Words = std::vector<std::string>;

/// How a program ended and what it said.
struct Ended {
  int code = -1;  ///< exit status, or 128 plus the signal that killed it
  std::string out, err;
};

struct StartOptions {
  std::string folder;  ///< where it stands
  std::string path;    ///< PATH; empty: as here
  std::string input = "/dev/null";
  std::string output;                  ///< a file for standard output in place of `Ended::out`
  bool closed_output = false;          ///< standard output is a pipe that nobody reads
  bool terminal = false;               ///< standard error is a terminal
  std::vector<std::string> variables;  ///< more of the surroundings, as NAME=value
};

/// A program that runs.
class Running {
 public:
  Running(const Words& words, const StartOptions& options);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

  pid_t id() const { return id_; }
  /// Waits until the program handles Ctrl-C, i.e. works; false when it ended before.
  bool wait_until_it_works() const;
  /// Waits for its end, but not for ever: then it is killed.
  Ended wait(std::chrono::seconds longest = std::chrono::seconds(240));

 private:
  pid_t id_ = -1;
  int out_ = -1, err_ = -1;
};

/// The program under test with these arguments.
Words sturnus_words(const Words& arguments);

/// Every test has an empty folder of its own in which the program stands.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  Ended run(const Words& arguments, StartOptions options = {}) const;
  /// The same, and it must end with 0.
  Ended run_well(const Words& arguments) const;
  /// Runs these words, which have to be refused with this sentence alone, and leave no file.
  void expect_refusal(const Words& words, const std::string& sentence) const;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  const std::string& folder() const { return folder_; }
  /// Options for a program that stands in the test's folder.
  StartOptions here() const {
    StartOptions options;
    options.folder = folder_;
    return options;
  }

  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Names of all files and folders, hidden ones too, relative to the test's folder.
  std::set<std::string> files() const;

 private:
  std::string folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
inline std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}
inline bool is_png(const std::string& bytes) {
  return bytes.starts_with("\x89PNG\r\n");
}

/// The sixteen digits after "hash ", or empty.
std::string hash_in(const std::string& text);
/// Names of all shipped scenarios, as `sturnus list` has them.
std::vector<std::string> shipped_names(const std::string& listing);

#define EXPECT_SAYS(text, part) \
  EXPECT_TRUE(::program_test::contains(text, part)) << "in: " << (text) << "\nmissing: " << (part)

}  // namespace program_test
