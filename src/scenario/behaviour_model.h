// The numbers of Reynolds' steering behaviours, compiled. Which of them a flock has, its terms say.
#pragma once

#include <sturnus/behaviours.h>

#include <array>
#include <cstdint>
#include <vector>

namespace sturnus {

struct PursuitModel {
  std::uint64_t flocks = 0;  ///< a bit for every flock that is looked at
  Prediction prediction = Prediction::intercept;
  float amount = 0;          ///< time, or time per length
  float radius_squared = 0;  ///< d² < this
  bool has_offset = false;
  std::array<float, 3> offset{};  ///< ahead, left, up
  float slowing = 0;
};

struct HideModel {
  std::uint64_t flocks = 0;  ///< a bit for every flock that is hidden from
  float radius_squared = 0;  ///< d² < this
  float reach = 0;
  float margin = 0;
  float slowing = 0;
  float time = 0;
};

/// Of a path or a wall.
struct LineModel {
  std::vector<std::array<float, 3>> corners;
  bool is_loop = false;
  float distance = 0;  ///< wall
  float radius = 0;
  float ahead = 0;
  float time = 0;
};

struct FlowModel {
  FlowKind kind = FlowKind::vortex;
  std::array<float, 3> centre{}, velocity{};
  float speed = 0;
  float core = 0;
  float rate = 0;
  float time = 0;
};

struct LeaderModel {
  std::uint64_t flocks = 0;
  float distance = 0;
  float clearance = 0;
  float slowing = 0;
};

struct AvoidanceModel {
  float radius = 0;
  float gap_squared = 0;
  float time = 0;
};

struct QueueModel {
  float distance = 0;
  float cos_half = 0;
};

struct BehavioursModel {
  PursuitModel pursue, evade;
  HideModel hide;
  LineModel path, wall;
  FlowModel flow;
  LeaderModel leader;
  AvoidanceModel avoidance;
  QueueModel queue;
};

}  // namespace sturnus
