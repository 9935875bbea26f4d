// Ctrl-C ends the work after the step in progress, so that what was done can be written.
#pragma once

#include <csignal>

namespace program {

/// While it lives, the first Ctrl-C (or kill) only asks; the second ends the program at once.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  bool asked() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace program
