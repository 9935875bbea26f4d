// Flow fields: velocities on a grid, and a whirl (Reynolds 1999).
#include <sturnus/steering.h>

#include <algorithm>

#include "rules/rules.h"

namespace sturnus {
namespace {

// Between which two points of an axis a place lies, and how far on the way from one to the other.
struct Between {
  std::size_t low = 0, high = 0;
  float share = 0;
};

Between between(float place, float first, float spacing, std::size_t points) {
  if (points < 2) return {};
  const float last = static_cast<float>(points - 1);
  const float at = std::clamp((place - first) / spacing, 0.0f, last);
  const std::size_t low = std::min(static_cast<std::size_t>(at), points - 2);
  return {low, low + 1, at - static_cast<float>(low)};
}

}  // namespace

Vector FlowGrid::operator()(const Vector& place) const {
  std::array<Between, 3> ends;
  for (std::size_t axis = 0; axis < 3; ++axis)
    ends[axis] = between(place[axis], first[axis], spacing[axis], points[axis]);
  Vec<3> sum;
  for (unsigned corner = 0; corner < 8; ++corner) {
    float weight = 1;
    std::array<std::size_t, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_high = (corner >> axis & 1u) != 0;
      at[axis] = is_high ? ends[axis].high : ends[axis].low;
      weight *= is_high ? ends[axis].share : 1 - ends[axis].share;
    }
    sum += Vec<3>{velocities[at[0] + points[0] * (at[1] + points[1] * at[2])]} * weight;
  }
  return sum.at;
}

Vector vortex(const Vector& from_centre, float speed, float core) {
  const Vec<3> way{{-from_centre[1], from_centre[0], 0}};
  const float distance = length(way);
  if (distance <= core) return core > 0 ? (way * (speed / core)).at : Vector{};
  return (way * (speed * (core / distance) / distance)).at;
}

template <int D>
Vec<D> flow_following(const FlowModel& model, const Wrapping& image, const Self<D>& self) {
  const auto flow = [&](const Vector& place) -> Vector {
    if (model.kind == FlowKind::uniform) return model.velocity;
    const Vec<D> from_centre = offset(narrow_to<D>(model.centre), narrow_to<D>(place), image);
    if (model.kind == FlowKind::shear) return {model.rate * from_centre[1], 0, 0};
    return vortex(widened(from_centre), model.speed, model.core);
  };
  return narrow_to<D>(follow_flow(flow, model.time, widened(self.position), widened(self.velocity)));
}

template Vec<2> flow_following<2>(const FlowModel&, const Wrapping&, const Self<2>&);
template Vec<3> flow_following<3>(const FlowModel&, const Wrapping&, const Self<3>&);

}  // namespace sturnus
