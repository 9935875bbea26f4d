// SDL: a streaming texture in a window.
#include "window.h"

#include <cstdlib>
#include <string_view>

namespace prog06 {
namespace {

std::string reason(const std::string& what) {
  const std::string_view why = SDL_GetError();
  return "prog06: " + what + (why.empty() ? "" : ": " + std::string(why));
}

// SDL falls back to drivers that show nothing. That is fine for whoever asked for one, and no window
// otherwise.
bool shows_nothing() {
  const char* driver = SDL_GetCurrentVideoDriver();
  if (driver == nullptr) return true;
  const std::string_view name = driver;
  return (name == "offscreen" || name == "dummy" || name == "evdev") &&
         std::getenv("SDL_VIDEODRIVER") == nullptr;
}

}  // namespace

Window::Window(sturnus::Size size) : failure_(open(size)) {}

Window::~Window() {
  texture_.reset();
  renderer_.reset();
  window_.reset();
  SDL_Quit();
}

std::string Window::open(sturnus::Size size) {
  // Otherwise SDL would load OpenGL only to copy a finished picture.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) return reason("there is no display to open a window on");
  if (shows_nothing()) return "prog06: there is no display to open a window on";
  // A window that rests most of the time keeps nobody's desktop from its effects, and no screen awake.
  SDL_EnableScreenSaver();
  window_.reset(SDL_CreateWindow("prog06", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, size.width,
                                 size.height, SDL_WINDOW_SHOWN));
  if (!window_) return reason("the window can't be opened");
  // The pixels come from the processor anyway, and the software renderer shows them unchanged everywhere.
  renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
  if (!renderer_) renderer_.reset(SDL_CreateRenderer(window_.get(), -1, 0));
  if (!renderer_) return reason("nothing can be drawn in the window");
  // Where somebody makes the window larger all the same, the picture keeps its shape.
  SDL_RenderSetLogicalSize(renderer_.get(), size.width, size.height);
  texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING,
                                   size.width, size.height));
  return texture_ ? "" : reason("the window has no room for a picture");
}

void Window::update(const sturnus::Image& image) {
  SDL_UpdateTexture(texture_.get(), nullptr, image.rgb.data(), image.width * 3);
}

void Window::set_title(const std::string& title) {
  SDL_SetWindowTitle(window_.get(), title.c_str());
}

void Window::present() {
  SDL_RenderClear(renderer_.get());
  SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
  SDL_RenderPresent(renderer_.get());
}

}  // namespace prog06
