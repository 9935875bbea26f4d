// Parameters by their paths, compared.
#include "session/differences.h"

#include <sturnus/parameters.h>

#include <algorithm>

namespace studio {
namespace {

using sturnus::About;
using sturnus::FieldRef;
using sturnus::FieldVisitor;
using sturnus::Items;
using sturnus::ScenarioDef;

bool is_for_people(std::string_view path) {
  return path == "title" || path == "about" || path == "try" || path == "source";
}

// Collects the paths of all parameters as `set_parameter` takes them.
class Paths : public FieldVisitor {
 public:
  Paths(std::string prefix, std::vector<std::string>& paths) : prefix_(std::move(prefix)), paths_(paths) {}

  void field(std::string_view key, FieldRef, const About&) override {
    std::string path = prefix_ + std::string(key);
    if (!is_for_people(path)) paths_.push_back(std::move(path));
  }
  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view) override {
    Paths inner(prefix_ + std::string(key) + ".", paths_);
    visit_inside(inner);
  }
  void items(std::string_view key, const About&, const Items& items) override {
    for (std::size_t i = 0; i < items.size(); ++i) {
      std::string prefix = prefix_ + std::string(key) + ".";
      if (items.name) prefix += items.name(i) + ".";
      if (!items.name && items.size() > 1) prefix += std::to_string(i) + ".";
      Paths inner(prefix, paths_);
      items.visit(i, inner);
    }
  }

 private:
  std::string prefix_;
  std::vector<std::string>& paths_;
};

// The scenario without what only people read.
std::string machine_text(ScenarioDef scenario) {
  scenario.title = scenario.about = scenario.source = "";
  scenario.try_this.clear();
  return to_toml(scenario);
}

}  // namespace

std::map<std::string, std::string> flatten(const ScenarioDef& scenario) {
  ScenarioDef copy = scenario;  // visiting hands out places to write to
  std::vector<std::string> paths;
  Paths collector("", paths);
  visit(copy, collector);
  std::map<std::string, std::string> out;
  for (const std::string& path : paths) {
    if (auto text = sturnus::get_parameter(scenario, path)) out[path] = std::move(*text);
  }
  return out;
}

Differences differences(const ScenarioDef& before, const ScenarioDef& after) {
  const auto old = flatten(before);
  ScenarioDef reached = before;
  Differences out;
  for (const auto& [path, value] : flatten(after)) {
    const auto known = old.find(path);
    if (known != old.end() && known->second == value) continue;
    out.set.push_back({path, value});
    if (!set_parameter(reached, path, sturnus::parse_value(value))) out.is_all = false;
  }
  out.is_all = out.is_all && machine_text(reached) == machine_text(after);
  return out;
}

// What is refused now may be right after another change: a least speed after its largest one.
sturnus::Result<std::vector<Difference>> in_order(const ScenarioDef& scenario,
                                                  const std::vector<Difference>& changes) {
  ScenarioDef reached = scenario;
  std::vector<Difference> left = changes, out;
  sturnus::Status refused;
  const auto is_right = [&](const Difference& change) {
    ScenarioDef tried = reached;
    sturnus::Status status =
        sturnus::is_fixed_while_running(change.path)
            ? sturnus::Problem{scenario.file, 0, change.path, "can't change while a flock runs", false}
            : set_parameter(tried, change.path, sturnus::parse_value(change.value));
    for (const sturnus::Problem& problem : check(tried)) {
      if (status && !problem.is_warning) status = problem;
    }
    if (!status) {
      refused = status;
      return false;
    }
    reached = std::move(tried);
    out.push_back(change);
    return true;
  };
  while (!left.empty()) {
    const std::size_t before = left.size();
    std::erase_if(left, is_right);
    if (left.size() == before) return refused.problems();
  }
  return out;
}

sturnus::Status set_all(World& world, const std::vector<Difference>& changes, const std::string& label) {
  const auto ordered = in_order(world.simulation().scenario(), changes);
  if (!ordered) return ordered.problems();
  const std::uint64_t gesture = world.new_gesture();
  for (const Difference& change : *ordered) {
    const sturnus::SetParameter set{change.path, change.value};
    if (const sturnus::Status status = world.act(set, label, gesture); !status) return status;
  }
  return {};
}

}  // namespace studio
