// The program `sturnus`: reads the command line, does what it asks, and ends with 0, 1, 2 or 130.
#include <sturnus/version.h>

#include <csignal>
#include <exception>
#include <new>

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
  app.name("sturnus");
  app.allow_extras();
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", std::string("sturnus ") + sturnus::version, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("OPTIONS", "options");
  app.get_formatter()->label("SUBCOMMAND", "command");
  app.get_formatter()->label("Positionals", "Arguments");
  app.get_formatter()->label("REQUIRED", "(required)");
  app.footer(
      "sturnus COMMAND --help explains a command, with examples.\n"
      "Exit codes: 0 done, 1 failed while running, 2 bad usage or input, 130 interrupted.");
  add_run(app, request);
  add_render(app, request);
  add_list(app, request);
  add_show(app, request);
  add_keys(app, request);
  add_new(app, request);
  add_check(app, request);
  add_shadertoy(app, request);
}

// Reads the words; what is left to do stands in `request.work`, unless there is nothing left or nothing to be
// done.
int read(CLI::App& app, Request& request) {
  try {
    app.parse(std::vector<std::string>(request.words.rbegin(), request.words.rend() - 1));
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return done;
  } catch (const CLI::CallForVersion&) {
    print(app.version() + "\n");
    return done;
  } catch (const CLI::ParseError& error) {
    const std::string unexpected = unexpected_words(app);
    return refuse(unexpected.empty() ? sentence_of(error, app) : unexpected);
  }
  if (const std::string unexpected = unexpected_words(app); !unexpected.empty()) {
    request.work = nullptr;
    return refuse(unexpected);
  }
  if (!request.work) print(welcome);
  return done;
}

int run_program(Request& request) {
  CLI::App app("Sturnus simulates flocks: scenario files in; measures, pictures and videos out.");
  describe(app, request);
  const int code = read(app, request);
  return request.work ? request.work() : code;
}

}  // namespace

int main(int count, char** words) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader who goes away ends nothing but the reading
  Request request;
  request.words.assign(words, words + count);
  try {
    return finish(run_program(request));
  } catch (const std::bad_alloc&) {
    tell("sturnus: the memory is used up");
  } catch (const std::exception& error) {
    tell(std::string("sturnus: ") + error.what());
  }
  return finish(failed);
}
