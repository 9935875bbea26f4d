// Marked, explained widgets.
#include "panels/widgets.h"

#include "panels/style.h"

namespace studio {

void mark(Desk& desk, const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  desk.items[name] = {low.x, low.y, high.x - low.x, high.y - low.y};
}

void tip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::GetCurrentContext() == nullptr) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool begin_panel(const char* name, const Box& box, ImGuiWindowFlags more) {
  ImGui::SetNextWindowPos({box.x, box.y});
  ImGui::SetNextWindowSize({box.width, box.height});
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | more);
}

void end_panel() {
  ImGui::End();
}

void end_popup() {
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

bool toggle(Desk& desk, const std::string& name, const char* text, bool& on, const std::string& explanation) {
  if (on) {
    const ImVec4 accent = to_imgui(sturnus::with_alpha(palette(desk.view.theme).accent, 0.45f));
    ImGui::PushStyleColor(ImGuiCol_Button, accent);
  }
  const bool was_on = on;
  const bool pressed = button(desk, name, text, explanation);
  if (was_on) ImGui::PopStyleColor();
  if (pressed) on = !on;
  return pressed;
}

bool button(Desk& desk, const std::string& name, const char* text, const std::string& explanation) {
  ImGui::PushID(name.c_str());
  const bool pressed = ImGui::Button(text);
  ImGui::PopID();
  mark(desk, name);
  tip(explanation);
  return pressed;
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string out = text;
  while (!out.empty() && ImGui::CalcTextSize((out + "\u2026").c_str()).x > width) {
    while (out.size() > 1 && (static_cast<unsigned char>(out.back()) & 0xc0) == 0x80) out.pop_back();
    out.pop_back();
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out + "\u2026";
}

void faint(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

}  // namespace studio
