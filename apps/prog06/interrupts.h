// Ctrl-C quits like closing the window, but is told from it at the end.
#pragma once

#include <csignal>

namespace prog06 {

/// While it lives, the first Ctrl-C (or kill) asks the loop to quit; the second ends the program at once. To
/// be made when SDL has begun, which turns these signals into events.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  bool asked() const;
};

}  // namespace prog06
