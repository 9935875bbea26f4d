// What can be wrong with Reynolds' steering behaviours beyond the range of a single number.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/behaviours.h"
#include "scenario/common_checks.h"

namespace sturnus {
namespace {

// Their members are gone through one by one, by every boid.
constexpr std::int64_t most_watched = 256;

class BehaviourChecker : Findings {
 public:
  BehaviourChecker(const ScenarioDef& scenario, Problems& problems) : Findings(scenario, problems) {
    for (const FlockDef& flock : scenario.flocks) names_.push_back(flock.name);
  }

  void check(const FlockDef& flock) {
    prefix_ = say("flock.", flock.name, ".");
    check_speed(flock);
    if (flock.pursue) check_pursuit(*flock.pursue, "pursue.");
    if (flock.evade) check_pursuit(*flock.evade, "evade.");
    if (flock.hide) check_hide(*flock.hide);
    if (flock.follow_path) check_line(flock.follow_path->points, axes(), "follow_path.points");
    if (flock.follow_wall) check_line(flock.follow_wall->points, 2, "follow_wall.points");
    if (flock.flow) check_flow(*flock.flow);
    if (flock.follow_leader) check_watched(flock.follow_leader->leader, "follow_leader.leader");
  }

 private:
  std::size_t axes() const { return static_cast<std::size_t>(scenario_.space.dimensions); }

  void say_error(const std::string& key, std::string text) {
    Findings::say_error(prefix_ + key, std::move(text));
  }

  void check_speed(const FlockDef& flock) {
    if (!std::isinf(flock.max_speed)) return;
    const auto refuse = [&](bool is_used, const char* key) {
      if (is_used)
        say_error(key, say("goes at full speed, but the max_speed of \"", flock.name, "\" is infinite"));
    };
    refuse(flock.pursue.has_value(), "pursue");
    refuse(flock.evade.has_value(), "evade");
    refuse(flock.hide.has_value(), "hide");
    refuse(flock.follow_path.has_value(), "follow_path");
    refuse(flock.follow_wall.has_value(), "follow_wall");
    refuse(flock.follow_leader.has_value(), "follow_leader");
  }

  void check_watched(const std::string& name, const std::string& key) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (name.empty()) return say_error(key, "names nobody");
    if (found == names_.end()) return say_error(key, unknown_word("flock", name, names_));
    const FlockDef& watched = scenario_.flocks[static_cast<std::size_t>(found - names_.begin())];
    if (watched.count > most_watched) {
      say_error(key, say("every boid looks at each of \"", name, "\", of which there may be ", most_watched,
                         ", but there are ", watched.count));
    }
  }

  void check_size(const Coordinates& at, std::size_t size, const std::string& key) {
    if (!at.empty() && at.size() != size)
      say_error(key, say("must have ", size, " numbers, but has ", at.size()));
  }

  void check_pursuit(const Pursuit& term, const std::string& table) {
    if (term.of.empty()) say_error(table + "of", "names nobody");
    for (const std::string& name : term.of) check_watched(name, table + "of");
    check_size(term.offset, axes(), table + "offset");
  }

  void check_hide(const Hide& term) {
    if (term.from.empty()) say_error("hide.from", "names nobody");
    for (const std::string& name : term.from) check_watched(name, "hide.from");
  }

  void check_line(const std::vector<Coordinates>& points, std::size_t size, const std::string& key) {
    if (points.size() < 2) say_error(key, say("needs at least two corners, but has ", points.size()));
    for (const Coordinates& point : points) {
      if (point.size() != size)
        return say_error(key, say("every corner must have ", size, " numbers, but one has ", point.size()));
    }
  }

  void check_flow(const FollowFlow& term) {
    check_size(term.centre, axes(), "flow.centre");
    check_size(term.velocity, axes(), "flow.velocity");
  }

  std::vector<std::string> names_;
  std::string prefix_;
};

}  // namespace

void check_behaviours(const ScenarioDef& scenario, Problems& problems) {
  BehaviourChecker checker(scenario, problems);
  for (const FlockDef& flock : scenario.flocks) checker.check(flock);
}

}  // namespace sturnus
