// Work on whole states: hash, order, removal.
#include "world/state.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <numeric>

#if defined(__unix__)
#include <unistd.h>
#endif

#include "base/hash.h"

namespace sturnus {
namespace {

template <class T>
void permute(std::vector<T>& array, const std::vector<std::uint32_t>& order, std::vector<T>& moved,
             const Workers& workers) {
  if (array.empty() || order.empty()) return;
  assert(order.size() == array.size());
  moved.resize(array.size());
  workers.for_ranges(order.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) moved[i] = array[order[i]];
  });
  array.swap(moved);
}

// 0 without obstacles. Their order is part of it: a number is an obstacle's name.
std::uint64_t hash_of(const std::vector<Obstacle>& obstacles) {
  std::uint64_t hash = 0;
  for (const Obstacle& obstacle : obstacles) {
    hash = fold(fold(hash, static_cast<std::uint64_t>(obstacle.kind)), bits_of(obstacle.radius));
    for (const auto* vector : {&obstacle.at, &obstacle.half, &obstacle.normal}) {
      for (const float value : *vector) hash = fold(hash, bits_of(value));
    }
  }
  return hash;
}

// Whether every value is that of the first, so that no order matters.
bool is_even(const std::vector<std::uint8_t>& array) {
  return array.size() < 2 || std::memcmp(array.data(), array.data() + 1, array.size() - 1) == 0;
}

template <class T>
void keep_in(std::vector<T>& array, const std::vector<std::uint8_t>& marks) {
  if (array.empty()) return;
  assert(marks.size() == array.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) array[kept++] = array[i];
  }
  array.resize(kept);
}

// Nothing where there is no food.
std::uint64_t hash_of(const Food& food) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < food.size(); ++i) {
    std::uint64_t piece = fold(mix(food.id[i] + 1), food.kind[i]);
    for (const auto& column : food.position) {
      if (!column.empty()) piece = fold(piece, bits_of(column[i]));
    }
    sum += piece;
  }
  return sum;
}

}  // namespace

std::uint64_t hash(const State& state) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    std::uint64_t boid = mix(state.id[i] + 1);
    boid = fold(boid, state.flock[i]);
    boid = fold(boid, state.quarantined[i]);
    for (const Columns* columns : {&state.position, &state.velocity, &state.wander, &state.colour}) {
      for (const auto& column : *columns) {
        if (!column.empty()) boid = fold(boid, bits_of(column[i]));
      }
    }
    for_each_clock(state.life, [&](const std::vector<double>& clock) {
      if (!clock.empty()) boid = fold(boid, bits_of(clock[i]));
    });
    if (!state.life.focus.empty()) boid = fold(boid, state.life.focus[i]);
    sum += boid;
  }
  sum += hash_of(state.food);
  std::uint64_t rest =
      fold(fold(fold(0, state.step), state.next_id), static_cast<std::uint64_t>(state.dimensions));
  rest = fold(rest, static_cast<std::uint64_t>(state.pointer.mode) * 2 + (state.pointer.pressed ? 1 : 0));
  for (const float coordinate : state.pointer.at) rest = fold(rest, bits_of(coordinate));
  if (state.pointer.along != std::array<float, 3>{}) {
    for (const float coordinate : state.pointer.along) rest = fold(rest, bits_of(coordinate));
  }
  return sum + rest + hash_of(state.obstacles);
}

void reorder(State& state, const std::vector<std::uint32_t>& order, Spare& spare, const Workers& workers) {
  permute(state.id, order, spare.ids, workers);
  if (!is_even(state.flock)) permute(state.flock, order, spare.bytes, workers);
  if (!is_even(state.quarantined)) permute(state.quarantined, order, spare.bytes, workers);
  for (Columns* columns : {&state.position, &state.velocity, &state.wander, &state.colour})
    reorder(*columns, order, spare.floats, workers);
  for_each_clock(state.life,
                 [&](std::vector<double>& clock) { permute(clock, order, spare.doubles, workers); });
  permute(state.life.focus, order, spare.ids, workers);
}

void reorder(Columns& columns, const std::vector<std::uint32_t>& order, std::vector<float>& spare,
             const Workers& workers) {
  for (auto& column : columns) permute(column, order, spare, workers);
}

void keep(State& state, const std::vector<std::uint8_t>& marks) {
  for_each_array(state, [&](auto& array) { keep_in(array, marks); });
}

void keep(Columns& columns, const std::vector<std::uint8_t>& marks) {
  for (auto& column : columns) keep_in(column, marks);
}

void keep(Food& food, const std::vector<std::uint8_t>& marks) {
  keep_in(food.id, marks);
  keep_in(food.kind, marks);
  keep(food.position, marks);
}

float wrapped_from_outside(float coordinate, float min, float max) {
  if (!is_sound(coordinate)) return coordinate;
  const float size = max - min;
  const float turned = coordinate - size * std::floor((coordinate - min) / size);
  return turned >= min && turned < max ? turned : min;
}

void wrap_obstacles(State& state, const std::array<float, 3>& min, const std::array<float, 3>& max) {
  for (Obstacle& obstacle : state.obstacles) {
    if (obstacle.kind == ObstacleKind::plane) continue;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(state.dimensions); ++axis)
      obstacle.at[axis] = wrapped(obstacle.at[axis], min[axis], max[axis]);
  }
}

bool is_any_hidden(const State& state) {
  return !state.quarantined.empty() &&
         std::memchr(state.quarantined.data(), 1, state.quarantined.size()) != nullptr;
}

double bytes_needed(double boids) {
  return boids * 260.0;
}

double bytes_available() {
#if defined(__unix__)
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
#else
  return 4e9;
#endif
}

std::optional<std::size_t> View::slot(std::uint64_t id) const {
  const auto found = std::find(state_->id.begin(), state_->id.end(), id);
  if (found == state_->id.end()) return {};
  return static_cast<std::size_t>(found - state_->id.begin());
}

std::vector<std::uint32_t> View::slots_by_id() const {
  std::vector<std::uint32_t> slots(size());
  std::iota(slots.begin(), slots.end(), 0u);
  std::sort(slots.begin(), slots.end(),
            [this](std::uint32_t a, std::uint32_t b) { return state_->id[a] < state_->id[b]; });
  return slots;
}

}  // namespace sturnus
