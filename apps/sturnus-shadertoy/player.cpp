// The passes of a frame, with Shadertoy's uniforms and channels.
#include "player.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "noise.h"

namespace shadertoy {
namespace {

constexpr float frames_per_second = 60;
constexpr sturnus::Size noise_size = {noise_side, noise_side};

sturnus::Result<Program> compile_pass(const std::string& text, const Shaders& shaders, const Tab& tab) {
  auto program = Program::build(text);
  if (program) return program;
  return problems_in(program.problems().front().text, shaders, tab);
}

// Gives a channel of the program in use its texture, and its size as Shadertoy tells it.
void set_channel(const Program& program, int channel, const Texture& texture) {
  const std::string number = std::to_string(channel);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(channel));
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glUniform3f(program.at(("iChannelResolution[" + number + "]").c_str()),
              static_cast<float>(texture.size().width), static_cast<float>(texture.size().height), 1);
}

}  // namespace

sturnus::Result<Passes> compile(const Shaders& shaders) {
  auto buffer_a = compile_pass(buffer_a_shader(shaders), shaders, shaders.buffer_a);
  if (!buffer_a) return buffer_a.problems();
  auto image = compile_pass(image_shader(shaders), shaders, shaders.image);
  if (!image) return image.problems();
  return Passes{std::move(*buffer_a), std::move(*image)};
}

Player::Player(Passes passes, sturnus::Size size, Mouse mouse)
    : passes_(std::move(passes)),
      mouse_(mouse),
      noise_(byte_texels, noise_size, GL_LINEAR, GL_REPEAT, noise_texels().data()),
      now_(float_texels, size),
      before_(float_texels, size),
      picture_(byte_texels, size) {
  now_.clear();
  before_.clear();
}

sturnus::Result<Player> Player::open(Passes passes, sturnus::Size size, Mouse mouse) {
  Player player(std::move(passes), size, mouse);
  if (player.now_.is_complete() && player.before_.is_complete() && player.picture_.is_complete() &&
      player.check())
    return player;
  return sturnus::Problem{"", 0, "",
                          "the driver has no room for pictures of " + std::to_string(size.width) + "x" +
                              std::to_string(size.height) + "; give a smaller --size",
                          false};
}

void Player::set_uniforms(const Program& program) const {
  const sturnus::Size size = now_.size();
  glUniform3f(program.at("iResolution"), static_cast<float>(size.width), static_cast<float>(size.height), 1);
  glUniform1f(program.at("iTime"), static_cast<float>(frame_) / frames_per_second);
  glUniform1f(program.at("iTimeDelta"), 1 / frames_per_second);
  glUniform1f(program.at("iFrameRate"), frames_per_second);
  glUniform1i(program.at("iFrame"), frame_);
  // No clock is read: every run is on the first day of 2000, whose month is 0 to Shadertoy.
  glUniform4f(program.at("iDate"), 2000, 0, 1, static_cast<float>(frame_) / frames_per_second);
  if (mouse_) {
    const float x = static_cast<float>(mouse_->first), y = static_cast<float>(mouse_->second);
    glUniform4f(program.at("iMouse"), x, y, x, frame_ == 0 ? y : -y);
  }
  for (int channel = 0; channel < 4; ++channel)
    glUniform1i(program.at(("iChannel" + std::to_string(channel)).c_str()), channel);
}

void Player::advance() {
  std::swap(now_, before_);
  ++frame_;
  passes_.buffer_a.use();
  set_uniforms(passes_.buffer_a);
  set_channel(passes_.buffer_a, 0, before_.texture());
  set_channel(passes_.buffer_a, 1, noise_);
  now_.draw();
}

sturnus::Image Player::picture() {
  passes_.image.use();
  set_uniforms(passes_.image);
  set_channel(passes_.image, 0, now_.texture());
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, 0);
  picture_.draw();

  const sturnus::Size size = picture_.size();
  sturnus::Image image(size, {});
  std::vector<std::array<std::uint8_t, 4>> texels(static_cast<std::size_t>(size.width) *
                                                  static_cast<std::size_t>(size.height));
  picture_.read(0, 0, size, texels.data());
  auto texel = texels.begin();
  for (int y = size.height - 1; y >= 0; --y) {  // GL's rows begin at the bottom
    for (int x = 0; x < size.width; ++x, ++texel)
      std::copy_n(texel->begin(), 3, image.rgb.begin() + static_cast<std::ptrdiff_t>(image.offset(x, y)));
  }
  return image;
}

sturnus::Status Player::check() const {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return {};
  return sturnus::Problem{"", 0, "", "the OpenGL driver failed with error " + std::to_string(error), false};
}

}  // namespace shadertoy
