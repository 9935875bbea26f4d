// Standard output and standard error, with an eye on every write.
#include "output.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace program {
namespace {

int output_error = 0;  // errno of the first write to standard output that failed

void keep_error(bool good) {
  if (!good && output_error == 0) output_error = errno != 0 ? errno : EIO;
}

}  // namespace

void print(const std::string& text) {
  errno = 0;
  keep_error(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void show_output() {
  errno = 0;
  keep_error(std::fflush(stdout) == 0);
}

void tell(const std::string& sentence) {
  std::fputs((sentence + "\n").c_str(), stderr);
}

void tell(const sturnus::Problems& problems) {
  std::fputs(to_text(problems).c_str(), stderr);
}

int refuse(const sturnus::Problems& problems) {
  tell(problems);
  return bad_input;
}

int refuse(const std::string& sentence) {
  tell(sentence);
  return bad_input;
}

int fail(const sturnus::Problems& problems) {
  tell(problems);
  return failed;
}

int finish(int code) {
  show_output();
  if (output_error == 0) return code;
  if (output_error != EPIPE) {
    tell(std::string("the standard output cannot be written: ") + std::strerror(output_error));
  }
  return code == done ? failed : code;
}

std::string counted(std::uint64_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string format(const char* pattern, ...) {
  std::va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, pattern, arguments);
  va_end(arguments);
  std::string text(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

}  // namespace program
