// Recording of lines and text.
#include "draw/canvas.h"

#include <cmath>

namespace sturnus {

void Canvas::line(float x0, float y0, float x1, float y1, float width, Rgba colour) {
  const float alpha = static_cast<float>(colour.a) / 255.0f;
  add(LineShape{{x0, y0, on_top}, {x1, y1, on_top}, width, colour, alpha, alpha});
}

void Canvas::text(std::string_view text, float x, float y, float size, Rgba colour, Align align) {
  // Far outside there is nothing to see, and the conversion to int below has to be safe.
  if (!(std::abs(x) < 1e5f) || !(std::abs(y) < 1e5f) || text.empty() || !has_font()) return;
  const float width = align == Align::left ? 0 : text_width(text, size);
  const float start = align == Align::left ? x : align == Align::right ? x - width : x - 0.5f * width;
  const float whole = std::floor(start);
  // Baselines sit on whole pixels: the feet of the letters stay sharp.
  const float baseline = std::floor(y + 0.5f * capital_height(size) + 0.5f);
  texts_.push_back(
      {text_ink(text, size, start - whole), static_cast<int>(whole), static_cast<int>(baseline), colour});
}

}  // namespace sturnus
