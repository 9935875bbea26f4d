// Reads scenario files: TOML text to definitions, every problem with its line and key.
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#define TOML_HEADER_ONLY 1
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#include <toml++/toml.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <sturnus/parameters.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/events.h"

namespace sturnus {
namespace {

// What one reading gathers: problems, and the line of every key for problems that are found later.
struct Reading {
  std::string file;
  ScenarioDef scenario;
  Problems problems;
  std::map<std::string, int> lines;

  void say_error(const toml::node& node, const std::string& path, std::string text) {
    problems.push_back({file, line_of(node), path, std::move(text), false});
  }
  static int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }
};

std::optional<Value> value_of(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return Value{flag->get()};
  if (const auto* whole = node.as_integer()) return Value{static_cast<double>(whole->get())};
  if (const auto* number = node.as_floating_point()) return Value{number->get()};
  if (const auto* text = node.as_string()) return Value{text->get()};
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  Value::List list;
  for (const toml::node& item : *array) {
    auto value = value_of(item);
    if (!value) return {};
    list.push_back(std::move(*value));
  }
  return Value{list};
}

bool is_neighbour_term(std::string_view key) {
  return key == "separation" || key == "alignment" || key == "cohesion";
}

// Reads one table into the places that the parameter list shows it.
class TableReader : public FieldVisitor {
 public:
  TableReader(const toml::table& table, std::string prefix, Reading& reading)
      : table_(&table), prefix_(std::move(prefix)), reading_(reading) {}
  // A plain value that stands for one key of a table: boundary = "wrap".
  TableReader(const toml::node& value, std::string_view short_key, std::string prefix, Reading& reading)
      : short_value_(&value), short_key_(short_key), prefix_(std::move(prefix)), reading_(reading) {}

  void field(std::string_view key, FieldRef place, const About& about) override {
    known_.emplace_back(key);
    const toml::node* node = find(key);
    if (std::holds_alternative<RingRef>(place)) {
      known_.emplace_back("ring");
      const toml::node* ring = find("ring");
      if (node != nullptr && ring != nullptr) {
        return reading_.say_error(*ring, prefix_ + "ring", "give radius or ring, not both");
      }
      if (ring != nullptr) node = ring;
    }
    if (node == nullptr) return;
    remember(*node, key);
    const std::string path = prefix_ + std::string(key);
    const auto value = value_of(*node);
    if (!value)
      return reading_.say_error(*node, path, say("must be ", kind_of(place), ", but found a table or date"));
    if (const auto error = assign(place, *value, about)) reading_.say_error(*node, path, *error);
  }

  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view short_key) override {
    known_.emplace_back(key);
    const toml::node* node = find(key);
    if (node == nullptr) return;
    remember(*node, key);
    const std::string prefix = say(prefix_, key, ".");
    if (const auto* inside = node->as_table()) {
      TableReader inner(*inside, prefix, reading_);
      visit_inside(inner);
      if (key == "run") inner.known_.emplace_back("events");
      inner.finish();
    } else if (!short_key.empty()) {
      TableReader inner(*node, short_key, prefix, reading_);
      visit_inside(inner);
    } else {
      reading_.say_error(*node, prefix_ + std::string(key), say("must be a table, such as [", key, "]"));
    }
  }

  void items(std::string_view key, const About&, const Items& items) override {
    known_.emplace_back(key);
    const toml::node* node = find(key);
    if (node == nullptr) {
      if (is_neighbour_term(key) && names_a_term() && !has_like_) items.resize(0);
      return;
    }
    remember(*node, key);
    std::vector<const toml::table*> tables;
    if (!tables_in(*node, key, items.at_most_one, tables)) return;
    if (!has_like_) items.resize(0);
    items.resize(tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (items.rename) {
        read_named(*tables[i], key, i, items);
      } else if (items.name) {
        read_flock(*tables[i], i, items);
      } else {
        read_item(*tables[i], tables.size() == 1 ? say(prefix_, key, ".") : say(prefix_, key, ".", i, "."), i,
                  items);
      }
    }
  }

  // Says which keys of the table nobody knows.
  void finish() {
    if (table_ == nullptr) return;
    for (const auto& [key, node] : *table_) {
      if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
      reading_.say_error(node, prefix_ + std::string(key.str()), unknown_word("key", key.str(), known_));
    }
  }

 private:
  const toml::node* find(std::string_view key) const {
    if (table_ == nullptr) return key == short_key_ ? short_value_ : nullptr;
    return table_->get(key);
  }

  void remember(const toml::node& node, std::string_view key) {
    reading_.lines[prefix_ + std::string(key)] = Reading::line_of(node);
  }

  bool names_a_term() const {
    return table_ != nullptr &&
           (table_->contains("separation") || table_->contains("alignment") || table_->contains("cohesion"));
  }

  bool tables_in(const toml::node& node, std::string_view key, bool at_most_one,
                 std::vector<const toml::table*>& out) {
    if (const auto* single = node.as_table()) {
      out.push_back(single);
      return true;
    }
    const auto* array = at_most_one ? nullptr : node.as_array();
    bool fits = array != nullptr;
    for (std::size_t i = 0; fits && i < array->size(); ++i) {
      out.push_back(array->get(i)->as_table());
      fits = out.back() != nullptr;
    }
    if (!fits) {
      reading_.say_error(node, prefix_ + std::string(key),
                         say("must be a table such as { ... }", at_most_one ? "" : " or a list of tables"));
    }
    return fits;
  }

  void read_item(const toml::table& table, const std::string& prefix, std::size_t i, const Items& items) {
    TableReader inner(table, prefix, reading_);
    items.visit(i, inner);
    inner.finish();
    const auto begin = table.source().begin;
    if (items.order)
      *items.order(i) = static_cast<int>(begin.line * 1000 + std::min<unsigned>(begin.column, 999));
  }

  void read_named(const toml::table& table, std::string_view key, std::size_t i, const Items& items) {
    const std::string name = table["name"].value_or(i == 0 ? std::string(key) : say(key, "-", i + 1));
    items.rename(i, name);
    const std::string prefix = say(prefix_, key, ".", name, ".");
    reading_.lines[prefix] = Reading::line_of(table);
    TableReader inner(table, prefix, reading_);
    items.visit(i, inner);
    inner.finish();
  }

  void read_flock(const toml::table& table, std::size_t i, const Items& items) {
    auto& flocks = reading_.scenario.flocks;
    const bool has_like = table.contains("like");
    if (has_like) copy_like(table, i);
    flocks[i].name = table["name"].value_or(i == 0 ? std::string("boids") : say("boids-", i + 1));
    const std::string prefix = say("flock.", flocks[i].name, ".");
    reading_.lines[prefix] = Reading::line_of(table);
    TableReader inner(table, prefix, reading_);
    inner.has_like_ = has_like;
    inner.known_.emplace_back("like");
    items.visit(i, inner);
    inner.finish();
  }

  void copy_like(const toml::table& table, std::size_t i) {
    auto& flocks = reading_.scenario.flocks;
    if (!table.get("like")->is_string()) {
      return reading_.say_error(*table.get("like"), "flock.like",
                                "must be text, the name of an earlier flock");
    }
    const std::string like = table["like"].value_or(std::string());
    std::vector<std::string> earlier;
    for (std::size_t j = 0; j < i; ++j) {
      earlier.push_back(flocks[j].name);
      if (earlier.back() != like) continue;
      flocks[i] = flocks[j];
      return;
    }
    reading_.say_error(*table.get("like"), "flock.like", unknown_word("earlier flock", like, earlier));
  }

  const toml::table* table_ = nullptr;
  const toml::node* short_value_ = nullptr;
  std::string_view short_key_;
  std::string prefix_;
  Reading& reading_;
  std::vector<std::string> known_;
  bool has_like_ = false;
};

void read_events(const toml::table& root, Reading& reading) {
  const toml::node* node = root["run"]["events"].node();
  if (node == nullptr) return;
  reading.lines["run.events"] = Reading::line_of(*node);
  const auto* array = node->as_array();
  if (array == nullptr)
    return reading.say_error(*node, "run.events",
                             "must be a list of events such as [[120, \"set\", path, value]]");
  std::vector<std::pair<Event, int>> found;  // with their lines
  for (const toml::node& item : *array) {
    const auto value = value_of(item);
    if (!value) {
      reading.say_error(item, "run.events",
                        "an event holds numbers, texts and lists, but found a table or date");
      continue;
    }
    auto event = event_from(*value);
    if (const auto* error = std::get_if<std::string>(&event)) {
      reading.say_error(item, "run.events", *error);
    } else {
      found.emplace_back(std::get<Event>(std::move(event)), Reading::line_of(item));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first.step < b.first.step; });
  for (std::size_t i = 0; i < found.size(); ++i) {
    reading.scenario.run.events.push_back(std::move(found[i].first));
    reading.lines[say("run.events.", i)] = found[i].second;
  }
}

void read_root(const toml::table& root, Reading& reading) {
  TableReader reader(root, "", reading);
  visit(reading.scenario, reader);
  reader.finish();
  read_events(root, reading);
  if (!root.contains("flock")) {
    reading.problems.push_back(
        {reading.file, 0, "flock",
         "the file has no [[flock]]; the shortest scenario is [[flock]] with count = 300", false});
  }
}

// The line of a key, or of the nearest table around it.
int line_of_key(const std::map<std::string, int>& lines, std::string key) {
  while (!key.empty()) {
    if (const auto found = lines.find(key); found != lines.end()) return found->second;
    if (const auto found = lines.find(key + "."); found != lines.end()) return found->second;
    const auto dot = key.rfind('.');
    key = dot == std::string::npos ? "" : key.substr(0, dot);
  }
  return 0;
}

std::string stem_of(const std::string& file) {
  const auto slash = file.find_last_of("/\\");
  std::string stem = slash == std::string::npos ? file : file.substr(slash + 1);
  return stem.ends_with(".toml") ? stem.substr(0, stem.size() - 5) : stem;
}

Problem syntax_problem(const toml::parse_error& error, const std::string& file) {
  std::string text(error.description());
  if (text.find("inline table") != std::string::npos || text.find("line-break") != std::string::npos) {
    text += " (a term in braces { } stands on one line)";
  }
  return {file, static_cast<int>(error.source().begin.line), "", text, false};
}

}  // namespace

Result<std::vector<Entry>> parse_entries(const std::string& text, const std::string& file) {
  const toml::parse_result parsed = toml::parse(std::string_view(text), std::string_view(file));
  if (parsed.failed()) return syntax_problem(parsed.error(), file);
  std::vector<Entry> entries;
  Problems problems;
  for (const auto& [key, node] : parsed.table()) {
    const int line = Reading::line_of(node);
    auto value = value_of(node);
    if (value) {
      entries.push_back({std::string(key.str()), std::move(*value), line});
    } else {
      problems.push_back({file, line, std::string(key.str()),
                          "must be a number, a text, true, false or a list of them", false});
    }
  }
  if (!problems.empty()) return problems;
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.line < b.line; });
  return entries;
}

Result<ScenarioDef> parse_scenario(const std::string& text, const std::string& file, Problems* problems) {
  const toml::parse_result parsed = toml::parse(std::string_view(text), std::string_view(file));
  Reading reading;
  reading.file = file;
  if (parsed.failed()) {
    reading.problems.push_back(syntax_problem(parsed.error(), file));
  } else {
    reading.scenario.name = stem_of(file);
    reading.scenario.file = file;
    read_root(parsed.table(), reading);
    for (Problem problem : check(reading.scenario)) {
      problem.line = line_of_key(reading.lines, problem.key);
      reading.problems.push_back(std::move(problem));
    }
  }
  if (problems != nullptr)
    problems->insert(problems->end(), reading.problems.begin(), reading.problems.end());
  if (!has_errors(reading.problems)) return std::move(reading.scenario);
  return std::move(reading.problems);
}

}  // namespace sturnus
