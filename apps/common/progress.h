// A bar on the terminal for work that takes a while.
#pragma once

#include <chrono>
#include <cstdint>

namespace program {

/// Shows how much is done on standard error: only on a terminal, only after half a second, and gone at the
/// end.
class Progress {
 public:
  /// `wanted`: false shows nothing.
  Progress(std::uint64_t steps, bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::uint64_t steps_done);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::uint64_t steps_done, double seconds);

  std::uint64_t steps_;
  bool wanted_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::milliseconds(500);
};

}  // namespace program
