// How panels look: one font, one accent, a grid of four points, corners of six.
#pragma once

#include <imgui.h>
#include <sturnus/colour.h>
#include <sturnus/picture.h>

namespace studio {

/// The colours that panels share with the view.
struct Palette {
  sturnus::Rgba background, surface, raised, outline, text, faint, accent, problem;
};
const Palette& palette(sturnus::ThemeName theme);

ImVec4 to_imgui(sturnus::Rgba colour);
ImU32 packed(sturnus::Rgba colour);

/// Colours and measures of every widget, for text `scale` times its usual size.
void apply_style(sturnus::ThemeName theme, float scale);
/// Letters for a display with so many pixels a point.
void load_font(float scale, float density);
/// Larger letters for the captions of films.
ImFont* caption_font();

}  // namespace studio
