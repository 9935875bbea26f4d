// sturnus new: a commented copy of a scenario to start from.
#include <sturnus/files.h>
#include <sturnus/scenario.h>

#include <unistd.h>

#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

struct NewOptions {
  std::string file;
  std::string from;
  bool force = false;
};

// The text as it was written, comments and all.
sturnus::Result<std::string> text_of(const std::string& name) {
  for (const auto& shipped : sturnus::shipped_scenarios()) {
    if (name == shipped.name) return std::string(shipped.text);
  }
  return sturnus::read_text(name);
}

bool is_shipped(const std::string& name) {
  for (const auto& shipped : sturnus::shipped_scenarios()) {
    if (name == shipped.name) return true;
  }
  return false;
}

int write_new(const NewOptions& options) {
  // Loading first gives the full complaint about a name that is not there, or a file that is wrong.
  if (const auto scenario = sturnus::load_scenario(options.from); !scenario)
    return refuse(scenario.problems());
  const auto text = text_of(options.from);
  if (!text) return refuse(text.problems());
  if (!options.force && access(options.file.c_str(), F_OK) == 0) {
    return refuse(options.file + ": the file is there already; --force replaces it");
  }
  if (const auto status = sturnus::write_text(options.file, *text); !status) {
    tell(status.problems());
    return failed;
  }
  if (!options.file.ends_with(".toml"))
    tell("note: the name \"" + options.file + "\" was taken as it is, without .toml");
  const std::string name = is_shipped(options.file) ? "./" + options.file : options.file;
  print("wrote " + options.file + "; try: sturnus run " + name + "\n");
  return done;
}

}  // namespace

void add_new(CLI::App& app, Request& request) {
  CLI::App* command =
      add_command(app, "new", "Write a commented copy of a scenario to start from",
                  {"sturnus new my.toml --from ucsd", "sturnus new my.toml --from yours.toml --force"});
  const auto options = std::make_shared<NewOptions>();
  command->add_option("FILE", options->file, "The file to write; the name is taken as it is")->required();
  add_text(*command, "--from", options->from, "SCENARIO", "A shipped scenario or the path of a file")
      ->required();
  command->add_flag("--force", options->force, "Replace the file if it is there");
  command->callback([&request, options] { request.work = [options] { return write_new(*options); }; });
}

}  // namespace program
