// One flock's settings.
#include <algorithm>
#include <cstdio>
#include <set>

#include "panels/inspector.h"
#include "panels/style.h"
#include "panels/values.h"
#include "panels/widgets.h"
#include "view/colours.h"

namespace studio {
namespace {

const std::set<std::string, std::less<>> limits{"min_speed", "max_speed", "max_acceleration",
                                                "field_of_view"};
const std::set<std::string, std::less<>> creatures{"hunt", "jump", "hunger", "feed"};
// What a term shows without being unfolded.
const std::set<std::string, std::less<>> foremost{"weight", "radius", "speed",    "acceleration", "turn",
                                                  "rate",   "sight",  "full_for", "starves_after"};

std::string readable(std::string_view key) {
  std::string text(key);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// Finds the switch of a term, if it has one.
class Switch : public sturnus::FieldVisitor {
 public:
  void field(std::string_view key, sturnus::FieldRef place, const sturnus::About&) override {
    if (bool** found = std::get_if<bool*>(&place); found != nullptr && key == "on") is_on_ = **found;
  }
  void table(std::string_view, const sturnus::About&, const Walk&, std::string_view) override {}
  void items(std::string_view, const sturnus::About&, const sturnus::Items&) override {}
  std::optional<bool> is_on() const { return is_on_; }

 private:
  std::optional<bool> is_on_;
};

std::string others(const Desk& desk, std::size_t self, bool hunters) {
  sturnus::Value::List names;
  const auto& flocks = desk.scenario().flocks;
  for (std::size_t i = 0; i < flocks.size(); ++i) {
    if (i != self && (!hunters || flocks[i].hunt)) names.push_back({flocks[i].name});
  }
  return names.empty() ? "" : to_text(sturnus::Value{names});
}

std::string first_other(const Desk& desk, std::size_t self) {
  for (std::size_t i = 0; i < desk.scenario().flocks.size(); ++i) {
    if (i != self) return to_text(sturnus::Value{desk.scenario().flocks[i].name});
  }
  return "";
}

// A line half the size of the space, round its middle.
std::string round_trip(const Desk& desk) {
  const sturnus::Extent& extent = desk.frame->extent;
  sturnus::Value::List corners;
  for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
    sturnus::Value::List corner;
    const int signs[3] = {x, y, 0};
    for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
      const double middle = (extent.min[axis] + extent.max[axis]) / 2;
      corner.push_back({middle + signs[axis] * (extent.max[axis] - extent.min[axis]) / 4});
    }
    corners.push_back({corner});
  }
  return to_text(sturnus::Value{corners});
}

struct Setting {
  std::string key, value;
};

// What has to be set for a term to appear; no value: it can't here.
Setting first_setting(const Desk& desk, std::size_t flock, std::string_view term) {
  if (term == "flee") return {"from", others(desk, flock, true)};
  if (term == "hunt") return {"prey", others(desk, flock, false)};
  if (term == "pursue" || term == "evade") return {"of", others(desk, flock, false)};
  if (term == "follow_leader") return {"leader", first_other(desk, flock)};
  if (term == "follow_path" || term == "follow_wall") return {"points", round_trip(desk)};
  if (term == "noise") return {"turn", "10"};
  if (term == "hunger") return {"full_for", "120"};
  if (term == "feed")
    return {"on", desk.scenario().food.empty() ? "" : to_text(sturnus::Value{desk.scenario().food[0].name})};
  const bool needs_hunt = term == "jump" && !desk.scenario().flocks[flock].hunt;
  return {"on", needs_hunt ? "" : "true"};
}

// The terms of a flock: those that it has as rows, the others as buttons.
class Terms : public sturnus::FieldVisitor {
 public:
  Terms(Desk& desk, const FieldPlace& where, std::size_t flock, bool for_creatures)
      : desk_(desk), where_(where), flock_(flock), for_creatures_(for_creatures) {}
  void field(std::string_view, sturnus::FieldRef, const sturnus::About&) override {}
  void table(std::string_view, const sturnus::About&, const Walk&, std::string_view) override {}
  void items(std::string_view key, const sturnus::About& about, const sturnus::Items& items) override {
    if (creatures.contains(key) != for_creatures_) return;
    if (items.size() == 0) absent_.emplace_back(key);
    for (std::size_t i = 0; i < items.size(); ++i) {
      std::string title = readable(key);
      if (items.size() > 1) title += " " + std::to_string(i + 1);
      show(path_of_item(where_.prefix, key, items, i), title, about,
           [&](FieldVisitor& visitor) { items.visit(i, visitor); });
    }
  }
  void show_absent();

 private:
  void show(const std::string& path, const std::string& title, const sturnus::About& about, const Walk& walk);

  Desk& desk_;
  const FieldPlace& where_;
  std::size_t flock_;
  bool for_creatures_;
  std::vector<std::string> absent_;
};

void Terms::show(const std::string& path, const std::string& title, const sturnus::About& about,
                 const Walk& walk) {
  Switch found;
  walk(found);
  ImGui::PushID(path.c_str());
  const ImU32 colour = packed(palette(desk_.view.theme).accent);
  if (const auto on = found.is_on()) {
    if (dot_switch(desk_, path + ".on", *on, colour))
      desk_.set(path + ".on", *on ? "false" : "true", desk_.next_gesture++);
    tip("On or off; the weight is kept");
    ImGui::SameLine(0, 0);
  }
  ImGui::AlignTextToFramePadding();
  if (found.is_on() == false) {
    faint(title);
  } else {
    ImGui::TextUnformatted(title.c_str());
  }
  tip(words_of(path, about));
  bool* is_open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("all"), false);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
  ImGui::PushStyleColor(ImGuiCol_Button, 0);
  if (button(desk_, "inspector." + path + ".all", *is_open ? "\u25be" : "\u25b8",
             "Everything that can be set of it"))
    *is_open = !*is_open;
  ImGui::PopStyleColor();
  Rows rows(desk_, {path + ".", where_.side}, [all = *is_open](std::string_view key) {
    return key != "on" && (all || foremost.contains(key));
  });
  walk(rows);
  ImGui::PopID();
  ImGui::Dummy({0, 2});
}

void Terms::show_absent() {
  const float right = ImGui::GetContentRegionMax().x;
  float at = 0;
  for (const std::string& term : absent_) {
    const Setting first = first_setting(desk_, flock_, term);
    if (first.value.empty()) continue;
    const std::string text = "+ " + readable(term);
    const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (at > 0 && at + width < right) ImGui::SameLine(0, 4);
    if (at + width >= right) at = 0;
    at += width + 4;
    const std::string path = where_.prefix + term + "." + first.key;
    if (button(desk_, "inspector." + where_.prefix + term + ".add", text.c_str(), "Give the flock this"))
      desk_.set(path, first.value, desk_.next_gesture++);
  }
}

void show_flock_head(Desk& desk, const std::string& name, std::size_t index) {
  show_presets(desk, index);
  bool linked = desk.inspector.linked.contains(name);
  if (toggle(desk, "inspector.flock." + name + ".link", "link radii", linked,
             "Changing one radius changes those of separation, alignment and cohesion in proportion")) {
    if (linked) desk.inspector.linked.insert(name);
    if (!linked) desk.inspector.linked.erase(name);
  }
  ImGui::Dummy({0, 2});
}

}  // namespace

bool fold(Desk& desk, const std::string& name, const char* text, bool is_open_at_first) {
  ImGui::PushID(name.c_str());
  const ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                   ImGuiTreeNodeFlags_FramePadding |
                                   (is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  const bool is_open = ImGui::TreeNodeEx(text, flags);
  ImGui::PopID();
  mark(desk, name + ".fold");
  return is_open;
}

void Rows::field(std::string_view key, sturnus::FieldRef place, const sturnus::About& about) {
  if (shows(key)) show_field(desk_, where_, key, place, about);
}

void Rows::table(std::string_view key, const sturnus::About& about, const Walk& walk, std::string_view) {
  if (shows(key)) part(where_.prefix + std::string(key), key, about, walk);
}

void Rows::items(std::string_view key, const sturnus::About& about, const sturnus::Items& items) {
  if (!shows(key)) return;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string title = items.name ? items.name(i) : std::string(key);
    part(path_of_item(where_.prefix, key, items, i), title, about,
         [&](FieldVisitor& visitor) { items.visit(i, visitor); });
  }
}

void Rows::part(const std::string& path, std::string_view title, const sturnus::About& about,
                const Walk& walk) {
  ImGui::Dummy({0, 2});
  ImGui::TextUnformatted(readable(title).c_str());
  tip(words_of(path, about));
  Rows inner(desk_, {path + ".", where_.side});
  walk(inner);
}

void show_flock(Desk& desk, const FieldPlace& where, std::size_t index, const Walk& walk) {
  const std::string name = desk.scenario().flocks[index].name;
  const std::size_t alive = index < desk.frame->population.size() ? desk.frame->population[index] : 0;
  const std::string base = "inspector.flock." + name;
  const std::string title = "     " + name + "  \u00b7  " + std::to_string(alive);
  const sturnus::Rgba colour = flock_colour(desk.scenario(), index, desk.view.theme);
  const bool is_open = fold(desk, base, title.c_str(), index < 2);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddCircleFilled({low.x + 2.2f * (high.y - low.y) * 0.62f, (low.y + high.y) / 2},
                                              (high.y - low.y) * 0.2f, packed(colour), 24);
  if (!is_open) return;
  ImGui::Indent(4);
  show_flock_head(desk, name, index);
  Terms terms(desk, where, index, false);
  walk(terms);
  terms.show_absent();
  if (fold(desk, base + ".limits", "limits", false)) {
    Rows rows(desk, where, [](std::string_view key) { return limits.contains(key); });
    walk(rows);
  }
  if (fold(desk, base + ".creatures", "hunting and feeding",
           desk.scenario().flocks[index].hunt.has_value())) {
    Terms hunting(desk, where, index, true);
    walk(hunting);
    hunting.show_absent();
  }
  if (fold(desk, base + ".more", "more of this flock", false)) {
    class Others : public Rows {
     public:
      using Rows::Rows;
      void items(std::string_view, const sturnus::About&, const sturnus::Items&) override {}
    };
    Others rows(desk, where, [](std::string_view key) { return !limits.contains(key); });
    walk(rows);
  }
  ImGui::Unindent(4);
}

}  // namespace studio
