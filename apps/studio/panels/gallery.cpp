// All scenarios with their pictures, what to try in them, and the files of one's own.
#include "panels/gallery.h"

#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "files/recent.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr float least_card_width = 150;     // points
constexpr float picture_shape = 9.0f / 16;  // height for a width of 1

Box place_of_gallery(const Desk& desk) {
  const Box& world = desk.layout.world;
  const float width = std::min(1060 * desk.text_scale, world.width - 32);
  const float top = desk.layout.tools.y;
  const float height = std::min(680 * desk.text_scale, world.height - top - 16);
  return {world.x + (world.width - width) / 2, top, width, height};
}

void open_shipped(Desk& desk, const Exhibit& exhibit) {
  const auto scenario = sturnus::load_scenario(exhibit.name);
  if (!scenario) return desk.say(scenario.error(), true);
  desk.files.open(desk, *scenario);
  desk.open.gallery = false;
}

// The exhibit that the details tell of: the one that was clicked last, or the world's own.
const std::string& told_of(const Desk& desk) {
  return desk.gallery.looked_at.empty() ? desk.scenario().name : desk.gallery.looked_at;
}

void draw_picture(const Desk& desk, const Exhibit& exhibit, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colours = palette(desk.view.theme);
  const float corner = 6 * desk.text_scale;
  list.AddRectFilled(low, high, packed(colours.background), corner);
  if (ImTextureID picture = desk.gallery.thumbnails.of(exhibit.name))
    list.AddImageRounded(picture, low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, corner);
  const bool is_chosen = told_of(desk) == exhibit.name, is_hovered = ImGui::IsItemHovered();
  const sturnus::Rgba edge = is_hovered || is_chosen ? colours.accent : colours.outline;
  list.AddRect(low, high, packed(edge), corner, 0, is_chosen ? 2.0f : 1.0f);
}

// The first click tells of an exhibit, the second opens it.
void press(Desk& desk, const Exhibit& exhibit) {
  if (desk.gallery.looked_at == exhibit.name) return open_shipped(desk, exhibit);
  desk.gallery.looked_at = exhibit.name;
}

// Names what can be clicked: not what is scrolled out of sight.
void mark_visible(Desk& desk, const Exhibit& exhibit) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float middle = (low.y + high.y) / 2, top = ImGui::GetWindowPos().y;
  if (middle > top && middle < top + ImGui::GetWindowHeight()) mark(desk, "gallery." + exhibit.name);
}

// A picture with the title below it, the whole of it a button.
void show_card(Desk& desk, const Exhibit& exhibit, float width) {
  const float scale = desk.text_scale, height = width * picture_shape;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const bool is_pressed = ImGui::InvisibleButton(exhibit.name.c_str(), {width, height + line + 4 * scale});
  mark_visible(desk, exhibit);
  if (told_of(desk) != exhibit.name) tip("Click for more about it; click again to open it");
  draw_picture(desk, exhibit, at, {at.x + width, at.y + height});
  const ImVec4 clip(at.x, at.y, at.x + width, at.y + height + line + 4 * scale);
  ImGui::GetWindowDrawList()->AddText(nullptr, 0, {at.x + 2, at.y + height + 4 * scale},
                                      packed(palette(desk.view.theme).text),
                                      shortened(exhibit.title, width - 2).c_str(), nullptr, 0, &clip);
  if (is_pressed) press(desk, exhibit);
}

// Bench worlds are listed without pictures.
void show_line(Desk& desk, const Exhibit& exhibit) {
  const bool is_chosen = told_of(desk) == exhibit.name;
  if (ImGui::Selectable((exhibit.title + "##" + exhibit.name).c_str(), is_chosen)) press(desk, exhibit);
  mark_visible(desk, exhibit);
}

void show_group(Desk& desk, const std::string& group, const std::vector<const Exhibit*>& members) {
  ImGui::Dummy({0, 2});
  faint(group);
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x + gap;
  const int columns = std::max(1, static_cast<int>(room / (least_card_width * desk.text_scale + gap)));
  const float width = std::floor(room / static_cast<float>(columns) - gap);
  int column = 0;
  for (const Exhibit* exhibit : members) {
    if (group == "bench") {
      show_line(desk, *exhibit);
      continue;
    }
    if (column > 0) ImGui::SameLine();
    show_card(desk, *exhibit, width);
    column = (column + 1) % columns;
  }
}

void show_cards(Desk& desk) {
  const std::string search = desk.gallery.search.data();
  bool is_any = false;
  for (const char* group : {"gallery", "courses", "steering", "bench"}) {
    std::vector<const Exhibit*> members;
    for (const Exhibit& exhibit : exhibits()) {
      if (exhibit.group == group && is_found(exhibit, search)) members.push_back(&exhibit);
    }
    if (!members.empty()) show_group(desk, group, members);
    is_any = is_any || !members.empty();
  }
  if (!is_any) faint("No scenario speaks of \"" + search + "\".");
}

void show_search(Desk& desk) {
  ImGui::SetNextItemWidth(-1);
  const bool is_entered =
      ImGui::InputTextWithHint("##search", "search", desk.gallery.search.data(), desk.gallery.search.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue);
  mark(desk, "gallery.search");
  if (!is_entered) return;
  for (const Exhibit& exhibit : exhibits()) {
    if (is_found(exhibit, desk.gallery.search.data())) return open_shipped(desk, exhibit);
  }
}

// Where the world runs, a parameter is set in it. Where another does, or it can only be set before a run, the
// exhibit's world begins anew with it.
void try_it(Desk& desk, const Exhibit& exhibit, const std::string& path, const std::string& value) {
  const bool is_here = desk.scenario().name == exhibit.name;
  desk.open.gallery = false;
  if (is_here && !sturnus::is_fixed_while_running(path)) return desk.set(path, value);
  auto scenario = is_here ? sturnus::Result(desk.scenario()) : sturnus::load_scenario(exhibit.name);
  if (!scenario) return desk.say(scenario.error(), true);
  if (const sturnus::Status set = sturnus::set_parameter(*scenario, path, sturnus::parse_value(value)); !set)
    return desk.say(set.error(), true);
  desk.files.open(desk, *scenario);
  desk.say(exhibit.name + " began with " + path + " = " + value + ".");
}

// A line such as "flock.birds.cohesion.on = false" can be tried at once.
void show_suggestion(Desk& desk, const Exhibit& exhibit, std::size_t index) {
  const std::string& line = exhibit.try_this[index];
  const auto sign = line.find(" = ");
  if (sign == std::string::npos) return ImGui::TextWrapped("%s", line.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const bool is_pressed =
      ImGui::Selectable((shortened(line, width) + "##" + line).c_str(), false, 0, {width, 0});
  mark(desk, "gallery.try." + std::to_string(index + 1));
  tip(line + "\nClick to try it now; undo takes it back");
  if (is_pressed) try_it(desk, exhibit, line.substr(0, sign), line.substr(sign + 3));
}

void show_details(Desk& desk) {
  const std::string wanted = told_of(desk);
  for (const Exhibit& exhibit : exhibits()) {
    if (exhibit.name != wanted) continue;
    ImGui::TextWrapped("%s", exhibit.title.c_str());
    faint(exhibit.name);
    const bool is_here = desk.scenario().name == exhibit.name;
    if (button(desk, "gallery.open", is_here ? "start again" : "open",
               "This world in place of the one that runs"))
      open_shipped(desk, exhibit);
    ImGui::Dummy({0, 4});
    ImGui::TextWrapped("%s", exhibit.about.c_str());
    if (exhibit.try_this.empty()) return;
    ImGui::Dummy({0, 4});
    faint("try");
    for (std::size_t i = 0; i < exhibit.try_this.size(); ++i) show_suggestion(desk, exhibit, i);
    return;
  }
}

void show_recent(Desk& desk) {
  if (desk.gallery.recent.empty()) return;
  ImGui::Dummy({0, 4});
  faint("opened lately");
  for (const std::string& file : desk.gallery.recent) {
    const std::string name = std::filesystem::path(file).filename().string();
    const bool is_pressed = ImGui::Selectable((name + "##" + file).c_str());
    mark(desk, "gallery.recent." + name);
    tip(file);
    if (!is_pressed) continue;
    desk.files.open(desk, file);
    desk.open.gallery = false;
  }
}

void show_saving(Desk& desk) {
  faint("save");
  const std::string typed = desk.gallery.file_name.data();
  if (button(desk, "gallery.save_scenario", "scenario",
             "The world's rules as they stand now, as a scenario file"))
    desk.files.save_scenario(desk, typed);
  ImGui::SameLine();
  if (button(desk, "gallery.save_session", "session",
             "Everything that was done since the start, as a scenario with events that replays to the bit"))
    desk.files.save_session(desk, typed);
  ImGui::SameLine();
  if (button(desk, "gallery.save_state", "boids", "Where everyone is now, as a table (CSV)"))
    desk.files.save_state(desk, typed);
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##file_name", "name of the file, or one is made", desk.gallery.file_name.data(),
                           desk.gallery.file_name.size());
  mark(desk, "gallery.file_name");
  tip("Nothing is ever overwritten: a taken name gets a number");
}

void show_side(Desk& desk) {
  const float saving = ImGui::GetTextLineHeightWithSpacing() + 2 * ImGui::GetFrameHeightWithSpacing() + 4;
  if (ImGui::BeginChild("details", {0, -saving})) {
    show_details(desk);
    show_recent(desk);
  }
  ImGui::EndChild();
  show_saving(desk);
}

void open_up(Desk& desk) {
  desk.gallery.recent = recent_files(recent_list_path());
  desk.gallery.looked_at.clear();
  ImGui::SetNextWindowFocus();
}

}  // namespace

void show_gallery(Desk& desk) {
  const bool was_open = std::exchange(desk.gallery.was_open, desk.open.gallery);
  if (!desk.open.gallery) return;
  desk.gallery.thumbnails.want(desk.view.theme);
  desk.gallery.thumbnails.upload();
  if (!was_open) open_up(desk);
  const Box place = place_of_gallery(desk);
  const float side = std::min(280 * desk.text_scale, 0.45f * place.width);
  ImGui::SetNextWindowBgAlpha(1);
  if (begin_panel("gallery", place)) {
    if (ImGui::BeginChild("cards", {ImGui::GetContentRegionAvail().x - side - 16, 0})) {
      show_search(desk);
      show_cards(desk);
    }
    ImGui::EndChild();
    ImGui::SameLine(0, 16);
    if (ImGui::BeginChild("side", {0, 0})) show_side(desk);
    ImGui::EndChild();
  }
  end_panel();
}

}  // namespace studio
