// What keys and the mouse mean to the studio, where no panel wants them.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "studio.h"

namespace studio {
namespace {

constexpr float zoom_per_notch = 1.15f;
constexpr float text_per_press = 1.1f;
constexpr float least_width = 520, least_height = 380;  // points that panels need at the usual size of text
constexpr float flight_per_second = 0.8f;               // of the distance to the middle

bool is_command(const SDL_Keysym& key) {
  return (key.mod & (KMOD_CTRL | KMOD_GUI)) != 0;
}

// While the right button is held these are no shortcuts, whether Shift is still down or not.
bool is_for_flight(SDL_Keycode key) {
  return key == SDLK_w || key == SDLK_a || key == SDLK_s || key == SDLK_d || key == SDLK_q || key == SDLK_e;
}

// Whether a panel of the frame before lies there. Dear ImGui tells it of the mouse alone, and only in the
// next frame, which is too late for a press that comes with the motion to it.
bool is_on_panel(const SDL_MouseButtonEvent& button) {
  const ImVec2 at{static_cast<float>(button.x), static_cast<float>(button.y)};
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    const bool is_there = window->WasActive && !window->Hidden && !window->IsFallbackWindow;
    if (is_there && (window->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
        window->OuterRectClipped.Contains(at))
      return true;
  }
  return false;
}

}  // namespace

void Studio::hear(const SDL_Event& event) {
  input_.hear(event);
  switch (event.type) {
    case SDL_QUIT:
      desk_.wants_quit = true;
      break;
    case SDL_KEYDOWN:
      if (!ImGui::GetIO().WantTextInput) hear_key(event.key);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      hear_button(event.button);
      break;
    case SDL_MOUSEMOTION:
      hear_motion(event.motion);
      break;
    case SDL_MOUSEWHEEL:
      hear_wheel(event.wheel);
      break;
    case SDL_DROPFILE:
      hear_drop(event.drop.file);
      break;
    default:
      break;
  }
}

void Studio::hear_drop(char* path) {
  if (path != nullptr) desk_.files.drop(desk_, path);
  SDL_free(path);
}

void Studio::hear_key(const SDL_KeyboardEvent& key) {
  if (is_command(key.keysym)) return hear_command_key(key.keysym);
  const bool repeats = key.repeat != 0;  // held down: only steps and counts repeat
  const SDL_Keycode code = key.keysym.sym;
  const bool may_repeat =
      code == SDLK_PERIOD || code == SDLK_UP || code == SDLK_DOWN || code == SDLK_LEFT || code == SDLK_RIGHT;
  if (!repeats || may_repeat) hear_plain_key(key.keysym);
}

void Studio::hear_command_key(const SDL_Keysym& key) {
  const bool shift = (key.mod & KMOD_SHIFT) != 0;
  const auto order = [&](bool (World::*what)()) {
    session_.order([what](World& world) {
      (world.*what)();
      return sturnus::Status();
    });
  };
  switch (key.sym) {
    case SDLK_z:
      return order(shift ? &World::redo : &World::undo);
    case SDLK_y:
      return order(&World::redo);
    case SDLK_PLUS:
    case SDLK_EQUALS:
    case SDLK_KP_PLUS:
      return set_text_scale(desk_.text_scale * text_per_press);
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
      return set_text_scale(desk_.text_scale / text_per_press);
    case SDLK_0:
      return set_text_scale(1);
    case SDLK_c:
      return desk_.files.copy(desk_);
    case SDLK_v:
      return desk_.files.paste(desk_);
    case SDLK_q:
      desk_.wants_quit = true;
      return;
    default:
      return;
  }
}

void Studio::hear_plain_key(const SDL_Keysym& key) {
  if (drag_ == Drag::look && is_for_flight(key.sym)) return;
  for (const ToolInfo& info : tool_list()) {
    if (info.tool != Tool::scatter && key.sym == info.key) desk_.tools.tool = info.tool;
  }
  switch (key.sym) {
    case SDLK_s:
      desk_.tools.tool = Tool::scatter;
      if (desk_.hand.in_view) desk_.tools.scatter(desk_.hand, *desk_.frame, desk_.camera, session_);
      break;
    case SDLK_ESCAPE:
      desk_.tools.tool = Tool::hand;
      desk_.open.help = desk_.open.gallery = false;
      break;
    case SDLK_SPACE:
    case SDLK_a:
      desk_.playback.play(!desk_.playback.is_playing());
      break;
    case SDLK_PERIOD:
      desk_.playback.play(false);
      desk_.playback.step_once();
      break;
    case SDLK_w:
      wants_picture_ = true;
      break;
    case SDLK_t:
      toggle_tracking();
      break;
    case SDLK_g:
      desk_.open.gallery = !desk_.open.gallery;
      break;
    case SDLK_r:
      desk_.toggle_recording();
      break;
    case SDLK_f:
      fit_camera();
      break;
    case SDLK_UP:
      desk_.tools.power = std::min(desk_.tools.power + 1, Tools::most_power);
      break;
    case SDLK_DOWN:
      desk_.tools.power = std::max(desk_.tools.power - 1, 0);
      break;
    case SDLK_LEFT:
    case SDLK_RIGHT:
      if (desk_.is_tracking) {
        session_.order([direction = key.sym == SDLK_LEFT ? -1 : 1](World& world) {
          world.track_next(direction);
          return sturnus::Status();
        });
      }
      break;
    case SDLK_QUESTION:
    case SDLK_F1:
      desk_.open.help = !desk_.open.help;
      break;
    case SDLK_SLASH:
      if ((key.mod & KMOD_SHIFT) != 0) desk_.open.help = !desk_.open.help;
      break;
    default:
      break;
  }
}

void Studio::place_hand(int x, int y) {
  desk_.hand.x = static_cast<float>(x) * desk_.density;
  desk_.hand.y = static_cast<float>(y) * desk_.density;
}

void Studio::hear_button(const SDL_MouseButtonEvent& button) {
  place_hand(button.x, button.y);
  const bool down = button.type == SDL_MOUSEBUTTONDOWN;
  if (!down) {
    if (drag_ == Drag::tool) desk_.tools.release(desk_.hand, *desk_.frame, desk_.camera, session_);
    drag_ = Drag::none;
    return;
  }
  const bool is_on_world = desk_.hand.in_view && !is_on_panel(button);
  if (!is_on_world || drag_ != Drag::none) return;
  const SDL_Keymod mod = SDL_GetModState();
  const bool left = button.button == SDL_BUTTON_LEFT, right = button.button == SDL_BUTTON_RIGHT;
  if (button.button == SDL_BUTTON_MIDDLE || (left && (mod & KMOD_ALT) != 0)) {
    drag_ = Drag::orbit;
  } else if (right && (mod & KMOD_SHIFT) != 0) {
    drag_ = Drag::look;
  } else if (left || right) {
    drag_ = Drag::tool;
    desk_.tools.press(desk_.hand, right, *desk_.frame, desk_.camera, session_);
  }
}

void Studio::hear_motion(const SDL_MouseMotionEvent& motion) {
  const float dx = static_cast<float>(motion.xrel) * desk_.density,
              dy = static_cast<float>(motion.yrel) * desk_.density;
  place_hand(motion.x, motion.y);
  if (drag_ == Drag::orbit) desk_.camera.orbit(dx, dy);
  if (drag_ == Drag::look) desk_.camera.look(dx, dy);
  if (drag_ == Drag::none || drag_ == Drag::tool)
    desk_.tools.move(desk_.hand, *desk_.frame, desk_.camera, session_);
}

void Studio::hear_wheel(const SDL_MouseWheelEvent& wheel) {
  if (!desk_.hand.in_view) return;
  const float factor = std::pow(zoom_per_notch, static_cast<float>(wheel.y));
  if ((SDL_GetModState() & KMOD_CTRL) != 0) {
    desk_.tools.radius *= factor;
  } else {
    desk_.camera.zoom(factor, desk_.hand.x, desk_.hand.y);
  }
}

// W, A, S, D while Shift and the right button are held.
void Studio::fly(double seconds) {
  if (drag_ != Drag::look || (SDL_GetModState() & KMOD_SHIFT) == 0) return;
  const auto& down = ImGui::GetIO().KeysDown;
  const auto axis = [&](SDL_Scancode back, SDL_Scancode on) {
    return (static_cast<float>(down[on]) - static_cast<float>(down[back])) * flight_per_second *
           static_cast<float>(seconds);
  };
  desk_.camera.fly(axis(SDL_SCANCODE_A, SDL_SCANCODE_D), axis(SDL_SCANCODE_Q, SDL_SCANCODE_E),
                   axis(SDL_SCANCODE_S, SDL_SCANCODE_W));
}

void Studio::set_text_scale(float scale) {
  const sturnus::Size points = window_.points();
  const float most = std::min(static_cast<float>(points.width) / least_width,
                              static_cast<float>(points.height) / least_height);
  desk_.text_scale = std::clamp(scale, 0.6f, std::clamp(most, 1.0f, 2.5f));
}

}  // namespace studio
