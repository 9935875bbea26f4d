// How terms share the acceleration: weighted sum, a budget by priority (VUW), or the first that is not zero.
#include <cmath>

#include "rules/rules.h"

namespace sturnus {
namespace {

// |v|, also where its square would overflow.
template <int D>
float safe_length(const Vec<D>& v) {
  const float plain = length(v);
  return std::isfinite(plain) ? plain : length(v * 0x1p-64f) * 0x1p64f;
}

}  // namespace

template <int D>
Vec<D> capped(const Vec<D>& v, float longest) {
  const float size = safe_length(v);
  return size > longest ? v * (longest / size) : v;
}

template <int D>
Vec<D> limited(const Vec<D>& velocity, float min_speed, float max_speed) {
  const float speed = safe_length(velocity);
  if (!(speed > 0) || !std::isfinite(speed)) return velocity;
  if (speed > max_speed) return velocity * (max_speed / speed);
  if (speed < min_speed) return velocity * (min_speed / speed);
  return velocity;
}

template <int D>
void Arbiter<D>::add(const Vec<D>& weighted) {
  switch (arbitration_) {
    case Arbitration::weighted:
      sum_ += weighted;
      break;
    case Arbitration::first:
      sum_ = weighted;
      done_ = !(weighted == Vec<D>{});
      break;
    case Arbitration::budget: {
      const float size = safe_length(weighted);
      done_ = size >= left_;
      sum_ += size > left_ ? weighted * (left_ / size) : weighted;
      left_ -= size;
      break;
    }
  }
}

template Vec<2> capped<2>(const Vec<2>&, float);
template Vec<3> capped<3>(const Vec<3>&, float);
template Vec<2> limited<2>(const Vec<2>&, float, float);
template Vec<3> limited<3>(const Vec<3>&, float, float);
template class Arbiter<2>;
template class Arbiter<3>;

}  // namespace sturnus
