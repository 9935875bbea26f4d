// Values of parameters as text, by their paths.
#pragma once

#include <sturnus/parameters.h>

#include <map>
#include <string>

namespace studio {

/// The value as a scenario file has it; empty where none is given.
std::string text_of(const sturnus::FieldRef& place);

/// Every parameter that a scenario has, by its path.
std::map<std::string, std::string> values_of(const sturnus::ScenarioDef& scenario);

/// How a list's item is called in a path that begins with `prefix` and `key`.
std::string path_of_item(const std::string& prefix, std::string_view key, const sturnus::Items& items,
                         std::size_t index);

/// What a slider spans.
struct Span {
  double low = 0, high = 1;
  bool is_logarithmic = false;
};
/// A span that suits a parameter which was `usual` and is `now`.
Span span_of(std::string_view key, const sturnus::About& about, double usual, double now, double side);

}  // namespace studio
