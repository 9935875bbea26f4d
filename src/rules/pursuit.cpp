// Pursuit: when a quarry will be caught, and steering to where it will be then (Reynolds 1999, VUW CGRA 354).
#include <sturnus/steering.h>

#include "rules/foresight.h"
#include "rules/rules.h"

namespace sturnus {
namespace {

constexpr double longest_time = 1e15;

// In double: squares of squares of the longest lengths, and a difference of products that nearly cancel.
double dot_product(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += double{a[axis]} * double{b[axis]};
  return sum;
}

}  // namespace

// |o + v T| = s T is a T² + 2 b T + c = 0 with a = v·v - s², b = o·v, c = o·o, c > 0. For b < 0 the smallest
// positive root is c / (root - b), whatever the sign of a; for b >= 0 there is one only where a < 0. Neither
// form subtracts what may be nearly equal.
std::optional<float> interception_time(const Vector& offset, const Vector& quarry_velocity, float speed) {
  const double a = dot_product(quarry_velocity, quarry_velocity) - double{speed} * double{speed};
  const double b = dot_product(offset, quarry_velocity);
  const double c = dot_product(offset, offset);
  if (c == 0) return 0.0f;
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || (b >= 0 && a >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double time = b < 0 ? c / (root - b) : (b + root) / -a;
  if (!(time <= longest_time)) return std::nullopt;
  return static_cast<float>(time);
}

float prediction_time(Prediction prediction, float amount, const Vector& offset,
                      const Vector& quarry_velocity, float speed) {
  if (prediction == Prediction::constant) return amount;
  if (prediction == Prediction::intercept) {
    if (const auto time = interception_time(offset, quarry_velocity, speed)) return *time;
  }
  return amount * length(Vec<3>{offset});
}

Vector pursue(const Vector& offset, const Vector& quarry_velocity, float time, const Vector& velocity,
              float max_speed) {
  return seek(predicted(offset, quarry_velocity, time), velocity, max_speed);
}

template <int D>
Vec<D> pursuit(const PursuitModel& model, const Others<D>& others, const Self<D>& self, float max_speed) {
  const auto slot = nearest_of(others, model.flocks, model.radius_squared, self);
  if (!slot) return {};
  const Vector o = widened(others.offset_to(self, *slot));
  const Vector quarry = widened(others.velocity(*slot));
  const Vector own = widened(self.velocity);
  const float time = prediction_time(model.prediction, model.amount, o, quarry, max_speed);
  if (!model.has_offset) return narrow_to<D>(pursue(o, quarry, time, own, max_speed));
  return narrow_to<D>(pursue_offset(o, quarry, model.offset, time, own, max_speed, model.slowing));
}

template Vec<2> pursuit<2>(const PursuitModel&, const Others<2>&, const Self<2>&, float);
template Vec<3> pursuit<3>(const PursuitModel&, const Others<3>&, const Self<3>&, float);

}  // namespace sturnus
