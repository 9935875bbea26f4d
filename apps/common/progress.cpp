// Drawing of the progress bar.
#include "progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace program {
namespace {

constexpr int bar_width = 30;

std::string time_text(double seconds) {
  const auto whole = static_cast<unsigned long long>(seconds + 0.5);
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest + " min";
}

}  // namespace

Progress::Progress(std::uint64_t steps, bool wanted)
    : steps_(steps), wanted_(wanted && steps > 0 && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::uint64_t steps_done) {
  if (!wanted_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  draw(steps_done, std::chrono::duration<double>(now - start_).count());
}

void Progress::draw(std::uint64_t steps_done, double seconds) {
  const double share = static_cast<double>(steps_done) / static_cast<double>(steps_);
  const auto full = static_cast<std::size_t>(share * bar_width);
  const std::string bar = std::string(full, '=') + std::string(bar_width - full, ' ');
  const std::string left = share > 0 ? ", " + time_text(seconds / share - seconds) + " left" : "";
  std::fprintf(stderr, "\r[%s] %3.0f %%  step %llu of %llu%s\x1b[K", bar.c_str(), 100 * share,
               static_cast<unsigned long long>(steps_done), static_cast<unsigned long long>(steps_),
               left.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace program
