// The effective scenario as TOML: every key with its value, terms in the order in which they count.
#include <sturnus/parameters.h>

#include <algorithm>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/events.h"
#include "scenario/extent.h"

namespace sturnus {
namespace {

// A term as it stands under a header of its own.
struct Part {
  int order;
  std::string key;
  std::string lines;
  bool is_listed;  ///< one of a list
};

// One `key = value` and where it belongs among its neighbours.
struct Entry {
  int order;
  std::string key;
  std::string text;
};

bool is_whole_table(std::string_view key) {
  for (const char* name : {"space", "time", "run", "index", "pointer", "camera"}) {
    if (key == name) return true;
  }
  return false;
}

// Collects the entries of one table; tables inside become { } on one line, the big ones get a [header].
class TomlPrinter : public FieldVisitor {
 public:
  void field(std::string_view key, FieldRef place, const About&) override {
    const auto value = value_at(place);
    if (!value) return;
    const auto* ring = std::get_if<RingRef>(&place);
    const bool has_inner = ring != nullptr && *ring->inner != 0;
    entries_.push_back({-1, has_inner ? "ring" : std::string(key), to_text(*value)});
  }

  void table(std::string_view key, const About&, const std::function<void(FieldVisitor&)>& visit_inside,
             std::string_view) override {
    TomlPrinter inner;
    visit_inside(inner);
    if (is_whole_table(key)) {
      blocks_.push_back(say("\n[", key, "]\n", inner.lines()));
    } else {
      entries_.push_back({-1, std::string(key), inner.braces()});
    }
  }

  void items(std::string_view key, const About&, const Items& items) override {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < items.size(); ++i) {
      TomlPrinter inner;
      items.visit(i, inner);
      if (items.name || items.has_header) {
        blocks_.push_back(say("\n[[", key, "]]\n", inner.under(key)));
      } else {
        texts.push_back(inner.braces());
        if (items.order)
          parts_.push_back({*items.order(i), std::string(key), inner.lines(), !items.at_most_one});
      }
    }
    if (items.name || items.has_header) return;
    if (texts.empty() && key != "separation" && key != "alignment" && key != "cohesion") return;
    const int order = !items.order ? -1 : texts.empty() ? 0 : *items.order(0);
    entries_.push_back({order, std::string(key), texts.size() == 1 ? texts.front() : list_text(texts)});
  }

  std::string lines() {
    sort();
    std::string out;
    for (const Entry& entry : entries_) out += say(entry.key, " = ", entry.text, "\n");
    return out;
  }

  /// The lines below the header of that key. Terms whose order `key = [...]` can't tell, since another one
  /// stands between two of a kind, all get headers of their own.
  std::string under(std::string_view key) {
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const Part& a, const Part& b) { return a.order < b.order; });
    if (!is_mixed()) return lines();
    std::erase_if(entries_, [&](const Entry& entry) { return has_part(entry.key); });
    std::string out = lines();
    for (const Part& part : parts_) {
      const std::string name = say(key, ".", part.key);
      out += say("\n", part.is_listed ? "[[" + name + "]]" : "[" + name + "]", "\n", part.lines);
    }
    return out;
  }

  std::string all() {
    std::string out = lines();
    for (const std::string& block : blocks_) out += block;
    return out;
  }

  static std::string list_text(const std::vector<std::string>& texts) {
    if (texts.empty()) return "[]";
    std::string out = "[\n";
    for (const std::string& text : texts) out += say("  ", text, ",\n");
    return out + "]";
  }

 private:
  std::string braces() {
    sort();
    std::string out;
    for (const Entry& entry : entries_) out += say(out.empty() ? "{ " : ", ", entry.key, " = ", entry.text);
    return out.empty() ? "{}" : out + " }";
  }

  bool has_part(std::string_view key) const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) { return part.key == key; });
  }

  // Whether parts of one key don't stand together.
  bool is_mixed() const {
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const auto is_kin = [&](const Part& part) { return part.key == parts_[i].key; };
      const auto here = parts_.begin() + static_cast<std::ptrdiff_t>(i);
      if (!is_kin(*std::prev(here)) && std::any_of(parts_.begin(), here, is_kin)) return true;
    }
    return false;
  }

  void sort() {
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.order < b.order; });
  }

  std::vector<Entry> entries_;
  std::vector<Part> parts_;
  std::vector<std::string> blocks_;
};

}  // namespace

std::string to_toml(const ScenarioDef& scenario) {
  ScenarioDef copy = scenario;  // visiting hands out places to write to
  copy.space.per_boid =
      scenario.space.min.empty() ? std::optional(per_boid_of(scenario.space)) : std::nullopt;
  TomlPrinter printer;
  visit(copy, printer);
  std::string out = printer.all();
  if (scenario.run.events.empty()) return out;
  std::vector<std::string> events;
  for (const Event& event : scenario.run.events) events.push_back(to_text(to_value(event)));
  const auto end_of_run = out.find("\n[", out.find("\n[run]\n") + 2);
  return out.insert(end_of_run, say("events = ", TomlPrinter::list_text(events), "\n"));
}

}  // namespace sturnus
