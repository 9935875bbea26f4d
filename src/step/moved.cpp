// The longest way of many boids, a register of them at a time.
#include "step/moved.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step/moved.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "step/lane_vec-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// Who has no sound place is out of play.
template <int D>
float LongestWay(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                 std::size_t end) {
  const Floats d;
  Lanes most = hn::Zero(d);
  for (std::size_t first = begin; first < end; first += width) {
    const std::size_t count = std::min<std::size_t>(width, end - first);
    const LaneVec<D> way =
        Offset(LoadSomeVec<D>(from, first, count), LoadSomeVec<D>(to, first, count), image);
    const Lanes squared = Squared<D>(way.at);
    most = hn::Max(most, hn::IfThenElseZero(hn::Le(squared, hn::Set(d, 1e38f)), squared));
  }
  const float size = std::max({image.size[0], image.size[1], image.size[2]});
  return 1.0001f * std::sqrt(hn::GetLane(hn::MaxOfLanes(d, most))) + 1e-5f * size;
}

float LongestWay2(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                  std::size_t end) {
  return LongestWay<2>(from, to, image, begin, end);
}
float LongestWay3(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                  std::size_t end) {
  return LongestWay<3>(from, to, image, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sturnus {

HWY_EXPORT(LongestWay2);
HWY_EXPORT(LongestWay3);

template <>
float longest_way<2>(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                     std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(LongestWay2)(from, to, image, begin, end);
}
template <>
float longest_way<3>(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                     std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(LongestWay3)(from, to, image, begin, end);
}

}  // namespace sturnus
#endif
