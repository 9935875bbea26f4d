// The grid over food finds exactly what a look at every piece finds, in any space.
#include "neighbours/pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <set>

namespace sturnus {
namespace {

template <int D>
void compare(unsigned seed, bool wraps, std::size_t count, float reach) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const std::array<float, 3> low{-50, 10, 0}, size{200, 120, 90};
  Wrapping image{wraps, size, {100, 60, 45}};
  Food food;
  for (std::size_t i = 0; i < count; ++i) {
    food.id.push_back(i);
    food.kind.push_back(0);
    for (std::size_t axis = 0; axis < D; ++axis)
      food.position[axis].push_back(between(low[axis], low[axis] + size[axis]));
  }
  Pieces pieces;
  pieces.build(food, D, image, low, reach);
  for (int question = 0; question < 50; ++question) {
    Vec<D> at;
    const float outside = wraps ? 0.0f : 40.0f;  // an open space may hold boids beyond its corners
    for (int axis = 0; axis < D; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      at[axis] = between(low[i] - outside, low[i] + size[i] + outside);
    }
    const float radius = question % 2 == 0 ? reach : between(0, 2 * reach);
    std::set<std::uint32_t> wanted, found;
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec<D> place;
      for (int axis = 0; axis < D; ++axis) place[axis] = food.position[static_cast<std::size_t>(axis)][i];
      const Vec<D> o = offset(at, place, image);
      if (dot(o, o) <= radius * radius) wanted.insert(i);
    }
    pieces.visit<D>(at, radius, [&](std::uint32_t piece, std::uint8_t, const Vec<D>&) {
      RC_ASSERT(found.insert(piece).second);
    });
    RC_ASSERT(found == wanted);
  }
}

RC_GTEST_PROP(Pieces, FindsWhatALookAtAllFinds, ()) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const auto count = *rc::gen::inRange<std::size_t>(0, 300);
  const float reach = 0.5f * static_cast<float>(*rc::gen::inRange(1, 160));
  const bool wraps = *rc::gen::arbitrary<bool>();
  *rc::gen::arbitrary<bool>() ? compare<2>(seed, wraps, count, reach) : compare<3>(seed, wraps, count, reach);
}

/// Boids in a small box ask together: each of them has to meet his pieces in the order in which he finds them
/// alone.
template <int D>
void compare_order(unsigned seed, bool wraps, std::size_t count, float radius, float side) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const std::array<float, 3> low{0, 0, 0}, size{100, 90, 110};
  const Wrapping image{wraps, size, {50, 45, 55}};
  Food food;
  for (std::size_t i = 0; i < count; ++i) {
    food.id.push_back(i);
    food.kind.push_back(0);
    for (std::size_t axis = 0; axis < D; ++axis) food.position[axis].push_back(between(0, size[axis]));
  }
  Pieces pieces;
  pieces.build(food, D, image, low, radius);
  std::array<float, 3> from{}, to{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    from[axis] = between(0, size[axis] - side);
    to[axis] = from[axis] + side;
  }
  std::vector<Pieces::Run> runs;
  if (!pieces.find_runs(from, to, radius, runs)) return;
  for (int boid = 0; boid < 20; ++boid) {
    Vec<D> at;
    for (int axis = 0; axis < D; ++axis)
      at[axis] = between(from[static_cast<std::size_t>(axis)], to[static_cast<std::size_t>(axis)]);
    std::vector<Vec<D>> wanted, found;
    pieces.visit<D>(at, radius, [&](std::uint32_t, std::uint8_t, const Vec<D>& o) { wanted.push_back(o); });
    for (const Pieces::Run run : runs) {
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        Vec<D> place;
        for (int axis = 0; axis < D; ++axis)
          place[axis] = pieces.coordinate_at(static_cast<std::size_t>(axis), i);
        const Vec<D> o = offset(at, place, image);
        if (dot(o, o) <= radius * radius) found.push_back(o);
      }
    }
    RC_ASSERT(found == wanted);
  }
}

RC_GTEST_PROP(Pieces, AreMetTogetherInTheOrderOfEach, ()) {
  const auto seed = *rc::gen::arbitrary<unsigned>();
  const auto count = *rc::gen::inRange<std::size_t>(0, 300);
  const float radius = 0.5f * static_cast<float>(*rc::gen::inRange(1, 80));
  const float side = 0.5f * static_cast<float>(*rc::gen::inRange(0, 100));
  const bool wraps = *rc::gen::arbitrary<bool>();
  *rc::gen::arbitrary<bool>() ? compare_order<2>(seed, wraps, count, radius, side)
                              : compare_order<3>(seed, wraps, count, radius, side);
}

}  // namespace
}  // namespace sturnus
