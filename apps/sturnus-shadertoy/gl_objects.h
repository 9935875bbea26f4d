// GL objects that end with their owners: textures, framebuffers, programs.
#pragma once

#include <epoxy/gl.h>
#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <string>
#include <utility>

namespace shadertoy {

/// The name of a GL object, and what deletes it.
template <void (*destroy)(GLuint)>
class Owned {
 public:
  explicit Owned(GLuint name) : name_(name) {}
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

void delete_texture(GLuint name);
void delete_framebuffer(GLuint name);
void delete_program(GLuint name);

/// How a texture is stored: GL_RGBA32F with GL_RGBA and GL_FLOAT, and so on.
struct TexelFormat {
  GLint stored;
  GLenum order, type;
};
inline constexpr TexelFormat float_texels = {GL_RGBA32F, GL_RGBA, GL_FLOAT};
inline constexpr TexelFormat integer_texels = {GL_RGBA32I, GL_RGBA_INTEGER, GL_INT};
inline constexpr TexelFormat byte_texels = {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};

class Texture {
 public:
  /// `texels` may be null. `filter`: GL_NEAREST or GL_LINEAR; `wrap`: GL_CLAMP_TO_EDGE or GL_REPEAT.
  Texture(TexelFormat format, sturnus::Size size, GLint filter, GLint wrap, const void* texels = nullptr);
  GLuint name() const { return name_.name(); }
  sturnus::Size size() const { return size_; }

 private:
  Owned<delete_texture> name_;
  sturnus::Size size_;
};

/// A texture to draw into and to read from.
class Target {
 public:
  Target(TexelFormat format, sturnus::Size size);
  const Texture& texture() const { return texture_; }
  sturnus::Size size() const { return texture_.size(); }
  /// Whether there was memory for it.
  bool is_complete() const;
  void clear() const;
  /// Draws a triangle over all of it with the program in use.
  void draw() const;
  /// Copies a rectangle of texels, rows from the bottom; `texels` has room for them.
  void read(int x, int y, sturnus::Size part, void* texels) const;

 private:
  TexelFormat format_;
  Texture texture_;
  Owned<delete_framebuffer> framebuffer_;
};

/// A program of a triangle over everything and a fragment shader.
class Program {
 public:
  /// The program, or the driver's log as the text of one problem.
  static sturnus::Result<Program> build(const std::string& fragment_shader);
  void use() const { glUseProgram(name_.name()); }
  /// Where a uniform is; -1, which GL ignores, where the shader does not use it.
  GLint at(const char* uniform) const { return glGetUniformLocation(name_.name(), uniform); }

 private:
  explicit Program(GLuint name) : name_(name) {}
  Owned<delete_program> name_;
};

}  // namespace shadertoy
