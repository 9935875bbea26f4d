// posix_spawn around the program, with its streams kept in nameless files; and that this tells truth from
// error.
#include "program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <sstream>
#include <thread>

extern char** environ;

namespace program_test {
namespace {

std::string text_of(int file) {
  std::string text;
  char buffer[1 << 14];
  lseek(file, 0, SEEK_SET);
  for (ssize_t got = 0; (got = ::read(file, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(got));
  return text;
}

// The surroundings of the program: ours, but for the PATH and what the test sets.
std::vector<std::string> environment(const StartOptions& options) {
  std::vector<std::string> out = options.variables;
  if (!options.path.empty()) out.push_back("PATH=" + options.path);
  const auto is_set = [set = out](const std::string& entry) {
    const std::string name = entry.substr(0, entry.find('=') + 1);
    return std::any_of(set.begin(), set.end(), [&](const std::string& one) { return one.starts_with(name); });
  };
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!is_set(*entry)) out.emplace_back(*entry);
  }
  return out;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

// A program that should have refused 1e12 steps and does them instead must not stay.
bool wait_or_kill(pid_t id, int* status, std::chrono::seconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  for (;;) {
    const pid_t ended = waitpid(id, status, WNOHANG);
    if (ended != 0) return ended == id;
    if (std::chrono::steady_clock::now() > end) ::kill(id, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace

Running::Running(const Words& words, const StartOptions& options)
    : out_(memfd_create("out", MFD_CLOEXEC)), err_(memfd_create("err", MFD_CLOEXEC)) {
  int unread[2] = {-1, -1};
  if (options.closed_output && pipe2(unread, O_CLOEXEC) == 0) ::close(unread[0]);

  int terminal = -1;
  if (options.terminal) {
    ::close(err_);
    err_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (grantpt(err_) == 0 && unlockpt(err_) == 0)
      terminal = ::open(ptsname(err_), O_RDWR | O_NOCTTY | O_CLOEXEC);
  }

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!options.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, options.input.c_str(), O_RDONLY, 0);
  if (options.output.empty()) {
    posix_spawn_file_actions_adddup2(&actions, options.closed_output ? unread[1] : out_, 1);
  } else {
    posix_spawn_file_actions_addopen(&actions, 1, options.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  }
  posix_spawn_file_actions_adddup2(&actions, options.terminal ? terminal : err_, 2);

  // The test may run where SIGINT is ignored, as in a shell's background job.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t defaults;
  sigemptyset(&defaults);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&defaults, signal);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  std::vector<std::string> arguments = words, variables = environment(options);
  const int error = posix_spawnp(&id_, words.front().c_str(), &actions, &attributes,
                                 pointers_to(arguments).data(), pointers_to(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (unread[1] >= 0) ::close(unread[1]);
  if (terminal >= 0) ::close(terminal);
  if (error != 0) {
    id_ = -1;
    ADD_FAILURE() << words.front() << " cannot be started: " << std::strerror(error);
  }
}

Running::~Running() {
  if (id_ > 0) {
    ::kill(id_, SIGKILL);
    wait();
  }
  ::close(out_);
  ::close(err_);
}

bool Running::wait_until_it_works() const {
  for (;;) {
    std::ifstream status("/proc/" + std::to_string(id_) + "/status");
    std::string line;
    while (std::getline(status, line)) {
      if (line.starts_with("State:") && contains(line, "zombie")) return false;
      if (!line.starts_with("SigCgt:")) continue;
      const unsigned long long caught = std::stoull(line.substr(7), nullptr, 16);
      if ((caught >> (SIGINT - 1) & 1) != 0) return true;
    }
    if (!status.is_open() || id_ <= 0) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

Ended Running::wait(std::chrono::seconds longest) {
  Ended ended;
  int status = 0;
  if (id_ > 0 && wait_or_kill(id_, &status, longest)) {
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  id_ = -1;
  ended.out = text_of(out_);
  ended.err = text_of(err_);
  return ended;
}

Words sturnus_words(const Words& arguments) {
  const char* given = std::getenv("STURNUS");
  Words words = {given != nullptr ? given : STURNUS_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

void ProgramTest::SetUp() {
  std::string pattern = (std::filesystem::temp_directory_path() / "sturnus-test-XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr) << std::strerror(errno);
  folder_ = pattern;
}

void ProgramTest::TearDown() {
  std::error_code error;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, error);
}

Ended ProgramTest::run(const Words& arguments, StartOptions options) const {
  if (options.folder.empty()) options.folder = folder_;
  return Running(sturnus_words(arguments), options).wait();
}

Ended ProgramTest::run_well(const Words& arguments) const {
  Ended ended = run(arguments);
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  EXPECT_EQ(ended.code, 0) << "sturnus" << line << "\n" << ended.err;
  return ended;
}

void ProgramTest::expect_refusal(const Words& words, const std::string& sentence) const {
  const std::set<std::string> before = files();
  const Ended ended = run(words);
  EXPECT_EQ(ended.code, 2) << sentence;
  EXPECT_EQ(ended.out, "");
  EXPECT_SAYS(ended.err, sentence);
  EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
  EXPECT_EQ(files(), before);
}

void ProgramTest::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string ProgramTest::read(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  EXPECT_TRUE(file.is_open()) << name << " is not there";
  return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> ProgramTest::files() const {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    names.insert(std::filesystem::relative(entry.path(), folder_).string());
  }
  return names;
}

std::string hash_in(const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("hash ([0-9a-f]{16})\\b")) ? match[1].str() : "";
}

std::vector<std::string> shipped_names(const std::string& listing) {
  std::vector<std::string> names;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  ")) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

namespace {

class Harness : public ProgramTest {
 protected:
  Ended shell(const std::string& script, StartOptions options = {}) const {
    if (options.folder.empty()) options.folder = folder();
    return Running({"/bin/sh", "-c", script}, options).wait();
  }
};

TEST_F(Harness, TellsCodesStreamsAndSignalsApart) {
  const Ended ended = shell("echo out; echo err >&2; pwd > where; exit 7");
  EXPECT_EQ(ended.code, 7);
  EXPECT_EQ(ended.out, "out\n");
  EXPECT_EQ(ended.err, "err\n");
  EXPECT_EQ(read("where"), folder() + "\n");
  EXPECT_EQ(files(), std::set<std::string>{"where"});
  EXPECT_EQ(shell("kill -9 $$").code, 137);
  EXPECT_EQ(hash_in("hash 0123456789abcdef"), "0123456789abcdef");
  EXPECT_EQ(hash_in("hash 0123"), "");
}

TEST_F(Harness, ChangesTheSurroundings) {
  StartOptions options;
  options.path = "/nonexistent";
  EXPECT_EQ(shell("echo $PATH", options).out, "/nonexistent\n");
  options.variables = {"STURNUS_HARNESS=here"};
  EXPECT_EQ(shell("echo $STURNUS_HARNESS", options).out, "here\n");
  options.closed_output = true;
  EXPECT_NE(shell("trap '' PIPE; echo lost", options).code, 0);
}

}  // namespace
}  // namespace program_test
