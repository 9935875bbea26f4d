// Handlers in front of those of SDL: they remember the signal and hand it on.
#include "interrupts.h"

#include <cstddef>

namespace prog06 {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM};
struct sigaction before[2];
volatile std::sig_atomic_t was_asked = 0;

void ask(int signal) {
  was_asked = 1;
  before[signal == SIGINT ? 0 : 1].sa_handler(signal);  // SDL's, which makes an event of it
}

}  // namespace

Interrupts::Interrupts() {
  was_asked = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    sigaction(signals[i], nullptr, &before[i]);
    // Ignored signals stay ignored, and without SDL's handler a signal ends the program by itself.
    if (before[i].sa_handler == SIG_IGN || before[i].sa_handler == SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = ask;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(signals[i], &action, nullptr);
  }
}

Interrupts::~Interrupts() {
  for (std::size_t i = 0; i < 2; ++i) sigaction(signals[i], &before[i], nullptr);
}

bool Interrupts::asked() const {
  return was_asked != 0;
}

}  // namespace prog06
