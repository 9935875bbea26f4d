// The tools at the left, their legend at the right, and the help.
#include "panels/layout.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "view/colours.h"

namespace studio {
namespace {

std::string tool_tip(const ToolInfo& info) {
  return std::string(info.name) + " (" + info.key + ")\n" + info.hint;
}

// What stands in the column and in the legend beside the tools: a key that follows a unit.
const ToolInfo& tracking_info() {
  static const ToolInfo info{Tool::hand, 'T', "track",
                             "Follows a unit and shows why it turns; left and right go to another.",
                             sturnus::rgb(0xff3b30)};
  return info;
}

// Puts the next thing where it belongs: from left to right, then down.
void next_slot(const Desk& desk, int& slot) {
  if (slot++ % desk.layout.tool_columns != 0) ImGui::SameLine(0, 4 * desk.text_scale);
}

ImVec2 slot_size(const Desk& desk) {
  return {28 * desk.text_scale, desk.layout.tool_height};
}

// A square with a key and, below it, a bar of its colour.
bool show_tool(Desk& desk, const ToolInfo& info, bool is_chosen) {
  const ImVec2 size = slot_size(desk), at = ImGui::GetCursorScreenPos();
  const sturnus::Rgba colour = colour_on(desk.view.theme, info.colour);
  const char label[] = {info.key, '\0'};
  ImGui::PushID(info.name);
  if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(sturnus::with_alpha(colour, 0.35f)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const bool is_pressed = ImGui::Button(label, size);
  ImGui::PopStyleVar();
  if (is_chosen) ImGui::PopStyleColor();
  ImGui::PopID();
  mark(desk, std::string("tool.") + info.name);
  tip(tool_tip(info));
  const float inset = size.x * 0.25f, thick = 3 * desk.text_scale;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x + inset, at.y + size.y - thick - 1},
                                            {at.x + size.x - inset, at.y + size.y - 1}, packed(colour), 2);
  return is_pressed;
}

void show_count(Desk& desk) {
  const std::string count = std::to_string(desk.tools.units_per_click());
  const ImVec2 size = slot_size(desk), at = ImGui::GetCursorScreenPos();
  const ImVec2 text = ImGui::CalcTextSize(count.c_str());
  ImGui::Dummy(size);
  tip(count + " units a click (up and down keys)");
  ImGui::GetWindowDrawList()->AddText({at.x + (size.x - text.x) / 2, at.y + (size.y - text.y) / 2},
                                      ImGui::GetColorU32(ImGuiCol_TextDisabled), count.c_str());
}

// To whom units are added, where there is a choice.
void show_flock(Desk& desk, int& slot) {
  const sturnus::ScenarioDef& scenario = desk.scenario();
  const auto chosen = desk.tools.chosen(scenario);
  if (!chosen || desk.tools.choices(scenario).size() < 2) return;
  next_slot(desk, slot);
  const std::string number = "\u2192" + std::to_string(*chosen + 1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const bool is_pressed = ImGui::Button((number + "##flock").c_str(), slot_size(desk));
  ImGui::PopStyleVar();
  mark(desk, "tool.flock");
  tip("Clicks add to " + scenario.flocks[*chosen].name + "; press for the next flock");
  if (is_pressed) desk.tools.choose_next(scenario);
}

void show_legend_button(Desk& desk) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const bool is_pressed = ImGui::Button("?##legend", slot_size(desk));
  ImGui::PopStyleVar();
  mark(desk, "tool.legend");
  tip("What the tools are called");
  if (!is_pressed) return;
  const bool is_shown = shows_legend(desk);
  desk.open.legend = !is_shown;
  desk.open.legend_anyway = !is_shown;
}

// A line of the legend: colour, key and name.
bool show_entry(Desk& desk, const ToolInfo& info, bool is_chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size / 2, at.y + size / 2}, size * 0.3f,
                                              packed(colour_on(desk.view.theme, info.colour)));
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  ImGui::Text("%c", info.key);
  ImGui::SameLine(size * 3.6f);
  const bool is_pressed = ImGui::Selectable(info.name, is_chosen);
  mark(desk, std::string("legend.") + info.name);
  tip(info.hint);
  return is_pressed;
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
  if (begin_panel("tools", desk.layout.tools, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4 * desk.text_scale, 4 * desk.text_scale});
    int slot = 0;
    for (const ToolInfo& info : tool_list()) {
      next_slot(desk, slot);
      if (show_tool(desk, info, desk.tools.tool == info.tool)) desk.tools.tool = info.tool;
    }
    next_slot(desk, slot);
    if (show_tool(desk, tracking_info(), desk.is_tracking)) desk.wants_tracking = true;
    next_slot(desk, slot);
    show_count(desk);
    show_flock(desk, slot);
    next_slot(desk, slot);
    show_legend_button(desk);
    ImGui::PopStyleVar();
  }
  end_panel();
}

// Where it would hide half of the world it comes only when it is asked for.
bool shows_legend(const Desk& desk) {
  const Box free = free_area(desk);
  const float width = 16 * ImGui::GetFontSize(), lines = static_cast<float>(tool_list().size() + 3);
  const bool has_room =
      width < 0.5f * free.width && lines * ImGui::GetTextLineHeightWithSpacing() < free.height;
  return desk.open.legend && (has_room || desk.open.legend_anyway);
}

void show_legend(Desk& desk) {
  if (!shows_legend(desk)) return;
  const Box& beside = desk.layout.inspector;
  ImGui::SetNextWindowPos({beside.x - 8, beside.y}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {1e4f, free_area(desk).height});
  ImGui::Begin("legend", nullptr, floating);
  for (const ToolInfo& info : tool_list()) {
    if (show_entry(desk, info, desk.tools.tool == info.tool)) desk.tools.tool = info.tool;
  }
  if (show_entry(desk, tracking_info(), desk.is_tracking)) desk.wants_tracking = true;
  if (ImGui::Selectable("\u00d7 fold away", false)) desk.open.legend = false;
  mark(desk, "legend.fold");
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  desk.items["legend"] = {at.x, at.y, size.x, size.y};
  ImGui::End();
}

void show_help(Desk& desk) {
  if (!desk.open.help) return;
  const Box& world = desk.layout.world;
  ImGui::SetNextWindowPos({world.x + world.width / 2, world.y + world.height / 2}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {world.width - 16, world.height - 16});
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::Begin("help", nullptr, floating & ~ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted("Keys");
  ImGui::SameLine(ImGui::GetFontSize() * 12);
  if (button(desk, "help.close", "close", "")) desk.open.help = false;
  ImGui::Separator();
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const auto& [key, meaning] : keys) show_key(key, meaning);
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace studio
