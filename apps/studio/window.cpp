// Opening the window, with sentences for what may be missing.
#include "window.h"

#include <epoxy/gl.h>

namespace studio {
namespace {

sturnus::Problem sdl_problem(const std::string& what) {
  return {"", 0, "", what + " (" + SDL_GetError() + ")", false};
}

// The view has several samples a pixel where it needs them; the window needs none.
void ask_for_context() {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
}

}  // namespace

sturnus::Result<Window> Window::open(const std::string& title, sturnus::Size points, bool resizable) {
  SDL_SetMainReady();
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_TIMER) != 0)
    return sdl_problem(
        "there is no display to open a window on; pictures and videos need none: sturnus render");
  Window window;
  window.library_ = std::make_unique<Library>();
  Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI;
  if (resizable) flags |= SDL_WINDOW_RESIZABLE;
  ask_for_context();
  window.window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                        points.width, points.height, flags));
  if (window.window_) window.context_.reset(SDL_GL_CreateContext(window.window_.get()));
  if (!window.window_) return sdl_problem("the window could not be opened");
  if (!window.context_ || epoxy_gl_version() < 33)
    return sdl_problem("the studio needs OpenGL 3.3, which this display does not have");
  window.has_pace_ = SDL_GL_SetSwapInterval(1) == 0 && SDL_GL_GetSwapInterval() != 0;
  return window;
}

sturnus::Size Window::pixels() const {
  sturnus::Size size;
  SDL_GL_GetDrawableSize(window_.get(), &size.width, &size.height);
  return size;
}

sturnus::Size Window::points() const {
  sturnus::Size size;
  SDL_GetWindowSize(window_.get(), &size.width, &size.height);
  return size;
}

float Window::density() const {
  return static_cast<float>(pixels().height) / static_cast<float>(points().height);
}

void Window::set_title(const std::string& title) {
  SDL_SetWindowTitle(window_.get(), title.c_str());
}

void Window::present() {
  SDL_GL_SwapWindow(window_.get());
}

}  // namespace studio
