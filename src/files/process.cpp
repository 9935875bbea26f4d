// posix_spawn, a pipe, and a signal that must not kill us.
#include "files/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>

extern char** environ;

namespace sturnus {
namespace {

// While it lives, a write to a closed pipe gives EPIPE in this thread and kills nobody; the host program's
// own handling of SIGPIPE is as before afterwards.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() {
    sigemptyset(&pipe_signal_);
    sigaddset(&pipe_signal_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_signal_, &before_);
  }
  ~NoBrokenPipeSignal() {
    const timespec now{};
    if (!was_pending_) {
      while (sigtimedwait(&pipe_signal_, nullptr, &now) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
  NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

 private:
  sigset_t pipe_signal_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

int open_nameless_file() {
  std::FILE* file = std::tmpfile();
  if (file == nullptr) return ::open("/dev/null", O_RDWR | O_CLOEXEC);
  const int copy = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3);
  std::fclose(file);
  return copy;
}

// Starts the child with its three standard streams; 0 or an errno.
int spawn(const std::vector<std::string>& words, int input, int complaints, pid_t* child) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, complaints, 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

void close_if_open(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

}  // namespace

Process::~Process() {
  kill();
  close_if_open(complaints_);
}

int Process::start(const std::vector<std::string>& words) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return errno;
  complaints_ = open_nameless_file();
  const int error = complaints_ < 0 ? errno : spawn(words, ends[0], complaints_, &child_);
  ::close(ends[0]);
  input_ = ends[1];
  if (error != 0) {
    child_ = -1;
    close_if_open(input_);
  }
  return error;
}

int Process::write(std::span<const unsigned char> bytes) {
  const NoBrokenPipeSignal quiet;
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

int Process::wait() {
  close_if_open(input_);
  if (child_ < 0) return 0;
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0) {
    if (errno != EINTR) return 127;
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Process::kill() {
  if (child_ > 0) ::kill(child_, SIGKILL);
  wait();
}

std::string Process::last_complaint() const {
  char text[4096];
  const off_t size = complaints_ < 0 ? 0 : ::lseek(complaints_, 0, SEEK_END);
  const off_t start = size > static_cast<off_t>(sizeof text) ? size - static_cast<off_t>(sizeof text) : 0;
  const ssize_t got = size <= 0 ? 0 : ::pread(complaints_, text, sizeof text, start);
  std::string all(text, got > 0 ? static_cast<std::size_t>(got) : 0);
  const std::size_t end = all.find_last_not_of(" \r\n");
  if (end == std::string::npos) return {};
  all.resize(end + 1);
  const std::size_t begin = all.find_last_of("\r\n");
  return begin == std::string::npos ? all : all.substr(begin + 1);
}

}  // namespace sturnus
