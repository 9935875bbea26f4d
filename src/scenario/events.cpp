// Events as lists of values, and what can be wrong with them.
#include "scenario/events.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "scenario/assign.h"
#include "scenario/common_checks.h"
#include "scenario/obstacles.h"
#include "scenario/targets.h"

namespace sturnus {
namespace {

Value number(double value) {
  return {value};
}
Value word(std::string text) {
  return {std::move(text)};
}
Value place(const Coordinates& at) {
  Value::List list;
  for (const double coordinate : at) list.push_back({coordinate});
  return {list};
}

// A direction at the end, where there is one.
Value::List with_line(Value::List list, const Coordinates& along) {
  if (!along.empty()) list.push_back(place(along));
  return list;
}

Value::List parts_of(const Command& command) {
  struct Parts {
    Value::List operator()(const SetParameter& set) const {
      return {word("set"), word(set.path), parse_value(set.value)};
    }
    Value::List operator()(const AddBoids& add) const {
      return {word("add"), word(add.flock), number(static_cast<double>(add.count)), place(add.at),
              number(add.radius)};
    }
    Value::List operator()(const AddFood& add) const {
      return {word("food"), word(add.food), number(static_cast<double>(add.count)), place(add.at),
              number(add.radius)};
    }
    Value::List operator()(const EraseBoids& erase) const {
      return with_line({word("erase"), place(erase.at), number(erase.radius)}, erase.along);
    }
    Value::List operator()(const MoveBoid& move) const {
      return {word("move"), number(static_cast<double>(move.id)), place(move.to), place(move.velocity)};
    }
    Value::List operator()(const MovePointer& pointer) const {
      const char* mode = pointer.mode == PointerMode::attract ? "attract" : "repel";
      return with_line({word("pointer"), word(pointer.pressed ? mode : "off"), place(pointer.at)},
                       pointer.along);
    }
    Value::List operator()(const ScatterBoids& scatter) const {
      return with_line({word("scatter"), place(scatter.at), number(scatter.radius)}, scatter.along);
    }
    Value::List operator()(const PlaceTarget& placed) const {
      const char* kind = placed.kind == TargetKind::attract ? "attract" : "repel";
      return {word("target"),        word(kind),
              place(placed.at),      word(form_names[static_cast<int>(placed.form)]),
              number(placed.weight), number(placed.radius)};
    }
    Value::List operator()(const PlaceObstacle& obstacle) const {
      return {word("obstacle"), place(obstacle.at), number(obstacle.radius)};
    }
  };
  return std::visit(Parts{}, command);
}

// Reads the parts of an event one after the other; the first that does not fit leaves a sentence.
class Parts {
 public:
  explicit Parts(const Value::List& list) : list_(list) {}

  double number(const char* what) {
    if (const auto* given = next<double>(what, "a number")) return *given;
    return 0;
  }
  std::uint64_t whole(const char* what) {
    const double given = number(what);
    if (error_.empty() && (!(given >= 0) || given != std::floor(given) || given > 9007199254740992.0)) {
      error_ = say("an event's ", what, " must be a whole number from 0 up, but is ", number_text(given));
    }
    return error_.empty() ? static_cast<std::uint64_t>(given) : 0;
  }
  std::string word(const char* what) {
    if (const auto* given = next<std::string>(what, "text")) return *given;
    return {};
  }
  Coordinates place(const char* what) {
    Coordinates out;
    const auto* given = next<Value::List>(what, "a list of numbers such as [0, 0]");
    if (given == nullptr) return out;
    for (const Value& item : *given) {
      const auto* coordinate = std::get_if<double>(&item.held);
      if (coordinate == nullptr) {
        error_ = say("an event's ", what, " must be a list of numbers such as [0, 0], but is ",
                     to_text(Value{*given}));
        return out;
      }
      out.push_back(*coordinate);
    }
    return out;
  }
  std::string value_text() {
    if (at_ < list_.size()) return to_text(list_[at_++]);
    error_ = "an event \"set\" needs a value after the path";
    return {};
  }
  bool at_end() const { return at_ == list_.size(); }
  const std::string& error() const { return error_; }
  void fail(std::string text) {
    if (error_.empty()) error_ = std::move(text);
  }

 private:
  template <class T>
  const T* next(const char* what, const char* kind) {
    if (!error_.empty()) return nullptr;
    if (at_ >= list_.size()) {
      error_ = say("an event ends before its ", what);
      return nullptr;
    }
    const Value& value = list_[at_++];
    if (const T* given = std::get_if<T>(&value.held)) return given;
    error_ = say("an event's ", what, " must be ", kind, ", but is ", to_text(value));
    return nullptr;
  }

  const Value::List& list_;
  std::size_t at_ = 0;
  std::string error_;
};

// May be left out.
Coordinates line_from(Parts& parts) {
  return parts.at_end() ? Coordinates{} : parts.place("direction");
}

Command pointer_from(Parts& parts) {
  MovePointer pointer;
  const std::string mode = parts.word("mode");
  if (mode != "attract" && mode != "repel" && mode != "off") {
    parts.fail(say("an event \"pointer\" must be \"attract\", \"repel\" or \"off\", but is \"", mode, "\""));
  }
  pointer.mode = mode == "repel" ? PointerMode::repel : PointerMode::attract;
  pointer.pressed = mode != "off";
  pointer.at = parts.place("place");
  pointer.along = line_from(parts);
  return pointer;
}

SteeringForm form_from(Parts& parts) {
  const std::string word = parts.word("form");
  const auto* const found = std::find(std::begin(form_names), std::end(form_names), word);
  if (found == std::end(form_names) && parts.error().empty())
    parts.fail(unknown_word("form", word, {std::begin(form_names), std::end(form_names)}));
  return found == std::end(form_names) ? SteeringForm::heading
                                       : static_cast<SteeringForm>(found - std::begin(form_names));
}

// Form, weight and radius may be left out, from the end.
Command target_from(Parts& parts) {
  PlaceTarget target;
  const std::string kind = parts.word("kind");
  if (kind != "attract" && kind != "repel")
    parts.fail(say("an event \"target\" must be \"attract\" or \"repel\", but is \"", kind, "\""));
  target.kind = kind == "repel" ? TargetKind::repel : TargetKind::attract;
  target.at = parts.place("place");
  if (!parts.at_end()) target.form = form_from(parts);
  if (!parts.at_end()) target.weight = parts.number("weight");
  if (!parts.at_end()) target.radius = parts.number("radius");
  return target;
}

Command command_from(const std::string& verb, Parts& parts) {
  if (verb == "set") {
    std::string path = parts.word("path");
    return SetParameter{std::move(path), parts.value_text()};
  }
  if (verb == "add") {
    AddBoids add;
    add.flock = parts.word("flock");
    add.count = static_cast<std::int64_t>(parts.whole("count"));
    add.at = parts.place("place");
    if (!parts.at_end()) add.radius = parts.number("radius");
    return add;
  }
  if (verb == "food") {
    AddFood add;
    add.food = parts.word("food");
    add.count = static_cast<std::int64_t>(parts.whole("count"));
    add.at = parts.place("place");
    if (!parts.at_end()) add.radius = parts.number("radius");
    return add;
  }
  if (verb == "erase") {
    EraseBoids erase;
    erase.at = parts.place("place");
    erase.radius = parts.number("radius");
    erase.along = line_from(parts);
    return erase;
  }
  if (verb == "move") {
    MoveBoid move;
    move.id = parts.whole("id");
    move.to = parts.place("place");
    move.velocity = parts.place("velocity");
    return move;
  }
  if (verb == "pointer") return pointer_from(parts);
  if (verb == "scatter") {
    ScatterBoids scatter;
    scatter.at = parts.place("place");
    scatter.radius = parts.number("radius");
    scatter.along = line_from(parts);
    return scatter;
  }
  if (verb == "target") return target_from(parts);
  if (verb == "obstacle") {
    Coordinates at = parts.place("place");
    return PlaceObstacle{std::move(at), parts.number("radius")};
  }
  parts.fail(unknown_word(
      "event", verb, {"set", "add", "food", "erase", "move", "pointer", "scatter", "target", "obstacle"}));
  return {};
}

std::optional<std::string> check_place(const ScenarioDef& scenario, const Coordinates& at, const char* what) {
  if (at.size() != static_cast<std::size_t>(scenario.space.dimensions)) {
    return say("the ", what, " must have ", scenario.space.dimensions, " coordinates, but has ", at.size());
  }
  for (const double coordinate : at) {
    if (!is_in_bounds(coordinate)) return say("the ", what, " must be finite and at most 1e15");
  }
  return {};
}

std::optional<std::string> check_line(const ScenarioDef& scenario, const Coordinates& along) {
  if (along.empty()) return {};
  if (auto error = check_place(scenario, along, "direction")) return error;
  const bool is_nothing = std::all_of(along.begin(), along.end(), [](double part) { return part == 0; });
  return is_nothing ? std::optional<std::string>("the direction must not be zero") : std::nullopt;
}

std::optional<std::string> check_radius(double radius) {
  if (!(radius >= 0 && radius <= 1e15))
    return say("the radius must not be negative or beyond 1e15, but is ", number_text(radius));
  return {};
}

struct CommandCheck {
  const ScenarioDef& scenario;
  using Error = std::optional<std::string>;

  Error operator()(const SetParameter& set) const {
    if (is_fixed_while_running(set.path)) return say("\"", set.path, "\" can't change while a flock runs");
    ScenarioDef changed = scenario;
    const Status status = set_parameter(changed, set.path, parse_value(set.value));
    if (!status) return say(set.path, ": ", status.problems().front().text);
    return first_error(changed);
  }
  static Error first_error(const ScenarioDef& scenario) {
    for (const Problem& problem : check(scenario)) {
      if (!problem.is_warning) return say(problem.key, ": ", problem.text);
    }
    return {};
  }
  Error operator()(const AddBoids& add) const {
    std::vector<std::string> names;
    for (const FlockDef& flock : scenario.flocks) names.push_back(flock.name);
    if (std::find(names.begin(), names.end(), add.flock) == names.end())
      return unknown_word("flock", add.flock, names);
    if (add.count < 0 || add.count > 1000000000)
      return say("the count must be between 0 and 1e9, but is ", add.count);
    if (auto error = check_radius(add.radius)) return error;
    return check_place(scenario, add.at, "place");
  }
  Error operator()(const AddFood& add) const {
    std::vector<std::string> names;
    for (const FoodDef& food : scenario.food) names.push_back(food.name);
    if (std::find(names.begin(), names.end(), add.food) == names.end())
      return unknown_word("food", add.food, names);
    if (add.count < 0 || add.count > 1000000)
      return say("the count must be between 0 and 1e6, but is ", add.count);
    if (auto error = check_radius(add.radius)) return error;
    return check_place(scenario, add.at, "place");
  }
  Error operator()(const EraseBoids& erase) const {
    if (auto error = check_radius(erase.radius)) return error;
    if (auto error = check_line(scenario, erase.along)) return error;
    return check_place(scenario, erase.at, "place");
  }
  Error operator()(const MoveBoid& move) const {
    if (auto error = check_place(scenario, move.to, "place")) return error;
    return check_place(scenario, move.velocity, "velocity");
  }
  Error operator()(const ScatterBoids& scatter) const {
    if (auto error = check_radius(scatter.radius)) return error;
    if (auto error = check_line(scenario, scatter.along)) return error;
    return check_place(scenario, scatter.at, "place");
  }
  Error operator()(const PlaceTarget& placed) const {
    if (auto error = check_place(scenario, placed.at, "place")) return error;
    ScenarioDef changed = scenario;
    add_target(placed, changed);
    return first_error(changed);
  }
  Error operator()(const PlaceObstacle& obstacle) const {
    if (auto error = check_place(scenario, obstacle.at, "place")) return error;
    return check_sphere_radius(scenario, obstacle.radius);
  }
  Error operator()(const MovePointer& pointer) const {
    if (auto error = check_line(scenario, pointer.along)) return error;
    return check_place(scenario, pointer.at, "place");
  }
};

}  // namespace

bool is_fixed_while_running(std::string_view path) {
  for (const char* fixed :
       {"format", "seed", "space.dimensions", "run.steps", "run.initial", "run.first_step", "run.resumed"}) {
    if (path == fixed) return true;
  }
  if (path.starts_with("target.") && path.ends_with(".name")) return true;
  if (path == "obstacle" || path.starts_with("obstacle.")) return true;
  if (path.starts_with("food.") && (path.ends_with(".name") || path.ends_with(".count")))
    return path.find(".random.") == path.npos;
  if (!path.starts_with("flock.")) return false;
  const auto dot = path.find('.', 6);
  const std::string_view rest = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  return rest == "name" || rest == "count" || rest == "start" || rest.starts_with("start.") ||
         rest == "colour.start" || rest == "colour";
}

bool change_scenario(const Command& command, std::uint64_t step, ScenarioDef& scenario) {
  if (const auto* set = std::get_if<SetParameter>(&command))
    return set_parameter(scenario, set->path, parse_value(set->value)).problems().empty();
  if (const auto* placed = std::get_if<PlaceTarget>(&command)) {
    add_target(*placed, scenario);
    return true;
  }
  const auto* erase = std::get_if<EraseBoids>(&command);
  return erase != nullptr && erase_targets(*erase, step, scenario);
}

std::array<double, 3> beside(std::array<double, 3> o, const Coordinates& along) {
  double lengthwise = 0, squared = 0;
  for (std::size_t axis = 0; axis < along.size(); ++axis) {
    lengthwise += o[axis] * along[axis];
    squared += along[axis] * along[axis];
  }
  for (std::size_t axis = 0; axis < along.size(); ++axis) o[axis] -= lengthwise / squared * along[axis];
  return o;
}

Value to_value(const Event& event) {
  Value::List list = parts_of(event.command);
  list.insert(list.begin(), number(static_cast<double>(event.step)));
  return {list};
}

std::variant<Event, std::string> event_from(const Value& value) {
  const auto* list = std::get_if<Value::List>(&value.held);
  if (list == nullptr)
    return say("an event is a list such as [120, \"set\", path, value], but found another value");
  Parts parts(*list);
  Event event;
  event.step = parts.whole("step");
  const std::string verb = parts.word("name");
  if (parts.error().empty()) event.command = command_from(verb, parts);
  if (parts.error().empty() && !parts.at_end())
    parts.fail(say("an event \"", verb, "\" has more parts than it should"));
  if (!parts.error().empty()) return parts.error();
  return event;
}

std::optional<std::string> check_command(const ScenarioDef& scenario, const Command& command) {
  return std::visit(CommandCheck{scenario}, command);
}

}  // namespace sturnus
