// A text file with a path a line.
#include "files/recent.h"

#include <sturnus/files.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace studio {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<std::string> lines_of(const std::string& list) {
  std::vector<std::string> lines;
  const auto text = sturnus::read_text(list);
  std::istringstream stream(text ? *text : "");
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::string recent_list_path() {
  const std::string state = variable("XDG_STATE_HOME"), home = variable("HOME");
  if (state.starts_with('/')) return state + "/sturnus/recent.txt";
  return home.empty() ? "" : home + "/.local/state/sturnus/recent.txt";
}

std::vector<std::string> recent_files(const std::string& list) {
  std::vector<std::string> files = lines_of(list);
  std::erase_if(files, [](const std::string& file) {
    std::error_code error;
    return !std::filesystem::exists(file, error);
  });
  if (files.size() > most_recent_files) files.resize(most_recent_files);
  return files;
}

void remember_file(const std::string& list, const std::string& file) {
  if (list.empty()) return;
  std::error_code error;
  const std::string whole = std::filesystem::absolute(file, error).lexically_normal().string();
  if (error || whole.find('\n') != std::string::npos) return;
  std::vector<std::string> files = lines_of(list);
  std::erase(files, whole);
  files.insert(files.begin(), whole);
  if (files.size() > most_recent_files) files.resize(most_recent_files);
  std::string text;
  for (const std::string& line : files) text += line + "\n";
  std::filesystem::create_directories(std::filesystem::path(list).parent_path(), error);
  static_cast<void>(sturnus::write_text(list, text));
}

}  // namespace studio
