// Pictures of a running flock: scene, viewpoint and theme brought together.
#include <sturnus/render.h>

#include <algorithm>

#include "draw/draw.h"
#include "draw/plot.h"
#include "draw/sheet.h"
#include "observe/scene.h"
#include "observe/vectors.h"

namespace sturnus {
namespace {

SceneColours scene_colours(const Theme& theme) {
  const auto& flocks = theme.flocks;
  SceneColours out = {theme.flocks,    theme.outline,   theme.surface,  theme.text,
                      theme.attractor, theme.attractor, theme.predator, theme.obstacle};
  out.terms = {theme.predator, flocks[0], flocks[2], flocks[3], flocks[1], flocks[4], flocks[5]};
  out.food = theme.food;
  out.full = theme.full_hunter;
  out.starved = theme.starved;
  out.ready = theme.ready_tail;
  out.tired = theme.tired_tail;
  return out;
}

Vec<3> vec_of(const Coordinates& at, const Vec<3>& otherwise) {
  Vec<3> out = otherwise;
  for (std::size_t axis = 0; axis < at.size(); ++axis)
    out[static_cast<int>(axis)] = static_cast<float>(at[axis]);
  return out;
}

// Of the longest arrow: a good part of the picture, whatever the numbers.
float arrow_length(const Framing& frame, int dimensions, bool is_near) {
  float side = frame.high[0] - frame.low[0];
  for (int axis = 1; axis < dimensions; ++axis) side = std::min(side, frame.high[axis] - frame.low[axis]);
  return (is_near ? 0.3f : 0.2f) * side;
}

// `is_near`: the frame is what one boid sees, and not for the scenario's camera to choose.
Viewpoint viewpoint_of(const View& view, const Framing& frame, Size size, bool is_near) {
  const CameraDef& camera = view.scenario().camera;
  if (view.dimensions() == 2) return flat_view(frame.low, frame.high);
  const auto field_of_view = static_cast<float>(camera.field_of_view);
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  Viewpoint fitted = three_quarter_view(frame.low, frame.high, aspect, field_of_view);
  if (is_near || (camera.eye.empty() && camera.target.empty())) return fitted;
  const Vec<3> target = vec_of(camera.target, fitted.target);
  Viewpoint given = look_at(vec_of(camera.eye, fitted.eye), target, fitted.up, field_of_view);
  const float middle = length(target - given.eye);
  const float half = 0.5f * length(frame.high - frame.low);
  given.fade_from = middle > half ? middle - 0.5f * half : 0;
  given.fade_to = middle + 1.5f * half;
  return given;
}

}  // namespace

struct Renderer::Parts {
  RenderOptions options;
  Workers workers;
  Trails trails;
  DrawList list;
  std::optional<std::uint64_t> explained = {};  ///< the boid whose vectors are drawn

  std::optional<Explanation> explain(const Simulation& simulation);
};

// Whoever was looked at first is looked at as long as it lives.
std::optional<Explanation> Renderer::Parts::explain(const Simulation& simulation) {
  if (!options.vectors) return {};
  if (options.boid) explained = options.boid;
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (!explained) explained = boid_in_the_middle(simulation.view());
    if (!explained) return {};
    if (auto told = simulation.explain(*explained)) return std::move(*told);
    if (options.boid) return {};
    explained.reset();
  }
  return {};
}

Renderer::Renderer(const RenderOptions& options)
    : parts_(std::make_unique<Parts>(Parts{options, Workers(options.threads), {}, {}})) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::follow(const Simulation& simulation) {
  if (parts_->options.trails) parts_->trails.follow(simulation.view());
}

Image Renderer::frame(const Simulation& simulation) {
  const RenderOptions& options = parts_->options;
  const View view = simulation.view();
  const Theme& colours = theme(options.picture.theme);
  const SceneColours of_scene = scene_colours(colours);
  DrawList& list = parts_->list;
  list.clear();
  SceneOptions scene{options.velocities, options.caption, {}, {}};
  const std::optional<Explanation> told = parts_->explain(simulation);
  Framing frame = framing_of(view);
  const std::optional<Framing> near = told && options.zoom ? framing_of(*told) : std::nullopt;
  if (near) frame = *near;
  // In space those who are nearer to the eye would hide what there is to see.
  const bool is_cleared = near && view.dimensions() == 3;
  if (told) scene.boid_colours = vector_colours(view, *told, of_scene, is_cleared ? near : std::nullopt);
  if (options.index) scene.index_boxes = simulation.index_boxes();
  if (options.trails) parts_->trails.add_to(view, of_scene, list);
  make_scene(view, of_scene, scene, list);
  if (told)
    add_vectors(view, *told, of_scene, arrow_length(frame, view.dimensions(), near.has_value()), list);
  if (told && !near) add_halo(view, *told, of_scene, list);
  if (told && options.caption) add_legend(*told, of_scene, list);
  return draw(list, viewpoint_of(view, frame, options.picture.size, near.has_value()), colours,
              options.picture.size, parts_->workers, options.picture.supersampling);
}

namespace {

// Polarisation and milling share a panel: a flock trades one for the other.
void add_panel(const MeasureColumn& column, const std::vector<Measures>& rows, Plot& plot) {
  PlotLine line{column.title, {}};
  for (const Measures& row : rows) line.values.push_back(column.value(row));
  const std::string_view name = column.name;
  if (name == "boids") return;
  if (name == "milling") {
    plot.panels.back().title = "Order";
    plot.panels.back().lines.push_back(std::move(line));
    return;
  }
  plot.panels.push_back({column.title, column.unit, {std::move(line)}, column.low, column.high});
}

// One line for each flock; no panel where nobody comes or goes.
void add_populations(const ScenarioDef& scenario, const std::vector<Measures>& rows, Plot& plot) {
  const auto is_as_first = [&](const Measures& row) { return row.populations == rows.front().populations; };
  if (std::all_of(rows.begin(), rows.end(), is_as_first)) return;
  PlotPanel panel{"Population", "", {}, 0};
  for (std::size_t flock = 0; flock < scenario.flocks.size(); ++flock) {
    PlotLine line{scenario.flocks[flock].name, {}};
    for (const Measures& row : rows) line.values.push_back(static_cast<double>(row.populations[flock]));
    panel.lines.push_back(std::move(line));
  }
  plot.panels.push_back(std::move(panel));
}

// Measures have a title, a unit and a range; what else a sweep tells has its name.
PlotPanel empty_panel(const std::string& measure) {
  for (const MeasureColumn& column : measure_columns()) {
    if (column.name == measure) return {column.title, column.unit, {}, 0, column.high};
  }
  return {measure, measure == "captures" ? "per hunter and time" : "", {}, 0};
}

}  // namespace

Image plot_measures(const std::vector<Measures>& rows, const ScenarioDef& scenario, ThemeName theme_name,
                    int width) {
  Plot plot;
  plot.title = scenario.title.empty() ? scenario.name : scenario.title;
  for (const Measures& row : rows) plot.x.push_back(static_cast<double>(row.step));
  add_populations(scenario, rows, plot);
  for (const MeasureColumn& column : measure_columns()) add_panel(column, rows, plot);
  return draw_plot(plot, theme(theme_name), plot_size(plot, width), Workers(0));
}

Image plot_sweep(const SweepPlot& sweep, ThemeName theme_name, int width) {
  Plot plot;
  plot.title = sweep.title.empty() ? sweep.parameter : sweep.title + " · " + sweep.parameter;
  plot.x_title = "";
  plot.x = sweep.values;
  for (const SweepPlot::Panel& panel : sweep.panels) {
    PlotPanel drawn = empty_panel(panel.measure);
    for (const SweepPlot::Curve& curve : panel.curves) drawn.lines.push_back({curve.name, curve.results});
    plot.panels.push_back(std::move(drawn));
  }
  Size size = plot_size(plot, width);
  size.height = std::min(size.height + 130 * static_cast<int>(plot.panels.size()), max_picture_side);
  return draw_plot(plot, theme(theme_name), size, Workers(0));
}

Image picture_sheet(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns,
                    ThemeName theme_name) {
  return contact_sheet(pictures, captions, columns, theme(theme_name), Workers(0));
}

}  // namespace sturnus
