// Panels float at the window's edges; the world lies below all of them.
#include "panels/layout.h"

#include <algorithm>

namespace studio {

Layout lay_out(const Desk& desk, sturnus::Size points) {
  const float scale = desk.text_scale, gap = 8;
  const auto width = static_cast<float>(points.width), height = static_cast<float>(points.height);
  const float bar = 44 * scale, column = 52 * scale;
  const float right = desk.open.inspector ? std::min(320 * scale, width * 0.45f) : 44 * scale;
  const float low = desk.open.bottom ? std::min(190 * scale, height * 0.4f) : 44 * scale;
  Layout layout;
  layout.top = {gap, gap, width - 2 * gap, bar};
  const float top = bar + 2 * gap, inner = height - top - low - 2 * gap;
  layout.tools = {gap, top, column, inner};
  layout.inspector = {width - right - gap, top, right, desk.open.inspector ? inner : bar};
  layout.bottom = {gap, height - low - gap, width - 2 * gap, low};
  layout.world = {0, 0, width, height};
  return layout;
}

}  // namespace studio
