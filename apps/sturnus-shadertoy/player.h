// Plays a pair of Shadertoy shaders frame by frame.
#pragma once

#include <optional>
#include <utility>

#include "gl_objects.h"
#include "shader_text.h"

namespace shadertoy {

/// Both passes as programs.
struct Passes {
  Program buffer_a;
  Program image;
};

/// The programs, or what the driver finds wrong, by file and line.
sturnus::Result<Passes> compile(const Shaders& shaders);

/// The pixel at which the mouse is held pressed, y upwards.
using Mouse = std::optional<std::pair<int, int>>;

class Player {
 public:
  /// Stands before frame 0, with Buffer A cleared.
  static sturnus::Result<Player> open(Passes passes, sturnus::Size size, Mouse mouse);

  /// Draws Buffer A of the next frame.
  void advance();
  /// Number of the frame that was drawn last; -1 before the first.
  int frame() const { return frame_; }
  const Target& buffer_a() const { return now_; }
  /// Draws the Image pass of this frame.
  sturnus::Image picture();
  /// The first error that the driver has noted since the start.
  sturnus::Status check() const;

 private:
  Player(Passes passes, sturnus::Size size, Mouse mouse);
  void set_uniforms(const Program& program) const;

  Passes passes_;
  Mouse mouse_;
  Texture noise_;
  Target now_, before_, picture_;
  int frame_ = -1;
};

}  // namespace shadertoy
