// Layout and drawing of plots.
#include "draw/plot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "draw/axis.h"
#include "draw/raster.h"

namespace sturnus {
namespace {

// Pixels.
constexpr float margin = 20;
constexpr float gap = 10;  // between panels
constexpr float title_size = 20;
constexpr float title_height = 38;
constexpr float header_size = 14;  // text in a panel's header
constexpr float header_height = 32;
constexpr float tick_size = 11.5f;
constexpr float x_axis_height = 40;
constexpr float line_width = 1.8f;
constexpr int samples = 3;

struct Frame {
  float left, top, right, bottom;  // pixels
  float width() const { return right - left; }
  float height() const { return bottom - top; }
};

// A panel's axis and the pixels it is drawn in.
struct Scales {
  Frame area;
  Axis x, y;
  float at_x(double value) const {
    return area.left + area.width() * static_cast<float>((value - x.low) / (x.high - x.low));
  }
  // Values beyond a fixed axis run along its edge rather than across the next panel.
  float at_y(double value) const {
    const double part = std::clamp((value - y.low) / (y.high - y.low), 0.0, 1.0);
    return area.bottom - area.height() * static_cast<float>(part);
  }
};

struct Point {
  float x, y;
};

// Cuts a text to a width, with an ellipsis where letters are lost.
std::string fitted(std::string text, float size, float width) {
  if (text_width(text, size) <= width) return text;
  while (!text.empty() && text_width(text + "…", size) > width) {
    do {
      const bool is_rest =
          (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80;  // of a letter of several bytes
      text.pop_back();
      if (!is_rest) break;
    } while (!text.empty());
  }
  return text.empty() ? text : text + "…";
}

double value_at(const PlotLine& line, std::size_t index) {
  return index < line.values.size() && std::isfinite(line.values[index])
             ? line.values[index]
             : std::numeric_limits<double>::quiet_NaN();
}

bool has_data(const Plot& plot, const PlotPanel& panel) {
  for (const PlotLine& line : panel.lines) {
    for (std::size_t i = 0; i < plot.x.size(); ++i) {
      if (!std::isnan(value_at(line, i))) return true;
    }
  }
  return false;
}

Axis y_axis(const Plot& plot, const PlotPanel& panel, int wanted_ticks) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlotLine& line : panel.lines) {
    for (std::size_t i = 0; i < plot.x.size(); ++i) {
      const double value = value_at(line, i);
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!(low <= high)) low = high = 0;
  const bool is_low_fixed = std::isfinite(panel.low);
  const bool is_high_fixed = std::isfinite(panel.high);
  // Zero belongs in the picture when the values come anywhere near it.
  if (low > 0 && low < 0.5 * high) low = 0;
  if (is_low_fixed) low = panel.low;
  if (is_high_fixed) high = panel.high;
  Axis axis = nice_axis(low, high, wanted_ticks, true);
  if (is_low_fixed && is_high_fixed && low < high) {
    axis.low = low;
    axis.high = high;
  }
  return axis;
}

Axis x_axis(const Plot& plot, float width) {
  double low = 0;
  double high = 0;
  bool any = false;
  for (const double x : plot.x) {
    if (!std::isfinite(x)) continue;
    low = any ? std::min(low, x) : x;
    high = any ? std::max(high, x) : x;
    any = true;
  }
  // A single step stands in the middle.
  if (!(high > low)) return {low - 0.5, high + 0.5, 1};
  return nice_axis(low, high, std::max(1, static_cast<int>(width / 110)), false);
}

// The points of one unbroken piece, at most four for each column of pixels: first, lowest, highest, last.
class Piece {
 public:
  void add(Point p) {
    if (!points_.empty() && std::floor(p.x) == column_) {
      ++count_;
      if (p.y < low_.y) low_ = p;
      if (p.y > high_.y) high_ = p;
      last_ = p;
      return;
    }
    end_column();
    column_ = std::floor(p.x);
    low_ = high_ = last_ = p;
    count_ = 1;
    points_.push_back(p);
  }

  const std::vector<Point>& finish() {
    end_column();
    return points_;
  }
  void clear() { *this = Piece(); }

 private:
  void end_column() {
    if (count_ > 3) {
      points_.push_back(low_);
      points_.push_back(high_);
    } else if (count_ == 3) {
      points_.push_back(low_.y != points_.back().y && low_.y != last_.y ? low_ : high_);
    }
    if (count_ > 1) points_.push_back(last_);
    count_ = 0;
  }

  std::vector<Point> points_;
  Point low_{}, high_{}, last_{};
  float column_ = 0;
  int count_ = 0;
};

// A faint ground under a line: one bar for each whole column of pixels, so that no two bars share one.
void add_ground(const std::vector<Point>& points, float bottom, Rgba colour, Canvas& canvas) {
  std::size_t i = 0;
  for (float x = std::ceil(points.front().x); x + 1 <= points.back().x; ++x) {
    while (i + 2 < points.size() && points[i + 1].x < x + 0.5f) ++i;
    const Point a = points[i];
    const Point b = points[i + 1];
    const float part = b.x > a.x ? std::clamp((x + 0.5f - a.x) / (b.x - a.x), 0.0f, 1.0f) : 0.5f;
    const float top = a.y + (b.y - a.y) * part;
    if (bottom - top > 0.5f) canvas.add(BarShape{x, top, x + 1, bottom, 0, colour});
  }
}

void add_piece(const std::vector<Point>& points, float bottom, bool with_ground, Rgba colour,
               Canvas& canvas) {
  if (points.empty()) return;
  if (with_ground) add_ground(points, bottom, with_alpha(colour, 0.10f), canvas);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    canvas.line(points[i].x, points[i].y, points[i + 1].x, points[i + 1].y, line_width, colour);
  }
  // A value between two gaps has no line: it gets a dot.
  if (points.size() == 1) canvas.add(DiscShape{{points[0].x, points[0].y, on_top}, 2.2f, -1, colour});
}

void add_line(const Plot& plot, const PlotLine& line, const Scales& scales, bool with_ground, Rgba colour,
              Canvas& canvas) {
  Piece piece;
  Point last{};
  bool any = false;
  for (std::size_t i = 0; i < plot.x.size(); ++i) {
    const double value = value_at(line, i);
    if (std::isnan(value) || !std::isfinite(plot.x[i])) {
      add_piece(piece.finish(), scales.area.bottom, with_ground, colour, canvas);
      piece.clear();
      continue;
    }
    last = {scales.at_x(plot.x[i]), scales.at_y(value)};
    any = true;
    piece.add(last);
  }
  add_piece(piece.finish(), scales.area.bottom, with_ground, colour, canvas);
  if (any) canvas.add(DiscShape{{last.x, last.y, on_top}, 3.2f, -1, colour});
}

std::string last_value(const Plot& plot, const PlotLine& line) {
  for (std::size_t i = std::min(plot.x.size(), line.values.size()); i-- > 0;) {
    if (std::isfinite(line.values[i])) return short_number(line.values[i]);
  }
  return "–";
}

// Names and last values from the right, as many as there is room for left of them.
void add_legend(const Plot& plot, const PlotPanel& panel, const Theme& theme, float left, float right,
                float y, Canvas& canvas) {
  const bool with_names = panel.lines.size() > 1;
  for (std::size_t i = panel.lines.size(); i-- > 0;) {
    const std::string value = last_value(plot, panel.lines[i]);
    const float value_width = text_width(value, header_size);
    const std::string name = with_names ? fitted(panel.lines[i].name, header_size, 160) : std::string();
    const float name_width = name.empty() ? 0 : text_width(name, header_size) + 22;
    if (right - value_width - name_width < left) return;
    canvas.text(value, right, y, header_size, theme.flock(i), Align::right);
    right -= value_width;
    if (!name.empty()) {
      canvas.text(name, right - 8, y, header_size, theme.faint_text, Align::right);
      canvas.add(DiscShape{{right - name_width, y, on_top}, 3.5f, -1, theme.flock(i)});
    }
    right -= name_width + 24;
  }
}

void add_header(const Plot& plot, const PlotPanel& panel, const Theme& theme, const Frame& card,
                Canvas& canvas) {
  const float y = card.top + 0.5f * header_height + 1;
  const float left = card.left + 14;
  const float right = card.right - 16;
  const std::string title = fitted(panel.title, header_size, 0.55f * (right - left));
  canvas.text(title, left, y, header_size, theme.text);
  float end = left + text_width(title, header_size) + 8;
  const std::string unit = fitted(panel.unit, tick_size, 0.15f * (right - left));
  canvas.text(unit, end, y, tick_size, theme.faint_text);
  end += text_width(unit, tick_size) + 20;
  add_legend(plot, panel, theme, end, right, y, canvas);
}

void add_grid(const Scales& scales, const Theme& theme, Canvas& canvas) {
  const Frame& area = scales.area;
  for (const double tick : scales.x.ticks()) {
    const float x = std::floor(scales.at_x(tick)) + 0.5f;
    canvas.line(x, area.top, x, area.bottom, 1, theme.grid);
  }
  for (const double tick : scales.y.ticks()) {
    const float y = std::floor(scales.at_y(tick)) + 0.5f;
    canvas.line(area.left, y, area.right, y, 1, theme.grid);
    canvas.text(scales.y.text(tick), area.left - 8, y, tick_size, theme.faint_text, Align::right);
  }
}

void add_x_labels(const Plot& plot, const Scales& scales, const Theme& theme, float y, Canvas& canvas) {
  // The name stands left of the numbers, in the gutter, where no number can meet it.
  canvas.text(fitted(plot.x_title, tick_size, scales.area.left - margin - 20), scales.area.left - 20, y,
              tick_size, theme.faint_text, Align::right);
  float free_from = 0;
  for (const double tick : scales.x.ticks()) {
    const std::string text = scales.x.text(tick);
    const float width = text_width(text, tick_size);
    const float x = std::min(scales.at_x(tick) - 0.5f * width, scales.area.right + margin - 4 - width);
    if (x < free_from) continue;
    canvas.text(text, x, y, tick_size, theme.faint_text);
    free_from = x + width + 12;
  }
}

void add_panel(const Plot& plot, const PlotPanel& panel, const Scales& scales, const Frame& card,
               const Theme& theme, Canvas& canvas) {
  canvas.add(BarShape{card.left, card.top, card.right, card.bottom, 6, theme.surface});
  add_header(plot, panel, theme, card, canvas);
  if (!has_data(plot, panel)) {
    canvas.text("no data", 0.5f * (scales.area.left + scales.area.right),
                0.5f * (scales.area.top + scales.area.bottom), header_size, theme.faint_text, Align::centre);
    return;
  }
  add_grid(scales, theme, canvas);
  for (std::size_t i = 0; i < panel.lines.size(); ++i) {
    add_line(plot, panel.lines[i], scales, panel.lines.size() == 1, theme.flock(i), canvas);
  }
}

float gutter_for(const std::vector<Axis>& axes) {
  float widest = 24;
  for (const Axis& axis : axes) {
    for (const double tick : axis.ticks()) widest = std::max(widest, text_width(axis.text(tick), tick_size));
  }
  return widest + 24;
}

}  // namespace

Size plot_size(const Plot& plot, int width) {
  const auto panels = static_cast<float>(std::max<std::size_t>(1, plot.panels.size()));
  const float top = plot.title.empty() ? margin : margin + title_height;
  const float height = top + panels * 148 + (panels - 1) * gap + x_axis_height;
  return {width, std::clamp(static_cast<int>(height), min_picture_side, max_picture_side)};
}

Image draw_plot(const Plot& plot, const Theme& theme, Size size, const Workers& workers) {
  Canvas canvas;
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  const float top = plot.title.empty() ? margin : margin + title_height;
  if (!plot.title.empty()) {
    canvas.text(fitted(plot.title, title_size, width - 2 * margin), margin, margin + 12, title_size,
                theme.text);
  }
  const auto count = static_cast<float>(std::max<std::size_t>(1, plot.panels.size()));
  const float card_height = std::max(20.0f, (height - top - x_axis_height - (count - 1) * gap) / count);
  const float area_height = std::max(4.0f, card_height - header_height - 12);
  const int wanted_ticks = std::clamp(static_cast<int>(area_height / 34), 1, 6);
  std::vector<Axis> axes;
  for (const PlotPanel& panel : plot.panels) axes.push_back(y_axis(plot, panel, wanted_ticks));
  const float left = margin + gutter_for(axes);
  const float right = width - margin - 16;
  const Axis shared = x_axis(plot, right - left);
  float y = top;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const Frame card{margin, y, width - margin, y + card_height};
    const Scales scales{{left, y + header_height, right, y + header_height + area_height}, shared, axes[i]};
    add_panel(plot, plot.panels[i], scales, card, theme, canvas);
    y += card_height + gap;
  }
  const Scales last{{left, 0, right, 1}, shared, {}};
  if (!plot.x.empty()) add_x_labels(plot, last, theme, y - gap + 0.45f * x_axis_height, canvas);
  return paint(canvas, size, theme.background, samples, workers);
}

}  // namespace sturnus
