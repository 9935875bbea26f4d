// Newcomers with sizes and speeds that suit who is there.
#include "session/creatures.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

using namespace sturnus;

constexpr double usual_speed = 3;    // length per time, where a flock has no limit
constexpr int last_order = 1 << 20;  // after the terms that the file has

template <class Items>
std::string free_name_in(const Items& items, const std::string& wish) {
  std::string name = wish;
  const auto is_taken = [&](const auto& item) { return item.name == name; };
  for (int i = 2; std::any_of(items.begin(), items.end(), is_taken); ++i)
    name = wish + "-" + std::to_string(i);
  return name;
}

double side_of(const ScenarioDef& scenario) {
  const Extent extent = extent_of(scenario);
  double side = 0;
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis)
    side = std::max(side, extent.max[axis] - extent.min[axis]);
  return side;
}

double speed_of(const FlockDef& flock) {
  return std::isfinite(flock.max_speed) && flock.max_speed > 0 ? flock.max_speed : usual_speed;
}

FlockDef predators_beside(const FlockDef& prey, double side) {
  FlockDef out;
  out.count = 0;
  out.start.min_speed = prey.start.min_speed;
  out.start.max_speed = prey.start.max_speed;
  out.min_speed = 0.5 * std::min(prey.min_speed, speed_of(prey));
  out.max_speed = 1.2 * speed_of(prey);
  out.max_acceleration = prey.max_acceleration;
  out.separation.clear();
  out.alignment.clear();
  out.cohesion.clear();
  out.size = 2 * prey.size;
  out.body_radius = 0.5 * prey.size + prey.body_radius;
  out.colour.start = "#d55e00";
  // Terms count in their order, and files keep it.
  out.wander = Wander{.rate = 0.2, .weight = 0.02 * speed_of(prey), .order = 1};
  out.hunt =
      Hunt{.sight = side / 4, .choose = HuntChoice::nearest, .weight = 0.08 * speed_of(prey), .order = 2};
  out.hunger = Hunger{};
  return out;
}

}  // namespace

bool is_predator(const ScenarioDef& scenario, std::size_t flock) {
  const FlockDef& own = scenario.flocks[flock];
  if (own.hunt) return true;
  return std::any_of(scenario.flocks.begin(), scenario.flocks.end(), [&](const FlockDef& other) {
    return std::any_of(other.flee.begin(), other.flee.end(), [&](const Flee& flee) {
      return std::find(flee.from.begin(), flee.from.end(), own.name) != flee.from.end();
    });
  });
}

std::vector<std::size_t> flocks_that(const ScenarioDef& scenario, bool are_predators) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    if (is_predator(scenario, i) == are_predators) found.push_back(i);
  }
  return found;
}

void give_predators(ScenarioDef& scenario) {
  const double side = side_of(scenario);
  FlockDef predators = predators_beside(scenario.flocks.front(), side);
  predators.name = free_name_in(scenario.flocks, "predators");
  for (FlockDef& flock : scenario.flocks) {
    predators.hunt->prey.push_back(flock.name);
    // Rows of one key stand together in a file, and the order of terms is that of the file.
    const int order = flock.flee.empty() ? last_order : flock.flee.back().order + 1;
    flock.flee.push_back(Flee{
        .from = {predators.name}, .radius = side / 10, .weight = 0.15 * speed_of(flock), .order = order});
  }
  scenario.flocks.push_back(std::move(predators));
}

void give_food(ScenarioDef& scenario) {
  const double side = side_of(scenario);
  FoodDef food;
  food.name = free_name_in(scenario.food, "food");
  food.count = 0;
  food.size = 0.6 * scenario.flocks.front().size;
  food.body_radius = 0.5 * scenario.flocks.front().size;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    FlockDef& flock = scenario.flocks[i];
    if (flock.feed || flock.hunt) continue;
    flock.feed =
        Feed{.on = food.name, .radius = side / 8, .weight = 0.05 * speed_of(flock), .order = last_order + 1};
  }
  scenario.food.push_back(std::move(food));
}

}  // namespace studio
