// Strokes of the mouse as commands.
#include "tools/tools.h"

#include <algorithm>
#include <cmath>

#include "session/creatures.h"
#include "view/colours.h"

namespace studio {
namespace {

using sturnus::Coordinates;
using sturnus::FlockDef;
using sturnus::rgb;
using sturnus::with_alpha;

constexpr float apart_in_stroke = 0.5f;  // of the tool's radius: from one dab of the eraser to the next

Coordinates coordinates(const Point& at, int dimensions) {
  return {at.begin(), at.begin() + dimensions};
}

// The boid that the ray comes nearest to.
const Instance* nearest_to(const Ray& ray, const Frame& frame) {
  const Instance* found = nullptr;
  float least = std::numeric_limits<float>::max();
  for (const Instance& boid : frame.boids) {
    const float away = distance(ray, {boid.position[0], boid.position[1], boid.position[2]});
    if (away < least) {
      least = away;
      found = &boid;
    }
  }
  return found;
}

Point on_ray(const Ray& ray, const float (&near)[3]) {
  float along = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) along += (near[axis] - ray.from[axis]) * ray.along[axis];
  Point at;
  for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = ray.from[axis] + along * ray.along[axis];
  return at;
}

// The line on which a tool works in space; in the plane, none.
Coordinates line_of(const Hand& hand, const Frame& frame, const Camera& camera) {
  if (frame.dimensions == 2) return {};
  const Point along = camera.ray(hand.x, hand.y).along;
  return {along.begin(), along.end()};
}

// Where a tool works that acts on what is there: in space, on the ray, beside the boid nearest to it.
Point reach_of(const Hand& hand, const Frame& frame, const Camera& camera) {
  if (frame.dimensions == 3) {
    const Ray ray = camera.ray(hand.x, hand.y);
    if (const Instance* boid = nearest_to(ray, frame)) return on_ray(ray, boid->position);
  }
  return camera.place(hand.x, hand.y, frame.centre);
}

float side_of(const Frame& frame) {
  double side = 0;
  for (std::size_t axis = 0; axis < frame.extent.min.size(); ++axis)
    side = std::max(side, frame.extent.max[axis] - frame.extent.min[axis]);
  return static_cast<float>(side);
}

}  // namespace

const std::vector<ToolInfo>& tool_list() {
  static const std::vector<ToolInfo> list = {
      {Tool::hand, '0', "hand",
       "Drag with the left button to attract the flock, with the right one to drive it away.", rgb(0xe6edf3)},
      {Tool::add, '1', "add units", "A click adds units; the up and down keys double and halve how many.",
       rgb(0x56b4e9)},
      {Tool::obstacle, '2', "avoidance obstacle",
       "A click puts an obstacle there that everybody steers around.", rgb(0x9aa5b1)},
      {Tool::attractor, '3', "attraction obstacle", "A click puts a place there to which everybody is drawn.",
       rgb(0x4c8dff)},
      {Tool::eraser, '4', "eraser",
       "Removes whatever it is dragged over; Ctrl and the wheel change its size.", rgb(0xf0e442)},
      {Tool::follow, '5', "follow cursor", "Everybody follows the cursor.", rgb(0x009e73)},
      {Tool::avoid, '6', "avoid cursor", "Everybody near the cursor flees from it.", rgb(0xcc79a7)},
      {Tool::food, '7', "food", "A click lays out a piece of food.", rgb(0x6ede8a)},
      {Tool::predator, '8', "predators", "A click lets a predator in.", rgb(0xd55e00)},
      {Tool::scatter, 'S', "scatter", "Everybody near the cursor flies straight away from it, at once.",
       rgb(0xe69f00)},
  };
  return list;
}

const ToolInfo& info_of(Tool tool) {
  const auto& list = tool_list();
  return *std::find_if(list.begin(), list.end(), [&](const ToolInfo& info) { return info.tool == tool; });
}

void Tools::suit(const Frame& frame) {
  radius = side_of(frame) / 12;
  flock = predators = 0;
  is_pressed_ = is_pointing_ = false;
}

Point Tools::place(const Hand& hand, const Frame& frame, const Camera& camera) const {
  return camera.place(hand.x, hand.y, frame.centre);
}

void Tools::press(const Hand& hand, bool right, const Frame& frame, const Camera& camera, Session& session) {
  ++gesture_;
  is_pressed_ = true;
  const Point at = place(hand, frame, camera);
  switch (tool) {
    case Tool::hand:
      mode_ = right ? sturnus::PointerMode::repel : sturnus::PointerMode::attract;
      return point(hand, mode_, true, frame, camera, session);
    case Tool::add:
    case Tool::predator:
      return add(at, frame, session);
    case Tool::obstacle:
      return place_obstacle(at, frame, session);
    case Tool::attractor:
      return session.act(sturnus::PlaceTarget{sturnus::TargetKind::attract, coordinates(at, frame.dimensions),
                                              sturnus::SteeringForm::heading, 0.1, side_of(frame) / 3},
                         "attraction obstacle");
    case Tool::food:
      return add_food(at, frame, session);
    case Tool::scatter:
      return scatter(hand, frame, camera, session);
    case Tool::eraser:
      return stroke(hand, frame, camera, session);
    case Tool::follow:
    case Tool::avoid:
      rests_ = false;
      mode_ = tool == Tool::follow ? sturnus::PointerMode::attract : sturnus::PointerMode::repel;
      return point(hand, mode_, true, frame, camera, session);
  }
}

void Tools::move(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  if (tool == Tool::follow || tool == Tool::avoid) return follow(hand, frame, camera, session);
  if (is_pointing_ && !(tool == Tool::hand && is_pressed_))
    return point(hand, mode_, false, frame, camera, session);
  if (!is_pressed_) return;
  if (tool == Tool::hand) point(hand, mode_, true, frame, camera, session);
  const float apart = apart_in_stroke * radius / camera.pixel_length(place(hand, frame, camera));
  if (tool == Tool::eraser && std::hypot(hand.x - last_x_, hand.y - last_y_) > apart)
    stroke(hand, frame, camera, session);
}

// Motion alone never begins another future: in the past that takes a click.
void Tools::follow(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  const sturnus::PointerMode mode =
      tool == Tool::follow ? sturnus::PointerMode::attract : sturnus::PointerMode::repel;
  if (is_pointing_ && (!hand.in_view || mode != mode_)) point(hand, mode_, false, frame, camera, session);
  if (!hand.in_view || rests_ || frame.step < frame.reach.last) return;
  if (!is_pointing_) ++gesture_;
  mode_ = mode;
  point(hand, mode_, true, frame, camera, session);
}

void Tools::notice(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  if (generation_ != frame.generation) {
    rests_ = generation_ != 0;
    is_pressed_ = is_pointing_ = false;
    generation_ = frame.generation;
  }
  if (!hand.in_view) rests_ = false;
  if (noticed_ == tool) return;
  noticed_ = tool;
  is_pressed_ = rests_ = false;
  move(hand, frame, camera, session);
}

void Tools::release(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  if (is_pressed_ && tool == Tool::eraser) stroke(hand, frame, camera, session);
  is_pressed_ = false;
  if (is_pointing_ && tool == Tool::hand) point(hand, mode_, false, frame, camera, session);
}

// One dab of the eraser.
void Tools::stroke(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  last_x_ = hand.x;
  last_y_ = hand.y;
  const Point at = reach_of(hand, frame, camera);
  session.act(sturnus::EraseBoids{coordinates(at, frame.dimensions), radius, line_of(hand, frame, camera)},
              "eraser", gesture_);
}

void Tools::scatter(const Hand& hand, const Frame& frame, const Camera& camera, Session& session) {
  const Point at = reach_of(hand, frame, camera);
  session.act(sturnus::ScatterBoids{coordinates(at, frame.dimensions), radius, line_of(hand, frame, camera)},
              "scatter");
}

std::vector<std::size_t> Tools::choices(const sturnus::ScenarioDef& scenario) const {
  std::vector<std::size_t> found = flocks_that(scenario, tool == Tool::predator);
  if (found.empty() && tool != Tool::predator) found = flocks_that(scenario, true);
  return found;
}

std::optional<std::size_t> Tools::chosen(const sturnus::ScenarioDef& scenario) const {
  const auto found = choices(scenario);
  if (found.empty()) return {};
  const std::size_t wanted = tool == Tool::predator ? predators : flock;
  return std::find(found.begin(), found.end(), wanted) == found.end() ? found.front() : wanted;
}

void Tools::choose_next(const sturnus::ScenarioDef& scenario) {
  const auto found = choices(scenario);
  const auto now = chosen(scenario);
  if (!now) return;
  auto next = std::find(found.begin(), found.end(), *now) + 1;
  (tool == Tool::predator ? predators : flock) = next == found.end() ? found.front() : *next;
}

void Tools::add(const Point& at, const Frame& frame, Session& session) {
  const auto own = chosen(*frame.scenario);
  const bool are_predators = tool == Tool::predator;
  if (!own) return bring_predators(at, frame, session);
  const FlockDef& def = frame.scenario->flocks[*own];
  const std::int64_t count = are_predators ? 1 : units_per_click();
  const double around =
      count == 1 ? 0 : def.size * std::pow(static_cast<double>(count), 1.0 / frame.dimensions);
  session.act(sturnus::AddBoids{def.name, count, coordinates(at, frame.dimensions), around},
              are_predators ? "predator" : "add units");
}

// A scenario without predators is given a flock of them with the first.
void Tools::bring_predators(const Point& at, const Frame& frame, Session& session) {
  session.order([at = coordinates(at, frame.dimensions), &session](World& world) {
    const sturnus::Status status = world.extend("predators", give_predators);
    if (!status) return status;
    const std::string name = world.simulation().scenario().flocks.back().name;
    session.note(
        {"The scenario now has a flock \"" + name + "\" that hunts the others. Undo takes it away."});
    return world.act(sturnus::AddBoids{name, 1, at, 0}, "");
  });
}

// A scenario without food is given a kind of it with the first piece.
void Tools::add_food(const Point& at, const Frame& frame, Session& session) {
  const Coordinates place = coordinates(at, frame.dimensions);
  if (!frame.scenario->food.empty())
    return session.act(sturnus::AddFood{frame.scenario->food.front().name, 1, place, 0}, "food");
  session.order([place, &session](World& world) {
    const sturnus::Status status = world.extend("food", give_food);
    if (!status) return status;
    const std::string name = world.simulation().scenario().food.back().name;
    session.note({"The scenario now has \"" + name + "\", and its flocks eat it. Undo takes it away."});
    return world.act(sturnus::AddFood{name, 1, place, 0}, "");
  });
}

// An obstacle nobody looks at would be no obstacle: flocks that don't avoid any yet learn it with it.
void Tools::place_obstacle(const Point& at, const Frame& frame, Session& session) {
  session.act(sturnus::PlaceObstacle{coordinates(at, frame.dimensions), radius / 2}, "avoidance obstacle",
              gesture_);
  for (const FlockDef& def : frame.scenario->flocks) {
    if (!def.avoid_obstacles)
      session.act(sturnus::SetParameter{"flock." + def.name + ".avoid_obstacles.weight", "0.5"}, "");
  }
}

// What the hand saw holds for that frame's generation: after a jump it is not heard.
void Tools::point(const Hand& hand, sturnus::PointerMode mode, bool pressed, const Frame& frame,
                  const Camera& camera, Session& session) {
  const Point at = pressed ? place(hand, frame, camera) : frame.pointer.at;
  is_pointing_ = pressed;
  sturnus::MovePointer pointer{mode, coordinates(at, frame.dimensions), pressed};
  if (pressed) pointer.along = line_of(hand, frame, camera);
  const bool is_drag = tool == Tool::hand;
  const std::string label = !pressed ? "" : is_drag ? "drag" : info_of(tool).name;
  session.order([pointer, label, gesture = gesture_, generation = frame.generation](World& world) {
    if (world.generation() != generation) return sturnus::Status();
    return world.act(pointer, label, gesture);
  });
}

void Tools::show(const Hand& hand, const Frame& frame, const Camera& camera, sturnus::ThemeName theme,
                 Shapes& shapes) const {
  if (!hand.in_view) return;
  const sturnus::Rgba colour = colour_on(theme, info_of(tool).colour);
  const bool has_reach = tool == Tool::eraser || tool == Tool::scatter;
  const Point at = place(hand, frame, camera);
  const float pixel = camera.pixel_length(at);
  const float own = tool == Tool::obstacle ? radius / 2 : tool == Tool::hand ? 6 * pixel : 10 * pixel;
  shapes.ring(at, has_reach ? radius : own, colour, 2);
  if (has_reach || tool == Tool::obstacle)
    shapes.disc(at, has_reach ? radius : own, with_alpha(colour, 0.12f));
  shapes.disc(at, 2 * pixel, colour);
}

}  // namespace studio
