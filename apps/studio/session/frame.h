// What the simulation's thread shows to the window's: one step of the world, packed for drawing, and what is
// known of it. A frame never changes once it is published.
#pragma once

#include <sturnus/explain.h>
#include <sturnus/view.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace studio {

/// What a boid does besides flying, as bits of `Instance::flags`.
enum InstanceFlag : std::uint8_t {
  is_hunter = 1,       ///< its flock hunts
  is_full = 2,         ///< a hunter after a meal
  can_jump = 4,        ///< a hunter whose jump is ready
  is_jumping = 8,      ///< in a jump
  is_quarantined = 16  ///< out of play
};

/// One boid as the graphics card gets it: 48 bytes, a vertex buffer's layout.
struct Instance {
  float position[3];            ///< after the step, length
  float previous[3];            ///< before it, on the near side of the seam; length
  float velocity[3];            ///< length per time
  std::uint8_t flock = 0;       ///< index in file order, from 0
  std::uint8_t flags = 0;       ///< InstanceFlag
  std::uint8_t starving = 0;    ///< 0 fed, 255 about to die
  std::uint8_t crowd = 0;       ///< neighbours within `run.link`, 255 at most; counted only when asked for
  std::uint8_t colour[4] = {};  ///< drifting colour in sRGB; opaque where there is one
  std::uint32_t id = 0;         ///< the lower half of its id, for what should differ from boid to boid
};
static_assert(sizeof(Instance) == 48);

/// A piece of food.
struct Piece {
  float position[3];       ///< length
  float size = 1;          ///< length, as drawn
  std::uint32_t kind = 0;  ///< index in file order, from 0
};

/// A target as it stands now.
struct TargetPlace {
  std::array<float, 3> at{};  ///< length
  bool repels = false;
  float radius = 0;  ///< length; infinity is no limit
};

/// How far back the world can be taken, and what can be undone.
struct Reach {
  std::uint64_t first = 0, last = 0;  ///< steps between which the timeline can be scrubbed
  std::string undo, redo;             ///< what would be undone or redone next; empty: nothing
};

struct Frame {
  std::uint64_t serial = 0;  ///< no two frames of a session have the same; 0: not of a session
  /// Counts jumps: loading, restarting, scrubbing, undoing. Between frames of one generation nothing but
  /// steps and commands happened.
  std::uint64_t generation = 0;
  std::uint64_t step = 0;  ///< steps done
  int dimensions = 2;
  bool has_previous = false;  ///< whether `Instance::previous` is the step before; otherwise it is `position`
  std::array<float, 3> centre{};  ///< mean place of the boids, or the middle of the space; length
  std::vector<Instance> boids;    ///< in storage order, which changes from step to step
  std::vector<std::uint64_t> ids;
  std::vector<Piece> food;
  std::vector<sturnus::Obstacle> obstacles;
  std::vector<TargetPlace> targets;
  sturnus::PointerState pointer;
  sturnus::Extent extent;                                ///< of the space
  std::shared_ptr<const sturnus::ScenarioDef> scenario;  ///< as it stands
  std::shared_ptr<const sturnus::ScenarioDef> opened;  ///< as it was opened; another one: another was opened
  std::string watched;                                 ///< the file whose changes the world follows; or empty
  std::vector<std::size_t> population;                 ///< by flock
  std::vector<std::array<std::array<float, 3>, 2>> index_boxes;  ///< cells or leaves; only when asked for
  std::optional<sturnus::Explanation> explained;                 ///< of the boid that is tracked
  std::optional<std::size_t> tracked;                            ///< its place in `boids`
  Reach reach;
  double step_seconds = 0;  ///< what the last step took
};

}  // namespace studio
