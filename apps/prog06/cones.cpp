// Frames along velocities, and cones in them.
#include "cones.h"

#include <algorithm>
#include <cstdint>

namespace prog06 {
namespace {

using sturnus::Frame3;
using sturnus::Point3;

// place + direction * factor
Point3 moved(const Point3& place, const Point3& direction, float factor) {
  return {place[0] + direction[0] * factor, place[1] + direction[1] * factor,
          place[2] + direction[2] * factor};
}

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

const Frame3 along_x = sturnus::frame_along({1, 0, 0}).value();

}  // namespace

std::array<sturnus::Triangle, 4> cone(const Point3& place, const Frame3& frame, float size,
                                      sturnus::Rgba colour) {
  const Point3 nose = moved(place, frame.w, 0.5f * size);
  const Point3 base[4] = {moved(place, frame.u, 0.2f * size), moved(place, frame.v, 0.2f * size),
                          moved(place, frame.u, -0.2f * size), moved(place, frame.v, -0.2f * size)};
  return {{{{nose, base[0], base[1]}, colour},
           {{nose, base[1], base[2]}, colour},
           {{nose, base[2], base[3]}, colour},
           {{nose, base[3], base[0]}, colour}}};
}

sturnus::Rgba heading_colour(const Point3& w) {
  // Three cosines, a third of a turn apart, of the angle to the direction in which each channel is brightest.
  constexpr float middle = 0.66f, swing = 0.34f, half = 0.5f, root = 0.8660254f;
  return {byte(middle + swing * w[0]), byte(middle + swing * (-half * w[0] + root * w[1])),
          byte(middle + swing * (-half * w[0] - root * w[1])), 255};
}

void Cones::follow(const sturnus::View& view) {
  frames_.resize(static_cast<std::size_t>(view.state().next_id), along_x);
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    if (const auto frame = sturnus::frame_along(view.velocity(slot))) frames_[view.id(slot)] = *frame;
  }
}

std::vector<sturnus::Triangle> Cones::triangles(const sturnus::View& view) const {
  std::vector<sturnus::Triangle> out;
  out.reserve(4 * view.size());
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    if (view.quarantined(slot)) continue;
    const Frame3& frame = frames_[view.id(slot)];
    const auto faces = cone(view.position(slot), frame, size_, heading_colour(frame.w));
    out.insert(out.end(), faces.begin(), faces.end());
  }
  return out;
}

}  // namespace prog06
