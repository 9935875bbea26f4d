// Parameters by their paths: set one, show one, list all.
#include <sturnus/parameters.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "scenario/assign.h"

namespace sturnus {
namespace {

std::pair<std::string_view, std::string_view> split_path(std::string_view path) {
  const auto dot = path.find('.');
  if (dot == std::string_view::npos) return {path, {}};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

std::optional<std::size_t> index_in(std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return {};
  return index;
}

// The highest place in the file that any term has.
class LastOrder : public FieldVisitor {
 public:
  void field(std::string_view, FieldRef, const About&) override {}
  void table(std::string_view, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view) override {
    visit_inside(*this);
  }
  void items(std::string_view, const About&, const Items& items) override {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items.order) last_ = std::max(last_, *items.order(i));
      items.visit(i, *this);
    }
  }
  int last() const { return last_; }

 private:
  int last_ = 0;
};

// Walks down a path and hands the place at its end to `use`.
class PathWalker : public FieldVisitor {
 public:
  using Use = std::function<std::optional<std::string>(const FieldRef&, const About&)>;
  /// `new_order`: the place in the file that a term gets which is not there yet; without it none is made.
  PathWalker(std::string_view path, std::optional<int> new_order, Use use)
      : path_(path), new_order_(new_order), use_(std::move(use)) {}

  void field(std::string_view key, FieldRef place, const About& about) override {
    known_.emplace_back(key);
    const auto [head, rest] = split_path(path_);
    const bool is_ring = head == "ring" && std::holds_alternative<RingRef>(place);
    if (found_ || (head != key && !is_ring)) return;
    found_ = true;
    error_ = rest.empty() ? use_(place, about)
                          : say("\"", key, "\" has no parts, but the path goes on with \"", rest, "\"");
  }

  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view short_key) override {
    known_.emplace_back(key);
    const auto [head, rest] = split_path(path_);
    if (found_ || head != key) return;
    enter(rest.empty() && !short_key.empty() ? short_key : rest, key, visit_inside);
  }

  void items(std::string_view key, const About&, const Items& items) override {
    known_.emplace_back(key);
    const auto [head, rest] = split_path(path_);
    if (found_ || head != key) return;
    if (items.name) return enter_named(key, rest, items);
    auto [first, after] = split_path(rest);
    auto index = items.at_most_one ? std::nullopt : index_in(first);
    if (!index) {
      after = rest;
      index = 0;
    }
    if (items.size() == 0 && new_order_) {
      items.resize(1);
      if (items.order) *items.order(0) = *new_order_;
    }
    if (*index >= items.size() || (items.size() > 1 && after.data() == rest.data())) {
      found_ = true;
      error_ = items.size() == 0 ? say("there is no ", key, " here")
                                 : say("there are ", items.size(), " tables \"", key, "\" here; write ", key,
                                       ".0 to ", key, ".", items.size() - 1);
      return;
    }
    enter(after, key, [&](FieldVisitor& inner) { items.visit(*index, inner); });
  }

  bool found() const { return found_; }
  const std::optional<std::string>& error() const { return error_; }
  std::string_view head() const { return split_path(path_).first; }
  const std::vector<std::string>& known() const { return known_; }

 private:
  void enter_named(std::string_view key, std::string_view rest, const Items& items) {
    const auto [name, after] = split_path(rest);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < items.size(); ++i) {
      names.push_back(items.name(i));
      if (names.back() == name)
        return enter(after, name, [&](FieldVisitor& inner) { items.visit(i, inner); });
    }
    found_ = true;
    error_ = unknown_word(key, name, names);
  }

  void enter(std::string_view rest, std::string_view name,
             const std::function<void(FieldVisitor&)>& visit_inside) {
    PathWalker inner(rest, new_order_, use_);
    visit_inside(inner);
    found_ = true;
    if (inner.found()) {
      error_ = inner.error();
    } else if (rest.empty()) {
      error_ =
          say("\"", name, "\" is a table; name one of its keys, such as ", name, ".", inner.known().front());
    } else {
      error_ = unknown_word("key", inner.head(), inner.known());
    }
  }

  std::string_view path_;
  std::optional<int> new_order_;
  Use use_;
  bool found_ = false;
  std::optional<std::string> error_;
  std::vector<std::string> known_;
};

Status walk(ScenarioDef& scenario, std::string_view path, bool may_create, PathWalker::Use use) {
  LastOrder order;
  visit(scenario, order);
  PathWalker walker(path, may_create ? std::optional(order.last() + 1) : std::nullopt, std::move(use));
  visit(scenario, walker);
  Problem problem{scenario.file, 0, std::string(path), "", false};
  if (!walker.found()) {
    problem.text = unknown_word("parameter", walker.head(), walker.known());
    return problem;
  }
  if (walker.error()) {
    problem.text = *walker.error();
    return problem;
  }
  return {};
}

// Lists every parameter of a scenario in which each list holds one item.
class RowLister : public FieldVisitor {
 public:
  RowLister(std::string prefix, std::vector<ParameterRow>& rows) : prefix_(std::move(prefix)), rows_(rows) {}

  void field(std::string_view key, FieldRef place, const About& about) override {
    const auto value = value_at(place);
    rows_.push_back({prefix_ + std::string(key), value ? to_text(*value) : "", kind_of(place), about});
  }
  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view) override {
    RowLister inner(say(prefix_, key, "."), rows_);
    visit_inside(inner);
  }
  void items(std::string_view key, const About&, const Items& items) override {
    if (items.size() == 0) items.resize(1);
    RowLister inner(say(prefix_, key, items.name ? ".NAME." : "."), rows_);
    items.visit(0, inner);
  }

 private:
  std::string prefix_;
  std::vector<ParameterRow>& rows_;
};

}  // namespace

Status set_parameter(ScenarioDef& scenario, std::string_view path, const Value& value) {
  ScenarioDef changed = scenario;
  Status status = walk(changed, path, true, [&](const FieldRef& place, const About& about) {
    return assign(place, value, about);
  });
  if (status) scenario = std::move(changed);
  return status;
}

Result<std::string> get_parameter(const ScenarioDef& scenario, std::string_view path) {
  ScenarioDef copy = scenario;  // visiting hands out places to write to
  std::string text;
  const Status status = walk(copy, path, false, [&](const FieldRef& place, const About&) {
    const auto value = value_at(place);
    text = value ? to_text(*value) : "";
    return std::optional<std::string>();
  });
  if (!status) return status.problems();
  return text;
}

std::vector<ParameterRow> parameter_rows() {
  ScenarioDef scenario;
  std::vector<ParameterRow> rows;
  RowLister lister("", rows);
  visit(scenario, lister);
  return rows;
}

}  // namespace sturnus
