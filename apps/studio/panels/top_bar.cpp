// The bar at the top: which scenario, playing, speed, seed, and how the world fares.
#include <cinttypes>
#include <cstdio>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "session/creatures.h"

namespace studio {
namespace {

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

std::string totals(const Desk& desk) {
  const Frame& frame = *desk.frame;
  std::size_t hunters = 0;
  for (std::size_t i = 0; i < frame.population.size(); ++i)
    hunters += is_predator(*frame.scenario, i) ? frame.population[i] : 0;
  std::string text = grouped(frame.boids.size() - hunters) + " units";
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

void show_speed(Desk& desk) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5);
  auto speed = static_cast<float>(desk.playback.speed());
  if (ImGui::SliderFloat("##speed", &speed, static_cast<float>(Playback::slowest),
                         static_cast<float>(Playback::fastest), speed_text(desk.playback.speed()).c_str(),
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput))
    desk.playback.set_speed(double{speed});
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) desk.playback.set_speed(1);
  mark(desk, "top.speed");
  tip("Speed, from 0.1x to 100x; 1x is 30 steps a second. Right click: 1x.");
}

void restart(Desk& desk, std::int64_t seed) {
  desk.session.order([seed](World& world) { return world.restart(seed); });
}

void show_seed(Desk& desk) {
  const std::int64_t seed = desk.scenario().seed;
  faint("seed " + std::to_string(seed));
  ImGui::SameLine();
  if (button(desk, "top.restart", "\u21bb", "Start again with the same seed")) restart(desk, seed);
  ImGui::SameLine();
  if (button(desk, "top.new_seed", "\u21bb+1", "Start again with the next seed")) restart(desk, seed + 1);
}

void show_totals(Desk& desk) {
  const std::string text = totals(desk);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const float theme = ImGui::CalcTextSize("\u263c").x + 24 * desk.text_scale;
  const float free = ImGui::GetContentRegionAvail().x;
  ImGui::SameLine(ImGui::GetCursorPosX() + std::max(0.0f, free - width - theme));
  ImGui::AlignTextToFramePadding();
  faint(text);
  mark(desk, "top.totals");
  tip("Who lives in this world, and how long its last step took");
  ImGui::SameLine();
  const bool is_dark = desk.view.theme == sturnus::ThemeName::dark;
  if (button(desk, "top.theme", is_dark ? "\u263c" : "\u263e", "Light or dark"))
    desk.view.theme = is_dark ? sturnus::ThemeName::light : sturnus::ThemeName::dark;
}

}  // namespace

void show_top_bar(Desk& desk) {
  if (begin_panel("top", desk.layout.top)) {
    const std::string title = (desk.open.gallery ? "\u25be " : "\u25b8 ") + desk.scenario().name;
    if (button(desk, "top.gallery", title.c_str(), "All scenarios and your files (g)"))
      desk.open.gallery = !desk.open.gallery;
    ImGui::SameLine(0, 20 * desk.text_scale);
    show_playing(desk);
    ImGui::SameLine();
    show_speed(desk);
    ImGui::SameLine(0, 20 * desk.text_scale);
    ImGui::AlignTextToFramePadding();
    show_seed(desk);
    ImGui::SameLine(0, 20 * desk.text_scale);
    show_recording(desk);
    ImGui::SameLine();
    show_view_menu(desk);
    ImGui::SameLine();
    show_totals(desk);
  }
  end_panel();
}

}  // namespace studio
