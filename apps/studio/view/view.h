// Draws a frame with OpenGL 3.3: one instanced draw for each kind of thing, one upload for each step.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <memory>

#include "session/frame.h"
#include "view/camera.h"
#include "view/shapes.h"

namespace studio {

/// automatic: the flock's, or the colours that drift where the scenario has them. The shaders know the
/// numbers.
enum class ColourBy { automatic, flock, heading, speed, neighbours, drifting };
/// How boids look. automatic: the scenario's glyph, simpler the more there are.
enum class Look { automatic, arrows, fish, birds, points };

struct ViewOptions {
  sturnus::ThemeName theme = sturnus::ThemeName::dark;
  ColourBy colour_by = ColourBy::automatic;
  Look look = Look::automatic;
  float size = 1;  ///< times the size that the scenario gives
  bool trails = false;
  int trail_steps = 24;
  bool smooth = true;   ///< edges, by several samples a pixel where bodies need it
  bool outline = true;  ///< the edge of the space
  bool grid = false;    ///< lines at even distances, with the space's edge
  bool index = false;   ///< the frame's index boxes
  bool reaches = true;  ///< rings around targets that have a radius
};

/// What is shown between two steps.
struct Moment {
  float part = 1;     ///< of the way from the frame's previous places to its places, 0 to 1
  float seconds = 0;  ///< since the start, for wings and fins
  float scale = 1;    ///< pixels of the display for one of the design
  std::optional<std::size_t> tracked = {};  ///< drawn red
};

/// Nanoseconds spent, as the drawing thread sees it.
struct ViewTimes {
  double upload = 0, draw = 0;
};

class View {
 public:
  /// Needs a current context of OpenGL 3.3 core; the driver's words where it can't draw.
  static sturnus::Result<View> create();
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;

  /// Takes a new frame: the one upload of its step. Frames of another generation forget the trails.
  void upload(const Frame& frame);
  /// Draws the frame that was uploaded last, and the shapes above it, into the framebuffer that is bound.
  void draw(const Frame& frame, const Camera& camera, const ViewOptions& options, const Moment& moment,
            const Shapes& shapes);
  ViewTimes times() const;

 private:
  struct Parts;
  explicit View(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// The pixels of the framebuffer that is bound, the upper row first.
sturnus::Image read_pixels(sturnus::Size size);

}  // namespace studio
