// sturnus studio: the program sturnus-studio that lies beside this one, in place of it.
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

std::string beside_this_program(const std::string& name) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? name : (self.parent_path() / name).string();
}

// Does not come back where all is well.
int become(const std::string& path, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(path.c_str(), pointers.data());
  return fail({{path, 0, "", std::string("cannot be started: ") + std::strerror(errno), false}});
}

int open_studio(const std::vector<std::string>& rest) {
  const std::string path = beside_this_program("sturnus-studio");
  if (::access(path.c_str(), X_OK) != 0) {
    return fail(
        {{path, 0, "",
          "is not there: the studio was not built with this program, because SDL2, Dear ImGui or libepoxy "
          "was missing",
          false}});
  }
  std::vector<std::string> words = {path};
  words.insert(words.end(), rest.begin(), rest.end());
  return become(path, words);
}

}  // namespace

void add_studio(CLI::App& app, Request& request) {
  CLI::App* command =
      add_command(app, "studio", "Open a window on a flock: place creatures, pull sliders, follow one bird",
                  {"sturnus studio", "sturnus studio two-flocks --theme light", "sturnus studio my.toml"});
  command->prefix_command();
  command->set_help_flag();
  command->callback(
      [&request, command] { request.work = [rest = command->remaining()] { return open_studio(rest); }; });
}

}  // namespace program
