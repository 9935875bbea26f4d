// What people are told: sentences in a strip above the bottom panel, and three lines at the first start.
#include <algorithm>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr std::size_t most_notes = 4;
constexpr double hint_seconds = 12, fading_seconds = 2;

constexpr const char* hints[] = {"Press S to scatter the flock under the cursor.",
                                 "Drag with the left button: the flock follows.",
                                 "The sliders at the right change how it flies; ? shows all keys."};

void show_hint(const Desk& desk) {
  if (desk.seconds > hint_seconds) return;
  const double left = std::min(1.0, (hint_seconds - desk.seconds) / fading_seconds);
  const Palette& colours = palette(desk.view.theme);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float left_edge = desk.layout.tools.x + desk.layout.tools.width;
  const float legend = desk.open.legend ? 190 * desk.text_scale : 0;
  const float middle = (left_edge + desk.layout.inspector.x - legend) / 2;
  float y = desk.layout.tools.y + 24 * desk.text_scale;
  for (const char* line : hints) {
    const ImVec2 size = ImGui::CalcTextSize(line);
    const sturnus::Rgba colour = sturnus::with_alpha(colours.text, 0.85f * static_cast<float>(left));
    list.AddText({middle - size.x / 2, y}, packed(colour), line);
    y += size.y * 1.5f;
  }
}

}  // namespace

void show_notes(Desk& desk) {
  show_hint(desk);
  for (ShownNote& note : desk.notes)
    if (note.about.empty()) note.seconds_left -= double{ImGui::GetIO().DeltaTime};
  desk.notes.erase(std::remove_if(desk.notes.begin(), desk.notes.end(),
                                  [](const ShownNote& note) { return note.seconds_left <= 0; }),
                   desk.notes.end());
  if (desk.notes.size() > most_notes) desk.notes.erase(desk.notes.begin(), desk.notes.end() - most_notes);
  if (desk.notes.empty()) return;
  const Box& low = desk.layout.bottom;
  ImGui::SetNextWindowPos({low.x + low.width / 2, low.y - 8}, ImGuiCond_Always, {0.5f, 1});
  ImGui::Begin("notes", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  for (ShownNote& shown : desk.notes) {
    const Palette& colours = palette(desk.view.theme);
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(shown.note.is_problem ? colours.problem : colours.text));
    ImGui::PushTextWrapPos(low.width * 0.7f);
    ImGui::TextUnformatted(shown.note.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    if (shown.about.empty()) continue;
    ImGui::PushID(shown.about.c_str());
    if (button(desk, "note.dismiss", "\u00d7 dismiss", "Shown until the file is right")) {
      shown.about.clear();
      shown.seconds_left = 0;
    }
    ImGui::PopID();
  }
  ImGui::End();
}

}  // namespace studio
