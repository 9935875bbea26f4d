// The order of drawing, and what it takes.
#include "view/view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "view/boids.h"
#include "view/scenery.h"
#include "view/smoothing.h"

namespace studio {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& nanoseconds) : out_(nanoseconds) {}
  ~Stopwatch() {
    out_ = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double& out_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void clear(const Camera& camera, sturnus::Rgba ground) {
  glViewport(0, 0, camera.pixels().width, camera.pixels().height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glClearColor(static_cast<float>(ground.r) / 255, static_cast<float>(ground.g) / 255,
               static_cast<float>(ground.b) / 255, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_LEQUAL);
}

// Depth is looked at in space, and written by what is solid.
void use_depth(bool look, bool write) {
  look ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
  glDepthMask(write ? GL_TRUE : GL_FALSE);
}

}  // namespace

struct View::Parts {
  Boids boids;
  Scenery scenery;
  gl::Owned<gl::delete_vertex_array> nothing = gl::vertex_array();
  Smoothing smoothing = {};
  Past past = {};
  Layer layer = {};
  ViewTimes times = {};
  std::uint64_t serial = 0;

  template <class Add>
  void draw_layer(const Lens& lens, const Add& add) {
    layer.clear();
    add(layer);
    scenery.draw(layer, lens);
  }
  void draw_flat(const Frame& frame, const Lens& lens, const ViewOptions& options, const Moment& moment);
  void draw_space(const Frame& frame, const Lens& lens, const ViewOptions& options, const Moment& moment);
};

void View::Parts::draw_flat(const Frame& frame, const Lens& lens, const ViewOptions& options,
                            const Moment& moment) {
  use_depth(false, true);
  draw_layer(lens, [&](Layer& out) { add_ground(frame, *lens.colours, options, out); });
  draw_layer(lens, [&](Layer& out) { add_obstacles(frame, *lens.colours, out); });
  if (options.trails) boids.draw_trails(past, frame, lens, options, moment);
  draw_layer(lens, [&](Layer& out) { add_food(frame, *lens.colours, out); });
  boids.draw(past, frame, lens, options, moment);
}

// Lines do not hide, so in space they come after what hides them.
void View::Parts::draw_space(const Frame& frame, const Lens& lens, const ViewOptions& options,
                             const Moment& moment) {
  use_depth(true, true);
  Layer obstacles;
  add_obstacles(frame, *lens.colours, obstacles);
  const std::vector<Line> lattices = std::exchange(obstacles.lines, {});
  scenery.draw(obstacles, lens);
  draw_layer(lens, [&](Layer& out) { add_food(frame, *lens.colours, out); });
  boids.draw(past, frame, lens, options, moment);
  use_depth(true, false);
  draw_layer(lens, [&](Layer& out) {
    add_ground(frame, *lens.colours, options, out);
    out.lines.insert(out.lines.end(), lattices.begin(), lattices.end());
  });
  if (options.trails) boids.draw_trails(past, frame, lens, options, moment);
}

View::View(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
View::~View() = default;
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;

sturnus::Result<View> View::create() {
  auto boids = Boids::create();
  if (!boids) return boids.problems();
  auto scenery = Scenery::create();
  if (!scenery) return scenery.problems();
  return View(std::make_unique<Parts>(Parts{std::move(*boids), std::move(*scenery)}));
}

void View::upload(const Frame& frame) {
  if (frame.serial != 0 && frame.serial == parts_->serial) return;
  const Stopwatch watch(parts_->times.upload);
  parts_->past.take(frame);
  parts_->serial = frame.serial;
}

void View::draw(const Frame& frame, const Camera& camera, const ViewOptions& options, const Moment& moment,
                const Shapes& shapes) {
  const Stopwatch watch(parts_->times.draw);
  const Colours& theme = colours(options.theme);
  const Lens lens{&camera, &theme, moment.scale, fade_of(camera, frame.extent)};
  parts_->smoothing.begin(camera.pixels(), options.smooth && has_rough_edges(frame, options.look));
  clear(camera, theme.background);
  glBindVertexArray(parts_->nothing.name());
  frame.dimensions == 2 ? parts_->draw_flat(frame, lens, options, moment)
                        : parts_->draw_space(frame, lens, options, moment);
  use_depth(false, true);
  parts_->draw_layer(lens, [&](Layer& out) { add_targets(frame, theme, options, out); });
  parts_->scenery.draw(shapes, lens);
  glBindVertexArray(0);
  parts_->smoothing.end();
}

ViewTimes View::times() const {
  return parts_->times;
}

sturnus::Image read_pixels(sturnus::Size size) {
  sturnus::Image image(size, {});
  sturnus::Image upside_down(size, {});
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.rgb.data());
  const auto row = static_cast<std::ptrdiff_t>(3 * image.width);
  for (int y = 0; y < image.height; ++y) {
    const auto from = upside_down.rgb.begin() + (image.height - 1 - y) * row;
    std::copy(from, from + row, image.rgb.begin() + y * row);
  }
  return image;
}

}  // namespace studio
