// Coverage of the samples of a band by each kind of shape.
#include "draw/samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sturnus {
namespace {

// Coordinates beyond this many pixels are not drawn: it keeps the integer arithmetic of triangles in range.
constexpr float farthest = 60000.0f;

std::uint32_t pack(Rgba c) {
  return static_cast<std::uint32_t>(c.r) | static_cast<std::uint32_t>(c.g) << 8 |
         static_cast<std::uint32_t>(c.b) << 16;
}

// `weight` of 256 parts of the source over what is there; red and blue go through one multiplication.
std::uint32_t blend(std::uint32_t below, std::uint32_t above, std::uint32_t weight) {
  const std::uint32_t rest = 256 - weight;
  const std::uint32_t rb = (below & 0xff00ffu) * rest + (above & 0xff00ffu) * weight + 0x800080u;
  const std::uint32_t g = (below & 0x00ff00u) * rest + (above & 0x00ff00u) * weight + 0x008000u;
  return (rb >> 8 & 0xff00ffu) | (g >> 8 & 0x00ff00u);
}

std::uint32_t weight_of(float cover, float alpha) {
  return static_cast<std::uint32_t>(cover * alpha * 256.0f + 0.5f);
}

// How much of the unit interval around `offset` lies between -half and half: exact, also for hair lines.
float overlap(float offset, float half) {
  return std::max(0.0f, std::min(offset + 0.5f, half) - std::max(offset - 0.5f, -half));
}

struct Reach {
  float x0, y0, x1, y1;
};

Reach around(const Spot& at, float radius) {
  return {at.x - radius, at.y - radius, at.x + radius, at.y + radius};
}

Reach reach(const TriangleShape& t) {
  return {std::min({t.at[0].x, t.at[1].x, t.at[2].x}), std::min({t.at[0].y, t.at[1].y, t.at[2].y}),
          std::max({t.at[0].x, t.at[1].x, t.at[2].x}), std::max({t.at[0].y, t.at[1].y, t.at[2].y})};
}
Reach reach(const BallShape& ball) {
  return around(ball.at, ball.radius);
}
Reach reach(const DiscShape& disc) {
  return around(disc.at, disc.radius);
}
Reach reach(const BarShape& bar) {
  return {bar.left, bar.top, bar.right, bar.bottom};
}
Reach reach(const LineShape& line) {
  const float half = 0.5f * line.width;
  return {std::min(line.from.x, line.to.x) - half, std::min(line.from.y, line.to.y) - half,
          std::max(line.from.x, line.to.x) + half, std::max(line.from.y, line.to.y) + half};
}
Reach reach(const DartShape& dart) {
  const float nose_x = dart.at.x + dart.forward_x * dart.nose;
  const float nose_y = dart.at.y + dart.forward_y * dart.nose;
  const float tail_x = dart.at.x - dart.forward_x * dart.tail;
  const float tail_y = dart.at.y - dart.forward_y * dart.tail;
  const float wing_x = std::abs(dart.forward_y * dart.half_width);
  const float wing_y = std::abs(dart.forward_x * dart.half_width);
  return {std::min(nose_x, tail_x - wing_x), std::min(nose_y, tail_y - wing_y),
          std::max(nose_x, tail_x + wing_x), std::max(nose_y, tail_y + wing_y)};
}

// Written so that a NaN fails every comparison and is left out.
bool is_drawable(const Reach& r) {
  return r.x0 > -farthest && r.y0 > -farthest && r.x1 < farthest && r.y1 < farthest && r.x0 <= r.x1 &&
         r.y0 <= r.y1;
}

// The edges of a triangle in whole sixteenths of a sample, so that a shared edge is the same line for both of
// its triangles. A sample is inside where all three sides are 0 or more; one on an edge belongs to both
// triangles, and the nearer keeps it.
struct Edges {
  static constexpr std::int64_t sub = 16;
  std::int64_t x[3];
  std::int64_t y[3];
  std::int64_t step[3];  // change of each side from one sample to the next in a row
  std::int64_t area;     // twice the signed area
  std::int64_t turn;     // which way round the corners go

  Edges(const TriangleShape& triangle, float scale) {
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = static_cast<std::int64_t>(std::floor(triangle.at[i].x * scale * sub + 0.5f));
      y[i] = static_cast<std::int64_t>(std::floor(triangle.at[i].y * scale * sub + 0.5f));
    }
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    turn = area > 0 ? 1 : -1;
    for (std::size_t i = 0; i < 3; ++i) step[i] = -turn * (y[next(i)] - y[i]) * sub;
  }

  static std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

  // Side i at the middle of a sample.
  std::int64_t at(std::size_t i, int column, int row) const {
    const std::int64_t px = column * sub + sub / 2;
    const std::int64_t py = row * sub + sub / 2;
    return turn * ((x[next(i)] - x[i]) * (py - y[i]) - (y[next(i)] - y[i]) * (px - x[i]));
  }
};

// Nearness over the picture: linear there, so a plane through the three corners. It is evaluated for each
// sample by itself, never summed along a row, so that it does not depend on where a band begins.
struct Plane {
  float start, slope_x, slope_y, x, y;

  Plane(const TriangleShape& triangle, const Edges& edges) {
    constexpr auto sub = static_cast<float>(Edges::sub);
    const float along_1 = triangle.at[1].nearness - triangle.at[0].nearness;
    const float along_2 = triangle.at[2].nearness - triangle.at[0].nearness;
    const float per_area = sub / static_cast<float>(edges.area);
    slope_x = (along_1 * static_cast<float>(edges.y[2] - edges.y[0]) -
               along_2 * static_cast<float>(edges.y[1] - edges.y[0])) *
              per_area;
    slope_y = (along_2 * static_cast<float>(edges.x[1] - edges.x[0]) -
               along_1 * static_cast<float>(edges.x[2] - edges.x[0])) *
              per_area;
    start = triangle.at[0].nearness;
    x = static_cast<float>(edges.x[0]) / sub - 0.5f;
    y = static_cast<float>(edges.y[0]) / sub - 0.5f;
  }

  float at(int column, int row) const {
    return start + slope_x * (static_cast<float>(column) - x) + slope_y * (static_cast<float>(row) - y);
  }
};

// A line in samples: how far along it and how far aside of it a place is.
struct Track {
  float x, y;    // where it starts
  float dx, dy;  // unit vector along it
  float length;
  float half;  // half its width

  Track(const LineShape& line, float scale) : x(line.from.x * scale), y(line.from.y * scale) {
    dx = line.to.x * scale - x;
    dy = line.to.y * scale - y;
    length = std::sqrt(dx * dx + dy * dy);
    half = 0.5f * line.width * scale;
    if (length > 0) {
      dx /= length;
      dy /= length;
    }
  }

  float along(float from_x, float from_y) const { return from_x * dx + from_y * dy; }
  float aside(float from_x, float from_y) const { return std::abs(from_y * dx - from_x * dy); }

  // Columns of a row that the endless line can touch: a long diagonal has a wide box and little in it.
  void narrow(float from_y, int& x0, int& x1) const {
    if (std::abs(dy) < 1e-3f) return;
    const float middle = x + from_y * dx / dy;
    const float reach = (half + 1) / std::abs(dy);
    x0 = static_cast<int>(
        std::floor(std::clamp(middle - reach, static_cast<float>(x0), static_cast<float>(x1))));
    x1 = static_cast<int>(
        std::ceil(std::clamp(middle + reach, static_cast<float>(x0), static_cast<float>(x1))));
  }

  // Part of a sample that the line covers; `inside` is the nearest place of its length.
  float cover(bool round, float from_x, float from_y, float inside) const {
    const float t = along(from_x, from_y);
    const float across = aside(from_x, from_y);
    if (!round) return overlap(across, half) * overlap(t - 0.5f * length, 0.5f * length);
    return overlap(t == inside ? across : std::sqrt(across * across + (t - inside) * (t - inside)), half);
  }
};

}  // namespace

Extent2 extent(const Shape& shape, Size size) {
  const Reach r = std::visit([](const auto& one) { return reach(one); }, shape);
  if (!is_drawable(r)) return {};
  // One pixel more on each side, for soft edges.
  return {std::max(0, static_cast<int>(std::floor(r.x0)) - 1),
          std::max(0, static_cast<int>(std::floor(r.y0)) - 1),
          std::min(size.width, static_cast<int>(std::floor(r.x1)) + 2),
          std::min(size.height, static_cast<int>(std::floor(r.y1)) + 2)};
}

Samples::Samples(int width, int rows, int scale, bool has_depth)
    : width_(width * scale), scale_(scale), has_depth_(has_depth) {
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows * scale);
  colours_.resize(count);
  if (has_depth) nearness_.resize(count);
}

void Samples::begin(int first_row, int rows, int x0, int x1, Rgba background) {
  top_ = first_row * scale_;
  bottom_ = (first_row + rows) * scale_;
  left_ = x0 * scale_;
  right_ = x1 * scale_;
  for (int y = top_; y < bottom_; ++y) {
    const auto begin = static_cast<std::ptrdiff_t>(row_start(y)) + left_;
    const auto end = static_cast<std::ptrdiff_t>(row_start(y)) + right_;
    std::fill(colours_.begin() + begin, colours_.begin() + end, pack(background));
    if (has_depth_) std::fill(nearness_.begin() + begin, nearness_.begin() + end, 0.0f);
  }
}

void Samples::draw(const Shape& shape) {
  std::visit([this](const auto& one) { draw_shape(one); }, shape);
}

Extent2 Samples::cut(float x0, float y0, float x1, float y1) const {
  return {std::max(left_, static_cast<int>(std::floor(x0))), std::max(top_, static_cast<int>(std::floor(y0))),
          std::min(right_, static_cast<int>(std::floor(x1)) + 1),
          std::min(bottom_, static_cast<int>(std::floor(y1)) + 1)};
}

// Fills where the signed distance to the edge is below zero, with an edge one sample wide.
template <class Distance>
void Samples::fill(const Extent2& box, Rgba colour, float nearness, const Distance& distance) {
  const std::uint32_t packed = pack(colour);
  const float alpha = static_cast<float>(colour.a) / 255.0f;
  for (int y = box.y0; y < box.y1; ++y) {
    std::uint32_t* row = colours_.data() + row_start(y);
    const float* depth = has_depth_ ? nearness_.data() + row_start(y) : nullptr;
    const float sample_y = static_cast<float>(y) + 0.5f;
    for (int x = box.x0; x < box.x1; ++x) {
      const float outside = distance(static_cast<float>(x) + 0.5f, sample_y);
      if (outside >= 0.5f || (depth != nullptr && nearness < depth[x])) continue;
      row[x] = blend(row[x], packed, weight_of(std::min(1.0f, 0.5f - outside), alpha));
    }
  }
}

void Samples::fill_whole(const Extent2& box, Rgba colour) {
  const std::uint32_t packed = pack(colour);
  const std::uint32_t weight = weight_of(1, static_cast<float>(colour.a) / 255.0f);
  for (int y = box.y0; y < box.y1; ++y) {
    std::uint32_t* row = colours_.data() + row_start(y);
    for (int x = box.x0; x < box.x1; ++x) row[x] = blend(row[x], packed, weight);
  }
}

void Samples::draw_shape(const TriangleShape& triangle) {
  const Edges edges(triangle, static_cast<float>(scale_));
  if (edges.area == 0) return;
  const auto scale = static_cast<float>(scale_);
  const Reach r = reach(triangle);
  const Extent2 box = cut(r.x0 * scale - 1, r.y0 * scale - 1, r.x1 * scale + 1, r.y1 * scale + 1);
  const Plane plane(triangle, edges);
  const std::uint32_t packed = pack(triangle.colour);
  std::int64_t side[3];
  for (int y = box.y0; y < box.y1; ++y) {
    for (std::size_t i = 0; i < 3; ++i) side[i] = edges.at(i, box.x0, y);
    std::uint32_t* row = colours_.data() + row_start(y);
    float* depth = has_depth_ ? nearness_.data() + row_start(y) : nullptr;
    for (int x = box.x0; x < box.x1; ++x) {
      if ((side[0] | side[1] | side[2]) >= 0) {
        const float nearness = plane.at(x, y);
        if (depth == nullptr || nearness > depth[x]) {
          row[x] = packed;
          if (depth != nullptr) depth[x] = nearness;
        }
      }
      for (std::size_t i = 0; i < 3; ++i) side[i] += edges.step[i];
    }
  }
}

void Samples::draw_shape(const BallShape& ball) {
  const auto scale = static_cast<float>(scale_);
  const float cx = ball.at.x * scale;
  const float cy = ball.at.y * scale;
  const float radius = ball.radius * scale;
  const Extent2 box = cut(cx - radius, cy - radius, cx + radius, cy + radius);
  const float depth_centre = 1.0f / ball.at.nearness;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const float nx = (static_cast<float>(x) + 0.5f - cx) / radius;
      const float ny = (static_cast<float>(y) + 0.5f - cy) / radius;
      const float rest = 1.0f - nx * nx - ny * ny;
      if (!(rest >= 0)) continue;
      const float nz = std::sqrt(rest);
      const std::size_t at = row_start(y) + static_cast<std::size_t>(x);
      if (has_depth_) {
        const float nearness = 1.0f / std::max(1e-30f, depth_centre - ball.depth_radius * nz);
        if (!(nearness > nearness_[at])) continue;
        nearness_[at] = nearness;
      }
      // Light from the upper left behind the viewer.
      const float light = std::clamp(-0.40f * nx - 0.62f * ny + 0.67f * nz, 0.0f, 1.0f);
      colours_[at] = blend(pack(ball.shadow), pack(ball.colour), weight_of(light, 1));
    }
  }
}

// The dart is folded along its axis: what is left is bounded by two straight edges.
void Samples::draw_shape(const DartShape& dart) {
  const auto scale = static_cast<float>(scale_);
  const Reach r = reach(dart);
  const float width = dart.half_width * scale;
  const float nose = dart.nose * scale;
  const float tail = dart.tail * scale;
  const float notch = dart.notch * scale;
  const float front = nose + tail;
  const float back = tail - notch;
  const float front_unit = 1.0f / std::sqrt(width * width + front * front);
  const float back_unit = 1.0f / std::sqrt(width * width + back * back);
  const float cx = dart.at.x * scale;
  const float cy = dart.at.y * scale;
  fill(cut(r.x0 * scale - 1, r.y0 * scale - 1, r.x1 * scale + 1, r.y1 * scale + 1), dart.colour,
       dart.at.nearness, [=, hx = dart.forward_x, hy = dart.forward_y](float x, float y) {
         const float u = (x - cx) * hx + (y - cy) * hy;
         const float v = std::abs((y - cy) * hx - (x - cx) * hy);
         return std::max(((u - nose) * width + v * front) * front_unit,
                         -((u + notch) * width + v * back) * back_unit);
       });
}

void Samples::draw_shape(const DiscShape& disc) {
  const auto scale = static_cast<float>(scale_);
  const float cx = disc.at.x * scale;
  const float cy = disc.at.y * scale;
  const float radius = disc.radius * scale;
  const float hole = disc.hole * scale;
  const Extent2 box = cut(cx - radius - 1, cy - radius - 1, cx + radius + 1, cy + radius + 1);
  const auto distance = [=](float x, float y) {
    const float r = std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy));
    return hole < 0 ? r - radius : std::max(r - radius, hole - r);
  };
  if (hole < 2) return fill(box, disc.colour, disc.at.nearness, distance);
  // Row by row around the hole: a large ring is nearly all hole.
  for (int y = box.y0; y < box.y1; ++y) {
    const float dy = static_cast<float>(y) + 0.5f - cy;
    const float chord = std::sqrt(std::max(0.0f, (hole - 1) * (hole - 1) - dy * dy));
    const int left = std::clamp(static_cast<int>(std::ceil(cx - chord)), box.x0, box.x1);
    const int right = std::clamp(static_cast<int>(std::floor(cx + chord)), left, box.x1);
    fill({box.x0, y, left, y + 1}, disc.colour, disc.at.nearness, distance);
    fill({right, y, box.x1, y + 1}, disc.colour, disc.at.nearness, distance);
  }
}

void Samples::draw_shape(const BarShape& bar) {
  const auto scale = static_cast<float>(scale_);
  const float corner = bar.corner * scale;
  const float left = bar.left * scale;
  const float top = bar.top * scale;
  const float right = bar.right * scale;
  const float bottom = bar.bottom * scale;
  const float cx = 0.5f * (left + right);
  const float cy = 0.5f * (top + bottom);
  const float half_x = 0.5f * (right - left) - corner;
  const float half_y = 0.5f * (bottom - top) - corner;
  const auto distance = [=](float x, float y) {
    const float dx = std::abs(x - cx) - half_x;
    const float dy = std::abs(y - cy) - half_y;
    if (dx <= 0 || dy <= 0) return std::max(dx, dy) - corner;
    return std::sqrt(dx * dx + dy * dy) - corner;
  };
  const Extent2 box = cut(left - 1, top - 1, right + 1, bottom + 1);
  if (box.empty()) return;
  // The middle is covered whole; only the rim around it has to be measured.
  const int x0 = std::clamp(static_cast<int>(std::ceil(left + corner)), box.x0, box.x1);
  const int y0 = std::clamp(static_cast<int>(std::ceil(top + corner)), box.y0, box.y1);
  const int x1 = std::clamp(static_cast<int>(std::floor(right - corner)), x0, box.x1);
  const int y1 = std::clamp(static_cast<int>(std::floor(bottom - corner)), y0, box.y1);
  fill({box.x0, box.y0, box.x1, y0}, bar.colour, on_top, distance);
  fill({box.x0, y0, x0, y1}, bar.colour, on_top, distance);
  fill_whole({x0, y0, x1, y1}, bar.colour);
  fill({x1, y0, box.x1, y1}, bar.colour, on_top, distance);
  fill({box.x0, y1, box.x1, box.y1}, bar.colour, on_top, distance);
}

void Samples::draw_shape(const LineShape& line) {
  const auto scale = static_cast<float>(scale_);
  const Track track(line, scale);
  if (!(track.length > 0)) return;
  const bool round = line.alpha_from >= 1 && line.alpha_to >= 1;
  const Reach r = reach(line);
  const Extent2 box = cut(r.x0 * scale - 1, r.y0 * scale - 1, r.x1 * scale + 1, r.y1 * scale + 1);
  const float nearness_slope = (line.to.nearness - line.from.nearness) / track.length;
  const float alpha_slope = (line.alpha_to - line.alpha_from) / track.length;
  const std::uint32_t packed = pack(line.colour);
  for (int y = box.y0; y < box.y1; ++y) {
    const float from_y = static_cast<float>(y) + 0.5f - track.y;
    int x0 = box.x0;
    int x1 = box.x1;
    track.narrow(from_y, x0, x1);
    for (int x = x0; x < x1; ++x) {
      const float from_x = static_cast<float>(x) + 0.5f - track.x;
      const float inside = std::clamp(track.along(from_x, from_y), 0.0f, track.length);
      const float cover = track.cover(round, from_x, from_y, inside);
      const std::size_t at = row_start(y) + static_cast<std::size_t>(x);
      if (!(cover > 0)) continue;
      if (has_depth_ && line.from.nearness + nearness_slope * inside < nearness_[at]) continue;
      colours_[at] = blend(colours_[at], packed, weight_of(cover, line.alpha_from + alpha_slope * inside));
    }
  }
}

template <int scale>
void Samples::average(int x0, int x1, Image& image) const {
  constexpr std::uint32_t count = scale * scale;
  for (int y = top_ / scale; y < bottom_ / scale; ++y) {
    const std::uint32_t* samples =
        colours_.data() + row_start(y * scale) + static_cast<std::size_t>(x0 * scale);
    std::uint8_t* pixel = image.rgb.data() + image.offset(x0, y);
    for (int x = x0; x < x1; ++x, samples += scale, pixel += 3) {
      std::uint32_t rb = 0;  // two sums of at most 16 * 255 in one word
      std::uint32_t g = 0;
      for (int row = 0; row < scale; ++row) {
        for (int column = 0; column < scale; ++column) {
          const std::uint32_t sample = samples[static_cast<std::ptrdiff_t>(row) * width_ + column];
          rb += sample & 0xff00ffu;
          g += sample >> 8 & 0xffu;
        }
      }
      pixel[0] = static_cast<std::uint8_t>(((rb & 0xffffu) + count / 2) / count);
      pixel[1] = static_cast<std::uint8_t>((g + count / 2) / count);
      pixel[2] = static_cast<std::uint8_t>(((rb >> 16) + count / 2) / count);
    }
  }
}

void Samples::resolve(int x0, int x1, Image& image) const {
  if (scale_ == 1) return average<1>(x0, x1, image);
  if (scale_ == 2) return average<2>(x0, x1, image);
  if (scale_ == 3) return average<3>(x0, x1, image);
  average<4>(x0, x1, image);
}

}  // namespace sturnus
