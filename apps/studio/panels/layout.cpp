// Panels float at the window's edges; the world lies below all of them.
#include "panels/layout.h"

#include <algorithm>

namespace studio {
namespace {

constexpr float gap = 8;
// Points at the usual size of text. The tools stand in as many columns as it takes to show them all, so that
// nothing has to scroll.
constexpr float bar_height = 44, tool_width = 28, least_tool_height = 22, tool_gap = 4, tool_inset = 12;
constexpr float plots_height = 190, least_plots_height = 114;
constexpr int tool_slots = 14;  // ten tools, tracking, units a click, their flock, the legend
constexpr int most_tool_columns = 4;

float height_of_bottom(const Desk& desk, float height) {
  const float scale = desk.text_scale;
  if (!desk.open.bottom) return bar_height * scale;
  return std::min(plots_height * scale, std::max(0.28f * height, least_plots_height * scale));
}

void lay_out_tools(Layout& layout, float scale) {
  const float room = layout.tools.height - 2 * gap * scale;
  int rows = tool_slots;
  layout.tool_columns = 1;
  while (static_cast<float>(rows) * (least_tool_height + tool_gap) * scale > room &&
         layout.tool_columns < most_tool_columns) {
    ++layout.tool_columns;
    rows = (tool_slots + layout.tool_columns - 1) / layout.tool_columns;
  }
  layout.tool_height = std::clamp(room / static_cast<float>(rows) - tool_gap * scale,
                                  least_tool_height * scale, tool_width * scale);
  const auto columns = static_cast<float>(layout.tool_columns);
  layout.tools.width = (columns * tool_width + (columns - 1) * tool_gap + 2 * tool_inset) * scale;
}

}  // namespace

Layout lay_out(const Desk& desk, sturnus::Size points) {
  const float scale = desk.text_scale;
  const auto width = static_cast<float>(points.width), height = static_cast<float>(points.height);
  const float bar = bar_height * scale;
  const float right = desk.open.inspector ? std::min(320 * scale, width * 0.42f) : bar;
  const float low = height_of_bottom(desk, height);
  Layout layout;
  layout.top = {gap, gap, width - 2 * gap, bar};
  const float top = bar + 2 * gap, inner = std::max(bar, height - top - low - 2 * gap);
  layout.tools = {gap, top, 0, inner};
  lay_out_tools(layout, scale);
  layout.inspector = {width - right - gap, top, right, desk.open.inspector ? inner : bar};
  layout.bottom = {gap, height - low - gap, width - 2 * gap, low};
  layout.world = {0, 0, width, height};
  return layout;
}

Box free_area(const Desk& desk) {
  const Layout& layout = desk.layout;
  const float left = layout.tools.x + layout.tools.width + gap, top = layout.tools.y;
  return {left, top, layout.inspector.x - gap - left, layout.bottom.y - gap - top};
}

}  // namespace studio
