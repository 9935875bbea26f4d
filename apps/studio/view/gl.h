// GL objects that end with their owners, and programs that pull what they draw out of buffers.
//
// Vertices are pulled by gl_VertexID instead of being instanced: software GL sets up every instance anew and
// takes many times as long for it, and no driver is slower for pulling.
#pragma once

#include <epoxy/gl.h>
#include <sturnus/result.h>

#include <cstddef>
#include <string>
#include <utility>

namespace studio::gl {

/// The name of a GL object, and what deletes it.
template <void (*destroy)(GLuint)>
class Owned {
 public:
  explicit Owned(GLuint name = 0) : name_(name) {}
  Owned(Owned&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Owned() {
    if (name_ != 0) destroy(name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

void delete_buffer(GLuint name);
void delete_texture(GLuint name);
void delete_program(GLuint name);
void delete_vertex_array(GLuint name);
void delete_framebuffer(GLuint name);
void delete_renderbuffer(GLuint name);

/// A buffer that shaders read as a texture of four numbers a texel.
class Pulled {
 public:
  /// `format`: GL_RGBA32UI or GL_RGBA32F.
  explicit Pulled(GLenum format);
  /// Replaces all; the memory that a running draw still reads is the driver's to keep.
  void fill(const void* data, std::size_t bytes);
  void bind(GLuint unit) const;

 private:
  Owned<delete_buffer> buffer_;
  Owned<delete_texture> texture_;
  GLenum format_;
};

/// Bytes that a pulled buffer holds at most.
std::size_t most_bytes();

class Program {
 public:
  /// The program, or the driver's log as the text of one problem.
  static sturnus::Result<Program> build(const std::string& vertex_shader, const std::string& fragment_shader);
  void use() const { glUseProgram(name_.name()); }
  /// Where a uniform is; -1, which GL ignores, where the shader does not use it.
  GLint at(const char* uniform) const { return glGetUniformLocation(name_.name(), uniform); }

 private:
  explicit Program(GLuint name) : name_(name) {}
  Owned<delete_program> name_;
};

/// An empty vertex array: core GL draws nothing without one.
Owned<delete_vertex_array> vertex_array();

}  // namespace studio::gl
