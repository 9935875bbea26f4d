// Events as lists of values, the form in which files keep them: [120, "set", "flock.birds.max_speed", 12].
#pragma once

#include <sturnus/parameters.h>

namespace sturnus {

Value to_value(const Event& event);

/// The event, or the sentence that says what is wrong with the list.
std::variant<Event, std::string> event_from(const Value& value);

/// Does what a command that has passed `check_command` changes in the scenario itself, before that step:
/// parameters and targets. Tells whether anything changed.
bool change_scenario(const Command& command, std::uint64_t step, ScenarioDef& scenario);

/// What of an offset is at right angles to a line of any length; all of it where there is none.
std::array<double, 3> beside(std::array<double, 3> o, const Coordinates& along);

/// What is wrong with a command in this scenario; empty when nothing is.
std::optional<std::string> check_command(const ScenarioDef& scenario, const Command& command);

}  // namespace sturnus
