// The steps that can be reached, as a line with a knob.
#include <algorithm>

#include "panels/plots.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

void order(Desk& desk, bool (World::*what)()) {
  desk.session.order([what](World& world) {
    (world.*what)();
    return sturnus::Status();
  });
}

void show_undo(Desk& desk) {
  const Reach& reach = desk.frame->reach;
  ImGui::BeginDisabled(reach.undo.empty());
  if (button(desk, "timeline.undo", "\u21b6",
             reach.undo.empty() ? "Nothing to undo" : "Undo " + reach.undo + " (Ctrl + Z)"))
    order(desk, &World::undo);
  ImGui::EndDisabled();
  ImGui::SameLine(0, 4);
  ImGui::BeginDisabled(reach.redo.empty());
  if (button(desk, "timeline.redo", "\u21b7",
             reach.redo.empty() ? "Nothing to redo" : "Redo " + reach.redo + " (Ctrl + Shift + Z)"))
    order(desk, &World::redo);
  ImGui::EndDisabled();
}

void draw_line(const Desk& desk, ImVec2 low, ImVec2 high, float part) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = (low.y + high.y) / 2, x = low.x + part * (high.x - low.x);
  const ImU32 accent = packed(palette(desk.view.theme).accent);
  list.AddRectFilled({low.x, y - 2}, {high.x, y + 2}, ImGui::GetColorU32(ImGuiCol_Border), 2);
  list.AddRectFilled({low.x, y - 2}, {x, y + 2}, accent, 2);
  list.AddCircleFilled({x, y}, ImGui::IsItemHovered() || ImGui::IsItemActive() ? 8.0f : 6.0f, accent, 24);
}

}  // namespace

void show_timeline(Desk& desk, bool is_short) {
  const Reach& reach = desk.frame->reach;
  show_undo(desk);
  ImGui::SameLine(0, 16);
  const std::string step = "step " + std::to_string(desk.frame->step);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(step.c_str());
  mark(desk, "timeline.step");
  ImGui::SameLine(ImGui::GetCursorStartPos().x + ImGui::GetFontSize() * (is_short ? 11.0f : 13.0f));
  const float behind = ImGui::GetFontSize() * (is_short ? 8.0f : 14.5f);
  const float width = std::max(40.0f, ImGui::GetContentRegionAvail().x - behind);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("timeline", {width, ImGui::GetFrameHeight()});
  mark(desk, "timeline");
  const double span = static_cast<double>(std::max<std::uint64_t>(1, reach.last - reach.first));
  double part =
      std::clamp((static_cast<double>(desk.frame->step) - static_cast<double>(reach.first)) / span, 0.0, 1.0);
  if (ImGui::IsItemActive()) {
    part = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - at.x) / width), 0.0, 1.0);
    const auto wanted = reach.first + static_cast<std::uint64_t>(part * span + 0.5);
    desk.playback.play(false);
    if (wanted != desk.frame->step) desk.session.go_to(wanted);
  }
  draw_line(desk, at, {at.x + width, at.y + ImGui::GetFrameHeight()}, static_cast<float>(part));
  tip("Steps " + std::to_string(reach.first) + " to " + std::to_string(reach.last) + "; drag to wind back");
}

}  // namespace studio
