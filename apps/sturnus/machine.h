// The machine that a figure was taken on, and the memory that the program has taken from it.
#pragma once

#include <cstdint>
#include <string>

namespace program {

/// The processor's name as Linux gives it; "unknown" elsewhere.
std::string processor_name();
int processor_cores();
/// The compiler of this program, e.g. "gcc 12.2.0".
std::string compiler_name();

/// Watches the memory from its making on: what it was then, and what the most has been since.
class MemoryWatch {
 public:
  MemoryWatch();
  /// Most bytes in memory since then, or since the program began where the system can't forget an earlier
  /// peak.
  std::uint64_t peak() const;
  /// Whether that is the peak since the making alone.
  bool is_own_peak() const { return own_; }
  /// Bytes in memory at the making.
  std::uint64_t before() const { return before_; }

 private:
  std::uint64_t before_;
  bool own_;
};

}  // namespace program
