// A window of fixed size that shows one picture, pixel for pixel.
#pragma once

#include <SDL.h>
#include <sturnus/picture.h>

#include <memory>
#include <string>

namespace prog06 {

class Window {
 public:
  /// Opens a window; `failure()` says why it could not.
  explicit Window(sturnus::Size size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// A sentence when there is no window; empty otherwise.
  const std::string& failure() const { return failure_; }

  /// Takes a new picture. It must be as large as the window.
  void update(const sturnus::Image& image);
  void set_title(const std::string& title);
  /// Shows the picture that was taken last.
  void present();

 private:
  struct Closer {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
  };
  std::string open(sturnus::Size size);

  std::unique_ptr<SDL_Window, Closer> window_;
  std::unique_ptr<SDL_Renderer, Closer> renderer_;
  std::unique_ptr<SDL_Texture, Closer> texture_;
  std::string failure_;  // made last: opening fills the three above
};

}  // namespace prog06
