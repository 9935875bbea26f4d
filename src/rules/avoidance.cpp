// Unaligned collision avoidance: step aside from whoever will come too near (Reynolds 1999).
#include <sturnus/steering.h>

#include "rules/rules.h"

namespace sturnus {
namespace {

// Below this share of the present distance, what lies across the heading is rounding, and no side to go by.
constexpr float least_share = 1e-3f;

}  // namespace

std::optional<float> nearest_approach_time(const Vector& offset, const Vector& other_velocity,
                                           const Vector& velocity) {
  const Vec<3> relative = Vec<3>{other_velocity} - Vec<3>{velocity};
  const float closing = -dot(Vec<3>{offset}, relative);
  const float speed_squared = dot(relative, relative);
  if (!(closing > 0) || !(speed_squared > 0)) return std::nullopt;
  return closing / speed_squared;
}

Vector sidestep(const Vector& offset, const Vector& other_velocity, float time, const Vector& velocity) {
  const Vec<3> gap = Vec<3>{offset} + (Vec<3>{other_velocity} - Vec<3>{velocity}) * time;
  const Vec<3> ahead = unit(Vec<3>{velocity});
  const Vec<3> across = gap - ahead * dot(gap, ahead);
  if (!(length(across) > least_share * length(Vec<3>{offset}))) return in_world({0, -1, 0}, velocity);
  return (unit(across) * -1.0f).at;
}

template <int D>
Vec<D> collision_avoidance(const AvoidanceModel& model, const Others<D>& others, const Self<D>& self) {
  if (!(model.radius > 0)) return {};
  float first = model.time;
  std::uint64_t first_id = ~std::uint64_t{0};
  Vec<D> aside;
  const Vector own = widened(self.velocity);
  visit<D>(others.near, self.position, model.radius, others.spans, [&](std::uint32_t slot, float) {
    const std::uint64_t id = others.state.id[slot];
    if (id == self.id) return;
    const Vec<D> o = others.offset_to(self, slot);
    const Vec<D> v = others.velocity(slot);
    const auto time = nearest_approach_time(widened(o), widened(v), own);
    if (!time || *time > first || (*time == first && id > first_id)) return;
    const Vec<D> gap = o + (v - self.velocity) * *time;
    if (!(dot(gap, gap) < model.gap_squared)) return;
    first = *time;
    first_id = id;
    aside = narrow_to<D>(sidestep(widened(o), widened(v), *time, own));
  });
  return aside;
}

template Vec<2> collision_avoidance<2>(const AvoidanceModel&, const Others<2>&, const Self<2>&);
template Vec<3> collision_avoidance<3>(const AvoidanceModel&, const Others<3>&, const Self<3>&);

}  // namespace sturnus
