// The hand of a scripted visit: events for SDL, and the cursor and captions that films show.
#include <SDL.h>

#include <algorithm>
#include <cmath>

#include "panels/style.h"
#include "script/player.h"

namespace studio {
namespace {

constexpr double fading_seconds = 0.3;
constexpr float caption_height = 0.645f;  // of the window, above the notes

// A small arrow that points to the upper left.
const ImVec2 arrow[] = {{0, 0}, {0, 17}, {4, 13.5f}, {6.6f, 19.5f}, {9.4f, 18.2f}, {6.9f, 12.4f}, {12, 12}};

void push_key(KeyPress press, bool down) {
  SDL_SetModState(static_cast<SDL_Keymod>(down ? press.mod : KMOD_NONE));
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.key.keysym.sym = press.sym;
  event.key.keysym.scancode = SDL_GetScancodeFromKey(press.sym);
  event.key.keysym.mod = static_cast<Uint16>(down ? press.mod : KMOD_NONE);
  SDL_PushEvent(&event);
}

void push_text(const std::string& letter) {
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  std::copy_n(letter.begin(), std::min(letter.size(), sizeof event.text.text - 1), event.text.text);
  SDL_PushEvent(&event);
}

// The bytes of the letter that begins there, in UTF-8.
std::string letter_at(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
  return text.substr(at, end - at);
}

}  // namespace

void Player::press_key(const std::vector<std::string>& words) {
  const KeyPress press = key_of(words[1]);
  beats_.emplace_back([press] { push_key(press, true); });
  rest(2);
  beats_.emplace_back([press] { push_key(press, false); });
  rest(4);
}

void Player::type(const std::vector<std::string>& words) {
  for (std::size_t at = 0; at < words[1].size();) {
    const std::string letter = letter_at(words[1], at);
    beats_.emplace_back([letter] { push_text(letter); });
    rest(4);
    at += letter.size();
  }
}

void Player::push_motion(Spot to) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<int>(std::lround(to.x));
  event.motion.y = static_cast<int>(std::lround(to.y));
  event.motion.xrel = event.motion.x - static_cast<int>(std::lround(cursor_.x));
  event.motion.yrel = event.motion.y - static_cast<int>(std::lround(cursor_.y));
  SDL_PushEvent(&event);
  cursor_ = to;
}

void Player::push_button(int button, bool down, int mod) {
  SDL_SetModState(static_cast<SDL_Keymod>(down ? mod : KMOD_NONE));
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = static_cast<Uint8>(button);
  event.button.state = down ? SDL_PRESSED : SDL_RELEASED;
  event.button.clicks = 1;
  event.button.x = static_cast<int>(std::lround(cursor_.x));
  event.button.y = static_cast<int>(std::lround(cursor_.y));
  SDL_PushEvent(&event);
  is_pressed_ = down;
}

void Player::draw_overlay() const {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  ImVec2 corners[std::size(arrow)];
  for (std::size_t i = 0; i < std::size(arrow); ++i)
    corners[i] = {cursor_.x + arrow[i].x, cursor_.y + arrow[i].y};
  if (is_pressed_) list.AddCircle({cursor_.x, cursor_.y}, 14, IM_COL32(255, 255, 255, 150), 0, 3);
  const ImVec2 body[] = {corners[0], corners[1], corners[6]};
  const ImVec2 tail[] = {corners[2], corners[3], corners[4], corners[5]};
  list.AddConvexPolyFilled(body, 3, IM_COL32_WHITE);
  list.AddConvexPolyFilled(tail, 4, IM_COL32_WHITE);
  list.AddPolyline(corners, static_cast<int>(std::size(arrow)), IM_COL32(0, 0, 0, 255), ImDrawFlags_Closed,
                   1.4f);
  draw_caption();
}

void Player::draw_caption() const {
  const Desk& desk = studio_.desk();
  const double left = caption_end_ - desk.seconds;
  if (caption_.empty() || left <= 0) return;
  const auto alpha = static_cast<float>(std::min(1.0, left / fading_seconds));
  ImFont* font = caption_font();
  const float size = 24, width = desk.layout.world.width * 0.8f;
  const ImVec2 extent = font->CalcTextSizeA(size, width, width, caption_.c_str());
  const ImVec2 at((desk.layout.world.width - extent.x) / 2,
                  desk.layout.world.height * caption_height - extent.y / 2);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const auto faded = [&](int shade, float full) {
    return IM_COL32(shade, shade, shade, static_cast<int>(full * alpha));
  };
  list.AddRectFilled({at.x - 20, at.y - 10}, {at.x + extent.x + 20, at.y + extent.y + 10}, faded(0, 190), 8);
  list.AddText(font, size, at, faded(255, 255), caption_.c_str(), nullptr, width);
}

}  // namespace studio
