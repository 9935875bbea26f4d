// Events as lists of values, the form in which files keep them: [120, "set", "flock.birds.max_speed", 12].
#pragma once

#include <sturnus/parameters.h>

namespace sturnus {

Value to_value(const Event& event);

/// The event, or the sentence that says what is wrong with the list.
std::variant<Event, std::string> event_from(const Value& value);

/// What is wrong with a command in this scenario; empty when nothing is.
std::optional<std::string> check_command(const ScenarioDef& scenario, const Command& command);

}  // namespace sturnus
