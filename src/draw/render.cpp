// Pictures of a running flock: scene, viewpoint and theme brought together.
#include <sturnus/render.h>

#include <algorithm>

#include "draw/draw.h"
#include "draw/plot.h"
#include "draw/sheet.h"
#include "observe/scene.h"

namespace sturnus {
namespace {

SceneColours scene_colours(const Theme& theme) {
  return {theme.flocks,      theme.outline,   theme.surface,    theme.text,
          theme.attractor,   theme.attractor, theme.predator,   theme.food,
          theme.full_hunter, theme.starved,   theme.ready_tail, theme.tired_tail};
}

Vec<3> vec_of(const Coordinates& at, const Vec<3>& otherwise) {
  Vec<3> out = otherwise;
  for (std::size_t axis = 0; axis < at.size(); ++axis)
    out[static_cast<int>(axis)] = static_cast<float>(at[axis]);
  return out;
}

Viewpoint viewpoint_of(const View& view, Size size) {
  const CameraDef& camera = view.scenario().camera;
  const Framing frame = framing_of(view);
  if (view.dimensions() == 2) return flat_view(frame.low, frame.high);
  const auto field_of_view = static_cast<float>(camera.field_of_view);
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  Viewpoint fitted = three_quarter_view(frame.low, frame.high, aspect, field_of_view);
  if (camera.eye.empty() && camera.target.empty()) return fitted;
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
};

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
  parts_->list.clear();
  SceneOptions scene{options.velocities, options.caption, {}};
  if (options.index) scene.index_boxes = simulation.index_boxes();
  if (options.trails) parts_->trails.add_to(view, scene_colours(colours), parts_->list);
  make_scene(view, scene_colours(colours), scene, parts_->list);
  return draw(parts_->list, viewpoint_of(view, options.picture.size), colours, options.picture.size,
              parts_->workers, options.picture.supersampling);
}

namespace {

// Polarisation and milling share a panel: a flock trades one for the other. A population that never changes
// has none.
void add_panel(const MeasureColumn& column, const std::vector<Measures>& rows, Plot& plot) {
  PlotLine line{column.title, {}};
  for (const Measures& row : rows) line.values.push_back(column.value(row));
  const std::string_view name = column.name;
  const auto is_first = [&](double value) { return value == line.values.front(); };
  if (name == "boids" && std::all_of(line.values.begin(), line.values.end(), is_first)) return;
  if (name == "milling") {
    plot.panels.back().title = "Order";
    plot.panels.back().lines.push_back(std::move(line));
    return;
  }
  plot.panels.push_back({column.title, column.unit, {std::move(line)}, column.low, column.high});
}

}  // namespace

Image plot_measures(const std::vector<Measures>& rows, const std::string& title, ThemeName theme_name,
                    int width) {
  Plot plot;
  plot.title = title;
  for (const Measures& row : rows) plot.x.push_back(static_cast<double>(row.step));
  for (const MeasureColumn& column : measure_columns()) add_panel(column, rows, plot);
  return draw_plot(plot, theme(theme_name), plot_size(plot, width), Workers(0));
}

Image picture_sheet(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns,
                    ThemeName theme_name) {
  return contact_sheet(pictures, captions, columns, theme(theme_name), Workers(0));
}

}  // namespace sturnus
