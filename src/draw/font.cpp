// Text with stb_truetype over the embedded font; draws nothing where either is missing.
#include "draw/font.h"

#include <sturnus/picture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#if __has_include(<stb/stb_truetype.h>)
#define STURNUS_HAS_STB_TRUETYPE 1
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
#endif

namespace sturnus {
namespace {

constexpr float largest_size = 512;  // pixels; a bound for memory, far above any picture's text

// One code point from the front of `text`, which must not be empty.
char32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 0;
  char32_t code = length == 1   ? first
                  : length == 2 ? first & 0x1fu
                  : length == 3 ? first & 0x0fu
                                : first & 0x07u;
  bool good = length > 0 && text.size() >= length;
  for (std::size_t i = 1; good && i < length; ++i) {
    good = (byte(i) & 0xc0) == 0x80;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  text.remove_prefix(good ? length : 1);
  return good ? code : U'\ufffd';
}

}  // namespace

#ifdef STURNUS_HAS_STB_TRUETYPE

namespace {

struct Face {
  stbtt_fontinfo info{};
  bool usable = false;
};

// Parsed at the first text; the language makes that safe from several threads.
const Face& face() {
  static const Face made = [] {
    Face fresh;
    fresh.usable = embedded_font_size > 0 && stbtt_InitFont(&fresh.info, embedded_font, 0) != 0;
    return fresh;
  }();
  return made;
}

float scale_for(float size) {
  return stbtt_ScaleForPixelHeight(&face().info, std::clamp(size, 1.0f, largest_size));
}

struct Letter {
  int glyph;
  float x;  // pixels from the start of the line
};

// Glyphs in a line with their places, and the advance of the whole line.
float lay_out(std::string_view text, float size, std::vector<Letter>* letters) {
  const stbtt_fontinfo* info = &face().info;
  const float scale = scale_for(size);
  float x = 0;
  int previous = 0;
  while (!text.empty()) {
    const int glyph = stbtt_FindGlyphIndex(info, static_cast<int>(take_code_point(text)));
    if (previous != 0) x += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(info, previous, glyph));
    if (letters != nullptr) letters->push_back({glyph, x});
    int advance = 0;
    int bearing = 0;
    stbtt_GetGlyphHMetrics(info, glyph, &advance, &bearing);
    x += scale * static_cast<float>(advance);
    previous = glyph;
  }
  return x;
}

// Adds one letter to the line; where letters touch, their ink adds up to full black.
void add_letter(const Letter& letter, float scale, float shift, TextInk& ink) {
  const float place = letter.x + shift;
  const float whole = std::floor(place);
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  stbtt_GetGlyphBitmapBoxSubpixel(&face().info, letter.glyph, scale, scale, place - whole, 0, &x0, &y0, &x1,
                                  &y1);
  const int width = x1 - x0;
  const int height = y1 - y0;
  if (width <= 0 || height <= 0) return;
  std::vector<std::uint8_t> cover(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  stbtt_MakeGlyphBitmapSubpixel(&face().info, cover.data(), width, height, width, scale, scale, place - whole,
                                0, letter.glyph);
  for (int row = 0; row < height; ++row) {
    const int y = y0 + row - ink.top;
    for (int column = 0; column < width; ++column) {
      const int x = static_cast<int>(whole) + x0 + column - ink.left;
      if (x < 0 || y < 0 || x >= ink.width || y >= ink.height) continue;
      auto& target = ink.cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(ink.width) +
                               static_cast<std::size_t>(x)];
      const int sum = target + cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(column)];
      target = static_cast<std::uint8_t>(std::min(sum, 255));
    }
  }
}

}  // namespace

std::span<const unsigned char> picture_font() {
  return {embedded_font, static_cast<std::size_t>(embedded_font_size)};
}

bool has_font() {
  return face().usable;
}

float text_width(std::string_view text, float size) {
  return has_font() ? lay_out(text, size, nullptr) : 0;
}

float capital_height(float size) {
  if (!has_font()) return 0;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  stbtt_GetCodepointBox(&face().info, 'H', &x0, &y0, &x1, &y1);
  return scale_for(size) * static_cast<float>(y1);
}

TextInk text_ink(std::string_view text, float size, float shift) {
  TextInk ink;
  if (!has_font() || text.empty()) return ink;
  std::vector<Letter> letters;
  const float advance = lay_out(text, size, &letters);
  const float scale = scale_for(size);
  int ascent = 0, descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&face().info, &ascent, &descent, &gap);
  // One pixel to spare on every side, and some to the right for letters that lean over their advance.
  ink.left = -2;
  ink.top = -static_cast<int>(std::ceil(scale * static_cast<float>(ascent))) - 1;
  ink.width = static_cast<int>(std::ceil(advance)) + 5;
  ink.height = static_cast<int>(std::ceil(scale * static_cast<float>(-descent))) + 1 - ink.top;
  ink.cover.assign(static_cast<std::size_t>(ink.width) * static_cast<std::size_t>(ink.height), 0);
  for (const Letter& letter : letters) add_letter(letter, scale, shift, ink);
  return ink;
}

#else  // no stb_truetype: every text is empty

bool has_font() {
  return false;
}
float text_width(std::string_view, float) {
  return 0;
}
float capital_height(float) {
  return 0;
}
TextInk text_ink(std::string_view, float, float) {
  return {};
}

#endif

}  // namespace sturnus
