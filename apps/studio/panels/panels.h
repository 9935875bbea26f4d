// The panels, each a function of the desk, called once a frame between ImGui::NewFrame and ImGui::Render.
#pragma once

#include "desk.h"

namespace studio {

void show_top_bar(Desk& desk);
/// What is drawn, and how: a button with a menu.
void show_view_menu(Desk& desk);
void show_tool_column(Desk& desk);
void show_legend(Desk& desk);
/// Whether the legend is seen: unfolded, and either there is room for it or somebody asked for it.
bool shows_legend(const Desk& desk);
void show_inspector(Desk& desk);
void show_bottom(Desk& desk);
void show_help(Desk& desk);
void show_gallery(Desk& desk);
/// The button that begins and ends a film, with its choices.
void show_recording(Desk& desk);
void show_notes(Desk& desk);

}  // namespace studio
