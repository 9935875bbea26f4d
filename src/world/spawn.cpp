// New boids, placed and set in motion by counter-based random numbers.
#include "world/spawn.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/random.h"
#include "world/columns.h"
#include "world/solid_body.h"
#include "world/state.h"

namespace sturnus {
namespace {

template <int D>
Vec<D> vec_of(const Coordinates& at, const std::array<float, 3>& otherwise) {
  Vec<D> v;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    v[axis] = at.empty() ? otherwise[i] : static_cast<float>(at[i]);
  }
  return v;
}

std::array<float, 3> middle(const Model& model) {
  std::array<float, 3> out{};
  for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = model.min[axis] + 0.5f * model.size[axis];
  return out;
}

template <int D>
Vec<D> in_box(const Vec<D>& min, const Vec<D>& max, Draws& draws) {
  Vec<D> at;
  for (int axis = 0; axis < D; ++axis) at[axis] = draws.between(min[axis], max[axis]);
  return at;
}

// In the ball, or outside its inner radius, by rejection; a thin ring, which would reject nearly all, is
// drawn along its circle.
template <int D>
Vec<D> in_ring(const Vec<D>& centre, float inner, float outer, Draws& draws) {
  if (inner > 0.95f * outer) {
    const auto direction = draws.direction<D>();
    return centre + direction * draws.between(inner, outer);
  }
  for (;;) {
    const Vec<D> offset = draws.in_ball<D>() * outer;
    if (dot(offset, offset) >= inner * inner) return centre + offset;
  }
}

template <int D>
Vec<D> start_position(const Start& start, const Model& model, Draws& draws) {
  const auto centre = vec_of<D>(start.centre, middle(model));
  const auto radius = static_cast<float>(start.radius);
  switch (start.region) {
    case StartRegion::space:
      return in_box(vec_of<D>({}, model.min), vec_of<D>({}, model.max), draws);
    case StartRegion::box:
      return in_box(vec_of<D>(start.min, {}), vec_of<D>(start.max, {}), draws);
    case StartRegion::ball:
      return in_ring(centre, 0, radius, draws);
    case StartRegion::ring:
      return in_ring(centre, static_cast<float>(start.inner), radius, draws);
  }
  return centre;
}

template <int D>
Vec<D> start_velocity(const Start& start, Draws& draws) {
  const float speed = draws.between(static_cast<float>(start.min_speed), static_cast<float>(start.max_speed));
  const Vec<D> given = vec_of<D>(start.heading, {});
  return (start.heading.empty() ? draws.direction<D>() : unit(given)) * speed;
}

template <int D>
void push(Columns& columns, const Vec<D>& v) {
  for (int axis = 0; axis < D; ++axis) columns[static_cast<std::size_t>(axis)].push_back(v[axis]);
}

// The colours a flock takes when it names none; safe for colour-blind eyes (Okabe and Ito).
constexpr std::array<const char*, 6> palette = {"#56b4e9", "#e69f00", "#009e73",
                                                "#f0e442", "#cc79a7", "#0072b2"};

// A bright colour of any hue: one channel full, one dark, one in between.
Vec<3> random_colour(Draws& draws) {
  const float hue = 6 * draws.uniform();
  const int sextant = static_cast<int>(hue);
  const float part = hue - static_cast<float>(sextant);
  constexpr float dark = 0.25f;
  const float between = dark + (1 - dark) * (sextant % 2 == 0 ? part : 1 - part);
  constexpr int full[] = {0, 1, 1, 2, 2, 0};
  constexpr int mixed[] = {1, 0, 2, 1, 0, 2};
  Vec<3> v{{dark, dark, dark}};
  v[full[sextant % 6]] = 1;
  v[mixed[sextant % 6]] = between;
  return v;
}

Vec<3> start_colour(const Colour& colour, std::size_t flock, Draws& draws) {
  if (colour.start == "random") return random_colour(draws);
  return Vec<3>{colour_of_hex(colour.start.empty() ? palette[flock % palette.size()] : colour.start)};
}

// What a boid has besides place and velocity, where the state keeps it at all.
template <int D>
void push_sides(const ScenarioDef& scenario, const Model& model, std::size_t flock, std::uint64_t id,
                State& state) {
  if (model.uses_wander) {
    Draws draws(model.seed, state.step, id, Stream::start_wander);
    push(state.wander, draws.direction<D>());
  }
  if (model.uses_colour) {
    Draws draws(model.seed, state.step, id, Stream::start_colour);
    push(state.colour, start_colour(scenario.flocks[flock].colour, flock, draws));
  }
  if (model.uses_hunger) {
    state.life.full.push_back(0);
    state.life.fasting.push_back(0);
  }
  if (model.uses_jump) {
    state.life.jump.push_back(0);
    state.life.rest.push_back(0);
  }
  if (model.uses_focus) state.life.focus.push_back(nobody);
}

template <int D>
void push_boid(const ScenarioDef& scenario, const Model& model, std::size_t flock, std::uint64_t id,
               const Vec<D>& position, const Vec<D>& velocity, State& state) {
  state.id.push_back(id);
  state.flock.push_back(static_cast<std::uint8_t>(flock));
  state.quarantined.push_back(0);
  push(state.position, position);
  push(state.velocity, velocity);
  push_sides<D>(scenario, model, flock, id, state);
}

void reserve(State& state, std::size_t size) {
  for_each_array(state, [size](auto& array) { array.reserve(size); });
}

// An index of its own, for who has none.
ObstacleIndex index_of(const Model& model, const State& state, float body) {
  ObstacleIndex index;
  index.fit(model, state.obstacles, body);
  return index;
}

constexpr int most_tries = 1000;

// Draws until a place is good; false, with the last place, when none was.
template <int D, class Draw, class IsGood>
bool find_place(Vec<D>& place, int tries, Draw&& draw, IsGood&& is_good) {
  while (tries-- > 0) {
    place = draw();
    if (is_good(place)) return true;
  }
  return false;
}

// A place as the state keeps it.
template <int D>
Vec<D> wrapped_place(const Model& model, Vec<D> place) {
  for (int axis = 0; axis < D && model.wraps(); ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    place[axis] = wrapped(place[axis], model.min[i], model.max[i]);
  }
  return place;
}

template <int D>
std::int64_t spawn_flock_in(const ScenarioDef& scenario, const Model& model, std::size_t flock,
                            State& state) {
  const FlockDef& def = scenario.flocks[flock];
  reserve(state, state.size() + static_cast<std::size_t>(def.count));
  const float body = model.flocks[flock].body_radius;
  const ObstacleIndex obstacles = index_of(model, state, body);
  const Solids<D> solids(model, obstacles, body);
  std::int64_t inside = 0;
  for (std::int64_t i = 0; i < def.count; ++i) {
    const std::uint64_t id = state.next_id++;
    Draws position_draws(model.seed, state.step, id, Stream::start_position);
    Draws velocity_draws(model.seed, state.step, id, Stream::start_velocity);
    Vec<D> position;
    const bool is_found = find_place(
        position, most_tries, [&] { return start_position<D>(def.start, model, position_draws); },
        [&](const Vec<D>& at) { return solids.is_outside(wrapped_place(model, at)); });
    if (!is_found) ++inside;
    push_boid<D>(scenario, model, flock, id, position, start_velocity<D>(def.start, velocity_draws), state);
  }
  return inside;
}

// Where a boid that is added stands. In a solid world that is a free place: the nearest, and if even that
// can't be had, any in the space. False where there is none at all.
template <int D>
bool added_position(const Model& model, const AddBoids& add, const Solids<D>& solids, Draws& draws,
                    Vec<D>& position) {
  const auto is_free = [&](const Vec<D>& at) { return solids.is_free(wrapped_place(model, at)); };
  const bool is_found = find_place(
      position, most_tries,
      [&] { return vec_of<D>(add.at, {}) + draws.in_ball<D>() * static_cast<float>(add.radius); }, is_free);
  if (is_found || !model.is_solid || solids.bring_out(position)) return true;
  return find_place(
      position, most_tries, [&] { return in_box(vec_of<D>({}, model.min), vec_of<D>({}, model.max), draws); },
      is_free);
}

template <int D>
bool spawn_around_in(const ScenarioDef& scenario, const Model& model, const AddBoids& add, State& state) {
  std::size_t flock = 0;
  while (scenario.flocks[flock].name != add.flock) ++flock;
  const FlockDef& def = scenario.flocks[flock];
  const float body = model.flocks[flock].body_radius;
  const ObstacleIndex obstacles = index_of(model, state, body);
  const Solids<D> solids(model, obstacles, body);
  bool are_all_there = true;
  for (std::int64_t i = 0; i < add.count; ++i) {
    const std::uint64_t id = state.next_id++;
    Draws position_draws(model.seed, state.step, id, Stream::start_position);
    Draws velocity_draws(model.seed, state.step, id, Stream::start_velocity);
    Vec<D> position;
    if (added_position(model, add, solids, position_draws, position)) {
      push_boid<D>(scenario, model, flock, id, position, start_velocity<D>(def.start, velocity_draws), state);
    } else {
      are_all_there = false;
    }
  }
  return are_all_there;
}

template <int D>
bool bring_out_in(const Model& model, std::size_t slot, State& state) {
  const float body = model.flocks[state.flock[slot]].body_radius;
  const ObstacleIndex obstacles = index_of(model, state, body);
  const Solids<D> solids(model, obstacles, body);
  auto place = at<D>(state.position, slot);
  if (!solids.is_free(place) && !solids.bring_out(place)) return false;
  put(state.position, slot, place);
  return true;
}

// Uniform in the space, or in a ball about the place where the food appears.
template <int D>
Vec<D> food_position(const Model& model, const Coordinates& at, double radius, Draws& draws) {
  if (at.empty()) return in_box(vec_of<D>({}, model.min), vec_of<D>({}, model.max), draws);
  return vec_of<D>(at, {}) + draws.in_ball<D>() * static_cast<float>(radius);
}

template <int D>
void push_food(const Model& model, std::size_t kind, std::uint64_t id, Vec<D> position, State& state) {
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (model.wraps()) position[axis] = wrapped(position[axis], model.min[i], model.max[i]);
  }
  state.food.id.push_back(id);
  state.food.kind.push_back(static_cast<std::uint8_t>(kind));
  push(state.food.position, position);
}

// How far from solid obstacles a piece lies (length): its body does not touch them, and the smallest of those
// who feed on it can stand there.
float food_room(const Model& model, std::size_t kind) {
  float least = FlockModel::infinity_f;
  for (const FlockModel& flock : model.flocks) {
    if (flock.feed && flock.feed->kind == kind) least = std::min(least, flock.body_radius);
  }
  const float own = model.food[kind].body_radius;
  return std::isinf(least) ? own : std::max(own, least);
}

// False where nothing is free.
template <int D, class Draw>
bool free_food_position(const Model& model, const Solids<D>& solids, Draw&& draw, Vec<D>& position) {
  constexpr int tries = 100;
  const bool is_found = find_place(
      position, tries, draw, [&](const Vec<D>& at) { return solids.is_free(wrapped_place(model, at)); });
  return is_found || solids.bring_out(position);
}

template <int D>
void spawn_food_in(const Model& model, std::size_t kind, std::size_t count, const Coordinates& at,
                   double radius, const ObstacleIndex& obstacles, State& state) {
  const Solids<D> solids(model, obstacles, food_room(model, kind));
  const bool is_solid = model.is_solid && !obstacles.empty();
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t id = state.next_id++;
    Draws draws(model.seed, state.step, id, Stream::food);
    const auto draw = [&] { return food_position<D>(model, at, radius, draws); };
    Vec<D> position;
    if (!is_solid) {
      push_food<D>(model, kind, id, draw(), state);
    } else if (free_food_position(model, solids, draw, position)) {
      push_food<D>(model, kind, id, position, state);
    }
  }
}

template <int D>
void spawn_beside_in(const ScenarioDef& scenario, const Model& model, std::size_t flock, const Vec<D>& place,
                     float distance, State& state) {
  const std::uint64_t id = state.next_id++;
  Draws draws(model.seed, state.step, id, Stream::birth);
  const Vec<D> position = place + draws.direction<D>() * distance;
  push_boid<D>(scenario, model, flock, id, position, start_velocity<D>(scenario.flocks[flock].start, draws),
               state);
  for (std::size_t axis = 0; model.wraps() && axis < D; ++axis) {
    float& coordinate = state.position[axis].back();
    coordinate = wrapped(coordinate, model.min[axis], model.max[axis]);
  }
}

void copy_clock(std::vector<double>& to, const std::vector<double>& from, std::size_t i) {
  if (!from.empty() && !to.empty()) to.back() = from[i];
}

void copy_life(Life& to, const Life& from, std::size_t i) {
  copy_clock(to.full, from.full, i);
  copy_clock(to.fasting, from.fasting, i);
  copy_clock(to.jump, from.jump, i);
  copy_clock(to.rest, from.rest, i);
  if (!from.focus.empty() && !to.focus.empty()) to.focus.back() = from.focus[i];
}

void copy_back(Columns& to, const Columns& from, std::size_t i) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!from[axis].empty() && !to[axis].empty()) to[axis].back() = from[axis][i];
  }
}

template <int D>
void append_boids_in(const ScenarioDef& scenario, const Model& model, const State& from, int flock,
                     State& state) {
  std::unordered_set<std::uint64_t> taken(state.id.begin(), state.id.end());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (flock >= 0 && from.flock[i] != flock) continue;
    std::uint64_t id = from.id[i];
    if (!taken.insert(id).second) {
      id = state.next_id;
      taken.insert(id);
    }
    state.next_id = std::max(state.next_id, id + 1);
    push_boid<D>(scenario, model, from.flock[i], id, at<D>(from.position, i), at<D>(from.velocity, i), state);
    state.quarantined.back() = from.quarantined[i];
    copy_back(state.wander, from.wander, i);
    copy_back(state.colour, from.colour, i);
    copy_life(state.life, from.life, i);
  }
  for (std::size_t i = 0; flock < 0 && i < from.food.size(); ++i) {
    const std::uint64_t id = taken.insert(from.food.id[i]).second ? from.food.id[i] : state.next_id;
    taken.insert(id);
    state.next_id = std::max(state.next_id, id + 1);
    push_food<D>(model, from.food.kind[i], id, at<D>(from.food.position, i), state);
  }
  state.next_id = std::max(state.next_id, from.next_id);
}

}  // namespace

std::int64_t spawn_flock(const ScenarioDef& scenario, const Model& model, std::size_t flock, State& state) {
  return model.dimensions == 3 ? spawn_flock_in<3>(scenario, model, flock, state)
                               : spawn_flock_in<2>(scenario, model, flock, state);
}

bool spawn_around(const ScenarioDef& scenario, const Model& model, const AddBoids& add, State& state) {
  return model.dimensions == 3 ? spawn_around_in<3>(scenario, model, add, state)
                               : spawn_around_in<2>(scenario, model, add, state);
}

bool bring_out(const Model& model, std::size_t slot, State& state) {
  return model.dimensions == 3 ? bring_out_in<3>(model, slot, state) : bring_out_in<2>(model, slot, state);
}

void spawn_beside(const ScenarioDef& scenario, const Model& model, std::size_t flock,
                  const std::array<float, 3>& place, float distance, State& state) {
  model.dimensions == 3 ? spawn_beside_in<3>(scenario, model, flock, narrow_to<3>(place), distance, state)
                        : spawn_beside_in<2>(scenario, model, flock, narrow_to<2>(place), distance, state);
}

void spawn_food(const ScenarioDef& scenario, const Model& model, std::size_t kind, std::size_t count,
                const ObstacleIndex& obstacles, State& state) {
  const FoodDef& food = scenario.food[kind];
  model.dimensions == 3 ? spawn_food_in<3>(model, kind, count, food.at, food.radius, obstacles, state)
                        : spawn_food_in<2>(model, kind, count, food.at, food.radius, obstacles, state);
}

void spawn_food(const ScenarioDef& scenario, const Model& model, State& state) {
  for (std::size_t kind = 0; kind < scenario.food.size(); ++kind) {
    const auto count = static_cast<std::size_t>(scenario.food[kind].count);
    spawn_food(scenario, model, kind, count, index_of(model, state, food_room(model, kind)), state);
  }
}

void spawn_food_around(const ScenarioDef& scenario, const Model& model, const AddFood& add, State& state) {
  std::size_t kind = 0;
  while (scenario.food[kind].name != add.food) ++kind;
  const auto count = static_cast<std::size_t>(add.count);
  const ObstacleIndex obstacles = index_of(model, state, food_room(model, kind));
  model.dimensions == 3 ? spawn_food_in<3>(model, kind, count, add.at, add.radius, obstacles, state)
                        : spawn_food_in<2>(model, kind, count, add.at, add.radius, obstacles, state);
}

std::size_t most_after_births(const Model& model, const State& state) {
  std::size_t most = state.size();
  std::vector<std::size_t> members(model.flocks.size());
  for (const std::uint8_t flock : state.flock) ++members[flock];
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::size_t cap = model.flocks[i].feed ? model.flocks[i].population_cap : 0;
    most += cap > members[i] ? cap - members[i] : 0;
  }
  return most;
}

void append_boids(const ScenarioDef& scenario, const Model& model, const State& from, int flock,
                  State& state) {
  model.dimensions == 3 ? append_boids_in<3>(scenario, model, from, flock, state)
                        : append_boids_in<2>(scenario, model, from, flock, state);
}

void wrap_positions(const Model& model, State& state) {
  if (!model.wraps()) return;
  wrap_obstacles(state, model.min, model.max);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(model.dimensions); ++axis) {
    for (float& coordinate : state.position[axis])
      coordinate = wrapped(coordinate, model.min[axis], model.max[axis]);
  }
}

}  // namespace sturnus
