// The shipped scenarios, read once.
#include <sturnus/scenario.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "panels/gallery.h"

namespace studio {
namespace {

std::vector<Exhibit> read_all() {
  std::vector<Exhibit> out;
  for (const sturnus::ShippedScenario& shipped : sturnus::shipped_scenarios()) {
    const auto scenario = sturnus::parse_scenario(shipped.text, shipped.name);
    if (!scenario) continue;
    const std::string title = scenario->title.empty() ? shipped.name : scenario->title;
    out.push_back({shipped.name, shipped.group, title, scenario->about, scenario->try_this});
  }
  return out;
}

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

}  // namespace

const std::vector<Exhibit>& exhibits() {
  static const std::vector<Exhibit> all = read_all();
  return all;
}

bool is_found(const Exhibit& exhibit, const std::string& search) {
  const std::string text =
      lower(exhibit.name + " " + exhibit.group + " " + exhibit.title + " " + exhibit.about);
  std::istringstream words(lower(search));
  for (std::string word; words >> word;) {
    if (text.find(word) == std::string::npos) return false;
  }
  return true;
}

}  // namespace studio
