// The animation loop: keys and mouse in, steps of the flock, pictures out.
#pragma once

#include <SDL.h>
#include <sturnus/simulation.h>

#include <chrono>
#include <string>

#include "choices.h"
#include "scene.h"
#include "window.h"

namespace prog06 {

/// The flock's data are stepped by `animating` or by a key; a picture is drawn only when they changed.
class Loop {
 public:
  Loop(const Choices& choices, sturnus::Simulation& flock, Window& window);

  /// Until somebody quits; false when a picture could not be written.
  bool run();

 private:
  void press_next_key();
  void handle_events();
  void handle(const SDL_Event& event);
  void handle_key(const SDL_KeyboardEvent& key);
  void hold_at(int x, int y, bool pressed);
  void step();
  void redraw();
  void write();
  void rest();
  bool is_waiting() const { return !animating_ && !updated_ && !quit_ && keys_.empty(); }

  using Clock = std::chrono::steady_clock;

  sturnus::Simulation& flock_;
  Window& window_;
  Scene scene_;
  sturnus::Image shown_;  // what the window shows
  std::string picture_;   // where the key w writes
  std::string keys_;      // still to be pressed by themselves
  Clock::time_point next_frame_ = Clock::now();
  sturnus::PointerMode mode_ = sturnus::PointerMode::attract;
  bool holding_ = false;    // a mouse button is down
  bool animating_ = false;  // a step in every frame
  bool updated_ = true;     // the data changed since they were drawn
  bool quit_ = false;
  bool all_written_ = true;
};

}  // namespace prog06
