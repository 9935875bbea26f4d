// The bar at the top: which scenario, playing, speed, seed, and how the world fares.
#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "session/creatures.h"

namespace studio {
namespace {

constexpr float gap_between_groups = 16;  // points at the usual size of text

std::string speed_text(double speed) {
  char text[32];
  std::snprintf(text, sizeof text, speed < 10 ? "%.1fx" : "%.0fx", speed);
  return text;
}

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, "\u2009");
  return text;
}

// How much the bar tells: less where it is narrow.
enum class Room { all, no_seed, units_only, none };

std::string totals(const Desk& desk, bool is_short = false) {
  const Frame& frame = *desk.frame;
  std::size_t hunters = 0;
  for (std::size_t i = 0; i < frame.population.size(); ++i)
    hunters += is_predator(*frame.scenario, i) ? frame.population[i] : 0;
  std::string text = grouped(frame.boids.size() - hunters) + " units";
  if (is_short) return text;
  if (hunters > 0) text += " \u00b7 " + grouped(hunters) + (hunters == 1 ? " predator" : " predators");
  if (!frame.obstacles.empty()) text += " \u00b7 " + grouped(frame.obstacles.size()) + " obstacles";
  if (!frame.food.empty()) text += " \u00b7 " + grouped(frame.food.size()) + " food";
  char milliseconds[48];
  std::snprintf(milliseconds, sizeof milliseconds, " \u00b7 %.1f ms", frame.step_seconds * 1e3);
  return text + milliseconds;
}

void show_playing(Desk& desk) {
  const bool plays = desk.playback.is_playing();
  if (button(desk, "top.start", "\u21e4", "Back to the first step that is remembered"))
    desk.session.go_to(desk.frame->reach.first);
  ImGui::SameLine();
  if (button(desk, "top.play", plays ? "\u2016" : "\u25b6", plays ? "Pause (space)" : "Play (space)"))
    desk.playback.play(!plays);
  ImGui::SameLine();
  if (button(desk, "top.step", "\u21e5", "One step, and pause (.)")) {
    desk.playback.play(false);
    desk.playback.step_once();
  }
}

// The number stands beside the slider, so that its knob hides nothing.
void show_speed(Desk& desk) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.5f);
  auto speed = static_cast<float>(desk.playback.speed());
  if (ImGui::SliderFloat("##speed", &speed, static_cast<float>(Playback::slowest),
                         static_cast<float>(Playback::fastest), "",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput))
    desk.playback.set_speed(double{speed});
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) desk.playback.set_speed(1);
  mark(desk, "top.speed");
  tip("Speed, from 0.1x to 100x; 1x is 30 steps a second. Right click: 1x.");
  const float after = ImGui::GetItemRectMax().x + ImGui::CalcTextSize(" 100x").x;
  ImGui::SameLine(0, 4 * desk.text_scale);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(speed_text(desk.playback.speed()).c_str());
  ImGui::SameLine(after - ImGui::GetWindowPos().x);
}

void restart(Desk& desk, std::int64_t seed) {
  desk.session.order([seed](World& world) { return world.restart(seed); });
}

void show_seed(Desk& desk, bool with_number) {
  const std::int64_t seed = desk.scenario().seed;
  const std::string text = "seed " + std::to_string(seed);
  if (with_number) {
    ImGui::AlignTextToFramePadding();
    faint(text);
    ImGui::SameLine();
  }
  if (button(desk, "top.restart", "\u21bb", "Start again with the same seed (" + text + ")"))
    restart(desk, seed);
  ImGui::SameLine();
  if (button(desk, "top.new_seed", "\u21bb+1", "Start again with the next seed")) restart(desk, seed + 1);
}

float width_of(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

float width_of_button(const char* text) {
  return width_of(text) + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
}

// What the bar takes besides its title, the seed, the totals and the gaps between groups.
float width_of_buttons(const Desk& desk) {
  float width = ImGui::GetFontSize() * 4.5f + width_of(" 100x") + 3 * ImGui::GetStyle().ItemSpacing.x;
  const char* record = desk.recorder.is_recording() ? "\u25cf 0:00" : "\u25cf";
  for (const char* text : {"\u21e4", "\u2016", "\u21e5", "\u21bb", "\u21bb+1", record, "view", "\u263c"})
    width += width_of_button(text);
  return width;
}

Room room_for(const Desk& desk, float free) {
  const float seed = width_of("seed " + std::to_string(desk.scenario().seed) + "  ");
  if (width_of(totals(desk)) + seed <= free) return Room::all;
  if (width_of(totals(desk)) <= free) return Room::no_seed;
  return width_of(totals(desk, true)) <= free ? Room::units_only : Room::none;
}

void show_theme(Desk& desk) {
  const bool is_dark = desk.view.theme == sturnus::ThemeName::dark;
  if (button(desk, "top.theme", is_dark ? "\u263c" : "\u263e", "Light or dark"))
    desk.view.theme = is_dark ? sturnus::ThemeName::light : sturnus::ThemeName::dark;
}

// At the right end: who lives here, and the theme.
void show_end(Desk& desk, Room room) {
  const std::string text = room == Room::none ? "" : totals(desk, room == Room::units_only);
  const float theme = width_of_button("\u263c") - ImGui::GetStyle().ItemSpacing.x;
  const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - theme;
  if (!text.empty()) {
    ImGui::SameLine(right - width_of(text) - ImGui::GetStyle().ItemSpacing.x);
    ImGui::AlignTextToFramePadding();
    faint(text);
    mark(desk, "top.totals");
    tip(totals(desk) + "\nWho lives in this world, and how long its last step took");
  }
  ImGui::SameLine(right);
  show_theme(desk);
}

void show_title(Desk& desk, float width) {
  const char* arrow = desk.open.gallery ? "\u25be " : "\u25b8 ";
  const std::string& name = desk.scenario().name;
  const float room = width - width_of_button(arrow);
  const std::string title = room < 2 * ImGui::GetFontSize() ? arrow : arrow + shortened(name, room);
  if (button(desk, "top.gallery", title.c_str(), name + "\nAll scenarios and your files (g)"))
    desk.open.gallery = !desk.open.gallery;
}

}  // namespace

void show_top_bar(Desk& desk) {
  if (begin_panel("top", desk.layout.top, ImGuiWindowFlags_NoScrollbar)) {
    const float buttons = ImGui::GetContentRegionAvail().x - width_of_buttons(desk);
    const float least = width_of_button("\u25b8 ");
    const float wide = std::clamp((buttons - 3 * least) / 4, 2.0f, gap_between_groups * desk.text_scale);
    const float free = buttons - 4 * wide;
    const float title = std::clamp(least + width_of(desk.scenario().name) + 1, least, std::max(free, least));
    const Room room = room_for(desk, free - title);
    show_title(desk, title);
    ImGui::SameLine(0, wide);
    show_playing(desk);
    ImGui::SameLine();
    show_speed(desk);
    ImGui::SameLine(0, wide);
    show_seed(desk, room == Room::all);
    ImGui::SameLine(0, wide);
    show_recording(desk);
    ImGui::SameLine();
    show_view_menu(desk);
    show_end(desk, room);
  }
  end_panel();
}

}  // namespace studio
