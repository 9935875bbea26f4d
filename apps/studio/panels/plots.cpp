// Small plots on ImGui's draw list.
#include "panels/plots.h"

#include <sturnus/files.h>
#include <sturnus/render.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "panels/inspector.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "view/colours.h"

namespace studio {
namespace {

struct Curve {
  std::string name;
  sturnus::Rgba colour;
  std::function<double(const PlotLine&)> value;
};

struct Plot {
  std::string name, title, unit;
  double low = std::numeric_limits<double>::quiet_NaN(), high = low;  // where known
  std::vector<Curve> curves;
};

std::vector<Plot> all_plots(const Desk& desk) {
  std::vector<Plot> plots;
  const sturnus::Rgba accent = palette(desk.view.theme).accent;
  for (const sturnus::MeasureColumn& column : sturnus::measure_columns()) {
    if (std::string_view(column.name) == "boids") continue;
    const auto value = [read = column.value](const PlotLine& line) { return read(line.sample.measures); };
    plots.push_back({column.name, column.title, column.unit, column.low, column.high, {{"", accent, value}}});
  }
  Plot population{"population", "Population", "units", 0, std::numeric_limits<double>::quiet_NaN(), {}};
  const auto& flocks = desk.scenario().flocks;
  for (std::size_t i = 0; i < flocks.size(); ++i) {
    population.curves.push_back(
        {flocks[i].name, flock_colour(desk.scenario(), i, desk.view.theme),
         [i](const PlotLine& line) { return static_cast<double>(line.sample.population[i]); }});
  }
  plots.push_back(std::move(population));
  Plot times{"times", "Times", "ms", 0, std::numeric_limits<double>::quiet_NaN(), {}};
  times.curves.push_back(
      {"step", accent, [](const PlotLine& line) { return line.sample.step_seconds * 1e3; }});
  times.curves.push_back({"frame", palette(desk.view.theme).problem,
                          [](const PlotLine& line) { return line.frame_seconds * 1e3; }});
  plots.push_back(std::move(times));
  return plots;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return std::isnan(value) ? "\u00b7" : text;
}

// The part of the window that a plot's lines fill, and what it stands for.
struct Area {
  ImVec2 low, high;
  double first, last, least, most;

  ImVec2 place(double step, double value) const {
    const double x = last > first ? (step - first) / (last - first) : 0;
    const double y = most > least ? (value - least) / (most - least) : 0.5;
    return {low.x + static_cast<float>(x) * (high.x - low.x),
            high.y - static_cast<float>(std::clamp(y, 0.0, 1.0)) * (high.y - low.y)};
  }
};

void find_range(const Plot& plot, const std::vector<PlotLine>& lines, Area& area) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Curve& curve : plot.curves) {
    for (const PlotLine& line : lines) {
      const double value = curve.value(line);
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  if (!std::isnan(plot.low)) least = std::min(least, plot.low);
  if (!std::isnan(plot.high)) most = std::max(most, plot.high);
  if (!(least <= most)) least = 0, most = 1;
  const double room = (most - least) * 0.05;
  area.least = std::isnan(plot.low) ? least - room : least;
  area.most = std::isnan(plot.high) ? most + room : most;
}

// No more corners than the plot has points across.
void draw_curve(const Curve& curve, const std::vector<PlotLine>& lines, const Area& area, ImDrawList& list) {
  const auto width = static_cast<std::size_t>(std::max(2.0f, area.high.x - area.low.x));
  const std::size_t stride = std::max<std::size_t>(1, (lines.size() + width - 1) / width);
  std::vector<ImVec2> corners;
  const auto draw = [&] {
    list.AddPolyline(corners.data(), static_cast<int>(corners.size()), packed(curve.colour), 0, 1.5f);
    corners.clear();
  };
  for (std::size_t i = 0; i < lines.size(); i += stride) {
    const std::size_t at = i + stride >= lines.size() ? lines.size() - 1 : i;
    const double value = curve.value(lines[at]);
    if (!std::isfinite(value)) {
      draw();
    } else {
      corners.push_back(area.place(static_cast<double>(lines[at].sample.measures.step), value));
    }
  }
  draw();
}

void show_values(const Plot& plot, const PlotLine& line) {
  ImGui::BeginTooltip();
  ImGui::Text("step %llu", static_cast<unsigned long long>(line.sample.measures.step));
  for (const Curve& curve : plot.curves) {
    const std::string text =
        (curve.name.empty() ? plot.title : curve.name) + "  " + number(curve.value(line)) + " " + plot.unit;
    if (plot.curves.size() > 1) ImGui::PushStyleColor(ImGuiCol_Text, packed(curve.colour));
    ImGui::TextUnformatted(text.c_str());
    if (plot.curves.size() > 1) ImGui::PopStyleColor();
  }
  ImGui::EndTooltip();
}

void show_hovered(const Plot& plot, const std::vector<PlotLine>& lines, const Area& area, ImDrawList& list) {
  const float part = (ImGui::GetIO().MousePos.x - area.low.x) / std::max(1.0f, area.high.x - area.low.x);
  const double step = area.first + static_cast<double>(part) * (area.last - area.first);
  const auto nearest =
      std::min_element(lines.begin(), lines.end(), [&](const PlotLine& a, const PlotLine& b) {
        return std::abs(static_cast<double>(a.sample.measures.step) - step) <
               std::abs(static_cast<double>(b.sample.measures.step) - step);
      });
  const auto at = static_cast<double>(nearest->sample.measures.step);
  const float x = area.place(at, 0).x;
  list.AddLine({x, area.low.y}, {x, area.high.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  for (const Curve& curve : plot.curves) {
    if (const double value = curve.value(*nearest); std::isfinite(value))
      list.AddCircleFilled(area.place(at, value), 3, packed(curve.colour));
  }
  show_values(plot, *nearest);
}

// The names of a plot's curves with what they are now, each in its colour, as far as there is room; the
// tooltip has all. Returns how wide that is.
float show_names(const Plot& plot, const PlotLine& line, ImVec2 right_top, float room, ImDrawList& list) {
  float x = right_top.x;
  for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
    const bool is_alone = plot.curves.size() == 1;
    const std::string text = (is_alone ? "" : curve->name + " ") + number(curve->value(line));
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (right_top.x - x + width > room) break;
    x -= width;
    list.AddText({x, right_top.y}, is_alone ? ImGui::GetColorU32(ImGuiCol_Text) : packed(curve->colour),
                 text.c_str());
    x -= ImGui::GetFontSize() * 0.6f;
  }
  return right_top.x - x;
}

// The title and the names above the curves; returns how high they are.
float show_plot_head(const Plot& plot, const PlotLine& line, ImVec2 at, float width, ImDrawList& list) {
  const float text = ImGui::GetTextLineHeight();
  const bool has_row = plot.curves.size() > 1;  // several names have a row of their own
  const float title = ImGui::CalcTextSize(plot.title.c_str()).x;
  const float least = has_row ? width : 0.45f * width;
  const float names = show_names(plot, line, {at.x + width, has_row ? at.y + text : at.y},
                                 std::max(least, width - title - ImGui::GetFontSize()), list);
  list.AddText(at, ImGui::GetColorU32(ImGuiCol_TextDisabled),
               shortened(plot.title, has_row ? width : width - names).c_str());
  return has_row ? 2 * text : text;
}

void show_plot(Desk& desk, const Plot& plot, ImVec2 size) {
  const std::vector<PlotLine>& lines = desk.plots.lines;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float inset = 8;
  ImGui::InvisibleButton(plot.name.c_str(), size);
  mark(desk, "plot." + plot.name);
  const bool is_hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.45f), 6);
  if (lines.empty()) return;
  const float head = show_plot_head(plot, lines.back(), {at.x + inset, at.y + 4}, size.x - 2 * inset, list);
  Area area{{at.x + inset, at.y + head + inset},
            {at.x + size.x - inset, at.y + size.y - inset},
            static_cast<double>(lines.front().sample.measures.step),
            static_cast<double>(lines.back().sample.measures.step),
            0,
            1};
  find_range(plot, lines, area);
  list.AddLine({area.low.x, area.high.y}, area.high, ImGui::GetColorU32(ImGuiCol_Border));
  for (const Curve& curve : plot.curves) draw_curve(curve, lines, area, list);
  const float now_x =
      area.place(std::clamp(static_cast<double>(desk.frame->step), area.first, area.last), 0).x;
  list.AddLine({now_x, area.low.y}, {now_x, area.high.y}, ImGui::GetColorU32(ImGuiCol_Border));
  if (is_hovered) show_hovered(plot, lines, area, list);
}

void save_csv(Desk& desk) {
  const std::string name = new_name(desk, "-measures.csv");
  const sturnus::Status status = sturnus::write_text(name, plots_csv(desk.plots, desk.scenario()));
  desk.say(status ? "The measures are in " + name + "." : status.error(), !status);
}

void save_plot(Desk& desk) {
  std::vector<sturnus::Measures> rows;
  for (const PlotLine& line : desk.plots.lines) rows.push_back(line.sample.measures);
  const std::string name = new_name(desk, "-measures.png");
  const sturnus::Image image = sturnus::plot_measures(rows, desk.scenario(), desk.view.theme);
  const sturnus::Status status = sturnus::save_picture(name, image);
  desk.say(status ? "The plots are in " + name + "." : status.error(), !status);
}

}  // namespace

void show_plot_files(Desk& desk) {
  if (button(desk, "plots.csv", "CSV", "Save all measures as a table in the current folder")) save_csv(desk);
  ImGui::SameLine(0, 4);
  if (button(desk, "plots.png", "PNG", "Save all measures as a picture in the current folder"))
    save_plot(desk);
}

void show_plot_chips(Desk& desk, bool is_short) {
  if (button(desk, "plots.choose", "plots \u25be", "Which plots are shown")) ImGui::OpenPopup("choose plots");
  if (ImGui::BeginPopup("choose plots")) {
    for (const Plot& plot : all_plots(desk)) {
      bool on = desk.plots.shown.contains(plot.name);
      if (toggle(desk, "plots." + plot.name, plot.title.c_str(), on, "")) {
        if (on) desk.plots.shown.insert(plot.name);
        if (!on) desk.plots.shown.erase(plot.name);
      }
    }
    if (is_short) show_plot_files(desk);
    end_popup();
  }
  if (is_short) return;
  ImGui::SameLine(0, 4);
  show_plot_files(desk);
}

// Where all do not fit beside each other, the row scrolls.
void show_plots(Desk& desk) {
  std::vector<Plot> plots = all_plots(desk);
  std::erase_if(plots, [&](const Plot& plot) { return !desk.plots.shown.contains(plot.name); });
  if (plots.empty()) return faint("Choose plots at the right end of the timeline.");
  const float gap = 8, least = ImGui::GetFontSize() * 8;
  const auto count = static_cast<float>(plots.size());
  const float width = std::max(least, (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count);
  if (ImGui::BeginChild("plots", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar)) {
    const float height = ImGui::GetContentRegionAvail().y;
    for (std::size_t i = 0; i < plots.size(); ++i) {
      if (i > 0) ImGui::SameLine(0, gap);
      show_plot(desk, plots[i], {std::floor(width), std::max(24.0f, height)});
    }
  }
  ImGui::EndChild();
}

}  // namespace studio
