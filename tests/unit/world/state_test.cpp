// Whole states: the hash covers every array and no order, wrapping, keeping and reordering.
#include "world/state.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "support.h"

namespace sturnus {
namespace {

State full_state(int dimensions, std::size_t count) {
  State state;
  state.dimensions = dimensions;
  state.step = 12;
  state.next_id = 1000;
  for (std::size_t i = 0; i < count; ++i) {
    state.id.push_back(7 * i + 3);
    state.flock.push_back(static_cast<std::uint8_t>(i % 3));
    state.quarantined.push_back(static_cast<std::uint8_t>(i % 5 == 0));
    float value = static_cast<float>(i) + 0.25f;
    for (Columns* columns : {&state.position, &state.velocity, &state.wander, &state.colour}) {
      const std::size_t used = columns == &state.colour ? 3 : static_cast<std::size_t>(dimensions);
      for (std::size_t axis = 0; axis < used; ++axis) (*columns)[axis].push_back(value += 1.5f);
    }
    double clock = static_cast<double>(i) + 0.125;
    for_each_clock(state.life, [&](std::vector<double>& column) { column.push_back(clock += 2.5); });
    state.life.focus.push_back(11 * i + 5);
  }
  return state;
}

void flip(float& value, int bit) {
  value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ (1u << bit));
}
void flip(double& value, int bit) {
  value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ (std::uint64_t{1} << bit));
}
template <class T>
void flip(T& value, int bit) {
  value = static_cast<T>(value ^ (T{1} << bit));
}

TEST(StateHash, EveryBitOfEveryArrayCounts) {
  for (const int dimensions : {2, 3}) {
    State state = full_state(dimensions, 5);
    const std::uint64_t before = hash(state);
    int arrays = 0;
    for_each_array(state, [&](auto& array) {
      arrays += array.empty() ? 0 : 1;
      for (auto& value : array) {
        for (int bit = 0; bit < static_cast<int>(8 * sizeof value); ++bit) {
          flip(value, bit);
          EXPECT_NE(hash(state), before) << "array " << arrays << " bit " << bit;
          flip(value, bit);
        }
      }
    });
    EXPECT_EQ(arrays, 3 + 3 * dimensions + 3 + 5);
    EXPECT_EQ(hash(state), before);
  }
}

TEST(StateHash, TheRestOfTheStateCounts) {
  const State state = full_state(2, 3);
  const std::uint64_t before = hash(state);
  const auto changed = [&](auto change) {
    State other = state;
    change(other);
    return hash(other) != before;
  };
  EXPECT_TRUE(changed([](State& other) { other.step += 1; }));
  EXPECT_TRUE(changed([](State& other) { other.next_id += 1; }));
  EXPECT_TRUE(changed([](State& other) { other.pointer.pressed = true; }));
  EXPECT_TRUE(changed([](State& other) { other.obstacles.emplace_back(); }));
  EXPECT_TRUE(changed([](State& other) { other.pointer.mode = PointerMode::repel; }));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(changed([axis](State& other) { other.pointer.at[axis] = 1; }));
  }
  EXPECT_TRUE(changed([](State& other) {
    other.step += 1;
    other.next_id -= 1;
  }));
  EXPECT_TRUE(changed([](State& other) { std::swap(other.id[0], other.id[1]); }));
}

TEST(StateHash, FoodCountsInWhateverOrderItLies) {
  State state = full_state(2, 3);
  const std::uint64_t without = hash(state);
  state.food = {{500, 501}, {0, 1}, {{{1, 2}, {3, 4}, {}}}};
  const std::uint64_t with = hash(state);
  EXPECT_NE(with, without);
  State other = state;
  other.food = {{501, 500}, {1, 0}, {{{2, 1}, {4, 3}, {}}}};
  EXPECT_EQ(hash(other), with);
  for (const auto change : {0, 1, 2, 3}) {
    other = state;
    if (change == 0) other.food.id[1] = 502;
    if (change == 1) other.food.kind[1] = 0;
    if (change >= 2) other.food.position[static_cast<std::size_t>(change) - 2][1] += 1;
    EXPECT_NE(hash(other), with) << change;
  }
}

RC_GTEST_PROP(StateHash, DoesNotDependOnTheOrderOfStorage, ()) {
  State state = full_state(*rc::gen::inRange(2, 4), *rc::gen::inRange<std::size_t>(0, 40));
  const std::uint64_t before = hash(state);
  std::vector<std::uint32_t> order(state.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::shuffle(order.begin(), order.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
  Spare spare;
  reorder(state, order, spare, Workers(1));
  RC_ASSERT(hash(state) == before);
}

TEST(Reorder, PutsEveryArrayInTheSameOrder) {
  State state = full_state(3, 4);
  const State before = state;
  Spare spare;
  reorder(state, {2, 0, 3, 1}, spare, Workers(1));
  EXPECT_EQ(state.id, (std::vector<std::uint64_t>{17, 3, 24, 10}));
  EXPECT_EQ(state.velocity[2][0], before.velocity[2][2]);
  EXPECT_EQ(state.colour[1][3], before.colour[1][1]);
  EXPECT_EQ(state.life.fasting[2], before.life.fasting[3]);
  EXPECT_EQ(state.life.focus[0], before.life.focus[2]);
  reorder(state, {}, spare, Workers(1));
  EXPECT_EQ(state.id.front(), 17u);
}

TEST(Keep, KeepsTheMarkedInTheirOrder) {
  State state = full_state(2, 5);
  keep(state, {1, 0, 0, 1, 1});
  EXPECT_EQ(state.id, (std::vector<std::uint64_t>{3, 24, 31}));
  for_each_array(state, [](const auto& array) { EXPECT_TRUE(array.empty() || array.size() == 3); });
}

TEST(Wrapped, ExactlyTheUpperEdgeBecomesTheLower) {
  EXPECT_EQ(wrapped(10, 0, 10), 0);
  EXPECT_EQ(wrapped(0, 0, 10), 0);
  EXPECT_EQ(wrapped(20, -20, 20), -20);
  EXPECT_EQ(wrapped(std::nextafter(10.0f, 0.0f), 0, 10), std::nextafter(10.0f, 0.0f));
  EXPECT_EQ(wrapped(-1e-9f, 0, 10), 0);  // 10 - 1e-9 rounds to 10
  EXPECT_EQ(wrapped(12, 0, 10), 2);
  EXPECT_EQ(wrapped(-3, 0, 10), 7);
  EXPECT_EQ(wrapped(-25, 0, 10), 5);
}

RC_GTEST_PROP(Wrapped, StaysInsideAndMovesByWholeTurns, ()) {
  const auto min = static_cast<float>(*rc::gen::inRange(-1000, 1000)) / 8;
  const float max = min + static_cast<float>(*rc::gen::inRange(1, 1000)) / 16;
  const auto at = static_cast<float>(*rc::gen::inRange(-100000, 100000)) / 32;
  const float inside = wrapped(at, min, max);
  RC_ASSERT(inside >= min && inside < max);
  const double turns = (double{at} - double{inside}) / (double{max} - double{min});
  RC_ASSERT(std::abs(turns - std::round(turns)) < 1e-3);
}

TEST(Wrapped, LeavesWhatIsNoPlaceToTheQuarantine) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(std::isfinite(wrapped(nan, 0, 10)));
  EXPECT_FALSE(std::isfinite(wrapped(inf, 0, 10)));
  EXPECT_FALSE(std::isfinite(wrapped(-inf, 0, 10)));
}

TEST(View, FindsBoidsByTheirIds) {
  const ScenarioDef scenario;
  const Columns none;
  State state = full_state(2, 4);
  Spare spare;
  reorder(state, {3, 1, 0, 2}, spare, Workers(1));
  const View view(state, scenario, none, none);
  EXPECT_EQ(view.slot(24), 0u);
  EXPECT_EQ(view.slot(3), 2u);
  EXPECT_FALSE(view.slot(4).has_value());
  EXPECT_EQ(view.slots_by_id(), (std::vector<std::uint32_t>{2, 1, 3, 0}));
  EXPECT_EQ(view.position(0)[2], 0);
  EXPECT_FALSE(view.has_previous());
}

TEST(Bytes, GrowWithTheBoids) {
  EXPECT_GT(bytes_needed(2), bytes_needed(1));
  EXPECT_GT(bytes_available(), 1e6);
}

}  // namespace
}  // namespace sturnus
