// Draws layers: solids, then sprites, then lines.
#include "view/scenery.h"

#include "view/shaders.h"

namespace studio {

Scenery::Scenery(gl::Program lines, gl::Program sprites, gl::Program solids)
    : lines_(std::move(lines)), sprites_(std::move(sprites)), solids_(std::move(solids)) {}

sturnus::Result<Scenery> Scenery::create() {
  auto lines = gl::Program::build(shaders::line_vertex(), shaders::line_fragment());
  if (!lines) return lines.problems();
  auto sprites = gl::Program::build(shaders::sprite_vertex(), shaders::figure_fragment());
  if (!sprites) return sprites.problems();
  auto solids = gl::Program::build(shaders::solid_vertex(), shaders::solid_fragment());
  if (!solids) return solids.problems();
  return Scenery(std::move(*lines), std::move(*sprites), std::move(*solids));
}

void Scenery::draw_solids(const std::vector<ShapeCorner>& corners, const Lens& lens, bool lit) {
  if (corners.empty()) return;
  lens.use(solids_);
  glUniform1i(solids_.at("corners"), 0);
  glUniform1i(solids_.at("lit"), lit ? 1 : 0);
  buffer_.fill(corners.data(), corners.size() * sizeof(ShapeCorner));
  buffer_.bind(0);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void Scenery::draw(const Layer& layer, const Lens& lens) {
  draw_solids(layer.solids, lens, lens.camera->dimensions() == 3);
  if (!layer.sprites.empty()) {
    lens.use(sprites_);
    glUniform1i(sprites_.at("sprites"), 0);
    buffer_.fill(layer.sprites.data(), layer.sprites.size() * sizeof(Sprite));
    buffer_.bind(0);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * layer.sprites.size()));
  }
  if (layer.lines.empty()) return;
  lens.use(lines_);
  glUniform1i(lines_.at("lines"), 0);
  buffer_.fill(layer.lines.data(), layer.lines.size() * sizeof(Line));
  buffer_.bind(0);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * layer.lines.size()));
}

void Scenery::draw(const Shapes& shapes, const Lens& lens) {
  draw_solids(shapes.triangles(), lens, false);
}

}  // namespace studio
