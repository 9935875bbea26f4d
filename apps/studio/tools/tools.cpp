// Strokes of the mouse as commands.
#include "tools/tools.h"

#include <algorithm>
#include <cmath>

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
  return camera.place(hand.x, hand.y, centre_of(frame));
}

float side_of(const Frame& frame) {
  double side = 0;
  for (std::size_t axis = 0; axis < frame.extent.min.size(); ++axis)
    side = std::max(side, frame.extent.max[axis] - frame.extent.min[axis]);
  return static_cast<float>(side);
}

std::vector<std::size_t> flocks_that(const sturnus::ScenarioDef& scenario, bool hunt) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    if (scenario.flocks[i].hunt.has_value() == hunt) found.push_back(i);
  }
  return found;
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

Point centre_of(const Frame& frame) {
  std::array<double, 3> sum{};
  for (const Instance& boid : frame.boids) {
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += double{boid.position[axis]};
  }
  Point centre{};
  for (std::size_t axis = 0; axis < frame.extent.min.size(); ++axis) {
    centre[axis] =
        static_cast<float>(frame.boids.empty() ? (frame.extent.min[axis] + frame.extent.max[axis]) / 2
                                               : sum[axis] / static_cast<double>(frame.boids.size()));
  }
  return centre;
}

void Tools::suit(const Frame& frame) {
  radius = side_of(frame) / 12;
  const auto prey = flocks_that(*frame.scenario, false);
  flock = prey.empty() ? 0 : prey.front();
  is_pressed_ = is_pointing_ = false;
}

Point Tools::place(const Hand& hand, const Frame& frame, const Camera& camera) const {
  return camera.place(hand.x, hand.y, centre_of(frame));
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
      return add(at, false, frame, session);
    case Tool::predator:
      return add(at, true, frame, session);
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

void Tools::add(const Point& at, bool hunters, const Frame& frame, Session& session) {
  const auto found = flocks_that(*frame.scenario, hunters);
  if (found.empty()) {
    return session.note({hunters
                             ? "This scenario has no predators; those of the gallery's hawk-and-starlings or "
                               "sharks-and-fish do."
                             : "Everybody in this scenario is a predator: use that tool.",
                         true});
  }
  const std::size_t chosen =
      hunters || std::find(found.begin(), found.end(), flock) == found.end() ? found.front() : flock;
  const FlockDef& def = frame.scenario->flocks[chosen];
  const std::int64_t count = hunters ? 1 : units_per_click();
  const double around =
      count == 1 ? 0 : def.size * std::pow(static_cast<double>(count), 1.0 / frame.dimensions);
  session.act(sturnus::AddBoids{def.name, count, coordinates(at, frame.dimensions), around},
              hunters ? "predator" : "add units");
}

void Tools::add_food(const Point& at, const Frame& frame, Session& session) {
  if (frame.scenario->food.empty())
    return session.note({"Nobody eats food in this scenario; they do in sharks-and-fish.", true});
  session.act(sturnus::AddFood{frame.scenario->food.front().name, 1, coordinates(at, frame.dimensions), 0},
              "food");
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

void Tools::show(const Hand& hand, const Frame& frame, const Camera& camera, Shapes& shapes) const {
  if (!hand.in_view) return;
  const sturnus::Rgba colour = info_of(tool).colour;
  const bool has_reach = tool == Tool::eraser || tool == Tool::scatter;
  const Point at = has_reach ? reach_of(hand, frame, camera) : place(hand, frame, camera);
  const float pixel = camera.pixel_length(at);
  const float own = tool == Tool::obstacle ? radius / 2 : tool == Tool::hand ? 6 * pixel : 10 * pixel;
  shapes.ring(at, has_reach ? radius : own, colour, 2);
  if (has_reach || tool == Tool::obstacle)
    shapes.disc(at, has_reach ? radius : own, with_alpha(colour, 0.12f));
  shapes.disc(at, 2 * pixel, colour);
}

}  // namespace studio
