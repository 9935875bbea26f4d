// One parameter as a row of the inspector: its name, a widget that suits its kind, and a dot where it was
// changed.
#pragma once

#include <sturnus/parameters.h>

#include <functional>

#include "desk.h"

namespace studio {

/// The bottom of a path's rows, and how they are set.
struct FieldPlace {
  std::string prefix;  ///< of the path, up to and with the last point
  double side = 100;   ///< of the space, length
};

/// A row. What is changed goes to the session.
void show_field(Desk& desk, const FieldPlace& where, std::string_view key, const sturnus::FieldRef& place,
                const sturnus::About& about);
/// A round switch; returns whether it was pressed.
bool dot_switch(Desk& desk, const std::string& path, bool is_on, ImU32 colour);
/// The dot of a value that differs from the scenario; pressed, it resets the value. Takes its room always.
void reset_dot(Desk& desk, const std::string& path, const std::string& now);
/// Takes a new gesture when the widget made last begins to be used.
void begin_gesture(Desk& desk);
/// Sets a value, and with it the flock's other radii where they are linked.
void set_value(Desk& desk, const std::string& path, double before, double value);

/// Sentence, unit, formula and source.
std::string words_of(const std::string& path, const sturnus::About& about);

}  // namespace studio
