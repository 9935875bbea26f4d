// One light that moves with the viewer, the brightness of faces under it, and the haze of distance.
#include "draw/light.h"

#include <algorithm>

namespace sturnus {
namespace {

constexpr float shade_at_night = 0.5f;  // brightness of a face turned away from the light

}  // namespace

Vec<3> towards_light(const Projection& projection) {
  return unit(projection.up() * 0.7f - projection.right() * 0.3f - projection.forward() * 0.8f);
}

Rgba shaded(Rgba colour, float light) {
  const float brightness = shade_at_night + (1.0f - shade_at_night) * std::max(0.0f, light);
  return {static_cast<std::uint8_t>(static_cast<float>(colour.r) * brightness + 0.5f),
          static_cast<std::uint8_t>(static_cast<float>(colour.g) * brightness + 0.5f),
          static_cast<std::uint8_t>(static_cast<float>(colour.b) * brightness + 0.5f), colour.a};
}

Rgba lit_face(Rgba colour, const Vec<3>& along, const Vec<3>& across, const Vec<3>& to_eye,
              const Vec<3>& light) {
  Vec<3> normal = unit(cross(along, across));
  if (dot(normal, to_eye) < 0) normal *= -1.0f;
  return shaded(colour, dot(normal, light));
}

Rgba sunk(Rgba colour, float depth, const Projection& projection, const Theme& theme) {
  Rgba ground = theme.background;
  ground.a = colour.a;
  return mix(colour, ground, theme.depth_fade * projection.fade(depth));
}

}  // namespace sturnus
