// Lists of numbers to obstacles and back; random spheres by throwing darts; checks.
#include "scenario/obstacles.h"

#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/text.h"

namespace sturnus {
namespace {

constexpr int most_tries = 1000;  // places that are drawn for one random sphere

Obstacle sphere_of(const Coordinates& numbers) {
  Obstacle out;
  for (std::size_t axis = 0; axis + 1 < numbers.size(); ++axis)
    out.at[axis] = static_cast<float>(numbers[axis]);
  out.radius = static_cast<float>(numbers.back());
  return out;
}

Obstacle box_of(const Coordinates& numbers) {
  Obstacle out;
  out.kind = ObstacleKind::box;
  const std::size_t axes = numbers.size() / 2;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.at[axis] = static_cast<float>(0.5 * (numbers[axis] + numbers[axis + axes]));
    out.half[axis] = static_cast<float>(0.5 * (numbers[axis + axes] - numbers[axis]));
  }
  return out;
}

Obstacle plane_of(const Coordinates& numbers) {
  Obstacle out;
  out.kind = ObstacleKind::plane;
  const std::size_t axes = numbers.size() / 2;
  double squared = 0;
  for (std::size_t axis = 0; axis < axes; ++axis) squared += numbers[axis + axes] * numbers[axis + axes];
  // What is a unit vector in single precision stays as it is, so that a printed plane reads back to its bits.
  const double scale = std::abs(squared - 1) < 1e-6 ? 1 : 1 / std::sqrt(squared);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.at[axis] = static_cast<float>(numbers[axis]);
    out.normal[axis] = static_cast<float>(numbers[axis + axes] * scale);
  }
  return out;
}

// The space in which random spheres are thrown, with the shortest way between places in it.
struct Field {
  Extent extent;
  bool wraps = false;

  explicit Field(const ScenarioDef& scenario)
      : extent(extent_of(scenario)), wraps(scenario.space.boundary.kind == BoundaryKind::wrap) {}
  std::size_t axes() const { return extent.min.size(); }
  double size(std::size_t axis) const { return extent.max[axis] - extent.min[axis]; }

  double along(std::size_t axis, double from, double to) const {
    double o = to - from;
    if (wraps && o > size(axis) / 2) o -= size(axis);
    if (wraps && o < -size(axis) / 2) o += size(axis);
    return o;
  }

  // From a place to the surface of an obstacle, negative inside; of a box no more than to the surface.
  double room(const std::array<float, 3>& at, const Obstacle& obstacle) const {
    double squared = 0, inside = -infinity, beyond = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const double o = along(axis, double{obstacle.at[axis]}, double{at[axis]});
      const double past = std::abs(o) - double{obstacle.half[axis]};
      squared += past > 0 ? past * past : 0;
      inside = std::max(inside, past);
      beyond += o * double{obstacle.normal[axis]};
    }
    if (obstacle.kind == ObstacleKind::plane) return beyond;
    if (obstacle.kind == ObstacleKind::box && inside < 0) return inside;
    return std::sqrt(squared) - double{obstacle.radius};
  }
};

// Spheres that have found their room, in cells so large that who is too near stands in the next one at most.
class Thrown {
 public:
  Thrown(const Field& field, double widest) : field_(field) {
    for (std::size_t axis = 0; axis < field.axes(); ++axis) {
      counts_[axis] = static_cast<int>(std::clamp(std::floor(field.size(axis) / widest), 1.0, 64.0));
      total_ *= static_cast<std::size_t>(counts_[axis]);
    }
    cells_.resize(total_);
  }

  void add(const Obstacle& sphere) {
    std::array<int, 3> cell{};
    for (std::size_t axis = 0; axis < field_.axes(); ++axis) cell[axis] = cell_of(axis, sphere.at[axis]);
    cells_[number_of(cell)].push_back(sphere);
  }

  bool has_room(const Obstacle& sphere, double keep_apart) const {
    std::array<int, 3> low{}, high{};
    for (std::size_t axis = 0; axis < field_.axes(); ++axis) {
      low[axis] = cell_of(axis, sphere.at[axis]) - 1;
      high[axis] = low[axis] + 2;
    }
    std::array<int, 3> at{};
    for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) {
          if (!are_far(at, sphere, keep_apart)) return false;
        }
      }
    }
    return true;
  }

 private:
  int cell_of(std::size_t axis, float at) const {
    const double share = (double{at} - field_.extent.min[axis]) / field_.size(axis);
    return std::clamp(static_cast<int>(share * counts_[axis]), 0, counts_[axis] - 1);
  }

  std::size_t number_of(const std::array<int, 3>& cell) const {
    std::size_t number = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      number = number * static_cast<std::size_t>(counts_[axis]) + static_cast<std::size_t>(cell[axis]);
    return number;
  }

  bool are_far(std::array<int, 3> cell, const Obstacle& sphere, double keep_apart) const {
    for (std::size_t axis = 0; axis < field_.axes(); ++axis) {
      if (cell[axis] >= 0 && cell[axis] < counts_[axis]) continue;
      if (!field_.wraps) return true;
      cell[axis] = (cell[axis] + counts_[axis]) % counts_[axis];
    }
    const auto& others = cells_[number_of(cell)];
    return std::all_of(others.begin(), others.end(), [&](const Obstacle& other) {
      return field_.room(sphere.at, other) - double{sphere.radius} >= keep_apart;
    });
  }

  const Field& field_;
  std::array<int, 3> counts_{1, 1, 1};
  std::size_t total_ = 1;
  std::vector<std::vector<Obstacle>> cells_;
};

// A place for a sphere: wholly inside the space, or anywhere where it wraps. False where it is too large.
bool draw_place(const Field& field, Draws& draws, Obstacle& sphere) {
  for (std::size_t axis = 0; axis < field.axes(); ++axis) {
    const double rim = field.wraps ? 0 : double{sphere.radius};
    if (!(field.size(axis) > 2 * rim)) return false;
    sphere.at[axis] = draws.between(static_cast<float>(field.extent.min[axis] + rim),
                                    static_cast<float>(field.extent.max[axis] - rim));
  }
  return true;
}

// Throws the spheres of one table among the obstacles that are there; tells how many found room.
std::int64_t throw_spheres(const RandomObstacles& random, const Field& field, std::uint64_t seed,
                           std::vector<Obstacle>& obstacles) {
  Thrown thrown(field, 2 * random.max_radius + random.keep_apart);
  const std::vector<Obstacle> earlier = obstacles;
  for (std::int64_t i = 0; i < random.count; ++i) {
    Draws draws(seed, 0, obstacles.size(), Stream::obstacle);
    Obstacle sphere;
    sphere.radius =
        draws.between(static_cast<float>(random.min_radius), static_cast<float>(random.max_radius));
    const auto fits = [&] {
      return draw_place(field, draws, sphere) && thrown.has_room(sphere, random.keep_apart) &&
             std::all_of(earlier.begin(), earlier.end(), [&](const Obstacle& other) {
               return field.room(sphere.at, other) - double{sphere.radius} >= random.keep_apart;
             });
    };
    bool found = false;
    for (int tries = 0; tries < most_tries && !found; ++tries) found = fits();
    if (!found) return i;
    thrown.add(sphere);
    obstacles.push_back(sphere);
  }
  return random.count;
}

std::string key_of(const ScenarioDef& scenario, std::size_t table, const char* key) {
  return scenario.obstacles.size() == 1 ? say("obstacle.", key) : say("obstacle.", table, ".", key);
}

double thickest(const ScenarioDef& scenario) {
  double out = 0;
  for (const FlockDef& flock : scenario.flocks) out = std::max(out, flock.body_radius);
  return out;
}

// Who is half as long as a wrapped space would meet itself.
std::optional<std::string> check_half(const ScenarioDef& scenario, std::size_t axis, double half) {
  if (scenario.space.boundary.kind != BoundaryKind::wrap) return {};
  const Extent extent = extent_of(scenario);
  const double size = extent.max[axis] - extent.min[axis];
  if (2 * (half + thickest(scenario)) < size) return {};
  return say("with the thickest boid around it an obstacle must be smaller than the wrapped space, which is ",
             number_text(size), " long");
}

class ObstacleChecker {
 public:
  explicit ObstacleChecker(const ScenarioDef& scenario)
      : scenario_(scenario), axes_(static_cast<std::size_t>(scenario.space.dimensions)) {}

  Problems run() {
    for (table_ = 0; table_ < scenario_.obstacles.size(); ++table_) {
      const ObstacleDef& def = scenario_.obstacles[table_];
      check_list("spheres", def.spheres, axes_ + 1, &ObstacleChecker::check_sphere);
      check_list("boxes", def.boxes, 2 * axes_, &ObstacleChecker::check_box);
      check_list("planes", def.planes, 2 * axes_, &ObstacleChecker::check_plane);
      if (def.random) check_random(*def.random);
    }
    return std::move(problems_);
  }

 private:
  using Check = std::optional<std::string> (ObstacleChecker::*)(const Coordinates&) const;

  void say_error(const char* key, std::string text) {
    problems_.push_back({scenario_.file, 0, key_of(scenario_, table_, key), std::move(text), false});
  }

  void check_list(const char* key, const std::vector<Coordinates>& list, std::size_t size, Check check) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string lead = say("number ", i + 1, " of the list: ");
      if (list[i].size() != size) {
        say_error(key, say(lead, "must have ", size, " numbers in ", axes_, " dimensions, but has ",
                           list[i].size()));
      } else if (const auto error = (this->*check)(list[i])) {
        say_error(key, lead + *error);
      }
    }
  }

  std::optional<std::string> check_sphere(const Coordinates& sphere) const {
    return check_sphere_radius(scenario_, sphere.back());
  }

  std::optional<std::string> check_box(const Coordinates& box) const {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      if (!(static_cast<float>(0.5 * (box[axis + axes_] - box[axis])) > 0))
        return say("the lower corner must be below the upper one on every axis, but ", number_text(box[axis]),
                   " is not below ", number_text(box[axis + axes_]));
      if (auto error = check_half(scenario_, axis, 0.5 * (box[axis + axes_] - box[axis]))) return error;
    }
    return {};
  }

  std::optional<std::string> check_plane(const Coordinates& plane) const {
    if (scenario_.space.boundary.kind == BoundaryKind::wrap)
      return "a plane has no place in a wrapped space; build a wall of boxes";
    double squared = 0;
    for (std::size_t axis = 0; axis < axes_; ++axis) squared += plane[axis + axes_] * plane[axis + axes_];
    if (!(squared > 1e-30 && squared < infinity)) return "the normal must have a direction";
    return {};
  }

  void check_random(const RandomObstacles& random) {
    if (!(static_cast<float>(random.min_radius) > 0)) return say_error("random.radius", "must be above 0");
    if (random.max_radius < random.min_radius)
      return say_error("random.radius", "the smaller radius must come first");
    if (const auto error = check_sphere_radius(scenario_, random.max_radius))
      say_error("random.radius", *error);
  }

  const ScenarioDef& scenario_;
  std::size_t axes_;
  std::size_t table_ = 0;
  Problems problems_;
};

void append_list(const std::vector<Coordinates>& list, Obstacle (*make)(const Coordinates&),
                 std::vector<Obstacle>& out) {
  for (const Coordinates& numbers : list) out.push_back(make(numbers));
}

Coordinates numbers_of(const Obstacle& obstacle, std::size_t axes) {
  Coordinates out;
  const auto add = [&](const std::array<float, 3>& from, double sign, const std::array<float, 3>& half) {
    for (std::size_t axis = 0; axis < axes; ++axis)
      out.push_back(double{from[axis]} + sign * double{half[axis]});
  };
  // In double half sides are added without rounding, unless they are a billionth of the place.
  add(obstacle.at, -1, obstacle.half);
  if (obstacle.kind == ObstacleKind::sphere) out.push_back(double{obstacle.radius});
  if (obstacle.kind == ObstacleKind::box) add(obstacle.at, 1, obstacle.half);
  if (obstacle.kind == ObstacleKind::plane) add(obstacle.normal, 0, {});
  return out;
}

std::vector<Coordinates>& list_for(ObstacleKind kind, ObstacleDef& def) {
  if (kind == ObstacleKind::box) return def.boxes;
  return kind == ObstacleKind::plane ? def.planes : def.spheres;
}

}  // namespace

std::optional<std::string> check_sphere_radius(const ScenarioDef& scenario, double radius) {
  if (!(static_cast<float>(radius) > 0 && radius <= 1e15))
    return say("the radius must be above 0 and at most 1e15, but is ", number_text(radius));
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scenario.space.dimensions); ++axis) {
    if (auto error = check_half(scenario, axis, radius)) return error;
  }
  return {};
}

Result<std::vector<Obstacle>> obstacles_of(const ScenarioDef& scenario) {
  std::vector<Obstacle> out;
  for (std::size_t table = 0; table < scenario.obstacles.size(); ++table) {
    const ObstacleDef& def = scenario.obstacles[table];
    append_list(def.spheres, sphere_of, out);
    append_list(def.boxes, box_of, out);
    append_list(def.planes, plane_of, out);
    if (!def.random) continue;
    const std::int64_t placed =
        throw_spheres(*def.random, Field(scenario), static_cast<std::uint64_t>(scenario.seed), out);
    if (placed == def.random->count) continue;
    return Problem{scenario.file, 0, key_of(scenario, table, "random"),
                   say("sphere ", placed + 1, " of ", def.random->count, " found no room in ", most_tries,
                       " tries; give fewer or smaller ones, or keep them less far apart"),
                   false};
  }
  return out;
}

std::vector<ObstacleDef> definitions_of(const std::vector<Obstacle>& obstacles, int dimensions) {
  std::vector<ObstacleDef> out;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    // A table for each run of one kind keeps the order.
    if (i == 0 || obstacles[i].kind != obstacles[i - 1].kind) out.emplace_back();
    list_for(obstacles[i].kind, out.back())
        .push_back(numbers_of(obstacles[i], static_cast<std::size_t>(dimensions)));
  }
  return out;
}

Problems obstacle_problems(const ScenarioDef& scenario) {
  Problems problems = ObstacleChecker(scenario).run();
  if (!problems.empty()) return problems;
  return obstacles_of(scenario).problems();
}

}  // namespace sturnus
