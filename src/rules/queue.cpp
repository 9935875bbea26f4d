// Queuing: brake for whoever is ahead (Reynolds 1999).
#include <sturnus/steering.h>

#include <algorithm>

#include "rules/rules.h"

namespace sturnus {

bool is_ahead(const Vector& offset, const Vector& velocity, float distance, float cos_half) {
  const Vec<3> o{offset}, v{velocity};
  const float speed = length(v), gap = length(o);
  return speed > 0 && gap < distance && dot(v, o) >= cos_half * speed * gap;
}

Vector brake(const Vector& offset, const Vector& velocity, float distance) {
  const float share = distance > 0 ? std::max(0.0f, 1 - length(Vec<3>{offset}) / distance) : 0.0f;
  return (Vec<3>{velocity} * -share).at;
}

template <int D>
Vec<D> queuing(const QueueModel& model, const Others<D>& others, const Self<D>& self) {
  if (!(model.distance > 0)) return {};
  Found nearest{std::numeric_limits<float>::infinity(), 0, 0};
  const Vector own = widened(self.velocity);
  visit<D>(others.near, self.position, model.distance, others.spans, [&](std::uint32_t slot, float squared) {
    const Found found{squared, others.state.id[slot], slot};
    if (found.id == self.id || !(found < nearest)) return;
    if (is_ahead(widened(others.offset_to(self, slot)), own, model.distance, model.cos_half)) nearest = found;
  });
  if (nearest.distance_squared == std::numeric_limits<float>::infinity()) return {};
  return narrow_to<D>(brake(widened(others.offset_to(self, nearest.slot)), own, model.distance));
}

template Vec<2> queuing<2>(const QueueModel&, const Others<2>&, const Self<2>&);
template Vec<3> queuing<3>(const QueueModel&, const Others<3>&, const Self<3>&);

}  // namespace sturnus
