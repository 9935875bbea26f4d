// Scenarios by name or path, and the simulations that need files besides.
#include <sturnus/files.h>

#include <sturnus/parameters.h>

#include <sys/stat.h>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/text.h"
#include "files/atomic_file.h"

namespace sturnus {
namespace {

bool looks_like_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(".toml");
}

bool is_file(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0;
}

Problem cannot_read(const std::string& path, int error) {
  return {path, 0, "", say("cannot be read: ", std::strerror(error)), false};
}

Problem unknown_scenario(const std::string& name) {
  std::vector<std::string> names;
  for (const ShippedScenario& shipped : shipped_scenarios()) names.emplace_back(shipped.name);
  const std::string near = nearest_word(name, names);
  std::string text = say("there is no shipped scenario and no file \"", name, "\"");
  text += near.empty() ? "; `sturnus list` shows what there is" : say("; did you mean \"", near, "\"?");
  return {"", 0, "", text, false};
}

// The path of a file that a scenario names: relative to the scenario's own folder.
std::string beside(const ScenarioDef& scenario, const std::string& file) {
  return file.starts_with("/") ? file : folder_of(scenario.file) + file;
}

Status read_table(const ScenarioDef& scenario, const std::string& file, BoidTables& tables) {
  if (file.empty() || tables.contains(file)) return {};
  auto table = read_state_csv(beside(scenario, file));
  if (!table) return table.problems();
  tables.emplace(file, std::move(*table));
  return {};
}

}  // namespace

Result<std::string> read_text(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return cannot_read(path, errno);
  if (S_ISDIR(info.st_mode)) return Problem{path, 0, "", "cannot be read: it is a folder", false};
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return cannot_read(path, errno);
  std::string text;
  char buffer[1 << 16];
  for (std::size_t got = 1; got > 0;) {
    got = std::fread(buffer, 1, sizeof buffer, file);
    text.append(buffer, got);
  }
  const bool failed = std::ferror(file) != 0;
  const int error = errno;
  std::fclose(file);
  if (failed) return cannot_read(path, error);
  return text;
}

Status write_text(const std::string& path, std::string_view text) {
  return write_file(path, text);
}

Status make_folder(const std::string& path) {
  return make_folders(path);
}

Result<ScenarioDef> load_scenario(const std::string& name_or_path, Problems* problems) {
  for (const ShippedScenario& shipped : shipped_scenarios()) {
    if (name_or_path == shipped.name) return parse_scenario(shipped.text, shipped.name, problems);
  }
  if (!looks_like_path(name_or_path) && !is_file(name_or_path)) return unknown_scenario(name_or_path);
  auto text = read_text(name_or_path);
  if (!text) return text.problems();
  return parse_scenario(*text, name_or_path, problems);
}

Result<Simulation> open_simulation(const ScenarioDef& scenario, int threads) {
  SimulationOptions options;
  options.threads = threads;
  Status status = read_table(scenario, scenario.run.initial, options.tables);
  for (const FlockDef& flock : scenario.flocks) {
    if (status && scenario.run.initial.empty())
      status = read_table(scenario, flock.start.file, options.tables);
  }
  if (!status) return status.problems();
  return Simulation::create(scenario, options);
}

}  // namespace sturnus
