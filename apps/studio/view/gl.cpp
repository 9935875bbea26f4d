// Making and deleting of GL objects.
#include "view/gl.h"

namespace studio::gl {
namespace {

GLuint new_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return name;
}

GLuint new_texture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}

std::string log_of(GLuint shader) {
  char text[2000] = {};
  glGetShaderInfoLog(shader, sizeof text, nullptr, text);
  return text;
}

// 0 and the driver's words in `log` where it does not compile.
GLuint compile(GLenum stage, const std::string& source, std::string& log) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  log = log_of(shader);
  glDeleteShader(shader);
  return 0;
}

sturnus::Problem driver_problem(const std::string& log) {
  return {"", 0, "", "the graphics driver does not take a shader of the studio: " + log, false};
}

}  // namespace

void delete_buffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
void delete_texture(GLuint name) {
  glDeleteTextures(1, &name);
}
void delete_program(GLuint name) {
  glDeleteProgram(name);
}
void delete_vertex_array(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
void delete_framebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
void delete_renderbuffer(GLuint name) {
  glDeleteRenderbuffers(1, &name);
}

Pulled::Pulled(GLenum format) : buffer_(new_buffer()), texture_(new_texture()), format_(format) {}

void Pulled::fill(const void* data, std::size_t bytes) {
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.name());
}

void Pulled::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glActiveTexture(GL_TEXTURE0);
}

std::size_t most_bytes() {
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  return static_cast<std::size_t>(texels) * 16;
}

sturnus::Result<Program> Program::build(const std::string& vertex_shader,
                                        const std::string& fragment_shader) {
  std::string log;
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_shader, log);
  if (vertex == 0) return driver_problem(log);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_shader, log);
  if (fragment == 0) {
    glDeleteShader(vertex);
    return driver_problem(log);
  }
  Program program(glCreateProgram());
  const GLuint name = program.name_.name();
  glAttachShader(name, vertex);
  glAttachShader(name, fragment);
  glLinkProgram(name);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint linked = 0;
  glGetProgramiv(name, GL_LINK_STATUS, &linked);
  if (linked != 0) return program;
  char text[2000] = {};
  glGetProgramInfoLog(name, sizeof text, nullptr, text);
  return driver_problem(text);
}

Owned<delete_vertex_array> vertex_array() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return Owned<delete_vertex_array>(name);
}

}  // namespace studio::gl
