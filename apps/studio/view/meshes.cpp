// Cones, fish and birds: rings along an axis, and flat fins and wings.
#include "view/meshes.h"

#include <initializer_list>

namespace studio {
namespace {

constexpr float full_turn = 6.283185307f;
constexpr int sides = 8;

// A cross-section of a body: an ellipse at x.
struct Ring {
  float x, half_width, half_height, centre_z;
};

class Builder {
 public:
  explicit Builder(std::vector<MeshCorner>& corners) : corners_(corners), first_(corners.size()) {}

  MeshRange range() const { return {first_, corners_.size() - first_}; }

  void corner(const Point& at, const Point& normal, BodyPart part) {
    corners_.push_back({at, static_cast<float>(part), normal});
  }

  void flat(const Point& a, const Point& b, const Point& c, BodyPart part) {
    const Point normal = unit(cross(b - a, c - a));
    for (const Point& at : {a, b, c}) corner(at, normal, part);
  }

  // The hull between two cross-sections; `is_jaw`: of parts that open.
  void hull(const Ring& back, const Ring& front, int around, bool is_jaw = false) {
    for (int i = 0; i < around; ++i) {
      const float from = full_turn * static_cast<float>(i) / static_cast<float>(around);
      const float to = full_turn * static_cast<float>(i + 1) / static_cast<float>(around);
      const BodyPart part = is_jaw ? jaw(0.5f * (from + to)) : BodyPart::body;
      const auto both = [&](const Ring& ring, float turn) {
        corner(at(ring, turn), outward(back, front, turn), part);
      };
      if (back.half_width > 0) both(back, from), both(back, to), both(front, to);
      if (front.half_width > 0) both(back, from), both(front, to), both(front, from);
    }
  }

  void cap(const Ring& ring, int around, BodyPart part, float facing) {
    const auto rim = [&](int i) {
      return at(ring, full_turn * static_cast<float>(i) / static_cast<float>(around));
    };
    for (int i = 1; i + 1 < around; ++i) {
      for (const Point& place : {rim(0), rim(i), rim(i + 1)}) corner(place, {facing, 0, 0}, part);
    }
  }

 private:
  static Point at(const Ring& ring, float turn) {
    return {ring.x, ring.half_width * std::cos(turn), ring.centre_z + ring.half_height * std::sin(turn)};
  }
  static Point outward(const Ring& back, const Ring& front, float turn) {
    const float slope = (back.half_width + back.half_height - front.half_width - front.half_height) * 0.5f /
                        (front.x - back.x);
    const float width = back.half_width + front.half_width;
    const float height = back.half_height + front.half_height;
    const Point across = unit({0, height * std::cos(turn), width * std::sin(turn)});
    return unit(across + Point{slope, 0, 0});
  }
  static BodyPart jaw(float turn) {
    const bool is_left = std::cos(turn) > 0;
    if (std::sin(turn) > 0) return is_left ? BodyPart::jaw_up_left : BodyPart::jaw_up_right;
    return is_left ? BodyPart::jaw_down_left : BodyPart::jaw_down_right;
  }

  std::vector<MeshCorner>& corners_;
  std::size_t first_;
};

MeshRange add_cone(std::vector<MeshCorner>& corners, int around) {
  Builder builder(corners);
  const Ring base{-0.22f, 0.19f, 0.19f, 0};
  builder.hull(base, {0.42f, 0, 0, 0}, around);
  builder.cap(base, around, BodyPart::body, -1);
  return builder.range();
}

void add_fish_fins(Builder& builder) {
  const Point stem{-0.30f, 0, 0};
  // The tail leans a little to both sides, so that it can be seen from above too.
  for (const float side : {-1.0f, 1.0f}) {
    builder.flat(stem, {-0.50f, 0.035f * side, 0.15f}, {-0.42f, 0.01f * side, 0}, BodyPart::fin);
    builder.flat(stem, {-0.42f, 0.01f * side, 0}, {-0.50f, 0.035f * side, -0.15f}, BodyPart::fin);
    builder.flat({0.20f, 0.065f * side, -0.02f}, {0.10f, 0.17f * side, -0.06f}, {0.09f, 0.06f * side, -0.02f},
                 BodyPart::fin);
    builder.flat({-0.06f, 0.05f * side, -0.08f}, {-0.14f, 0.10f * side, -0.13f},
                 {-0.15f, 0.03f * side, -0.06f}, BodyPart::fin);
  }
  builder.flat({0.16f, 0, 0.12f}, {-0.02f, 0.018f, 0.21f}, {-0.16f, 0, 0.07f}, BodyPart::fin);
  builder.flat({-0.02f, 0.018f, 0.21f}, {-0.13f, 0.014f, 0.15f}, {-0.16f, 0, 0.07f}, BodyPart::fin);
}

MeshRange add_fish(std::vector<MeshCorner>& corners) {
  Builder builder(corners);
  const Ring rings[] = {{-0.36f, 0.008f, 0.03f, 0},       {-0.24f, 0.025f, 0.05f, 0},
                        {-0.08f, 0.060f, 0.105f, 0},      {0.10f, 0.080f, 0.130f, 0},
                        {0.24f, 0.074f, 0.115f, 0},       {0.32f, 0.062f, 0.090f, 0},
                        {0.44f, 0.036f, 0.045f, -0.005f}, {0.50f, 0, 0, -0.01f}};
  for (std::size_t i = 0; i + 1 < std::size(rings); ++i) builder.hull(rings[i], rings[i + 1], sides, i >= 5);
  builder.cap({0.325f, 0.058f, 0.084f, 0}, sides, BodyPart::throat, 1);
  add_fish_fins(builder);
  return builder.range();
}

// Two parts, each a trapezium; the tips are swept back.
void add_wing(Builder& builder, float side) {
  const Point root_front{0.17f, 0.04f * side, 0.02f}, root_back{-0.08f, 0.04f * side, 0.02f};
  const Point wrist_front{0.16f, 0.28f * side, 0.02f}, wrist_back{-0.10f, 0.26f * side, 0.02f};
  const Point tip_front{0.02f, 0.54f * side, 0.02f}, tip_back{-0.10f, 0.56f * side, 0.02f};
  const auto quad = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
    builder.flat(a, b, c, BodyPart::wing);
    builder.flat(a, c, d, BodyPart::wing);
  };
  quad(root_front, root_back, wrist_back, wrist_front);
  quad(wrist_front, wrist_back, tip_back, tip_front);
}

MeshRange add_bird(std::vector<MeshCorner>& corners) {
  Builder builder(corners);
  const Ring rings[] = {{-0.30f, 0.012f, 0.010f, 0},     {-0.12f, 0.055f, 0.050f, 0},
                        {0.06f, 0.075f, 0.070f, 0},      {0.20f, 0.050f, 0.050f, 0.008f},
                        {0.27f, 0.046f, 0.046f, 0.016f}, {0.33f, 0.026f, 0.026f, 0.012f}};
  for (std::size_t i = 0; i + 1 < std::size(rings); ++i) builder.hull(rings[i], rings[i + 1], sides);
  builder.hull({0.32f, 0.024f, 0.022f, 0.010f}, {0.43f, 0, 0, 0.002f}, 4, true);
  add_wing(builder, 1);
  add_wing(builder, -1);
  for (const float side : {-1.0f, 1.0f})
    builder.flat({-0.20f, 0, 0.012f}, {-0.50f, 0.11f * side, 0.012f}, {-0.46f, 0, 0.012f}, BodyPart::fin);
  for (const float side : {-1.0f, 1.0f})
    builder.flat({-0.20f, 0, 0.012f}, {-0.20f, 0.035f * side, 0.012f}, {-0.50f, 0.11f * side, 0.012f},
                 BodyPart::fin);
  return builder.range();
}

}  // namespace

MeshRange MeshBuffer::of(Mesh mesh) const {
  if (mesh == Mesh::fish) return fish;
  if (mesh == Mesh::bird) return bird;
  return mesh == Mesh::pyramid ? pyramid : cone;
}

MeshBuffer make_meshes() {
  MeshBuffer out;
  out.cone = add_cone(out.corners, 8);
  out.pyramid = add_cone(out.corners, 4);
  out.fish = add_fish(out.corners);
  out.bird = add_bird(out.corners);
  return out;
}

}  // namespace studio
