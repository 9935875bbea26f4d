// Checks that several tables of a scenario have in common. Each gives the sentence for what is wrong, or
// nothing.
#pragma once

#include <sturnus/scenario.h>

#include <string_view>

namespace sturnus {

/// What all checkers have: a scenario, and the list in which they write what they find.
class Findings {
 protected:
  Findings(const ScenarioDef& scenario, Problems& problems) : scenario_(scenario), problems_(problems) {}

  void say_error(std::string key, std::string text) {
    problems_.push_back({scenario_.file, 0, std::move(key), std::move(text), false});
  }
  void say_if(std::optional<std::string> wrong, std::string key) {
    if (wrong) say_error(std::move(key), std::move(*wrong));
  }
  void say_warning(std::string key, std::string text) {
    problems_.push_back({scenario_.file, 0, std::move(key), std::move(text), true});
  }

  const ScenarioDef& scenario_;
  Problems& problems_;
};

/// What files call the steering forms, in their order.
inline constexpr const char* form_names[] = {"heading", "seek", "linear", "arrive", "orbit"};

/// A name that paths use: plain letters, and not taken by an earlier one. `what` names several of the kind:
/// "flocks".
std::optional<std::string> wrong_name(std::string_view what, const std::string& name,
                                      const std::vector<std::string>& earlier);

/// A place with a number for each axis, each within bounds; nothing given is nothing wrong.
std::optional<std::string> wrong_place(const Coordinates& at, std::size_t axes);

/// A form that goes at full speed, in a flock that has no top speed.
std::optional<std::string> wrong_form(SteeringForm form, const FlockDef& flock);

/// "#rrggbb".
bool is_hex_colour(const std::string& text);

/// A number that a place or a length may be.
bool is_in_bounds(double number);

}  // namespace sturnus
