// Paths and walls as items of a draw list.
#include "observe/lines.h"

#include <algorithm>

namespace sturnus {
namespace {

constexpr float path_width = 1.25f;  // pixels
constexpr float wall_width = 2.5f;   // pixels; as planes are drawn
constexpr float path_alpha = 0.6f;

using Corners = std::vector<Coordinates>;

// A line that was drawn already.
struct Drawn {
  const Corners* points;
  bool loop;
  bool is_wall;
  bool operator==(const Drawn& other) const {
    return *points == *other.points && loop == other.loop && is_wall == other.is_wall;
  }
};

Vec<3> place_of(const Coordinates& corner) {
  Vec<3> at;
  for (std::size_t axis = 0; axis < corner.size(); ++axis)
    at[static_cast<int>(axis)] = static_cast<float>(corner[axis]);
  return at;
}

class Pencil {
 public:
  Pencil(const View& view, const SceneColours& colours, DrawList& list)
      : extent_(extent_of(view.scenario())), dimensions_(view.dimensions()), colours_(colours), list_(list) {}

  void path(const FollowPath& path) {
    if (path.on && is_new({&path.points, path.loop, false})) trace(path.points, path.loop, {}, false);
  }

  void wall(const FollowWall& wall) {
    if (!wall.on || !is_new({&wall.points, wall.loop, true})) return;
    if (dimensions_ == 2) return trace(wall.points, wall.loop, {}, true);
    const Vec<3> foot{{0, 0, static_cast<float>(extent_.min[2])}};
    const Vec<3> top{{0, 0, static_cast<float>(extent_.max[2])}};
    trace(wall.points, wall.loop, foot, true);
    trace(wall.points, wall.loop, top, true);
    for (const Coordinates& corner : wall.points) add(place_of(corner) + foot, place_of(corner) + top, true);
  }

 private:
  bool is_new(const Drawn& line) {
    if (std::find(drawn_.begin(), drawn_.end(), line) != drawn_.end()) return false;
    drawn_.push_back(line);
    return true;
  }

  void trace(const Corners& corners, bool loop, const Vec<3>& shift, bool is_wall) {
    for (std::size_t i = 0; i + 1 < corners.size() + (loop ? 1 : 0); ++i)
      add(place_of(corners[i]) + shift, place_of(corners[(i + 1) % corners.size()]) + shift, is_wall);
  }

  void add(const Vec<3>& from, const Vec<3>& to, bool is_wall) {
    const Rgba colour = is_wall ? colours_.obstacle : with_alpha(colours_.obstacle, path_alpha);
    list_.segments.push_back({from, to, colour, is_wall ? wall_width : path_width, 1, 1, Layer::below});
  }

  Extent extent_;
  int dimensions_;
  const SceneColours& colours_;
  DrawList& list_;
  std::vector<Drawn> drawn_;
};

}  // namespace

void add_lines(const View& view, const SceneColours& colours, DrawList& list) {
  Pencil pencil(view, colours, list);
  for (const FlockDef& flock : view.scenario().flocks) {
    if (flock.follow_path) pencil.path(*flock.follow_path);
    if (flock.follow_wall) pencil.wall(*flock.follow_wall);
  }
}

}  // namespace sturnus
