// Copies pictures into a grid and writes their captions.
#include "draw/sheet.h"

#include <algorithm>
#include <cstddef>

#include "draw/raster.h"

namespace sturnus {
namespace {

// Pixels.
constexpr int gap = 12;
constexpr int caption_height = 26;
constexpr float caption_size = 13;

void copy_into(const Image& picture, int left, int top, Image& sheet) {
  for (int y = 0; y < picture.height; ++y) {
    const auto from = picture.rgb.begin() + static_cast<std::ptrdiff_t>(picture.offset(0, y));
    std::copy(from, from + std::ptrdiff_t{3} * picture.width,
              sheet.rgb.begin() + static_cast<std::ptrdiff_t>(sheet.offset(left, top + y)));
  }
}

struct Grid {
  int columns = 1;
  int rows = 0;
  int cell_width = 0;   // pixels
  int cell_height = 0;  // pixels, without the caption
  int caption = 0;      // pixels

  int left(int index) const { return gap + index % columns * (cell_width + gap); }
  int top(int index) const { return gap + index / columns * (cell_height + caption + gap); }
  Size size() const {
    return {gap + columns * (cell_width + gap), gap + rows * (cell_height + caption + gap)};
  }
};

Grid grid_for(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns) {
  const int count = static_cast<int>(pictures.size());
  Grid grid;
  grid.columns = std::clamp(columns, 1, std::max(1, count));
  grid.rows = (count + grid.columns - 1) / grid.columns;
  for (const Image& picture : pictures) {
    grid.cell_width = std::max(grid.cell_width, picture.width);
    grid.cell_height = std::max(grid.cell_height, picture.height);
  }
  const bool any =
      std::any_of(captions.begin(), captions.end(), [](const auto& text) { return !text.empty(); });
  grid.caption = any ? caption_height : 0;
  return grid;
}

}  // namespace

Image contact_sheet(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns,
                    const Theme& theme, const Workers& workers) {
  const Grid grid = grid_for(pictures, captions, columns);
  Canvas canvas;
  for (std::size_t i = 0; i < std::min(captions.size(), pictures.size()); ++i) {
    const int index = static_cast<int>(i);
    canvas.text(captions[i], static_cast<float>(grid.left(index)) + 2,
                static_cast<float>(grid.top(index) + grid.cell_height) + 0.5f * caption_height, caption_size,
                theme.text);
  }
  Image sheet = paint(canvas, grid.size(), theme.background, 1, workers);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int index = static_cast<int>(i);
    copy_into(pictures[i], grid.left(index) + (grid.cell_width - pictures[i].width) / 2,
              grid.top(index) + (grid.cell_height - pictures[i].height) / 2, sheet);
  }
  return sheet;
}

}  // namespace sturnus
