// Sorts shapes into bands of a fixed height, paints each band by itself, and puts the text on top.
#include "draw/raster.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "draw/samples.h"

namespace sturnus {

Image::Image(Size size, Rgba fill) : width(std::max(0, size.width)), height(std::max(0, size.height)) {
  rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t at = 0; at < rgb.size(); at += 3) {
    rgb[at] = fill.r;
    rgb[at + 1] = fill.g;
    rgb[at + 2] = fill.b;
  }
}

namespace {

// Pixels. Small enough that a band's samples stay in the second-level cache; the picture does not depend on
// it.
constexpr int band_rows = 8;

// The shapes of each band in drawing order: items[start[b]] to items[start[b + 1]].
struct Bands {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> items;
  std::vector<int> x0;  // first column that any shape of the band may touch
  std::vector<int> x1;  // the column after the last
};

Bands sort_into_bands(const std::vector<Shape>& shapes, Size size, std::size_t band_count) {
  Bands bands;
  bands.start.assign(band_count + 1, 0);
  bands.x0.assign(band_count, size.width);
  bands.x1.assign(band_count, 0);
  struct Span {
    std::uint32_t first, end;
  };
  std::vector<Span> spans(shapes.size(), Span{0, 0});
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Extent2 box = extent(shapes[i], size);
    if (box.empty()) continue;
    spans[i] = {static_cast<std::uint32_t>(box.y0 / band_rows),
                static_cast<std::uint32_t>((box.y1 - 1) / band_rows + 1)};
    for (std::size_t band = spans[i].first; band < spans[i].end; ++band) {
      ++bands.start[band + 1];
      bands.x0[band] = std::min(bands.x0[band], box.x0);
      bands.x1[band] = std::max(bands.x1[band], box.x1);
    }
  }
  for (std::size_t band = 0; band < band_count; ++band) bands.start[band + 1] += bands.start[band];
  bands.items.resize(bands.start[band_count]);
  std::vector<std::uint32_t> next(bands.start.begin(), bands.start.end() - 1);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t band = spans[i].first; band < spans[i].end; ++band) {
      bands.items[next[band]++] = static_cast<std::uint32_t>(i);
    }
  }
  return bands;
}

std::uint8_t over(std::uint8_t below, std::uint8_t above, int weight) {
  return static_cast<std::uint8_t>((below * (255 - weight) + above * weight + 127) / 255);
}

void put_text(const TextShape& text, Image& image) {
  for (int row = 0; row < text.ink.height; ++row) {
    const int y = text.y + text.ink.top + row;
    if (y < 0 || y >= image.height) continue;
    for (int column = 0; column < text.ink.width; ++column) {
      const int x = text.x + text.ink.left + column;
      const int cover =
          text.ink.cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(text.ink.width) +
                         static_cast<std::size_t>(column)];
      if (cover == 0 || x < 0 || x >= image.width) continue;
      std::uint8_t* pixel = image.rgb.data() + image.offset(x, y);
      const int weight = (cover * text.colour.a + 127) / 255;
      pixel[0] = over(pixel[0], text.colour.r, weight);
      pixel[1] = over(pixel[1], text.colour.g, weight);
      pixel[2] = over(pixel[2], text.colour.b, weight);
    }
  }
}

}  // namespace

Image paint(const Canvas& canvas, Size size, Rgba background, int supersampling, const Workers& workers) {
  Image image(size, background);
  if (image.rgb.empty()) return image;
  const int scale = std::clamp(supersampling, 1, 4);
  const auto band_count = static_cast<std::size_t>((size.height + band_rows - 1) / band_rows);
  const Bands bands = sort_into_bands(canvas.shapes(), size, band_count);
  const auto team = static_cast<std::size_t>(workers.count());
  // Every worker takes every team-th band: a flock in one corner still keeps all of them busy.
  workers.for_ranges(team, [&](std::size_t begin, std::size_t end, int) {
    Samples samples(size.width, band_rows, scale, canvas.has_depth());
    for (std::size_t part = begin; part < end; ++part) {
      for (std::size_t band = part; band < band_count; band += team) {
        if (bands.x0[band] >= bands.x1[band]) continue;
        const int first_row = static_cast<int>(band) * band_rows;
        samples.begin(first_row, std::min(band_rows, size.height - first_row), bands.x0[band], bands.x1[band],
                      background);
        for (std::uint32_t i = bands.start[band]; i < bands.start[band + 1]; ++i) {
          samples.draw(canvas.shapes()[bands.items[i]]);
        }
        samples.resolve(bands.x0[band], bands.x1[band], image);
      }
    }
  });
  for (const TextShape& text : canvas.texts()) put_text(text, image);
  return image;
}

}  // namespace sturnus
