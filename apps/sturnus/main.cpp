// The program `sturnus`: reads the command line, does what it asks, and ends with 0, 1, 2, 3 or 130.
#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace {

using namespace program;

constexpr const char* welcome =
    "Sturnus simulates flocks: scenario files in; measures, pictures and videos out.\n"
    "\n"
    "Three things to try:\n"
    "  sturnus run ucsd                         a classic flock, and how fast it runs here\n"
    "  sturnus render murmuration -o birds.mp4  a video of starlings\n"
    "  sturnus new my.toml --from ucsd          a scenario of your own to play with\n"
    "\n"
    "sturnus list shows all scenarios, sturnus --help all commands.\n";

void describe(CLI::App& app, Request& request) {
  app.require_subcommand(0, 1);
  app.footer(
      "sturnus COMMAND --help explains a command, with examples.\n"
      "Exit codes: 0 done, 1 failed while running, 2 bad usage or input, 3 compared files differ, "
      "130 interrupted.");
  add_run(app, request);
  add_sweep(app, request);
  add_render(app, request);
  add_list(app, request);
  add_show(app, request);
  add_keys(app, request);
  add_new(app, request);
  add_check(app, request);
  add_bench(app, request);
  add_explain(app, request);
  add_compare(app, request);
  add_shadertoy(app, request);
  add_studio(app, request);
}

}  // namespace

int main(int count, char** words) {
  CLI::App app("Sturnus simulates flocks: scenario files in; measures, pictures and videos out.", "sturnus");
  Request request;
  request.words.assign(words, words + count);
  request.work = [] {
    print(welcome);
    return done;
  };
  return main_program(app, request, describe);
}
