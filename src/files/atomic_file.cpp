// Atomic writing over POSIX calls: they report every error, at the call that meets it.
#include "files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace sturnus {
namespace {

Problem plain_problem(const std::string& path, std::string text) {
  Problem problem;
  problem.file = path;
  problem.text = std::move(text);
  return problem;
}

// 0, or the errno of the first write that failed. ENOSPC may come with any write, and with fsync and close.
int write_all(int file, std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

// Some file systems and all pipes cannot be synchronised; that is not a failure to write.
int synchronise(int file) {
  if (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS) return 0;
  return errno;
}

int close_file(int file) {
  return ::close(file) == 0 || errno == EINTR ? 0 : errno;
}

// The descriptor that a name such as /dev/stdout stands for, or -1. Opening such a name again would start at
// the beginning of a file that the shell has put there, and renaming over it would destroy the name.
int inherited_descriptor(const std::string& path) {
  if (path == "/dev/stdout") return 1;
  if (path == "/dev/stderr") return 2;
  constexpr std::string_view prefix = "/dev/fd/";
  if (path.compare(0, prefix.size(), prefix) != 0) return -1;
  int number = -1;
  const char* end = path.data() + path.size();
  const auto parsed = std::from_chars(path.data() + prefix.size(), end, number);
  return parsed.ec == std::errc() && parsed.ptr == end ? number : -1;
}

// Devices, pipes and sockets: there is nothing to rename. Returns 0 or an errno.
int write_directly(const std::string& path, std::span<const unsigned char> bytes) {
  const int inherited = inherited_descriptor(path);
  const int file =
      inherited >= 0 ? ::fcntl(inherited, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = write_all(file, bytes);
  const int close_error = close_file(file);
  return error != 0 ? error : close_error;
}

// A new file with the bytes, on the disk; 0 or an errno.
int write_new(const std::string& path, mode_t mode, std::span<const unsigned char> bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0) return errno;
  int error = write_all(file, bytes);
  if (error == 0) error = synchronise(file);
  const int close_error = close_file(file);
  return error != 0 ? error : close_error;
}

// Makes the new name itself survive a power cut. Best effort: the file is complete either way.
void synchronise_folder(const std::string& path) {
  const std::string folder = folder_of(path);
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  static_cast<void>(::fsync(file));
  ::close(file);
}

// Where a link points, so that the file behind it is replaced and the link stays.
std::string link_target(const std::string& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0 || !S_ISLNK(info.st_mode)) return path;
  char* resolved = ::realpath(path.c_str(), nullptr);
  if (resolved == nullptr) return path;
  std::string target = resolved;
  std::free(resolved);
  return target;
}

}  // namespace

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string unfinished_name(const std::string& path) {
  static std::atomic<unsigned> count{0};
  const std::string target = link_target(path);
  const std::string folder = folder_of(target);
  // A name may have 255 bytes; a long one is cut, and the numbers keep it unique.
  const std::string name = target.substr(folder.size(), 200);
  return folder + "." + name + "." + std::to_string(::getpid()) + "." + std::to_string(++count) + ".part";
}

Problem cannot_write(const std::string& path, int error_number) {
  return plain_problem(path, std::string("cannot be written: ") + std::strerror(error_number));
}

bool is_stream(const std::string& path) {
  if (inherited_descriptor(path) >= 0) return true;
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

Status check_writable(const std::string& path) {
  if (path.empty()) return plain_problem({}, "the name of the file to write is empty");
  struct stat info {};
  const bool exists = ::stat(path.c_str(), &info) == 0;
  if (path.back() == '/' || (exists && S_ISDIR(info.st_mode))) return cannot_write(path, EISDIR);
  if (exists && ::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);
  if (is_stream(path)) return {};
  const std::string folder = folder_of(link_target(path));
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) return cannot_write(path, errno);
  return {};
}

Status publish(const std::string& unfinished, const std::string& path) {
  const int file = ::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC);
  int error = file < 0 ? errno : synchronise(file);
  if (file >= 0) ::close(file);
  const std::string target = link_target(path);
  if (error == 0 && std::rename(unfinished.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(unfinished.c_str());
    return cannot_write(path, error);
  }
  synchronise_folder(target);
  return {};
}

Status write_file(const std::string& path, std::span<const unsigned char> bytes) {
  const Status possible = check_writable(path);
  if (!possible) return possible;
  if (is_stream(path)) {
    const int error = write_directly(path, bytes);
    return error == 0 ? Status() : Status(cannot_write(path, error));
  }
  struct stat info {};
  const mode_t mode = ::stat(path.c_str(), &info) == 0 ? info.st_mode & 0777 : 0666;
  const std::string unfinished = unfinished_name(path);
  const int error = write_new(unfinished, mode, bytes);
  if (error != 0) {
    ::unlink(unfinished.c_str());
    return cannot_write(path, error);
  }
  return publish(unfinished, path);
}

Status write_file(const std::string& path, std::string_view text) {
  return write_file(path, std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

Status make_folders(const std::string& path) {
  for (std::size_t end = 0; end != std::string::npos && end < path.size();) {
    end = path.find('/', end + 1);
    const std::string folder = path.substr(0, end);
    if (folder.empty() || ::mkdir(folder.c_str(), 0777) == 0 || errno == EEXIST) continue;
    const int error = errno;
    return plain_problem(folder, std::string("the folder cannot be created: ") + std::strerror(error));
  }
  struct stat info {};
  if (!path.empty() && (::stat(path.c_str(), &info) != 0 || !S_ISDIR(info.st_mode))) {
    return plain_problem(path, std::string("the folder cannot be created: ") + std::strerror(ENOTDIR));
  }
  return {};
}

}  // namespace sturnus
