// The commands of the program, each in a file of its own, and how they are made known to the command line.
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

void add_run(CLI::App& app, Request& request);
void add_render(CLI::App& app, Request& request);
void add_list(CLI::App& app, Request& request);
void add_show(CLI::App& app, Request& request);
void add_keys(CLI::App& app, Request& request);
void add_new(CLI::App& app, Request& request);
void add_check(CLI::App& app, Request& request);
void add_shadertoy(CLI::App& app, Request& request);

}  // namespace program
