// Uniforms of the camera.
#include "view/lens.h"

#include <algorithm>

namespace studio {
namespace {

void set_point(const gl::Program& program, const char* uniform, const Point& at) {
  glUniform3f(program.at(uniform), at[0], at[1], at[2]);
}

}  // namespace

void set_colour(const gl::Program& program, const char* uniform, sturnus::Rgba colour) {
  glUniform3f(program.at(uniform), static_cast<float>(colour.r) / 255, static_cast<float>(colour.g) / 255,
              static_cast<float>(colour.b) / 255);
}

void Lens::use(const gl::Program& program) const {
  program.use();
  const bool in_space = camera->dimensions() == 3;
  const float nearest = camera->nearest();
  const Point eye = camera->eye();
  glUniformMatrix4fv(program.at("to_clip"), 1, GL_FALSE, camera->matrix().data());
  set_point(program, "eye", eye);
  set_point(program, "right", camera->right());
  set_point(program, "up", camera->up());
  set_point(program, "forward", camera->forward());
  glUniform1i(program.at("in_space"), in_space ? 1 : 0);
  const Point ahead = eye + camera->forward() * (2 * nearest);
  glUniform1f(program.at("pixel"), camera->pixel_length(ahead) / (in_space ? 2 * nearest : 1));
  glUniform2f(program.at("window"), static_cast<float>(camera->pixels().width),
              static_cast<float>(camera->pixels().height));
  glUniform1f(program.at("scale"), scale);
  glUniform1f(program.at("nearest"), in_space ? nearest : 0);
  glUniform2f(program.at("fade_between"), fade[0], fade[1]);
  set_colour(program, "background", colours->background);
}

std::array<float, 2> fade_of(const Camera& camera, const sturnus::Extent& extent) {
  if (camera.dimensions() == 2) return {0, 1};
  std::array<float, 2> out{1e30f, 0};
  for (int index = 0; index < 8; ++index) {
    Point corner{};
    for (std::size_t axis = 0; axis < extent.min.size() && axis < 3; ++axis)
      corner[axis] = static_cast<float>((index >> axis & 1) != 0 ? extent.max[axis] : extent.min[axis]);
    const float depth = dot(corner - camera.eye(), camera.forward());
    out = {std::min(out[0], depth), std::max(out[1], depth)};
  }
  out[0] = std::max(0.0f, out[0]);
  out[1] = std::max(out[1], out[0] + 1e-3f);
  return out;
}

}  // namespace studio
