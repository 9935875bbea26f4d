// sturnus list: the shipped scenarios by group, one line each.
#include <sturnus/scenario.h>

#include <algorithm>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

constexpr std::size_t line_width = 110;

// Cut between words where a line would be too long.
std::string cut(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  const auto space = text.find_last_of(' ', width - 4);
  return text.substr(0, space == std::string::npos ? width - 4 : space) + " ...";
}

std::string summary(const sturnus::ShippedScenario& shipped) {
  const auto scenario = sturnus::parse_scenario(shipped.text, shipped.name);
  if (!scenario) return {};
  if (scenario->title.empty() || scenario->about.empty()) return scenario->title + scenario->about;
  return scenario->title + ": " + scenario->about;
}

int list() {
  std::size_t width = 0;
  for (const auto& shipped : sturnus::shipped_scenarios())
    width = std::max(width, std::string(shipped.name).size());
  std::string group;
  for (const auto& shipped : sturnus::shipped_scenarios()) {
    if (group != shipped.group) print((group.empty() ? "" : "\n") + std::string(shipped.group) + "\n");
    group = shipped.group;
    const std::string name = shipped.name;
    print("  " + name + std::string(width - name.size() + 2, ' ') +
          cut(summary(shipped), line_width - width - 4) + "\n");
  }
  return done;
}

}  // namespace

void add_list(CLI::App& app, Request& request) {
  CLI::App* command = add_command(app, "list", "List the shipped scenarios", {"sturnus list"});
  command->callback([&request] { request.work = list; });
}

}  // namespace program
