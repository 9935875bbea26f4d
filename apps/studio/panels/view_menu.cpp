// What is drawn, and how.
#include <algorithm>

#include "panels/panels.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr const char* colours[] = {"as the scenario says", "flock",   "heading", "speed",
                                   "neighbours",           "drifting"};
constexpr const char* looks[] = {"as the scenario says", "arrows", "fish", "birds", "points"};

// A word of a list.
template <class Choice, std::size_t N>
void choose(Desk& desk, const char* name, const char* const (&words)[N], Choice& chosen,
            const char* explanation) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11);
  if (ImGui::BeginCombo(name, words[static_cast<std::size_t>(chosen)])) {
    for (std::size_t i = 0; i < N; ++i) {
      if (ImGui::Selectable(words[i], static_cast<std::size_t>(chosen) == i)) chosen = static_cast<Choice>(i);
      mark(desk, std::string("view.") + name + "." + words[i]);
    }
    ImGui::EndCombo();
  } else {
    mark(desk, std::string("view.") + name);
    tip(explanation);
  }
}

void check(Desk& desk, const char* name, bool& on, const char* explanation) {
  ImGui::Checkbox(name, &on);
  mark(desk, std::string("view.") + name);
  tip(explanation);
}

}  // namespace

void show_view_menu(Desk& desk) {
  if (button(desk, "top.view", "view", "Colours, forms, trails, grid and cells"))
    ImGui::OpenPopup("view menu");
  const Box below = desk.items["top.view"];
  const float width = 18 * ImGui::GetFontSize();
  ImGui::SetNextWindowPos({std::max(8.0f, std::min(below.x, desk.layout.world.width - width)),
                           desk.layout.top.y + desk.layout.top.height + 4});
  if (!ImGui::BeginPopup("view menu")) return;
  choose(desk, "colour", colours, desk.view.colour_by,
         "What a unit's colour tells: its flock, where it flies, how fast, among how many, or the colour of "
         "its own that drifts towards its neighbours', in scenarios that have such colours");
  choose(desk, "look", looks, desk.view.look, "How a unit is drawn");
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11);
  ImGui::SliderFloat("size", &desk.view.size, 0.25f, 8, "%.2f", ImGuiSliderFlags_Logarithmic);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) desk.view.size = 1;
  mark(desk, "view.size");
  tip("How large units are drawn, times the size that the scenario gives. Right click: 1.");
  check(desk, "trails", desk.view.trails, "Where each unit was in its last steps");
  check(desk, "smooth", desk.view.smooth,
        "Edges of bodies, by four samples a pixel: slow without a graphics card");
  check(desk, "outline", desk.view.outline, "The edge of the space");
  check(desk, "grid", desk.view.grid, "Lines at even distances");
  check(desk, "cells", desk.view.index, "The cells or leaves in which neighbours are looked for");
  desk.wishes = {desk.view.index, desk.view.colour_by == ColourBy::neighbours};
  end_popup();
}

}  // namespace studio
