// What SDL's events mean to Dear ImGui. Its stock SDL backend asks for the mouse's global state, which is
// stale and knows nothing of pushed events; this one hears events alone, so that played sessions are like
// real ones.
#pragma once

#include <SDL.h>
#include <sturnus/picture.h>

namespace studio {

class ImguiInput {
 public:
  /// Tells ImGui which keys are which. Needs a current ImGui context.
  ImguiInput();
  void hear(const SDL_Event& event);
  /// Before ImGui::NewFrame: the window as it is, and the time since the last frame.
  void begin_frame(sturnus::Size points, sturnus::Size pixels, double seconds);

 private:
  void hear_button(const SDL_MouseButtonEvent& button);
  void hear_key(const SDL_KeyboardEvent& key);

  // A button that goes down and up within a frame is shown as down for one.
  bool is_down_[3] = {};
  bool was_pressed_[3] = {};
};

}  // namespace studio
