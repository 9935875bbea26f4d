// From obstacles to columns.
#include "world/obstacle_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sturnus {
namespace {

constexpr float infinite = FlockModel::infinity_f;

// Of a box along the axes, on one of them; a plane goes on without end.
float extent_of(const Obstacle& obstacle, std::size_t axis) {
  if (obstacle.kind == ObstacleKind::plane) return infinite;
  return obstacle.kind == ObstacleKind::sphere ? obstacle.radius : obstacle.half[axis];
}

}  // namespace

void ObstacleColumns::fit(std::size_t most) {
  count = 0;
  for (auto* columns : {&at, &extent}) {
    for (auto& column : *columns) column.resize(most + spare);
  }
  radius.resize(most + spare);
  number.resize(most + spare);
}

void ObstacleColumns::fill(const Model& model, const std::vector<Obstacle>& obstacles) {
  fit(obstacles.size());
  const float size = std::max({model.size[0], model.size[1], model.size[2]});
  for (const Obstacle& obstacle : obstacles) {
    const auto& place = obstacle.at;
    const float slack = 1e-5f * (size + std::abs(place[0]) + std::abs(place[1]) + std::abs(place[2]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis][count] = place[axis];
      extent[axis][count] = 1.0001f * extent_of(obstacle, axis) + slack;
    }
    const bool is_sphere = obstacle.kind == ObstacleKind::sphere;
    radius[count] = is_sphere ? 1.0001f * obstacle.radius + slack : infinite;
    number[count] = std::bit_cast<float>(static_cast<std::uint32_t>(count));
    ++count;
  }
  for (std::size_t i = count; i < radius.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis][i] = 0;
      extent[axis][i] = -infinite;
    }
    radius[i] = 0;
    number[i] = 0;
  }
}

void ObstacleColumns::spoil() {
  for (auto* columns : {&at, &extent}) {
    for (auto& column : *columns) std::fill(column.begin(), column.end(), std::nanf(""));
  }
  std::fill(radius.begin(), radius.end(), std::nanf(""));
}

}  // namespace sturnus
