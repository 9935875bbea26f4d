// The look of panels.
#include "panels/style.h"

#include <algorithm>

namespace studio {
namespace {

constexpr float text_points = 15, caption_points = 24;

// The captions' letters are the second font of the atlas.
constexpr int caption_index = 1;

// Letters, and the few signs that buttons wear.
constexpr ImWchar glyph_ranges[] = {0x20,   0xff,   0x2000, 0x206f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x2300,
                                    0x23ff, 0x25a0, 0x25ff, 0x2600, 0x26ff, 0x0370, 0x03ff, 0};
constexpr ImWchar caption_ranges[] = {0x20, 0xff, 0x2000, 0x206f, 0x2190, 0x2193, 0};

}  // namespace

const Palette& palette(sturnus::ThemeName theme) {
  using sturnus::rgb;
  static const Palette dark{rgb(0x0f1419), rgb(0x161d24), rgb(0x212b34), rgb(0x2b3640),
                            rgb(0xe6edf3), rgb(0x8b98a5), rgb(0x56b4e9), rgb(0xd55e00)};
  static const Palette light{rgb(0xffffff), rgb(0xf6f8fa), rgb(0xe8ecf0), rgb(0xd0d7de),
                             rgb(0x1f2328), rgb(0x656d76), rgb(0x0072b2), rgb(0xc04a00)};
  return theme == sturnus::ThemeName::dark ? dark : light;
}

ImVec4 to_imgui(sturnus::Rgba colour) {
  return {static_cast<float>(colour.r) / 255, static_cast<float>(colour.g) / 255,
          static_cast<float>(colour.b) / 255, static_cast<float>(colour.a) / 255};
}

ImU32 packed(sturnus::Rgba colour) {
  return IM_COL32(colour.r, colour.g, colour.b, colour.a);
}

namespace {

void set_measures(ImGuiStyle& style) {
  style.WindowRounding = style.ChildRounding = style.FrameRounding = style.PopupRounding = 6;
  style.GrabRounding = style.ScrollbarRounding = style.TabRounding = 6;
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowPadding = {12, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {4, 4};
  style.IndentSpacing = 12;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowMinSize = {8, 8};
  style.WindowTitleAlign = {0, 0.5f};
}

void set_colours(ImGuiStyle& style, const Palette& colours) {
  const auto set = [&](ImGuiCol which, sturnus::Rgba colour, float alpha = 1) {
    style.Colors[which] = to_imgui(sturnus::with_alpha(colour, alpha));
  };
  for (int i = 0; i < ImGuiCol_COUNT; ++i) set(i, colours.raised);
  set(ImGuiCol_Text, colours.text);
  set(ImGuiCol_TextDisabled, colours.faint);
  set(ImGuiCol_WindowBg, colours.surface, 0.94f);
  set(ImGuiCol_ChildBg, colours.surface, 0);
  set(ImGuiCol_PopupBg, colours.surface, 0.98f);
  set(ImGuiCol_Border, colours.outline);
  set(ImGuiCol_BorderShadow, colours.outline, 0);
  set(ImGuiCol_FrameBgHovered, colours.outline);
  set(ImGuiCol_FrameBgActive, colours.outline);
  set(ImGuiCol_ScrollbarBg, colours.surface, 0);
  set(ImGuiCol_ScrollbarGrab, colours.outline);
  set(ImGuiCol_ScrollbarGrabHovered, colours.faint);
  set(ImGuiCol_ScrollbarGrabActive, colours.faint);
  set(ImGuiCol_CheckMark, colours.accent);
  set(ImGuiCol_SliderGrab, colours.accent, 0.6f);  // numbers stand above it
  set(ImGuiCol_SliderGrabActive, colours.accent);
  set(ImGuiCol_Button, colours.raised);
  set(ImGuiCol_ButtonHovered, colours.outline);
  set(ImGuiCol_ButtonActive, colours.accent, 0.5f);
  set(ImGuiCol_Header, colours.raised);
  set(ImGuiCol_HeaderHovered, colours.outline);
  set(ImGuiCol_HeaderActive, colours.accent, 0.4f);
  set(ImGuiCol_Separator, colours.outline);
  set(ImGuiCol_ResizeGrip, colours.outline, 0);
  set(ImGuiCol_TextSelectedBg, colours.accent, 0.35f);
  set(ImGuiCol_NavHighlight, colours.accent);
  set(ImGuiCol_PlotLines, colours.accent);
}

}  // namespace

void apply_style(sturnus::ThemeName theme, float scale) {
  ImGuiStyle style;
  set_measures(style);
  set_colours(style, palette(theme));
  style.ScaleAllSizes(scale);
  style.AntiAliasedLinesUseTex = false;
  ImGui::GetStyle() = style;
}

void load_font(float scale, float density) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const auto font = sturnus::picture_font();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = density > 1.5f ? 1 : 2;
  const float pixels = std::max(8.0f, text_points * scale * density);
  if (font.empty()) {
    io.Fonts->AddFontDefault();
  } else {
    auto* bytes = const_cast<unsigned char*>(font.data());
    const int count = static_cast<int>(font.size());
    io.Fonts->AddFontFromMemoryTTF(bytes, count, pixels, &config, glyph_ranges);
    io.Fonts->AddFontFromMemoryTTF(bytes, count, caption_points * density, &config, caption_ranges);
  }
  io.FontGlobalScale = 1 / density;
}

ImFont* caption_font() {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  return fonts[std::min(caption_index, fonts.Size - 1)];
}

}  // namespace studio
