// The samples of one horizontal band of a picture, and how each shape covers them.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace sturnus {

/// A rectangle in pixels or samples; the ends are not part of it.
struct Extent2 {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// What a shape may touch, in pixels, cut to the picture; empty when it is outside or not finite.
Extent2 extent(const Shape& shape, Size size);

/// A band's samples. Colours are packed as r | g << 8 | b << 16; nearness is there only for pictures with
/// depth.
class Samples {
 public:
  /// For bands `rows` pixels high in pictures `width` pixels wide, `scale` samples along a pixel's side.
  Samples(int width, int rows, int scale, bool has_depth);

  /// Starts the band whose first pixel row is `first_row`, and clears the columns x0 to x1 (pixels).
  void begin(int first_row, int rows, int x0, int x1, Rgba background);

  /// Draws what a shape covers of this band.
  void draw(const Shape& shape);

  /// Writes the mean of each pixel's samples for columns x0 to x1 into the picture.
  void resolve(int x0, int x1, Image& image) const;

 private:
  void draw_shape(const TriangleShape& triangle);
  void draw_shape(const BallShape& ball);
  void draw_shape(const DartShape& dart);
  void draw_shape(const DiscShape& disc);
  void draw_shape(const LineShape& line);
  void draw_shape(const BarShape& bar);

  template <class Distance>
  void fill(const Extent2& box, Rgba colour, float nearness, const Distance& distance);
  void fill_whole(const Extent2& box, Rgba colour);
  template <int scale>
  void average(int x0, int x1, Image& image) const;
  Extent2 cut(float x0, float y0, float x1, float y1) const;
  std::size_t row_start(int y) const {
    return static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(width_);
  }

  int width_;       // samples in a row
  int scale_;       // samples along a pixel's side
  int top_ = 0;     // first sample row of this band
  int bottom_ = 0;  // the row after its last
  int left_ = 0;    // first column that was cleared, in samples
  int right_ = 0;   // the column after the last
  bool has_depth_;
  std::vector<std::uint32_t> colours_;
  std::vector<float> nearness_;
};

}  // namespace sturnus
