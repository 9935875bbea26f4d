// The studio: a window, a session behind it, and what happens in one frame.
#pragma once

#include <sturnus/files.h>

#include <chrono>
#include <memory>
#include <string>

#include "desk.h"
#include "files/memory.h"
#include "input/imgui_input.h"
#include "panels/panels.h"
#include "window.h"

namespace studio {

struct StudioOptions {
  sturnus::Size points{1280, 800};  ///< the window
  int threads = 0;                  ///< of the simulation; 0: one for each core
  std::size_t history_bytes = std::size_t{512} << 20;
  sturnus::ThemeName theme = sturnus::ThemeName::dark;
  /// For tests and films: every frame is a sixtieth of a second, and waits for the steps that are due.
  bool in_lockstep = false;
  /// Waits for the graphics card after each part of a frame, so that `Studio::times` knows what each took.
  bool measures_frames = false;
  std::string memory;  ///< file of what an earlier visit left, see files/memory.h; empty: a first visit
};

/// What frames took so far, seconds in all.
struct FrameTimes {
  double upload = 0;      ///< of steps to the graphics card
  double draw = 0;        ///< of the world, without uploads
  double panels = 0;      ///< making and drawing them
  std::size_t steps = 0;  ///< that were uploaded
  std::size_t frames = 0;
};

class Studio {
 public:
  /// A window on the simulation, or why there is none.
  static sturnus::Result<std::unique_ptr<Studio>> open(sturnus::Simulation simulation,
                                                       const StudioOptions& options);
  ~Studio();

  /// Events, steps, panels and a picture of them. False when the window was closed.
  bool frame();

  Desk& desk() { return desk_; }
  /// Only where the options ask for it; else nothing is counted.
  const FrameTimes& times() const { return times_; }
  void forget_times() { times_ = {}; }
  /// What the last frame showed with its panels, or the world alone in the middle of the picture.
  sturnus::Image picture(bool with_panels);
  /// Opens another scenario in place of this one; undo brings the world back.
  void load(const sturnus::ScenarioDef& scenario);

 private:
  Studio(Window window, View view, sturnus::Simulation simulation, const StudioOptions& options);
  void hear(const SDL_Event& event);
  void hear_key(const SDL_KeyboardEvent& key);
  void hear_command_key(const SDL_Keysym& key);
  void hear_plain_key(const SDL_Keysym& key);
  void hear_button(const SDL_MouseButtonEvent& button);
  void hear_motion(const SDL_MouseMotionEvent& motion);
  void hear_wheel(const SDL_MouseWheelEvent& wheel);
  void place_hand(int x, int y);
  double time_of_frame();
  void serve(double seconds);
  void fly(double seconds);
  void rest(std::chrono::steady_clock::time_point begin) const;
  void fit_camera();
  void show_panels(double seconds);
  void notice_hand();
  void resize_camera();
  void draw_world();
  void draw();
  void count_time(double& sum);
  void set_text_scale(float scale);
  void save_picture();
  void tell_of_film();
  void hear_drop(char* path);
  void toggle_tracking();
  void remember_panels();

  struct ImguiEnd {
    ~ImguiEnd();
  };
  enum class Drag { none, tool, orbit, look };

  StudioOptions options_;
  Window window_;
  View view_;
  Session session_;
  ImguiEnd imgui_;
  ImguiInput input_;
  Desk desk_;
  Drag drag_ = Drag::none;
  bool wants_picture_ = false, is_frame_due_ = false;
  float loaded_scale_ = 0, loaded_density_ = 0;
  sturnus::Extent fitted_;  // empty before the first frame
  Wishes wished_;
  FrameTimes times_;
  std::chrono::steady_clock::time_point counted_;  // when the last part of a frame was done
  std::uint64_t uploaded_ = 0;                     // the serial of the frame that was counted last
  Memory remembered_;
  std::string titled_;  // the scenario that the window's title names
  std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
};

}  // namespace studio
