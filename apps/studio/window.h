// The window and its OpenGL context; also one without any display, for tests and films.
#pragma once

#include <SDL.h>
#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <memory>
#include <string>

namespace studio {

class Window {
 public:
  /// A window of so many points with OpenGL 3.3, or a sentence on why there is none.
  static sturnus::Result<Window> open(const std::string& title, sturnus::Size points, bool resizable = true);

  /// Pixels to draw into; more than points on fine displays.
  sturnus::Size pixels() const;
  sturnus::Size points() const;
  /// Pixels for each point.
  float density() const;
  void set_title(const std::string& title);
  void present();
  /// Whether presenting waits for the display.
  bool has_pace() const { return has_pace_; }
  SDL_Window* handle() const { return window_.get(); }

 private:
  struct Library {
    ~Library() { SDL_Quit(); }
  };
  struct Closer {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(void* context) const { SDL_GL_DeleteContext(context); }
  };
  std::unique_ptr<Library> library_;
  std::unique_ptr<SDL_Window, Closer> window_;
  std::unique_ptr<void, Closer> context_;
  bool has_pace_ = false;
};

}  // namespace studio
