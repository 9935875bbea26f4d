// The way from the words to the exit code.
#include "main_program.h"

#include <sturnus/version.h>

#include <csignal>
#include <exception>
#include <new>

#include "command_line.h"
#include "output.h"

namespace program {
namespace {

void describe_usual(CLI::App& app) {
  app.allow_extras();
  app.set_version_flag("--version", app.get_name() + " " + sturnus::version, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("OPTIONS", "options");
  app.get_formatter()->label("SUBCOMMAND", "command");
  app.get_formatter()->label("Positionals", "Arguments");
  app.get_formatter()->label("REQUIRED", "(required)");
}

// Reads the words; returns the exit code where there is nothing left to do.
std::optional<int> read(CLI::App& app, const Request& request) {
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
  if (const std::string unexpected = unexpected_words(app); !unexpected.empty()) return refuse(unexpected);
  return {};
}

}  // namespace

int main_program(CLI::App& app, Request& request, const std::function<void(CLI::App&, Request&)>& describe) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader who goes away ends nothing but the reading
  try {
    describe_usual(app);
    describe(app, request);
    const auto code = read(app, request);
    return finish(code ? *code : request.work());
  } catch (const std::bad_alloc&) {
    tell(app.get_name() + ": the memory is used up");
  } catch (const std::exception& error) {
    tell(app.get_name() + ": " + error.what());
  }
  return finish(failed);
}

}  // namespace program
