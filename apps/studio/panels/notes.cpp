// What people are told: sentences in a strip above the bottom panel, and three lines at the first start.
#include <algorithm>

#include "panels/layout.h"
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

void show_hint(Desk& desk) {
  if (desk.seconds > hint_seconds) desk.open.hint = false;
  if (!desk.open.hint) return;
  const double left = std::min(1.0, (hint_seconds - desk.seconds) / fading_seconds);
  const Palette& colours = palette(desk.view.theme);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  Box free = free_area(desk);
  if (shows_legend(desk)) free.width -= desk.items["legend"].width + 8;
  const float width = std::min(free.width - 16, 30 * ImGui::GetFontSize());
  if (width < 6 * ImGui::GetFontSize()) return;
  float y = free.y + 16 * desk.text_scale;
  for (const char* line : hints) {
    const ImVec2 size = ImGui::CalcTextSize(line, nullptr, false, width);
    const sturnus::Rgba colour = sturnus::with_alpha(colours.text, 0.85f * static_cast<float>(left));
    list.AddText(nullptr, 0, {free.x + (free.width - size.x) / 2, y}, packed(colour), line, nullptr, width);
    y += size.y + ImGui::GetTextLineHeight() * 0.5f;
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
  ImGui::Begin("notes", nullptr, floating);
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
