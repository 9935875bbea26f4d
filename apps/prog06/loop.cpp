// One turn of the loop is one frame: events, perhaps a step, perhaps a new picture, and a rest.
#include "loop.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ratio>
#include <thread>

#include "flock.h"
#include "picture_file.h"

namespace prog06 {
Loop::Loop(const Choices& choices, sturnus::Simulation& flock, Window& window)
    : flock_(flock), window_(window), scene_(choices), picture_(choices.picture), keys_(choices.keys) {
  scene_.follow(flock_.view());
}

bool Loop::run() {
  while (!quit_) {
    if (is_waiting()) {
      SDL_WaitEvent(nullptr);
      next_frame_ = Clock::now();
    }
    press_next_key();
    handle_events();
    if (quit_) break;
    if (animating_) step();
    if (updated_) redraw();
    window_.present();
    rest();
  }
  return all_written_;
}

// Sleeps until the next frame is due. Frames that are late are not made up for.
void Loop::rest() {
  using Frames = std::chrono::duration<std::int64_t, std::ratio<1, 60>>;
  next_frame_ = std::max(next_frame_ + std::chrono::duration_cast<Clock::duration>(Frames(1)), Clock::now());
  std::this_thread::sleep_until(next_frame_);
}

// Keys of --keys go the way of all keys.
void Loop::press_next_key() {
  if (keys_.empty()) return;
  const char key = keys_.front();
  keys_.erase(keys_.begin());
  if (key == ' ') return;
  SDL_Event event{};
  event.type = SDL_KEYDOWN;
  event.key.state = SDL_PRESSED;
  event.key.keysym.sym = key;  // SDL's codes of these keys are their characters
  SDL_PushEvent(&event);
}

void Loop::handle_events() {
  SDL_Event event;
  while (!quit_ && SDL_PollEvent(&event) != 0) handle(event);
}

void Loop::handle(const SDL_Event& event) {
  switch (event.type) {
    case SDL_QUIT:
      quit_ = true;
      break;
    case SDL_KEYDOWN:
      handle_key(event.key);
      break;
    case SDL_MOUSEBUTTONDOWN:
      mode_ = event.button.button == SDL_BUTTON_RIGHT ? sturnus::PointerMode::repel
                                                      : sturnus::PointerMode::attract;
      hold_at(event.button.x, event.button.y, true);
      break;
    case SDL_MOUSEMOTION:
      if (holding_) hold_at(event.motion.x, event.motion.y, true);
      break;
    case SDL_MOUSEBUTTONUP:
      if (holding_) hold_at(event.button.x, event.button.y, false);
      break;
    default:
      break;
  }
}

void Loop::handle_key(const SDL_KeyboardEvent& key) {
  const bool again = key.repeat != 0;  // a key held down: only steps repeat
  switch (key.keysym.sym) {
    case SDLK_a:
      if (!again) animating_ = !animating_;
      break;
    case SDLK_s:
      step();
      break;
    case SDLK_w:
      if (!again) write();
      break;
    case SDLK_q:
    case SDLK_ESCAPE:
      quit_ = true;
      break;
    default:
      break;
  }
}

void Loop::hold_at(int x, int y, bool pressed) {
  const auto place = scene_.place_under(x, y);
  if (!place && pressed) return;
  hold(flock_, mode_, place.value_or(sturnus::Point3{}), pressed);
  holding_ = pressed;
  updated_ = true;
}

void Loop::step() {
  flock_.step();
  scene_.follow(flock_.view());
  updated_ = true;
}

void Loop::redraw() {
  shown_ = scene_.picture(flock_.view());
  window_.update(shown_);
  window_.set_title("prog06: " + std::to_string(flock_.view().size()) + " boids, step " +
                    std::to_string(flock_.step_number()));
  updated_ = false;
}

// Writes what the window shows; a step of this frame is shown first.
void Loop::write() {
  if (updated_) redraw();
  if (const sturnus::Status status = write_picture(picture_, shown_); !status) {
    std::fputs(status.error().c_str(), stderr);
    all_written_ = false;
    return;
  }
  std::printf("%s: step %llu\n", picture_.c_str(), static_cast<unsigned long long>(flock_.step_number()));
  std::fflush(stdout);
}

}  // namespace prog06
