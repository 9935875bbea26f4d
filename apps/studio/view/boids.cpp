// Boids: which mesh, what colour and size, and a draw for each kind of mesh in use.
#include "view/boids.h"

#include <algorithm>
#include <cmath>

#include "view/shaders.h"

namespace studio {
namespace {

constexpr std::size_t most_flocks = 64;
constexpr std::size_t simple_above = 20'000;   // boids
constexpr std::size_t points_above = 200'000;  // boids
constexpr GLuint boids_unit = 0, meshes_unit = 1;

Mesh simple(int dimensions) {
  return dimensions == 2 ? Mesh::triangle : Mesh::pyramid;
}

Mesh arrow(int dimensions) {
  return dimensions == 2 ? Mesh::dart : Mesh::cone;
}

Mesh glyph_of(const sturnus::FlockDef& flock, int dimensions) {
  if (!flock.glyph) return arrow(dimensions);
  if (*flock.glyph == sturnus::GlyphStyle::circle) return dimensions == 2 ? Mesh::disc : Mesh::ball;
  return arrow(dimensions);
}

// Drawn as a flat shape whose edge fades.
bool is_figure(Mesh mesh) {
  return mesh == Mesh::dart || mesh == Mesh::triangle || mesh == Mesh::disc || mesh == Mesh::ball ||
         mesh == Mesh::point;
}

// In the order of the flocks: in the plane, later ones lie above.
std::vector<Mesh> meshes_in_use(const Frame& frame, Look look) {
  std::vector<Mesh> out;
  for (const sturnus::FlockDef& flock : frame.scenario->flocks) {
    const Mesh mesh = mesh_of(flock, frame.dimensions, look, frame.boids.size());
    if (std::find(out.begin(), out.end(), mesh) == out.end()) out.push_back(mesh);
  }
  return out;
}

float finite(double value) {
  return std::isfinite(value) ? static_cast<float>(value) : 0.0f;
}

struct Styles {
  std::array<std::array<float, 4>, most_flocks> colour{}, form{};
};

Styles styles_of(const Frame& frame, const ViewOptions& options) {
  Styles out;
  const auto& flocks = frame.scenario->flocks;
  for (std::size_t i = 0; i < flocks.size() && i < most_flocks; ++i) {
    const sturnus::Rgba colour = flock_colour(*frame.scenario, i, options.theme);
    out.colour[i] = {static_cast<float>(colour.r) / 255, static_cast<float>(colour.g) / 255,
                     static_cast<float>(colour.b) / 255, finite(flocks[i].size)};
    const Mesh mesh = mesh_of(flocks[i], frame.dimensions, options.look, frame.boids.size());
    out.form[i] = {static_cast<float>(mesh), finite(flocks[i].min_speed), finite(flocks[i].max_speed),
                   flocks[i].jump ? 1.0f : 0.0f};
  }
  return out;
}

void set_styles(const gl::Program& program, const Frame& frame, const ViewOptions& options) {
  const Styles styles = styles_of(frame, options);
  glUniform4fv(program.at("flock_colour"), most_flocks, styles.colour[0].data());
  glUniform4fv(program.at("flock_form"), most_flocks, styles.form[0].data());
}

void set_boids(const gl::Program& program, const Frame& frame, const Lens& lens, const ViewOptions& options,
               const Moment& moment) {
  lens.use(program);
  set_styles(program, frame, options);
  const Colours& all = *lens.colours;
  set_colour(program, "full_colour", all.full);
  set_colour(program, "starved_colour", all.starved);
  set_colour(program, "ready_tail", all.ready_tail);
  set_colour(program, "tired_tail", all.tired_tail);
  set_colour(program, "quarantined_colour", all.quarantined);
  set_colour(program, "tracked_colour", all.tracked);
  glUniform1f(program.at("lightness"), options.theme == sturnus::ThemeName::light ? 0.62f : 0.74f);
  glUniform1f(program.at("part"), moment.part);
  glUniform1f(program.at("size"), options.size);
  glUniform1i(program.at("colour_by"), static_cast<GLint>(options.colour_by));
  glUniform1i(program.at("tracked"), moment.tracked ? static_cast<GLint>(*moment.tracked) : -1);
  glUniform1i(program.at("boids"), boids_unit);
}

}  // namespace

std::size_t steps_kept(std::size_t boids) {
  constexpr std::size_t bytes = std::size_t{64} << 20, most_steps = 60;
  return std::clamp<std::size_t>(bytes / (std::max<std::size_t>(1, boids) * sizeof(Instance)), 1, most_steps);
}

void Past::advance(std::size_t room) {
  if (steps_.size() != room) {
    steps_.clear();
    steps_.resize(room);
    newest_ = known_ = 0;
  }
  newest_ = known_ == 0 ? 0 : (newest_ + 1) % steps_.size();
  known_ = std::min(known_ + 1, steps_.size());
}

void Past::take(const Frame& frame) {
  // A little more room than needed, so that births don't change it every step.
  std::size_t room = steps_kept(frame.boids.size());
  if (room < steps_.size() && steps_kept(frame.boids.size() / 2) >= steps_.size()) room = steps_.size();
  if (room > steps_.size() && steps_kept(frame.boids.size() * 2) <= steps_.size() && !steps_.empty())
    room = steps_.size();
  const bool is_same = known_ > 0 && frame.generation == generation_;
  if (!is_same) known_ = 0;
  if (!is_same || frame.step != step_ || room != steps_.size()) advance(room);
  generation_ = frame.generation;
  step_ = frame.step;
  Step& step = steps_[newest_];
  step.boids = std::min(frame.boids.size(), gl::most_bytes() / sizeof(Instance));
  if (step.boids > 0) step.buffer.fill(frame.boids.data(), step.boids * sizeof(Instance));
}

Mesh mesh_of(const sturnus::FlockDef& flock, int dimensions, Look look, std::size_t boids) {
  if (look == Look::points || boids > points_above) return Mesh::point;
  const Mesh own = glyph_of(flock, dimensions);
  if (look == Look::automatic && (own == Mesh::disc || own == Mesh::ball)) return own;
  if (boids > simple_above) return simple(dimensions);
  if (look == Look::fish) return Mesh::fish;
  if (look == Look::birds) return Mesh::bird;
  return arrow(dimensions);
}

bool has_rough_edges(const Frame& frame, Look look) {
  if (frame.boids.size() > simple_above) return false;
  const std::vector<Mesh> meshes = meshes_in_use(frame, look);
  return frame.dimensions == 3 ||
         std::any_of(meshes.begin(), meshes.end(), [](Mesh mesh) { return !is_figure(mesh); });
}

Boids::Boids(gl::Program figures, gl::Program bodies, gl::Program points, gl::Program trails)
    : figures_(std::move(figures)),
      bodies_(std::move(bodies)),
      points_(std::move(points)),
      trails_(std::move(trails)),
      parts_(make_meshes()) {
  meshes_.fill(parts_.corners.data(), parts_.corners.size() * sizeof(MeshCorner));
}

sturnus::Result<Boids> Boids::create() {
  auto figures = gl::Program::build(shaders::figure_vertex(), shaders::figure_fragment());
  if (!figures) return figures.problems();
  auto bodies = gl::Program::build(shaders::body_vertex(), shaders::body_fragment());
  if (!bodies) return bodies.problems();
  auto points = gl::Program::build(shaders::point_vertex(), shaders::point_fragment());
  if (!points) return points.problems();
  auto trails = gl::Program::build(shaders::trail_vertex(), shaders::line_fragment());
  if (!trails) return trails.problems();
  return Boids(std::move(*figures), std::move(*bodies), std::move(*points), std::move(*trails));
}

void Boids::draw_kind(Mesh mesh, std::size_t boids, const Frame& frame, const Lens& lens,
                      const ViewOptions& options, const Moment& moment) const {
  const auto count = static_cast<GLsizei>(boids);
  if (mesh == Mesh::point) {
    set_boids(points_, frame, lens, options, moment);
    glUniform1f(points_.at("smallest"), boids > points_above ? 1.0f : 2.0f);
    return glDrawArrays(GL_POINTS, 0, count);
  }
  const gl::Program& program = is_figure(mesh) ? figures_ : bodies_;
  set_boids(program, frame, lens, options, moment);
  glUniform1i(program.at("mesh"), static_cast<GLint>(mesh));
  if (is_figure(mesh)) {
    glUniform1i(program.at("shape"), static_cast<GLint>(mesh));
    return glDrawArrays(GL_TRIANGLES, 0, 6 * count);
  }
  const MeshRange range = parts_.of(mesh);
  glUniform1i(program.at("meshes"), meshes_unit);
  glUniform1i(program.at("first"), static_cast<GLint>(range.first));
  glUniform1i(program.at("corners"), static_cast<GLint>(range.corners));
  glUniform1f(program.at("seconds"), moment.seconds);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(range.corners) * count);
}

void Boids::draw(const Past& past, const Frame& frame, const Lens& lens, const ViewOptions& options,
                 const Moment& moment) const {
  if (past.size() == 0 || past.at(0).boids == 0) return;
  past.at(0).buffer.bind(boids_unit);
  meshes_.bind(meshes_unit);
  glEnable(GL_PROGRAM_POINT_SIZE);
  for (const Mesh mesh : meshes_in_use(frame, options.look)) {
    frame.dimensions == 3 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
    draw_kind(mesh, past.at(0).boids, frame, lens, options, moment);
  }
}

void Boids::draw_trails(const Past& past, const Frame& frame, const Lens& lens, const ViewOptions& options,
                        const Moment& moment) const {
  const std::size_t steps = std::min(past.size(), static_cast<std::size_t>(std::max(0, options.trail_steps)));
  Moment whole = moment;
  whole.part = 1;
  whole.tracked.reset();  // places change from step to step; the tracked boid's trail has its flock's colour
  for (std::size_t ago = steps; ago-- > 0;) {
    const Past::Step& step = past.at(ago);
    if (step.boids == 0) continue;
    set_boids(trails_, frame, lens, options, ago == 0 ? moment : whole);
    step.buffer.bind(boids_unit);
    const auto age = [&](std::size_t from) {
      return 0.55f * static_cast<float>(steps - from) / static_cast<float>(steps);
    };
    glUniform2f(trails_.at("ages"), ago + 1 < steps ? age(ago + 1) : 0, age(ago));
    glUniform1f(trails_.at("width"), 1.4f);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * step.boids));
  }
}

}  // namespace studio
