// A text file with a line for each thing that is over.
#include "files/memory.h"

#include <sturnus/files.h>

#include <filesystem>
#include <sstream>

#include "files/recent.h"

namespace studio {
namespace {

constexpr const char* legend_line = "legend folded";
constexpr const char* hint_line = "hint seen";

}  // namespace

std::string memory_path() {
  const std::string list = recent_list_path();
  return list.empty() ? "" : (std::filesystem::path(list).parent_path() / "studio.txt").string();
}

Memory recall(const std::string& path) {
  Memory memory;
  const auto text = sturnus::read_text(path);
  std::istringstream stream(text ? *text : "");
  for (std::string line; std::getline(stream, line);) {
    if (line == legend_line) memory.legend = false;
    if (line == hint_line) memory.hint = false;
  }
  return memory;
}

void remember(const std::string& path, const Memory& memory) {
  if (path.empty()) return;
  std::string text;
  if (!memory.legend) text.append(legend_line).append("\n");
  if (!memory.hint) text.append(hint_line).append("\n");
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  static_cast<void>(sturnus::write_text(path, text));
}

}  // namespace studio
