// The library's own renderer draws; OpenGL only keeps the pictures.
#include "panels/thumbnails.h"

#include <epoxy/gl.h>
#include <sturnus/files.h>
#include <sturnus/render.h>

#include <algorithm>
#include <cstring>

namespace studio {
namespace {

constexpr std::uint64_t flight_steps = 60;
constexpr std::int64_t most_boids = 600;
constexpr std::size_t uploads_per_frame = 2;

void thin_out(sturnus::ScenarioDef& scenario) {
  const std::int64_t all = scenario.boid_count();
  if (all <= most_boids) return;
  for (sturnus::FlockDef& flock : scenario.flocks) {
    if (flock.count > 0) flock.count = std::max<std::int64_t>(1, flock.count * most_boids / all);
  }
}

unsigned texture_of(const sturnus::Image& picture) {
  unsigned texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               picture.rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace

sturnus::Image draw_thumbnail(const std::string& name, sturnus::ThemeName theme) {
  auto scenario = sturnus::load_scenario(name);
  if (!scenario) return {};
  thin_out(*scenario);
  auto simulation = sturnus::open_simulation(*scenario, 1);
  if (!simulation) return {};
  simulation->run(flight_steps);
  sturnus::RenderOptions options;
  options.picture.size = Thumbnails::size;
  options.picture.theme = theme;
  options.caption = false;
  options.threads = 1;
  return sturnus::Renderer(options).frame(*simulation);
}

Thumbnails::~Thumbnails() {
  stop();
  for (const auto& [name, texture] : textures_) glDeleteTextures(1, &texture);
}

void Thumbnails::want(sturnus::ThemeName theme) {
  if (is_wanted_ && theme == theme_) return;
  stop();
  is_wanted_ = true;
  theme_ = theme;
  artist_ = std::thread([this, theme] { draw_all(theme); });
}

void Thumbnails::stop() {
  quit_ = true;
  if (artist_.joinable()) artist_.join();
  quit_ = false;
  is_drawn_ = false;
  ready_.clear();
}

void Thumbnails::draw_all(sturnus::ThemeName theme) {
  for (const sturnus::ShippedScenario& shipped : sturnus::shipped_scenarios()) {
    if (quit_) return;
    if (std::strcmp(shipped.group, "bench") == 0) continue;
    sturnus::Image picture = draw_thumbnail(shipped.name, theme);
    const std::lock_guard lock(mutex_);
    ready_.push_back({shipped.name, std::move(picture)});
  }
  is_drawn_ = true;
}

void Thumbnails::upload() {
  std::vector<Ready> taken;
  {
    const std::lock_guard lock(mutex_);
    const auto count = static_cast<std::ptrdiff_t>(std::min(uploads_per_frame, ready_.size()));
    std::move(ready_.begin(), ready_.begin() + count, std::back_inserter(taken));
    ready_.erase(ready_.begin(), ready_.begin() + count);
  }
  for (const Ready& ready : taken) {
    if (ready.picture.rgb.empty()) continue;
    unsigned& texture = textures_[ready.name];
    if (texture != 0) glDeleteTextures(1, &texture);
    texture = texture_of(ready.picture);
  }
}

ImTextureID Thumbnails::of(const std::string& name) const {
  const auto found = textures_.find(name);
  return found == textures_.end() ? nullptr : reinterpret_cast<ImTextureID>(std::uintptr_t{found->second});
}

std::size_t Thumbnails::ready_count() const {
  const std::lock_guard lock(mutex_);
  return ready_.size();
}

}  // namespace studio
