// One parameter's place: reading a value into it, and its value as it would stand in a file.
#pragma once

#include <sturnus/parameters.h>

namespace sturnus {

/// Puts the value in its place; otherwise leaves it and returns the sentence that says why.
std::optional<std::string> assign(const FieldRef& place, const Value& value, const About& about);

/// The value at a place; empty for one that is not given and has no value of its own.
std::optional<Value> value_at(const FieldRef& place);

/// What kind of value belongs there, for people: "number", "integer", "open | closed".
std::string kind_of(const FieldRef& place);

/// Sentence for a name that is not known, with "did you mean" where a known one is near.
std::string unknown_word(std::string_view what, std::string_view word, const std::vector<std::string>& known);

}  // namespace sturnus
