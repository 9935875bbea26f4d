// The edge of the space: turn back inside a margin, wrap around, or bounce.
#include <cmath>

#include "rules/rules.h"
#include "world/state.h"

namespace sturnus {
namespace {

// Folds a coordinate into [0, size] as a ball between two walls would go; tells whether it moves backwards
// then.
bool fold_back(float& coordinate, float size) {
  const float turns = std::floor(coordinate / size);
  coordinate -= turns * size;
  const bool mirrored = std::fmod(turns, 2.0f) != 0;
  if (mirrored) coordinate = size - coordinate;
  return mirrored;
}

}  // namespace

template <int D>
Vec<D> boundary_turn(const Model& model, const Vec<D>& position) {
  Vec<D> push;
  if (model.boundary != BoundaryKind::turn) return push;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (position[axis] < model.min[i] + model.margin[i]) push[axis] += model.turn_strength;
    if (position[axis] > model.max[i] - model.margin[i]) push[axis] -= model.turn_strength;
  }
  return push;
}

template <int D>
void keep_inside(const Model& model, Vec<D>& position, Vec<D>& velocity) {
  if (model.boundary != BoundaryKind::wrap && model.boundary != BoundaryKind::bounce) return;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (model.wraps()) {
      position[axis] = wrapped(position[axis], model.min[i], model.max[i]);
    } else if (position[axis] < model.min[i] || position[axis] > model.max[i]) {
      float inside = position[axis] - model.min[i];
      if (fold_back(inside, model.size[i])) velocity[axis] = -velocity[axis];
      position[axis] = model.min[i] + inside;
      // From far away the fold is only as exact as the coordinate was.
      if (position[axis] < model.min[i]) position[axis] = model.min[i];
      if (position[axis] > model.max[i]) position[axis] = model.max[i];
    }
  }
}

template Vec<2> boundary_turn<2>(const Model&, const Vec<2>&);
template Vec<3> boundary_turn<3>(const Model&, const Vec<3>&);
template void keep_inside<2>(const Model&, Vec<2>&, Vec<2>&);
template void keep_inside<3>(const Model&, Vec<3>&, Vec<3>&);

}  // namespace sturnus
