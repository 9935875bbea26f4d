// Small pieces that panels are made of.
#pragma once

#include <string>

#include "desk.h"

namespace studio {

/// Remembers where the widget that was made last stands, for films and tests.
void mark(Desk& desk, const std::string& name);
/// Explains the widget that was made last, after a short rest of the mouse on it.
void tip(const std::string& text);
/// A plain window at a fixed place.
bool begin_panel(const char* name, const Box& box, ImGuiWindowFlags more = 0);
void end_panel();
/// Ends a popup, which Escape closes.
void end_popup();
/// A button of the accent's colour where it is on.
bool toggle(Desk& desk, const std::string& name, const char* text, bool& on, const std::string& explanation);
/// A button that is marked and explained.
bool button(Desk& desk, const std::string& name, const char* text, const std::string& explanation);
/// Text in the faint colour.
void faint(const std::string& text);
/// A text, or what fits of it into so many points, with three dots at its end.
std::string shortened(const std::string& text, float width);
/// A window that is as large as what it holds, at a place of its own.
constexpr ImGuiWindowFlags floating = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing;

}  // namespace studio
