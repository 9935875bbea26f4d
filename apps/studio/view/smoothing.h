// Smooth edges by a framebuffer of one's own: that of a window without a display says that it has several
// samples a pixel, and has one.
#pragma once

#include <sturnus/picture.h>

#include "view/gl.h"

namespace studio {

/// Several samples a pixel between begin() and end().
class Smoothing {
 public:
  /// From here, what is drawn into the framebuffer that is bound gets four samples a pixel, or as many as the
  /// driver has; where `wanted` is false, or the driver has no more than one, nothing changes.
  void begin(sturnus::Size size, bool wanted);
  /// The framebuffer that was bound is so again, and has what was drawn, each pixel the mean of its samples.
  void end();

 private:
  void make(sturnus::Size size, GLint samples);

  struct Buffers {
    gl::Owned<gl::delete_framebuffer> framebuffer;
    gl::Owned<gl::delete_renderbuffer> colour, depth;
    bool is_complete = false;
  };
  static Buffers buffers(sturnus::Size size, GLint samples);

  // Samples become pixels of the same format first, which any window's framebuffer takes.
  Buffers samples_, pixels_;
  sturnus::Size size_{0, 0};
  GLuint target_ = 0;  // the framebuffer that was bound
  bool is_own_ = false;
  bool is_refused_ = false;  // by the driver: then edges stay as they are
};

}  // namespace studio
