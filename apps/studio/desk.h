// Everything that panels look at and change: the desk on which the session's window stands.
#pragma once

#include <imgui.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "files/files.h"
#include "panels/gallery.h"
#include "panels/states.h"
#include "recorder/recorder.h"
#include "session/playback.h"
#include "session/session.h"
#include "tools/tools.h"
#include "view/camera.h"
#include "view/shapes.h"
#include "view/view.h"

namespace studio {

/// Which panels are unfolded.
struct Open {
  bool legend = true;
  bool legend_anyway = false;  ///< also where it hides much of the world
  bool hint = true;            ///< the lines of the first start, until they faded
  bool inspector = true;
  bool bottom = true;
  bool gallery = false;
  bool help = false;
};

/// A sentence on the screen, and how long it is still shown.
struct ShownNote {
  Note note;
  double seconds_left = 0;
  std::string about;  ///< a file that is still wrong: shown until it is right or somebody dismisses it
};

/// A rectangle of the window, points.
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
  bool holds(float px, float py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

/// Where panels stand in this frame.
struct Layout {
  Box top, tools, inspector, bottom, world;
  int tool_columns = 1;    ///< in which the tools stand
  float tool_height = 28;  ///< of a tool's button, points
};

struct Desk {
  explicit Desk(Session& served) : session(served), frame(served.frame()) {}

  Session& session;
  Playback playback;
  Tools tools;
  Camera camera;
  ViewOptions view;
  Wishes wishes;
  std::shared_ptr<const Frame> frame;  ///< what is shown now
  Open open;
  Layout layout;
  Hand hand;
  float text_scale = 1;      ///< Ctrl + and Ctrl -
  float density = 1;         ///< pixels for each point
  double seconds = 0;        ///< since the start
  sturnus::Size pixels;      ///< of the window
  double frame_seconds = 0;  ///< what the last frame took to draw
  bool is_tracking = false;
  bool wants_tracking = false;  ///< to begin or end in this frame
  std::vector<ShownNote> notes;
  InspectorState inspector;
  TrackingState tracking;
  PlotsState plots;
  std::vector<std::function<void(Shapes&)>> shapes;  ///< what panels add above the world, once
  std::map<std::string, Box> items;  ///< where widgets stood in the last frame, by name: for films and tests
  std::uint64_t next_gesture = 1u << 20;  ///< a number for the next drag of a slider
  bool wants_quit = false;
  Files files;
  GalleryState gallery;
  Recorder recorder;
  FilmOptions film;               ///< of the next film that is begun
  std::function<void()> overlay;  ///< draws above everything: a scripted visit's cursor and captions

  const sturnus::ScenarioDef& scenario() const { return *frame->scenario; }
  void say(std::string text, bool is_problem = false);
  /// Says what is wrong with a file until it is unsaid, in place of what was said of it before.
  void keep_saying(const std::string& about, std::string text);
  void unsay(const std::string& about);
  /// Sets a parameter, as one gesture with those of the same number.
  void set(const std::string& path, const std::string& value, std::uint64_t gesture = 0);
  /// Begins a film of the window, or ends the one that is being made.
  void toggle_recording();
};

}  // namespace studio
