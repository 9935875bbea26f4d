// Random worlds for the neighbour indexes: places on cell edges, exactly on the radius, at one point, in one
// cell, far out, or none at all.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "neighbours/index.h"
#include "neighbours/offset.h"
#include "world/state.h"

namespace sturnus::test {

/// Places of boids and how far they look.
struct RandomWorld {
  int dimensions = 2;
  bool wraps = false;
  float reach = 1;
  std::array<float, 3> min{}, max{};
  Columns position;
  std::vector<std::uint8_t> hidden;
  std::vector<std::uint64_t> ids;

  std::size_t size() const { return ids.size(); }
  std::size_t axes() const { return static_cast<std::size_t>(dimensions); }

  Cloud cloud() const {
    Cloud cloud;
    cloud.dimensions = dimensions;
    cloud.count = size();
    for (std::size_t axis = 0; axis < axes(); ++axis) cloud.position[axis] = position[axis].data();
    cloud.hidden = hidden.data();
    cloud.wraps = wraps;
    cloud.min = min;
    cloud.max = max;
    return cloud;
  }

  Wrapping image() const {
    Wrapping image{wraps, {}, {}};
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      image.size[axis] = max[axis] - min[axis];
      image.half[axis] = 0.5f * image.size[axis];
    }
    return image;
  }

  /// Puts the boids in the order that an index asks for.
  void reorder_as(const std::vector<std::uint32_t>& order) {
    if (order.empty()) return;
    std::vector<float> spare;
    reorder(position, order, spare, Workers(1));
    const auto old_hidden = hidden;
    const auto old_ids = ids;
    for (std::size_t i = 0; i < order.size(); ++i) {
      hidden[i] = old_hidden[order[i]];
      ids[i] = old_ids[order[i]];
    }
  }
};

inline float eighths(int low, int high) {
  return static_cast<float>(*rc::gen::inRange(low, high + 1)) / 8;
}

/// One coordinate, by the manner of the whole world.
inline float random_coordinate(int manner, const RandomWorld& world, std::size_t axis) {
  const float span = world.max[axis] - world.min[axis];
  switch (manner) {
    case 0:
      return world.min[axis] + span * static_cast<float>(*rc::gen::inRange(0, 1 << 20)) * 0x1p-20f;
    case 1:
      return world.min[axis] + world.reach / 4 * static_cast<float>(*rc::gen::inRange(0, 60));  // cell edges
    case 2:
      return world.min[axis] + world.reach * static_cast<float>(*rc::gen::inRange(0, 12));  // on the radius
    case 3:
      return world.min[axis] + span / 2;  // at one point
    default:
      return world.min[axis] + world.reach / 100 * static_cast<float>(*rc::gen::inRange(0, 9));  // one cell
  }
}

inline RandomWorld random_world(bool wraps, int most = 70) {
  RandomWorld world;
  world.dimensions = *rc::gen::inRange(2, 4);
  world.wraps = wraps;
  world.reach = *rc::gen::element(0.5f, 1.0f, 1.37f, 3.0f, 20.0f);
  for (std::size_t axis = 0; axis < world.axes(); ++axis) {
    world.min[axis] = eighths(-80, 80);
    world.max[axis] = world.min[axis] + world.reach * *rc::gen::element(1.0f, 3.0f, 3.01f, 4.0f, 7.3f, 20.0f);
  }
  const int manner = *rc::gen::inRange(0, 5);
  const int count = *rc::gen::inRange(0, most);
  for (int i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < world.axes(); ++axis) {
      const float at = random_coordinate(manner, world, axis);
      world.position[axis].push_back(wraps ? wrapped(at, world.min[axis], world.max[axis]) : at);
    }
    world.hidden.push_back(*rc::gen::inRange(0, 20) == 0 ? 1 : 0);
    world.ids.push_back(static_cast<std::uint64_t>(i));
  }
  if (!wraps && count > 0 && *rc::gen::inRange(0, 3) == 0) {  // one is lost in an open world
    for (std::size_t axis = 0; axis < world.axes(); ++axis) world.position[axis].back() = 1e6f;
  }
  return world;
}

}  // namespace sturnus::test
