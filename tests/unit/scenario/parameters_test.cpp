// The one list of parameters: every path can be set, shown, printed and read back; every bad value is refused
// with line and key.
#include <gtest/gtest.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <set>

#include "support.h"

namespace sturnus::test {
namespace {

constexpr const char* file = "test.toml";

/// The list of named tables that a row belongs to, "flock", "target" or "food"; empty for none.
std::string list_of(const ParameterRow& row) {
  const auto name = row.path.find(".NAME.");
  return name == std::string::npos ? "" : row.path.substr(0, name);
}
std::string default_name(const std::string& list) {
  return list == "flock" ? "boids" : list;
}
std::string key_in_table(const ParameterRow& row, const std::string& path) {
  const std::string list = list_of(row);
  return list.empty() ? path : path.substr(list.size() + 6);
}

/// A row's path in a scenario whose flock and target have no names of their own.
std::string path_of(const ParameterRow& row) {
  const std::string list = list_of(row);
  return list.empty() ? row.path : list + "." + default_name(list) + "." + key_in_table(row, row.path);
}
/// The same after a value was set, which may have been the name.
std::string path_in(const ScenarioDef& scenario, const ParameterRow& row) {
  if (row.path == "flock.NAME.name") return "flock." + scenario.flocks.front().name + ".name";
  if (row.path == "target.NAME.name") return "target." + scenario.targets.front().name + ".name";
  if (row.path == "food.NAME.name") return "food." + scenario.food.front().name + ".name";
  return path_of(row);
}

/// A file in which that key has that value, on the line that `line_of` tells.
std::string file_with(const ParameterRow& row, const std::string& path, const std::string& value) {
  const std::string list = list_of(row);
  const std::string line = key_in_table(row, path) + " = " + value + "\n";
  if (list.empty()) return line + "[[flock]]\n";
  return "[[" + list + "]]\n" + line + (list == "flock" ? "" : "[[flock]]\n");
}
int line_of(const ParameterRow& row) {
  return list_of(row).empty() ? 1 : 2;
}

/// Gives a flock of hunters its prey, or one that feeds its food; both are called "fish".
void add_creatures(const ParameterRow& row, ScenarioDef& scenario) {
  if (row.path.starts_with("food.")) scenario.food.emplace_back();
  const bool feeds = row.path.starts_with("flock.NAME.feed.");
  bool hunts = false;
  for (const char* key : {"hunt.", "jump.", "hunger."})
    hunts = hunts || row.path.starts_with(std::string("flock.NAME.") + key);
  if (!feeds && !hunts) return;
  scenario.flocks.emplace_back().name = "fish";
  scenario.food.emplace_back().name = "fish";
  if (feeds) set(scenario, "flock.boids.feed.on", "fish");
  if (hunts) set(scenario, "flock.boids.hunt.prey", "[fish]");
}

/// A scenario that has the row's table.
ScenarioDef scenario_for(const ParameterRow& row) {
  ScenarioDef scenario;
  add_creatures(row, scenario);
  if (list_of(row) != "target") return scenario;
  scenario.targets.emplace_back();
  scenario.targets.front().name = "target";
  scenario.targets.front().at = {1, 2};
  return scenario;
}

bool is_number(const ParameterRow& row) {
  return row.kind == "number" || row.kind == "whole number";
}
bool is_list_of_numbers(const ParameterRow& row) {
  return row.kind == "list of numbers" || row.kind == "[low, high]" ||
         row.kind == "number or list of numbers";
}

/// Expects a sentence with file, line and key.
void expect_problem(const ParameterRow& row, const std::string& value, const std::string& part) {
  const Result<ScenarioDef> result = parse_scenario(file_with(row, row.path, value), file);
  ASSERT_FALSE(result) << row.path << " = " << value << " was taken";
  const auto names_it = [&](const Problem& problem) {
    const std::string sentence = problem.sentence();
    const std::string start = std::string(file) + ":" + std::to_string(line_of(row)) + ": " + path_of(row);
    return sentence.starts_with(start) && sentence.find(part) != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(result.problems().begin(), result.problems().end(), names_it))
      << row.path << " = " << value << " gave\n"
      << result.error();
}

std::string wrong_type_for(const ParameterRow& row) {
  if (row.kind == "text") return "5";
  if (row.kind == "true or false") return "\"yes\"";
  if (row.kind.starts_with("list of texts")) return "[5]";
  return "true";
}

TEST(EveryParameter, RefusesTheWrongType) {
  for (const ParameterRow& row : parameter_rows()) {
    if (row.path.ends_with(".NAME.name")) continue;  // the key then has no name to stand under
    expect_problem(row, wrong_type_for(row), "must be");
    expect_problem(row, "1979-05-27", "date");
  }
}

TEST(EveryParameter, RefusesWhatIsNoNumber) {
  for (const ParameterRow& row : parameter_rows()) {
    if (is_number(row) || row.kind == "number or [inner, outer]") expect_problem(row, "nan", "nan");
    if (is_list_of_numbers(row)) expect_problem(row, "[nan, 1]", "nan");
    if (row.kind == "number or [inner, outer]") expect_problem(row, "[nan, 1]", "nan");
  }
}

TEST(EveryParameter, RefusesWhatIsOutOfRange) {
  int tried = 0;
  for (const ParameterRow& row : parameter_rows()) {
    if (!is_number(row)) continue;
    if (std::isfinite(row.about.low)) expect_problem(row, number_text(row.about.low - 1), "must");
    if (std::isfinite(row.about.high)) {
      const double beyond = row.about.high + std::max(1.0, 1e-9 * row.about.high);
      expect_problem(row, number_text(beyond), "must");
    }
    if (!row.about.may_be_infinite) expect_problem(row, "inf", "must");
    expect_problem(row, "-inf", "must");
    if (row.kind == "whole number") expect_problem(row, "2.5", "must");
    ++tried;
  }
  EXPECT_GT(tried, 50);
}

TEST(EveryParameter, RefusesUnknownNeighboursWithTheirNearestName) {
  for (const ParameterRow& row : parameter_rows()) {
    const std::string wrong = row.path + "x";
    const Result<ScenarioDef> result = parse_scenario(file_with(row, wrong, "1"), file);
    ASSERT_FALSE(result) << wrong;
    const std::string last = row.path.substr(row.path.rfind('.') + 1);
    const Problem& problem = result.problems().front();
    EXPECT_EQ(problem.line, line_of(row)) << wrong;
    EXPECT_EQ(problem.key, path_of(row) + "x");
    EXPECT_NE(problem.text.find("did you mean \"" + last + "\"?"), std::string::npos)
        << wrong << ": " << problem.text;
  }
}

TEST(EveryParameter, RefusesToBeGivenTwice) {
  for (const ParameterRow& row : parameter_rows()) {
    const std::string key = key_in_table(row, row.path);
    const Result<ScenarioDef> result = parse_scenario(file_with(row, row.path, "1\n" + key + " = 1"), file);
    ASSERT_FALSE(result) << row.path;
    const Problem& problem = result.problems().front();
    EXPECT_EQ(problem.line, line_of(row) + 1) << row.path << ": " << problem.sentence();
    EXPECT_NE(problem.text.find(row.path.substr(row.path.rfind('.') + 1)), std::string::npos) << problem.text;
  }
}

/// Values worth trying, the default first.
std::vector<std::string> candidates(const ParameterRow& row) {
  std::vector<std::string> out;
  if (!row.value.empty()) out.push_back(row.value);
  if (row.kind == "true or false") out.insert(out.end(), {"true", "false"});
  if (is_number(row)) out.insert(out.end(), {"1", "0.5", "3", "30", "0.001"});
  if (row.kind == "text") out.insert(out.end(), {"\"#102030\"", "\"fish\"", "\"boids\""});
  if (row.kind == "list of texts")
    out.insert(out.end(), {"[\"a\", \"b\"]", "[\"boids\"]", "[\"boids\", \"boids\"]", "[\"fish\"]"});
  if (is_list_of_numbers(row)) out.insert(out.end(), {"[0.25, 0.75]", "[1, 2, 3]"});
  if (row.kind == "list of lists of numbers")
    out.insert(out.end(), {"[[1, 2, 3]]", "[[1, 2, 3, 4], [5, 6, 7, 8]]", "[[1, 2], [3, 4]]",
                           "[[5, 6], [7, 8], [9, 1]]"});
  if (row.kind == "number or [inner, outer]") out.insert(out.end(), {"7", "[2, 5]"});
  if (row.kind.starts_with("\"own\"")) out.insert(out.end(), {"\"own\"", "\"all\"", "[\"boids\"]"});
  for (std::size_t at = 0; row.kind.starts_with("\"") && at < row.kind.size();) {
    const auto end = row.kind.find(" | ", at);
    const std::string word = row.kind.substr(at, end == std::string::npos ? end : end - at);
    if (word.starts_with("\"")) out.push_back(word);
    at = end == std::string::npos ? row.kind.size() : end + 3;
  }
  return out;
}

TEST(EveryParameter, CanBeSetAndShownByItsPath) {
  for (const ParameterRow& row : parameter_rows()) {
    int taken = 0;
    for (const std::string& value : candidates(row)) {
      ScenarioDef scenario = scenario_for(row);
      if (!set_parameter(scenario, path_of(row), parse_value(value))) continue;
      ++taken;
      const auto shown = get_parameter(scenario, path_in(scenario, row));
      ASSERT_TRUE(static_cast<bool>(shown)) << shown.error();
      EXPECT_EQ(*shown, to_text(parse_value(value))) << row.path;
    }
    EXPECT_GE(taken, row.path == "format" ? 1 : 2) << row.path << " (" << row.kind << ")";
  }
}

// A behaviour needs somebody to look at, of whom there are not too many, or a line.
void complete_behaviour(const ParameterRow& row, ScenarioDef& scenario) {
  const auto is_of = [&](const char* table) {
    return row.path.starts_with(std::string("flock.NAME.") + table + ".");
  };
  if (is_of("pursue") || is_of("evade") || is_of("follow_leader")) scenario.flocks.front().count = 100;
  if (is_of("hide")) scenario.flocks.front().count = 100;
  if (is_of("hide")) set(scenario, "flock.boids.hide.from", "[boids]");
  if (is_of("pursue")) set(scenario, "flock.boids.pursue.of", "[boids]");
  if (is_of("evade")) set(scenario, "flock.boids.evade.of", "[boids]");
  if (is_of("follow_leader")) set(scenario, "flock.boids.follow_leader.leader", "boids");
  if (is_of("follow_path")) set(scenario, "flock.boids.follow_path.points", "[[0, 0], [1, 1]]");
  if (is_of("follow_wall")) set(scenario, "flock.boids.follow_wall.points", "[[0, 0], [1, 1]]");
}

TEST(EveryParameter, IsPrintedAndReadBack) {
  std::set<std::string> never;
  for (const ParameterRow& row : parameter_rows()) {
    bool printed = false;
    for (const std::string& value : candidates(row)) {
      ScenarioDef scenario = scenario_for(row);
      complete_behaviour(row, scenario);
      if (row.path.starts_with("flock.NAME.flee.")) set(scenario, "flock.boids.flee.from", "[boids]");
      // A wrapped space has no planes.
      if (row.path == "obstacle.planes") set(scenario, "space.boundary", "open");
      if (!set_parameter(scenario, path_of(row), parse_value(value)) || value == row.value) continue;
      if (has_errors(check(scenario))) continue;
      const Result<ScenarioDef> read = parse_scenario(to_toml(scenario), file);
      ASSERT_TRUE(static_cast<bool>(read)) << row.path << " = " << value << "\n" << read.error();
      EXPECT_EQ(*get_parameter(*read, path_in(scenario, row)), to_text(parse_value(value))) << row.path;
      EXPECT_EQ(to_toml(*read), to_toml(scenario)) << row.path;
      printed = true;
    }
    if (!printed) never.insert(row.path);
  }
  // These need another key beside them, or have one legal value.
  // A corner of the space needs the other beside it, and the format has one legal value.
  EXPECT_EQ(never, (std::set<std::string>{"format", "space.max", "space.min"}));
}

TEST(EveryParameter, IsDescribedInOneSentenceWithAUnitWhereItHasOne) {
  std::set<std::string> paths;
  for (const ParameterRow& row : parameter_rows()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path << " stands twice";
    EXPECT_GT(std::string(row.about.text).size(), 4u) << row.path;
    EXPECT_FALSE(row.kind.empty()) << row.path;
  }
}

TEST(SetParameter, LeavesTheScenarioAsItWasWhenItCannot) {
  ScenarioDef scenario;
  const std::string before = to_toml(scenario);
  for (const char* path :
       {"", "flock", "flock.boids", "flock.birds.count", "flock.boids.separation", "space.boundary.kin",
        "flock.boids.separation.3.weight", "seed.low", "flock.boids.flee.radiu"}) {
    const Status status = set_parameter(scenario, path, parse_value("1"));
    EXPECT_FALSE(status) << path;
    EXPECT_FALSE(status.problems().empty() || status.problems().front().text.empty()) << path;
  }
  EXPECT_EQ(to_toml(scenario), before);
}

TEST(SetParameter, ReachesTheItemsOfAListByTheirNumber) {
  ScenarioDef scenario;
  scenario.flocks.front().separation.push_back({});
  set(scenario, "flock.boids.separation.1.weight", "7");
  EXPECT_EQ(scenario.flocks.front().separation[1].weight, 7);
  const Status status = set_parameter(scenario, "flock.boids.separation.weight", parse_value("7"));
  EXPECT_NE(status.error().find("separation.0"), std::string::npos) << status.error();
}

TEST(SetParameter, PutsANewTermBehindThoseThatAreThere) {
  ScenarioDef scenario =
      take(parse_scenario("[[flock]]\nnoise = { acceleration = 1 }\ncruise = { speed = 1 }\n", file));
  set(scenario, "flock.boids.wander.weight", "1");
  const FlockDef& flock = scenario.flocks.front();
  EXPECT_GT(flock.wander->order, flock.noise->order);
  EXPECT_GT(flock.wander->order, flock.cruise->order);
}

}  // namespace
}  // namespace sturnus::test
