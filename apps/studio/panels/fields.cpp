// Rows of the inspector.
#include "panels/fields.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels/style.h"
#include "panels/values.h"
#include "panels/widgets.h"

namespace studio {
namespace {

constexpr float name_share = 0.40f;  // of a row's width
constexpr float grab = 5;            // points; narrow, so that the number behind it can be read

bool slider(ImGuiDataType type, void* value, const void* low, const void* high, const char* format,
            ImGuiSliderFlags flags) {
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, grab);
  const bool changed = ImGui::SliderScalar("##value", type, value, low, high, format, flags);
  ImGui::PopStyleVar();
  return changed;
}

std::string readable(std::string_view key) {
  std::string text(key);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

double usual_of(const Desk& desk, const std::string& path, double now) {
  const auto found = desk.inspector.baseline.find(path);
  if (found == desk.inspector.baseline.end()) return now;
  const sturnus::Value value = sturnus::parse_value(found->second);
  const auto* number = std::get_if<double>(&value.held);
  return number == nullptr ? now : *number;
}

// The widget of each kind of value, beside the name. Places are taken just as `FieldRef` holds them: for
// anything else the general one, which shows text, fits better.
struct Widget {
  Desk& desk;
  const FieldPlace& where;
  std::string_view key;
  const sturnus::About& about;
  std::string path;

  void slide(double value, bool may_be_infinite) const {
    const Span span = span_of(key, about, usual_of(desk, path, value), value, where.side);
    const bool is_infinite = std::isinf(value);
    const float room =
        may_be_infinite ? ImGui::CalcTextSize("\u221e").x + 2 * ImGui::GetStyle().FramePadding.x + 4 : 0;
    double moved = is_infinite ? span.high : value;
    ImGui::SetNextItemWidth(-1 - room);
    const ImGuiSliderFlags flags = span.is_logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool changed =
        slider(ImGuiDataType_Double, &moved, &span.low, &span.high, is_infinite ? "no limit" : "%.4g", flags);
    begin_gesture(desk);
    mark(desk, "inspector." + path);
    tip(words_of(path, about));
    if (changed) set_value(desk, path, value, moved);
    if (may_be_infinite) show_infinity(is_infinite, span.high);
  }

  void show_infinity(bool is_infinite, double finite) const {
    ImGui::SameLine(0, 4);
    bool on = is_infinite;
    if (toggle(desk, "inspector." + path + ".infinite", "\u221e", on, "No limit"))
      desk.set(path, on ? "inf" : sturnus::number_text(finite), desk.next_gesture++);
  }

  void write(const std::string& text) const {
    char buffer[512];
    std::snprintf(buffer, sizeof buffer, "%s", text.c_str());
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint("##text", "by default", buffer, sizeof buffer,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    mark(desk, "inspector." + path);
    tip(words_of(path, about) + "\nEnter sets it.");
    if (entered && buffer != text && buffer[0] != '\0') desk.set(path, buffer, desk.next_gesture++);
  }

  void operator()(double* place) const { slide(*place, about.may_be_infinite); }
  void operator()(const sturnus::RingRef& place) const { slide(*place.outer, about.may_be_infinite); }
  void operator()(std::optional<double>* place) const {
    if (*place) return slide(**place, about.may_be_infinite);
    write("");
  }
  void operator()(std::int64_t* place) const {
    std::int64_t moved = *place;
    const auto usual = static_cast<double>(moved);
    const Span span = span_of(key, about, usual_of(desk, path, usual), usual, where.side);
    const auto low = static_cast<std::int64_t>(span.low),
               high = std::max(low + 4, static_cast<std::int64_t>(span.high));
    ImGui::SetNextItemWidth(-1);
    const bool changed = slider(ImGuiDataType_S64, &moved, &low, &high, "%lld", 0);
    begin_gesture(desk);
    mark(desk, "inspector." + path);
    tip(words_of(path, about));
    if (changed) desk.set(path, std::to_string(moved), desk.inspector.gesture);
  }
  void operator()(bool* place) const {
    if (dot_switch(desk, path, *place, packed(palette(desk.view.theme).accent)))
      desk.set(path, *place ? "false" : "true", desk.next_gesture++);
    tip(words_of(path, about));
  }
  void operator()(const sturnus::Choice& place) const {
    const auto now = static_cast<std::size_t>(place.get());
    ImGui::SetNextItemWidth(-1);
    const bool is_open = ImGui::BeginCombo("##choice", std::string(place.names[now]).c_str());
    if (!is_open) {
      mark(desk, "inspector." + path);
      tip(words_of(path, about));
      return;
    }
    for (std::size_t i = 0; i < place.names.size(); ++i) {
      const std::string name(place.names[i]);
      if (ImGui::Selectable(name.c_str(), i == now) && i != now)
        desk.set(path, to_text(sturnus::Value{name}), desk.next_gesture++);
      mark(desk, "inspector." + path + "." + name);
    }
    ImGui::EndCombo();
  }
  template <class Other>
  void operator()(const Other& place) const {
    write(text_of(place));
  }
};

}  // namespace

void begin_gesture(Desk& desk) {
  if (ImGui::IsItemActivated()) desk.inspector.gesture = desk.next_gesture++;
}

std::string words_of(const std::string& path, const sturnus::About& about) {
  std::string words = about.text;
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  if (*about.unit != '\0') words += std::string("\nUnit: ") + about.unit;
  if (*about.formula != '\0') words += std::string("\nFormula: ") + about.formula;
  if (*about.source != '\0') words += std::string("\nSource: ") + about.source;
  return words + "\n" + path;
}

bool dot_switch(Desk& desk, const std::string& path, bool is_on, ImU32 colour) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(path.c_str());
  const bool pressed = ImGui::InvisibleButton("dot", {side * 0.8f, side});
  ImGui::PopID();
  mark(desk, "inspector." + path);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 centre{at.x + side * 0.4f, at.y + side * 0.5f};
  const float radius = side * (ImGui::IsItemHovered() ? 0.26f : 0.22f);
  if (is_on) {
    list.AddCircleFilled(centre, radius, colour, 24);
  } else {
    list.AddCircle(centre, radius, ImGui::GetColorU32(ImGuiCol_TextDisabled), 24, 1.5f);
  }
  return pressed;
}

void reset_dot(Desk& desk, const std::string& path, const std::string& now) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto found = desk.inspector.baseline.find(path);
  if (found == desk.inspector.baseline.end() || found->second == now) {
    ImGui::Dummy({side * 0.5f, side});
    return;
  }
  ++desk.inspector.modified;
  ImGui::PushID(path.c_str());
  const bool pressed = ImGui::InvisibleButton("reset", {side * 0.5f, side});
  ImGui::PopID();
  mark(desk, "inspector." + path + ".reset");
  tip(found->second.empty()
          ? "Changed; the scenario gives no value to go back to. Undo takes the change back."
          : "Back to " + found->second + ", as the scenario has it");
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + side * 0.25f, at.y + side * 0.5f}, side * 0.13f,
                                              packed(palette(desk.view.theme).accent), 16);
  if (pressed && !found->second.empty()) desk.set(path, found->second, desk.next_gesture++);
}

void set_value(Desk& desk, const std::string& path, double before, double value) {
  const std::uint64_t gesture = desk.inspector.gesture;
  desk.set(path, sturnus::number_text(value), gesture);
  const std::size_t term = path.find('.', 6), end = path.rfind('.');
  if (!path.starts_with("flock.") || term == std::string::npos || path.substr(end) != ".radius") return;
  const std::string flock = path.substr(6, term - 6);
  if (!desk.inspector.linked.contains(flock) || !(before > 0) || !(value > 0)) return;
  const auto values = values_of(desk.scenario());
  for (const char* kind : {"separation", "alignment", "cohesion"})
    for (const std::string& other : paths_of_rows(values, flock, kind, "radius"))
      if (const auto text = scaled(values.at(other), value / before); text && other != path)
        desk.set(other, *text, gesture);
}

void show_field(Desk& desk, const FieldPlace& where, std::string_view key, const sturnus::FieldRef& place,
                const sturnus::About& about) {
  const std::string path = where.prefix + std::string(key);
  const std::string text = text_of(place);
  ImGui::PushID(path.c_str());
  reset_dot(desk, path, text);
  ImGui::SameLine(0, 0);
  ImGui::AlignTextToFramePadding();
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  faint(readable(key));
  tip(words_of(path, about));
  ImGui::SameLine(left + width * name_share);
  if (sturnus::is_fixed_while_running(path)) {
    ImGui::TextUnformatted(text.empty() ? "by default" : text.c_str());
    tip(words_of(path, about) + "\nIt can't change while the flock runs.");
  } else {
    std::visit(Widget{desk, where, key, about, path}, place);
  }
  ImGui::PopID();
}

}  // namespace studio
