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

void show_choices(FilmOptions& film) {
  faint("film");
  if (ImGui::RadioButton("video (mp4)", !film.is_gif)) film.is_gif = false;
  ImGui::SameLine();
  if (ImGui::RadioButton("GIF", film.is_gif)) film.is_gif = true;
  if (ImGui::RadioButton("30 pictures a second", film.frames_per_second == 30)) film.frames_per_second = 30;
  ImGui::SameLine();
  if (ImGui::RadioButton("60", film.frames_per_second == 60)) film.frames_per_second = 60;
  ImGui::Checkbox("with panels", &film.with_panels);
}

}  // namespace

void show_recording(Desk& desk) {
  const bool is_on = desk.recorder.is_recording();
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(red));
  const std::string text = is_on ? clock_text(desk.recorder.seconds()) : "\u25cf";
  const bool is_pressed = ImGui::Button((text + "###record").c_str());
  ImGui::PopStyleColor();
  mark(desk, "top.record");
  tip(is_on ? "End the film (r)" : "Begin a film (r); right click: what it is like");
  if (is_pressed) desk.toggle_recording();
  if (is_on || !ImGui::BeginPopupContextItem("film")) return;
  show_choices(desk.film);
  end_popup();
}

}  // namespace studio
