// Signal handlers that set one flag.
#include "interrupts.h"

namespace program {
namespace {

volatile std::sig_atomic_t was_asked = 0;

void ask(int) {
  was_asked = 1;
}

// A signal that the caller ignores stays ignored, as in a job that a shell runs in the background.
void take(int signal, struct sigaction& before) {
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = ask;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupts::Interrupts() {
  was_asked = 0;
  take(SIGINT, interrupt_before_);
  take(SIGTERM, terminate_before_);
}

Interrupts::~Interrupts() {
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool Interrupts::asked() const {
  return was_asked != 0;
}

}  // namespace program
