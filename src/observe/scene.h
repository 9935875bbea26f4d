// What there is to see of a flock, as draw lists.
#pragma once

#include <sturnus/view.h>

#include <array>
#include <deque>
#include <unordered_map>
#include <vector>

#include "observe/draw_list.h"

namespace sturnus {

/// Colours that a scene takes from the theme.
struct SceneColours {
  std::array<Rgba, 6> flocks{};
  Rgba outline, surface, text, accent;
  Rgba attractor, repeller, obstacle;
  std::array<Rgba, 7> terms{};  ///< separation, alignment, cohesion, then whatever else is felt
  Rgba food{};
  Rgba full{};     ///< a hunter after a meal
  Rgba starved{};  ///< what a hunter pales to
  Rgba ready{};    ///< the tail of one that can jump
  Rgba tired{};    ///< and of one that can't
};

/// What besides the boids is put into a scene.
struct SceneOptions {
  bool velocities = false;
  bool caption = true;
  std::vector<std::array<std::array<float, 3>, 2>> index_boxes;
  std::vector<Rgba> boid_colours = {};  ///< by slot, not drawn where transparent; empty: `colour_of`
};

/// The path of every boid over the last steps, by id; pieces never cross the seam of a wrapped space.
class Trails {
 public:
  void follow(const View& view);
  void add_to(const View& view, const SceneColours& colours, DrawList& list) const;

 private:
  struct Piece {
    std::uint64_t id;
    Vec<3> from, to;
  };
  std::deque<std::vector<Piece>> steps_;
  std::unordered_map<std::uint64_t, Vec<3>> last_;
};

/// The colour that a boid is drawn in: its own drifting one, its flock's, or the palette's; a hunter is red
/// after a meal and pales as it starves.
Rgba colour_of(const View& view, std::size_t slot, const SceneColours& colours);

/// The glyph of a flock's boids.
GlyphKind kind_of(const FlockDef& flock, int dimensions);

/// Fills a draw list with the space's outline, boids, and what the options ask for.
void make_scene(const View& view, const SceneColours& colours, const SceneOptions& options, DrawList& list);

/// Corners of what the scenario's camera wants to fit: the space, or where most of the boids are.
struct Framing {
  Vec<3> low, high;
};
Framing framing_of(const View& view);

}  // namespace sturnus
