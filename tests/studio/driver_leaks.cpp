// The leak checker's question whether to stay away: a software OpenGL driver is unloaded with memory that it
// never freed, which nothing tells from ours any more. Only tests that opened a window are excused.
#include <cstdlib>

extern "C" int __lsan_is_turned_off();

// Tests name a video driver before they open a window.
extern "C" int __lsan_is_turned_off() {
  return std::getenv("SDL_VIDEODRIVER") != nullptr ? 1 : 0;
}
