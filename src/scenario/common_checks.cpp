// Names, places, forms and colours, wherever a scenario has them.
#include "scenario/common_checks.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace sturnus {

std::optional<std::string> wrong_name(std::string_view what, const std::string& name,
                                      const std::vector<std::string>& earlier) {
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!plain) return say("\"", name, "\" must be letters, digits, - and _, so that paths can name it");
  if (std::find(earlier.begin(), earlier.end(), name) == earlier.end()) return {};
  return say("two ", what, " are called \"", name, "\"");
}

std::optional<std::string> wrong_place(const Coordinates& at, std::size_t axes) {
  if (!at.empty() && at.size() != axes) return say("must have ", axes, " numbers, but has ", at.size());
  if (!std::all_of(at.begin(), at.end(), is_in_bounds)) return "must be finite and at most 1e15";
  return {};
}

std::optional<std::string> wrong_form(SteeringForm form, const FlockDef& flock) {
  const bool goes_at_full_speed = form != SteeringForm::heading && form != SteeringForm::linear;
  if (!goes_at_full_speed || !std::isinf(flock.max_speed)) return {};
  return say("\"", form_names[static_cast<int>(form)], "\" goes at full speed, but the max_speed of \"",
             flock.name, "\" is infinite");
}

bool is_hex_colour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

bool is_in_bounds(double number) {
  return std::abs(number) <= 1e15;
}

}  // namespace sturnus
