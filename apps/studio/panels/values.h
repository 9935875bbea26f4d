// Values of parameters as text, by their paths.
#pragma once

#include <sturnus/parameters.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace studio {

/// The value as a scenario file has it; empty where none is given.
std::string text_of(const sturnus::FieldRef& place);

/// Every parameter that a scenario has, by its path.
std::map<std::string, std::string> values_of(const sturnus::ScenarioDef& scenario);

/// How a list's item is called in a path that begins with `prefix` and `key`.
std::string path_of_item(const std::string& prefix, std::string_view key, const sturnus::Items& items,
                         std::size_t index);

/// A number or a list of numbers (a ring's radii), each times the factor; nothing for any other text.
std::optional<std::string> scaled(const std::string& text, double factor);
/// The paths of a flock's value: "flock.a.cohesion.radius", or one for each of several rows of the kind,
/// "flock.a.cohesion.0.radius".
std::vector<std::string> paths_of_rows(const std::map<std::string, std::string>& values,
                                       const std::string& flock, const std::string& kind,
                                       const std::string& key);

/// What a slider spans.
struct Span {
  double low = 0, high = 1;
  bool is_logarithmic = false;
};
/// A span that suits a parameter which was `usual` and is `now`.
Span span_of(std::string_view key, const sturnus::About& about, double usual, double now, double side);

}  // namespace studio
