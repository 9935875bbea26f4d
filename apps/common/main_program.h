// What every program's main does: read the words, do the work, and end with the right code.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace program {

/// What the command line was, and what it asks for.
struct Request {
  std::vector<std::string> words;  ///< as typed, with the program's name
  std::function<int()> work;       ///< set by the command that was chosen; returns the exit code
};

/// Reads the words by what `describe` says of the program, and does `request.work`, which stays as it was
/// where no command replaces it. Returns the exit code: 0, 1, 2 or 130.
int main_program(CLI::App& app, Request& request, const std::function<void(CLI::App&, Request&)>& describe);

}  // namespace program
