// Commands as tuples of their parts.
#include "session/events.h"

#include <tuple>

namespace studio {
namespace {

using namespace sturnus;

auto parts(const SetParameter& c) {
  return std::tie(c.path, c.value);
}
auto parts(const AddBoids& c) {
  return std::tie(c.flock, c.count, c.at, c.radius);
}
auto parts(const AddFood& c) {
  return std::tie(c.food, c.count, c.at, c.radius);
}
auto parts(const EraseBoids& c) {
  return std::tie(c.at, c.radius, c.along);
}
auto parts(const MoveBoid& c) {
  return std::tie(c.id, c.to, c.velocity);
}
auto parts(const MovePointer& c) {
  return std::tie(c.mode, c.at, c.pressed, c.along);
}
auto parts(const ScatterBoids& c) {
  return std::tie(c.at, c.radius, c.along);
}
auto parts(const PlaceTarget& c) {
  return std::tie(c.kind, c.at, c.form, c.weight, c.radius);
}
auto parts(const PlaceObstacle& c) {
  return std::tie(c.at, c.radius);
}

}  // namespace

bool is_same(const Event& one, const Event& other) {
  if (one.step != other.step || one.command.index() != other.command.index()) return false;
  return std::visit(
      [&](const auto& command) {
        return parts(command) == parts(std::get<std::decay_t<decltype(command)>>(other.command));
      },
      one.command);
}

// A recording keeps its scenario's events in their order, with others in between.
std::vector<Event> done_by_hand(const std::vector<Event>& recorded, const std::vector<Event>& own) {
  std::vector<Event> out;
  auto next = own.begin();
  for (const Event& event : recorded) {
    if (next != own.end() && is_same(event, *next)) {
      ++next;
    } else {
      out.push_back(event);
    }
  }
  return out;
}

}  // namespace studio
