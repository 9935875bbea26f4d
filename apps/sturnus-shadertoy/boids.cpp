// The probe that asks Common, and the reading of texels.
#include "boids.h"

#include <algorithm>
#include <array>
#include <string>

namespace shadertoy {
namespace {

constexpr int probe_width = 16384;  // texels in a row

using Four = std::array<GLint, 4>;

sturnus::Problem problem_of(const Shaders& shaders, std::string text) {
  const std::string& file = shaders.common.file;
  return {file.empty() ? "common.glsl" : file, 0, "", std::move(text), false};
}

// The first `count` texels of the probe.
std::vector<Four> ask(const Program& probe, int count) {
  const sturnus::Size size = {std::min(count, probe_width), (count + probe_width - 1) / probe_width};
  const Target target(integer_texels, size);
  probe.use();
  glUniform1i(probe.at("probe_width"), size.width);
  target.draw();
  std::vector<Four> texels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  target.read(0, 0, size, texels.data());
  texels.resize(static_cast<std::size_t>(count));
  return texels;
}

std::string text_of(sturnus::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

sturnus::Result<Boids> Boids::find(const Shaders& shaders, sturnus::Size size) {
  const auto probe = Program::build(probe_shader(shaders));
  if (!probe) {
    return problem_of(
        shaders,
        "does not say where the boids are; --state needs const int COUNT, const int DIMENSIONS, "
        "int flock_of(int boid) and ivec2 texel_of(int boid)");
  }
  probe->use();
  glUniform3f(probe->at("iResolution"), static_cast<float>(size.width), static_cast<float>(size.height), 1);
  const Four about = ask(*probe, 1).front();
  Boids boids;
  boids.dimensions_ = about[1];
  if (boids.dimensions_ != 2 && boids.dimensions_ != 3)
    return problem_of(shaders, "DIMENSIONS must be 2 or 3, but is " + std::to_string(about[1]));
  if (about[0] < 0 || about[0] > size.width * size.height / boids.texels_each()) {
    return problem_of(shaders, "COUNT is " + std::to_string(about[0]) + ", but a picture of " +
                                   text_of(size) + " has room for 0 to " +
                                   std::to_string(size.width * size.height / boids.texels_each()) + " boids");
  }
  const std::vector<Four> texels = ask(*probe, about[0] + 1);
  for (std::size_t i = 1; i < texels.size(); ++i) {
    boids.flock_.push_back(texels[i][0]);
    boids.texel_.push_back({texels[i][1], texels[i][2]});
  }
  if (const sturnus::Status status = boids.check(shaders, size); !status) return status.problems();
  return boids;
}

sturnus::Status Boids::check(const Shaders& shaders, sturnus::Size size) const {
  for (std::size_t i = 0; i < texel_.size(); ++i) {
    const Texel at = texel_[i];
    if (flock_[i] < 0 || flock_[i] > 255) {
      return problem_of(shaders, "flock_of(" + std::to_string(i) + ") must be 0 to 255, but is " +
                                     std::to_string(flock_[i]));
    }
    if (at.x < 0 || at.y < 0 || at.x + texels_each() > size.width || at.y >= size.height) {
      return problem_of(shaders, "texel_of(" + std::to_string(i) + ") is " + std::to_string(at.x) + "," +
                                     std::to_string(at.y) + ", outside a picture of " + text_of(size));
    }
  }
  return {};
}

sturnus::State Boids::read(const Target& buffer_a, int frame) const {
  sturnus::State state;
  state.dimensions = dimensions_;
  state.step = static_cast<std::uint64_t>(frame);
  state.next_id = texel_.size();
  state.quarantined.assign(texel_.size(), 0);
  int rows = 0;
  for (const Texel& at : texel_) rows = std::max(rows, at.y + 1);
  const sturnus::Size part = {buffer_a.size().width, rows};
  std::vector<std::array<float, 4>> texels(static_cast<std::size_t>(part.width) *
                                           static_cast<std::size_t>(rows));
  if (rows > 0) buffer_a.read(0, 0, part, texels.data());

  const auto axes = static_cast<std::size_t>(dimensions_);
  for (std::size_t i = 0; i < texel_.size(); ++i) {
    const std::size_t place = static_cast<std::size_t>(texel_[i].y) * static_cast<std::size_t>(part.width) +
                              static_cast<std::size_t>(texel_[i].x);
    // 2D: x, y, vx, vy in one texel; 3D: x, y, z in one and vx, vy, vz in the next.
    const float* position = texels[place].data();
    const float* velocity = axes == 2 ? position + 2 : texels[place + 1].data();
    state.id.push_back(i);
    state.flock.push_back(static_cast<std::uint8_t>(flock_[i]));
    for (std::size_t axis = 0; axis < axes; ++axis) {
      state.position[axis].push_back(position[axis]);
      state.velocity[axis].push_back(velocity[axis]);
    }
  }
  return state;
}

}  // namespace shadertoy
