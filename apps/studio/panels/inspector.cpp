// The settings, made from the one list of parameters.
#include "panels/inspector.h"

#include <algorithm>
#include <array>
#include <utility>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/values.h"
#include "panels/widgets.h"
#include "session/creatures.h"

namespace studio {
namespace {

bool is_one_of(std::string_view key, std::initializer_list<std::string_view> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// Goes down a path of tables and shows what stands there to another visitor.
class Descent : public sturnus::FieldVisitor {
 public:
  Descent(std::string_view path, FieldVisitor& there) : path_(path), there_(there) {}
  void field(std::string_view, sturnus::FieldRef, const sturnus::About&) override {}
  void table(std::string_view key, const sturnus::About&, const Walk& walk, std::string_view) override {
    if (path_ == key) return walk(there_);
    if (!path_.starts_with(key) || path_[std::min(key.size(), path_.size() - 1)] != '.') return;
    Descent deeper(path_.substr(key.size() + 1), there_);
    walk(deeper);
  }
  void items(std::string_view, const sturnus::About&, const sturnus::Items&) override {}

 private:
  std::string_view path_;
  FieldVisitor& there_;
};

class Flocks : public sturnus::FieldVisitor {
 public:
  Flocks(Desk& desk, double side) : desk_(desk), side_(side) {}
  void field(std::string_view, sturnus::FieldRef, const sturnus::About&) override {}
  void table(std::string_view, const sturnus::About&, const Walk&, std::string_view) override {}
  void items(std::string_view key, const sturnus::About&, const sturnus::Items& items) override {
    if (key != "flock") return;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const FieldPlace where{path_of_item("", key, items, i) + ".", side_};
      show_flock(desk_, where, i, [&](FieldVisitor& visitor) { items.visit(i, visitor); });
    }
  }

 private:
  Desk& desk_;
  double side_;
};

void renew_baseline(Desk& desk) {
  if (desk.inspector.opened == desk.frame->opened && desk.inspector.opened) return;
  desk.inspector.opened = desk.frame->opened;
  desk.inspector.baseline = values_of(desk.frame->opened ? *desk.frame->opened : desk.scenario());
  desk.inspector.linked.clear();
}

void reset_all(Desk& desk) {
  const std::uint64_t gesture = desk.next_gesture++;
  for (const auto& [path, text] : values_of(desk.scenario())) {
    const auto found = desk.inspector.baseline.find(path);
    if (sturnus::is_fixed_while_running(path)) continue;
    if (found == desk.inspector.baseline.end()) {
      if (path.ends_with(".on") && text == "true") desk.set(path, "false", gesture);
    } else if (found->second != text && !found->second.empty()) {
      desk.set(path, found->second, gesture);
    }
  }
}

void show_totals(Desk& desk) {
  const Frame& frame = *desk.frame;
  std::size_t hunters = 0;
  for (std::size_t i = 0; i < std::min(frame.population.size(), frame.scenario->flocks.size()); ++i)
    hunters += is_predator(*frame.scenario, i) ? frame.population[i] : 0;
  const std::array<std::pair<const char*, std::size_t>, 5> totals{
      {{"units", frame.boids.size() - hunters},
       {"predators", hunters},
       {"obstacles", frame.obstacles.size()},
       {"food", frame.food.size()},
       {"a click", static_cast<std::size_t>(desk.tools.units_per_click())}}};
  // Each is as wide as the word "obstacles"; two rows where five do not fit.
  const float wide = ImGui::CalcTextSize("obstacles").x;
  const int columns = ImGui::GetContentRegionAvail().x < 4.4f * wide ? 3 : static_cast<int>(totals.size());
  if (!ImGui::BeginTable("totals", columns, ImGuiTableFlags_SizingFixedFit)) return;
  for (const auto& [name, number] : totals) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(std::to_string(number).c_str());
    mark(desk, std::string("inspector.total.") + name);
    faint(name);
  }
  ImGui::EndTable();
}

void show_head(Desk& desk) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Settings");
  const std::size_t modified = std::exchange(desk.inspector.modified, 0);
  const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  if (modified > 0) {
    ImGui::SameLine(right - ImGui::GetFrameHeight() * 2 - ImGui::CalcTextSize("reset all").x);
    if (button(desk, "inspector.reset", "reset all", "Every value back to what the scenario has"))
      reset_all(desk);
  }
  ImGui::SameLine(right - ImGui::GetFrameHeight());
  if (button(desk, "inspector.fold", "\u25b8", "Fold the settings away")) desk.open.inspector = false;
  show_totals(desk);
  ImGui::Dummy({0, 4});
}

void show_part(Desk& desk, sturnus::ScenarioDef& copy, const char* title, const char* path, double side) {
  if (!fold(desk, std::string("inspector.") + path, title, false)) return;
  Rows rows(desk, {std::string(path) + ".", side});
  Descent descent(path, rows);
  visit(copy, descent);
}

void show_rest(Desk& desk, sturnus::ScenarioDef& copy, double side) {
  if (!copy.food.empty() && fold(desk, "inspector.food", "food", false)) {
    Rows rows(desk, {"", side}, [](std::string_view key) { return key == "food"; });
    visit(copy, rows);
  }
  if (!copy.targets.empty() && fold(desk, "inspector.target", "targets", false)) {
    Rows rows(desk, {"", side}, [](std::string_view key) { return key == "target"; });
    visit(copy, rows);
  }
  if (!fold(desk, "inspector.more", "more", false)) return;
  Rows rows(desk, {"", side}, [](std::string_view key) {
    return !is_one_of(key, {"flock", "food", "target", "time", "pointer"});
  });
  visit(copy, rows);
}

void show_settings(Desk& desk) {
  sturnus::ScenarioDef copy = desk.scenario();
  const sturnus::Extent& extent = desk.frame->extent;
  const double side = extent.max.empty() ? 100 : extent.max[0] - extent.min[0];
  Flocks flocks(desk, side);
  visit(copy, flocks);
  show_part(desk, copy, "boundary", "space.boundary", side);
  show_part(desk, copy, "time step", "time", side);
  show_part(desk, copy, "pointer", "pointer", side);
  show_rest(desk, copy, side);
}

}  // namespace

void show_inspector(Desk& desk) {
  renew_baseline(desk);
  follow_tracked(desk);
  if (begin_panel("inspector", desk.layout.inspector)) {
    if (!desk.open.inspector) {
      if (button(desk, "inspector.unfold", "\u25c2", "Settings")) desk.open.inspector = true;
    } else if (desk.is_tracking && desk.frame->explained) {
      show_tracked(desk);
    } else {
      show_head(desk);
      ImGui::BeginChild("settings");
      show_settings(desk);
      ImGui::EndChild();
    }
  }
  end_panel();
}

}  // namespace studio
