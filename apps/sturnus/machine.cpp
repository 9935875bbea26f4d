// What Linux tells of itself in /proc.
#include "machine.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <thread>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace program {
namespace {

// What stands behind the colon of the first line that begins with a word; empty when there is none.
std::string value_in(const char* file, const std::string& word) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(word)) continue;
    const auto begin = line.find_first_not_of(" \t", line.find(':') + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return {};
}

// Bytes from a line such as "VmHWM:   10124 kB"; 0 when there is none.
std::uint64_t status_bytes(const char* word) {
  const std::string text = value_in("/proc/self/status", word);
  return text.empty() ? 0 : std::uint64_t{1024} * std::stoull(text);
}

// Sets the peak back to what is in memory now.
bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good() && status_bytes("VmHWM:") > 0;
}

// Gives back what the allocator only keeps, so that no case has the room of the one before.
std::uint64_t settled_bytes() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return status_bytes("VmRSS:");
}

}  // namespace

std::string processor_name() {
  const std::string name = value_in("/proc/cpuinfo", "model name");
  return name.empty() ? "unknown" : name;
}

int processor_cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string compiler_name() {
#if defined(__clang__)
  return std::string("clang ") + __clang_version__;
#else
  return std::string("gcc ") + __VERSION__;
#endif
}

MemoryWatch::MemoryWatch() : before_(settled_bytes()), own_(forget_peak()) {}

std::uint64_t MemoryWatch::peak() const {
  if (own_) return status_bytes("VmHWM:");
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::uint64_t{1024} * static_cast<std::uint64_t>(usage.ru_maxrss);
}

}  // namespace program
