// The tools at the left, their legend at the right, and the help.
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace studio {
namespace {

std::string tool_tip(const ToolInfo& info) {
  return std::string(info.name) + " (" + info.key + ")\n" + info.hint;
}

// A square with the tool's key and, below it, a bar of its colour.
void show_tool(Desk& desk, const ToolInfo& info) {
  const bool is_chosen = desk.tools.tool == info.tool;
  const float side = ImGui::GetContentRegionAvail().x;
  const char label[] = {info.key, '\0'};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(info.name);
  if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(sturnus::with_alpha(info.colour, 0.35f)));
  if (ImGui::Button(label, {side, side * 0.95f})) desk.tools.tool = info.tool;
  if (is_chosen) ImGui::PopStyleColor();
  ImGui::PopID();
  mark(desk, std::string("tool.") + info.name);
  tip(tool_tip(info));
  const float inset = side * 0.25f;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x + inset, at.y + side * 0.82f},
                                            {at.x + side - inset, at.y + side * 0.82f + 3 * desk.text_scale},
                                            packed(info.colour), 2);
}

// To whom units are added, where there is a choice.
void show_flock(Desk& desk) {
  const sturnus::ScenarioDef& scenario = desk.scenario();
  const auto chosen = desk.tools.chosen(scenario);
  if (!chosen || desk.tools.choices(scenario).size() < 2) return;
  const std::string& name = scenario.flocks[*chosen].name;
  const std::string number = "\u2192" + std::to_string(*chosen + 1);
  if (button(desk, "tool.flock", number.c_str(), "Clicks add to " + name + "; press for the next flock"))
    desk.tools.choose_next(scenario);
}

void show_key(const char* key, const char* meaning) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(key);
  ImGui::TableNextColumn();
  faint(meaning);
}

constexpr const char* keys[][2] = {
    {"space, a", "play, pause"},
    {". (point)", "a single step"},
    {"0 \u2026 8, S", "the tools"},
    {"up, down", "twice, half as many units a click"},
    {"Ctrl + wheel", "the reach of eraser and scatter"},
    {"T", "track a unit; left, right: another one"},
    {"wheel", "zoom"},
    {"middle drag, Alt + left", "pan; in space orbit"},
    {"Shift + right drag, WASD", "look round and fly in space"},
    {"f", "see the whole space"},
    {"g", "gallery"},
    {"w", "save a picture"},
    {"r", "begin and end a film"},
    {"Ctrl + Z, Ctrl + Shift + Z", "undo, redo"},
    {"Ctrl + C, Ctrl + V", "copy and paste a scenario"},
    {"Ctrl +, Ctrl -", "larger and smaller text"},
    {"?", "this help"},
};

}  // namespace

void show_tool_column(Desk& desk) {
  if (begin_panel("tools", desk.layout.tools)) {
    for (const ToolInfo& info : tool_list()) show_tool(desk, info);
    ImGui::Dummy({0, 4});
    const std::string count = std::to_string(desk.tools.units_per_click());
    faint(count);
    tip(count + " units a click (up and down keys)");
    show_flock(desk);
    if (button(desk, "tool.legend", "?", "What the tools are called")) desk.open.legend = !desk.open.legend;
  }
  end_panel();
}

void show_legend(Desk& desk) {
  if (!desk.open.legend) return;
  const Box& beside = desk.layout.inspector;
  ImGui::SetNextWindowPos({beside.x - 8, beside.y}, ImGuiCond_Always, {1, 0});
  ImGui::Begin("legend", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  for (const ToolInfo& info : tool_list()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size / 2, at.y + size / 2}, size * 0.3f,
                                                packed(info.colour));
    ImGui::Dummy({size, size});
    ImGui::SameLine();
    ImGui::Text("%c", info.key);
    ImGui::SameLine(size * 3.6f);
    if (ImGui::Selectable(info.name, desk.tools.tool == info.tool)) desk.tools.tool = info.tool;
    mark(desk, std::string("legend.") + info.name);
    tip(info.hint);
  }
  if (ImGui::Selectable("\u00d7 fold away", false)) desk.open.legend = false;
  mark(desk, "legend.fold");
  ImGui::End();
}

void show_help(Desk& desk) {
  if (!desk.open.help) return;
  const Box& world = desk.layout.world;
  ImGui::SetNextWindowPos({world.x + world.width / 2, world.y + world.height / 2}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::Begin("help", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextUnformatted("Keys");
  ImGui::Separator();
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const auto& [key, meaning] : keys) show_key(key, meaning);
    ImGui::EndTable();
  }
  if (button(desk, "help.close", "close", "")) desk.open.help = false;
  ImGui::End();
}

}  // namespace studio
