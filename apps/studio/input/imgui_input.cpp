// From SDL's scancodes and buttons to ImGui's.
#include "input/imgui_input.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

namespace studio {
namespace {

constexpr std::pair<ImGuiKey, SDL_Scancode> keys[] = {
    {ImGuiKey_Tab, SDL_SCANCODE_TAB},
    {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
    {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
    {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
    {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
    {ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
    {ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
    {ImGuiKey_Home, SDL_SCANCODE_HOME},
    {ImGuiKey_End, SDL_SCANCODE_END},
    {ImGuiKey_Insert, SDL_SCANCODE_INSERT},
    {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
    {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
    {ImGuiKey_Space, SDL_SCANCODE_SPACE},
    {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
    {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
    {ImGuiKey_KeyPadEnter, SDL_SCANCODE_KP_ENTER},
    {ImGuiKey_A, SDL_SCANCODE_A},
    {ImGuiKey_C, SDL_SCANCODE_C},
    {ImGuiKey_V, SDL_SCANCODE_V},
    {ImGuiKey_X, SDL_SCANCODE_X},
    {ImGuiKey_Y, SDL_SCANCODE_Y},
    {ImGuiKey_Z, SDL_SCANCODE_Z},
};

const char* clipboard(void*) {
  static std::string text;
  char* given = SDL_GetClipboardText();
  text = given == nullptr ? "" : given;
  SDL_free(given);
  return text.c_str();
}

// SDL's left, right, middle as ImGui numbers them; -1 for others.
int button_of(Uint8 button) {
  if (button == SDL_BUTTON_LEFT) return 0;
  if (button == SDL_BUTTON_RIGHT) return 1;
  return button == SDL_BUTTON_MIDDLE ? 2 : -1;
}

}  // namespace

ImguiInput::ImguiInput() {
  ImGuiIO& io = ImGui::GetIO();
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
  io.GetClipboardTextFn = clipboard;
  io.SetClipboardTextFn = [](void*, const char* text) { SDL_SetClipboardText(text); };
  io.MousePos = {-1e9f, -1e9f};
}

void ImguiInput::hear(const SDL_Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION:
      io.MousePos = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
      break;
    case SDL_MOUSEWHEEL:
      io.MouseWheel += static_cast<float>(event.wheel.y);
      io.MouseWheelH += static_cast<float>(event.wheel.x);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      hear_button(event.button);
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      hear_key(event.key);
      break;
    case SDL_TEXTINPUT:
      io.AddInputCharactersUTF8(event.text.text);
      break;
    default:
      break;
  }
}

void ImguiInput::hear_button(const SDL_MouseButtonEvent& button) {
  ImGui::GetIO().MousePos = {static_cast<float>(button.x), static_cast<float>(button.y)};
  const int which = button_of(button.button);
  if (which < 0) return;
  is_down_[which] = button.type == SDL_MOUSEBUTTONDOWN;
  if (is_down_[which]) was_pressed_[which] = true;
}

void ImguiInput::hear_key(const SDL_KeyboardEvent& key) {
  ImGuiIO& io = ImGui::GetIO();
  const auto code = static_cast<std::size_t>(key.keysym.scancode);
  if (code < std::size(io.KeysDown)) io.KeysDown[code] = key.type == SDL_KEYDOWN;
  const int mod = key.keysym.mod;
  io.KeyCtrl = (mod & KMOD_CTRL) != 0;
  io.KeyShift = (mod & KMOD_SHIFT) != 0;
  io.KeyAlt = (mod & KMOD_ALT) != 0;
  io.KeySuper = (mod & KMOD_GUI) != 0;
}

void ImguiInput::begin_frame(sturnus::Size points, sturnus::Size pixels, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(points.width), static_cast<float>(points.height)};
  io.DisplayFramebufferScale = {static_cast<float>(pixels.width) / io.DisplaySize.x,
                                static_cast<float>(pixels.height) / io.DisplaySize.y};
  io.DeltaTime = std::max(1e-4f, static_cast<float>(seconds));
  for (int i = 0; i < 3; ++i) io.MouseDown[i] = std::exchange(was_pressed_[i], false) || is_down_[i];
}

}  // namespace studio
