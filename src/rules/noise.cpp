// Noise: a random acceleration in the weighted sum, and a random turn after the velocity update (Vicsek
// 1995).
#include <cmath>

#include "base/root.h"
#include "rules/rules.h"

namespace sturnus {
namespace {

Vec<2> turned(const Vec<2>& v, const CosSin& angle, Draws&) {
  const auto c = static_cast<float>(angle.cos);
  const auto s = static_cast<float>(angle.sin);
  return {{c * v[0] - s * v[1], s * v[0] + c * v[1]}};
}

Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

// About a random axis perpendicular to v: v cos + (axis x v) sin.
Vec<3> turned(const Vec<3>& v, const CosSin& angle, Draws& draws) {
  const Vec<3> heading = unit(v);
  Vec<3> axis;
  do {
    axis = unit(cross(heading, draws.direction<3>()));
  } while (axis == Vec<3>{});
  return v * static_cast<float>(angle.cos) + cross(axis, v) * static_cast<float>(angle.sin);
}

}  // namespace

template <int D>
Vec<D> noise_acceleration(const TermModel& term, const Self<D>& self, const Moment& moment) {
  Draws draws(moment.seed, moment.step, self.id, Stream::noise_acceleration);
  return draws.in_cube<D>() * term.amount;
}

template <int D>
Vec<D> turned_at_random(const Vec<D>& velocity, float eta, std::uint64_t id, const Moment& moment) {
  const float squared = dot(velocity, velocity);
  // Without a direction, or with one lost to overflow, there is nothing to turn; the latter ends in
  // quarantine.
  if (eta == 0 || !(squared > 0) || !std::isfinite(squared)) return velocity;
  Draws draws(moment.seed, moment.step, id, Stream::noise_turn);
  const float angle = eta * (draws.uniform() - 0.5f);
  return turned(velocity, cos_sin(double{angle}), draws);
}

template Vec<2> noise_acceleration<2>(const TermModel&, const Self<2>&, const Moment&);
template Vec<3> noise_acceleration<3>(const TermModel&, const Self<3>&, const Moment&);
template Vec<2> turned_at_random<2>(const Vec<2>&, float, std::uint64_t, const Moment&);
template Vec<3> turned_at_random<3>(const Vec<3>&, float, std::uint64_t, const Moment&);

}  // namespace sturnus
