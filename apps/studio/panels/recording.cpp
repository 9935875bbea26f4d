// The red dot: films of the window, and what they are like.
#include <cstdio>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr sturnus::Rgba red = sturnus::rgb(0xe5484d);

std::string clock_text(double seconds) {
  char text[32];
  const int whole = static_cast<int>(seconds);
  std::snprintf(text, sizeof text, "\u25cf %d:%02d", whole / 60, whole % 60);
  return text;
}

bool show_choice(Desk& desk, const char* name, const char* text, bool is_on) {
  const bool is_pressed = ImGui::RadioButton(text, is_on);
  mark(desk, name);
  return is_pressed;
}

void show_choices(Desk& desk) {
  FilmOptions& film = desk.film;
  faint(desk.recorder.is_recording() ? "the next film" : "film");
  if (show_choice(desk, "film.mp4", "video (mp4)", !film.is_gif)) film.is_gif = false;
  ImGui::SameLine();
  if (show_choice(desk, "film.gif", "GIF", film.is_gif)) film.is_gif = true;
  if (show_choice(desk, "film.30", "30 pictures a second", film.frames_per_second == 30))
    film.frames_per_second = 30;
  ImGui::SameLine();
  if (show_choice(desk, "film.60", "60", film.frames_per_second == 60)) film.frames_per_second = 60;
  ImGui::Checkbox("with panels", &film.with_panels);
  mark(desk, "film.panels");
}

}  // namespace

void show_recording(Desk& desk) {
  const bool is_on = desk.recorder.is_recording();
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(red));
  const std::string text = is_on ? clock_text(desk.recorder.seconds()) : "\u25cf";
  const bool is_pressed = ImGui::Button((text + "###record").c_str());
  ImGui::PopStyleColor();
  mark(desk, "top.record");
  tip(is_on ? "End the film (r)" : "Begin a film (r); right click: what films are like");
  if (is_pressed) desk.toggle_recording();
  if (!ImGui::BeginPopupContextItem("film")) return;
  show_choices(desk);
  end_popup();
}

}  // namespace studio
