// prog06: boids over a software rasteriser, in a window. Ends with 0, 1 (failed while running), 2 (bad
// input) or 130 (interrupted).
#include <sturnus/files.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "arguments.h"
#include "flock.h"
#include "interrupts.h"
#include "loop.h"
#include "window.h"

namespace {

using namespace prog06;

enum Exit : int { done = 0, failed = 1, bad_input = 2, interrupted = 130 };

int tell(const std::string& text, Exit code) {
  std::fputs(text.c_str(), stderr);
  return code;
}

// Everything that is wrong with the words, and with what they name.
int refuse(const sturnus::Problems& problems) {
  return tell(std::string(usage) + "\n" + sturnus::to_text(problems), bad_input);
}

int show(const Choices& choices, sturnus::Simulation& flock) {
  Window window(choices.size);
  if (!window.failure().empty()) return tell(window.failure() + "\n", failed);
  const Interrupts interrupts;
  std::printf("a animates, s steps, w writes %s, q quits\n", choices.picture.c_str());
  std::fflush(stdout);
  if (!Loop(choices, flock, window).run()) return failed;
  return interrupts.asked() ? interrupted : done;
}

int run_program(const std::vector<std::string>& words) {
  const auto request = read_arguments(words);
  if (!request) return refuse(request.problems());
  if (request->help) {
    std::fputs(help_text().c_str(), stdout);
    return done;
  }
  const Choices& choices = request->choices;
  if (const auto possible = sturnus::check_file(choices.picture); !possible) {
    return refuse({{"prog06", 0, "out.ppm", possible.problems().front().sentence(), false}});
  }
  auto flock = open_flock(choices);
  if (!flock) return refuse(flock.problems());
  return show(choices, *flock);
}

}  // namespace

int main(int count, char** words) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader who goes away ends nothing but the reading
  try {
    return run_program(count > 0 ? std::vector<std::string>(words + 1, words + count)
                                 : std::vector<std::string>());
  } catch (const std::bad_alloc&) {
    return tell("prog06: the memory is used up\n", failed);
  } catch (const std::exception& error) {
    return tell(std::string("prog06: ") + error.what() + "\n", failed);
  }
}
