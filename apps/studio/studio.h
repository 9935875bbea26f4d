// The studio: a window, a session behind it, and what happens in one frame.
#pragma once

#include <sturnus/files.h>

#include <chrono>
#include <memory>
#include <string>

#include "desk.h"
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
  /// What the last frame showed, with panels or the world alone.
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
  void set_text_scale(float scale);
  void save_picture();
  void record(bool with_panels);
  void tell_of_film();
  void hear_drop(char* path);
  void toggle_tracking();

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
  std::string titled_;  // the scenario that the window's title names
  std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
};

}  // namespace studio
