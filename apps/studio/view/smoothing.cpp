// A framebuffer of several samples a pixel, and its way into the window.
#include "view/smoothing.h"

#include <algorithm>

namespace studio {
namespace {

GLint number_of(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

template <class Generate>
GLuint made(Generate generate) {
  GLuint name = 0;
  generate(1, &name);
  return name;
}

gl::Owned<gl::delete_renderbuffer> renderbuffer(GLenum format, sturnus::Size size, GLint samples) {
  gl::Owned<gl::delete_renderbuffer> buffer(made(glGenRenderbuffers));
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
  return buffer;
}

void copy(GLuint from, GLuint to, sturnus::Size size) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
}

}  // namespace

Smoothing::Buffers Smoothing::buffers(sturnus::Size size, GLint samples) {
  Buffers out;
  out.framebuffer = gl::Owned<gl::delete_framebuffer>(made(glGenFramebuffers));
  out.colour = renderbuffer(GL_RGBA8, size, samples);
  glBindFramebuffer(GL_FRAMEBUFFER, out.framebuffer.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, out.colour.name());
  if (samples > 0) {
    out.depth = renderbuffer(GL_DEPTH_COMPONENT24, size, samples);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, out.depth.name());
  }
  out.is_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  return out;
}

void Smoothing::make(sturnus::Size size, GLint samples) {
  size_ = size;
  samples_ = buffers(size, samples);
  pixels_ = buffers(size, 0);
  is_refused_ = !samples_.is_complete || !pixels_.is_complete;
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
}

void Smoothing::begin(sturnus::Size size, bool wanted) {
  is_own_ = false;
  if (!wanted || is_refused_ || size.width < 1 || size.height < 1) return;
  target_ = static_cast<GLuint>(number_of(GL_DRAW_FRAMEBUFFER_BINDING));
  const GLint samples = std::min(4, number_of(GL_MAX_SAMPLES));
  if (samples < 2) return;
  if (size != size_) make(size, samples);
  if (is_refused_) return;
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.framebuffer.name());
  is_own_ = true;
}

void Smoothing::end() {
  if (!is_own_) return;
  copy(samples_.framebuffer.name(), pixels_.framebuffer.name(), size_);
  copy(pixels_.framebuffer.name(), target_, size_);
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
}

}  // namespace studio
