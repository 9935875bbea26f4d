// Creation of GL objects.
#include "gl_objects.h"

namespace shadertoy {
namespace {

constexpr const char* triangle =
    "#version 300 es\n"
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";

GLuint new_texture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}

GLuint new_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return name;
}

// Whether it went well with a shader or a program, and what the driver says of it.
bool succeeded(GLuint name, GLenum what, PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC get_log,
               std::string& log) {
  GLint good = 0, length = 0;
  get(name, what, &good);
  get(name, GL_INFO_LOG_LENGTH, &length);
  log.assign(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  if (length > 0) get_log(name, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return good == GL_TRUE;
}

// Compiles a shader and leaves it to the program, so that it ends with the program.
bool attach(GLuint program, GLenum kind, const std::string& text, std::string& log) {
  const GLuint shader = glCreateShader(kind);
  const char* start = text.c_str();
  glShaderSource(shader, 1, &start, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
  return succeeded(shader, GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog, log);
}

bool link(GLuint program, std::string& log) {
  glLinkProgram(program);
  return succeeded(program, GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog, log);
}

}  // namespace

void delete_texture(GLuint name) {
  glDeleteTextures(1, &name);
}

void delete_framebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}

void delete_program(GLuint name) {
  glDeleteProgram(name);
}

Texture::Texture(TexelFormat format, sturnus::Size size, GLint filter, GLint wrap, const void* texels)
    : name_(new_texture()), size_(size) {
  glBindTexture(GL_TEXTURE_2D, name());
  glTexImage2D(GL_TEXTURE_2D, 0, format.stored, size.width, size.height, 0, format.order, format.type,
               texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glBindTexture(GL_TEXTURE_2D, 0);
}

Target::Target(TexelFormat format, sturnus::Size size)
    : format_(format), texture_(format, size, GL_NEAREST, GL_CLAMP_TO_EDGE), framebuffer_(new_framebuffer()) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
}

bool Target::is_complete() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Target::clear() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

void Target::draw() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, size().width, size().height);
  glDisable(GL_DITHER);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Target::read(int x, int y, sturnus::Size part, void* texels) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glReadPixels(x, y, part.width, part.height, format_.order, format_.type, texels);
}

sturnus::Result<Program> Program::build(const std::string& fragment_shader) {
  Program program(glCreateProgram());
  std::string log;
  if (attach(program.name_.name(), GL_VERTEX_SHADER, triangle, log) &&
      attach(program.name_.name(), GL_FRAGMENT_SHADER, fragment_shader, log) &&
      link(program.name_.name(), log))
    return program;
  return sturnus::Problem{"", 0, "", log, false};
}

}  // namespace shadertoy
