// One parameter's place: checks and stores a value, and shows what is stored.
#include "scenario/assign.h"

#include <cmath>

#include "base/text.h"

namespace sturnus {
namespace {

using Error = std::optional<std::string>;

std::string found(const Value& value) {
  const std::string text = to_text(value);
  return say("but found ", text.size() > 80 ? text.substr(0, 77) + "..." : text);
}

Error check_number(double number, const About& about) {
  if (std::isnan(number)) return "must be a number, but is not one (nan)";
  if (std::isinf(number) && about.may_be_infinite && number > 0) return {};
  if (std::isinf(number)) return "must be finite";
  if (number < about.low) {
    return about.low == 0
               ? say("must not be negative, but is ", number_text(number))
               : say("must be at least ", number_text(about.low), ", but is ", number_text(number));
  }
  if (number > about.high)
    return say("must be at most ", number_text(about.high), ", but is ", number_text(number));
  return {};
}

// Whether bytes are UTF-8, as every TOML file must be.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t j = 1; j < length; ++j) {
      if ((static_cast<unsigned char>(text[i + j]) & 0xc0) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

struct Assigner {
  const Value& value;
  const About& about;

  Error number(double& place) const {
    const auto* given = std::get_if<double>(&value.held);
    if (given == nullptr) return say("must be a number, ", found(value));
    if (auto error = check_number(*given, about)) return error;
    place = *given;
    return {};
  }

  Error operator()(double* place) const { return number(*place); }

  Error operator()(std::optional<double>* place) const {
    double given = 0;
    if (auto error = number(given)) return error;
    *place = given;
    return {};
  }

  Error operator()(std::int64_t* place) const {
    double given = 0;
    if (!std::holds_alternative<double>(value.held)) return say("must be a whole number, ", found(value));
    if (auto error = number(given)) return error;
    if (given != std::floor(given) || std::abs(given) > 9007199254740992.0) {
      return say("must be a whole number, ", found(value));
    }
    *place = static_cast<std::int64_t>(given);
    return {};
  }

  Error operator()(bool* place) const {
    const auto* given = std::get_if<bool>(&value.held);
    if (given == nullptr) return say("must be true or false, ", found(value));
    *place = *given;
    return {};
  }

  Error operator()(std::string* place) const {
    const auto* given = std::get_if<std::string>(&value.held);
    if (given == nullptr) return say("must be text, ", found(value));
    if (!is_utf8(*given)) return "must be text in UTF-8";
    *place = *given;
    return {};
  }

  Error operator()(const Choice& place) const {
    std::string word;
    if (const auto* text = std::get_if<std::string>(&value.held)) word = *text;
    if (std::holds_alternative<double>(value.held)) word = to_text(value);
    std::vector<std::string> known;
    for (std::size_t i = 0; i < place.names.size(); ++i) {
      known.emplace_back(place.names[i]);
      if (place.names[i] == word && !word.empty()) {
        place.set(static_cast<int>(i));
        return {};
      }
    }
    const std::string near = word.empty() ? "" : nearest_word(word, known);
    return say("must be one of ", kind_of(place), ", ", found(value), near.empty() ? "" : "; did you mean \"",
               near, near.empty() ? "" : "\"?");
  }

  // The numbers of a list, or the error.
  Error numbers(std::vector<double>& out) const {
    const auto* list = std::get_if<Value::List>(&value.held);
    if (list == nullptr) return say("must be a list of numbers such as [0, 1], ", found(value));
    for (const Value& item : *list) {
      const auto* number = std::get_if<double>(&item.held);
      if (number == nullptr) return say("must be a list of numbers such as [0, 1], ", found(value));
      if (auto error = check_number(*number, about)) return error;
      out.push_back(*number);
    }
    return {};
  }

  Error operator()(const CoordinatesRef& place) const {
    if (place.one_for_all && std::holds_alternative<double>(value.held)) {
      double single = 0;
      if (auto error = number(single)) return error;
      *place.at = {single};
      return {};
    }
    std::vector<double> given;
    if (auto error = numbers(given)) return error;
    if (given.size() > 3) return say("must have a number for each dimension, ", found(value));
    *place.at = given;
    return {};
  }

  Error pair(double* low, double* high, const char* what) const {
    std::vector<double> given;
    if (auto error = numbers(given)) return error;
    if (given.size() != 2) return say("must be two numbers ", what, ", ", found(value));
    if (given[0] > given[1]) {
      return say("must be ", what, " with the smaller first, ", found(value));
    }
    *low = given[0];
    *high = given[1];
    return {};
  }

  Error operator()(const Range& place) const { return pair(place.low, place.high, "[low, high]"); }

  // A list is the ring, a number the outer radius.
  Error operator()(const RingRef& place) const {
    if (std::holds_alternative<Value::List>(value.held))
      return pair(place.inner, place.outer, "[inner, outer]");
    return number(*place.outer);
  }

  Error names(std::vector<std::string>& place) const {
    const auto* list = std::get_if<Value::List>(&value.held);
    if (list == nullptr) return say("must be a list of names such as [\"hawks\"], ", found(value));
    std::vector<std::string> given;
    for (const Value& item : *list) {
      const auto* name = std::get_if<std::string>(&item.held);
      if (name == nullptr) return say("must be a list of names such as [\"hawks\"], ", found(value));
      if (!is_utf8(*name)) return "must be text in UTF-8";
      given.push_back(*name);
    }
    place = given;
    return {};
  }

  Error operator()(std::vector<std::string>* place) const { return names(*place); }

  Error operator()(std::vector<Coordinates>* place) const {
    constexpr const char* wanted = "must be a list of lists of numbers such as [[0, 0, 5], [9, 4, 2]], ";
    const auto* list = std::get_if<Value::List>(&value.held);
    if (list == nullptr) return say(wanted, found(value));
    std::vector<Coordinates> given(list->size());
    for (std::size_t i = 0; i < list->size(); ++i) {
      if (!std::holds_alternative<Value::List>((*list)[i].held)) return say(wanted, found(value));
      if (auto error = Assigner{(*list)[i], about}.numbers(given[i])) return error;
    }
    *place = std::move(given);
    return {};
  }

  Error operator()(Whose* place) const {
    if (const auto* word = std::get_if<std::string>(&value.held)) {
      if (*word != "own" && *word != "all") {
        return say("must be \"own\", \"all\" or a list of flock names, ", found(value));
      }
      *place = {*word == "own" ? Whose::Kind::own : Whose::Kind::all, {}};
      return {};
    }
    std::vector<std::string> given;
    if (auto error = names(given)) return error;
    *place = {Whose::Kind::named, given};
    return {};
  }
};

Value list_of_numbers(const std::vector<double>& numbers) {
  Value::List list;
  for (const double number : numbers) list.push_back({number});
  return {list};
}

Value list_of_names(const std::vector<std::string>& names) {
  Value::List list;
  for (const std::string& name : names) list.push_back({name});
  return {list};
}

struct Shower {
  using Shown = std::optional<Value>;
  Shown operator()(const double* place) const { return Value{*place}; }
  Shown operator()(const std::int64_t* place) const { return Value{static_cast<double>(*place)}; }
  Shown operator()(const bool* place) const { return Value{*place}; }
  Shown operator()(const std::string* place) const { return Value{*place}; }
  Shown operator()(const std::optional<double>* place) const {
    return *place ? Shown(Value{**place}) : Shown();
  }
  Shown operator()(const CoordinatesRef& place) const {
    if (place.at->empty()) return {};
    if (place.one_for_all && place.at->size() == 1) return Value{place.at->front()};
    return list_of_numbers(*place.at);
  }
  Shown operator()(const Range& place) const { return list_of_numbers({*place.low, *place.high}); }
  Shown operator()(const RingRef& place) const {
    if (*place.inner == 0) return Value{*place.outer};
    return list_of_numbers({*place.inner, *place.outer});
  }
  Shown operator()(const Whose* place) const {
    if (place->kind == Whose::Kind::named) return list_of_names(place->names);
    return Value{std::string(place->kind == Whose::Kind::own ? "own" : "all")};
  }
  Shown operator()(const std::vector<std::string>* place) const { return list_of_names(*place); }
  // An empty list is the same as none.
  Shown operator()(const std::vector<Coordinates>* place) const {
    if (place->empty()) return {};
    Value::List list;
    for (const Coordinates& numbers : *place) list.push_back(list_of_numbers(numbers));
    return Value{list};
  }
  Shown operator()(const Choice& place) const {
    return Value{std::string(place.names[static_cast<std::size_t>(place.get())])};
  }
};

struct Kinds {
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const std::int64_t*) const { return "whole number"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const std::optional<double>*) const { return "number"; }
  std::string operator()(const CoordinatesRef& place) const {
    return place.one_for_all ? "number or list of numbers" : "list of numbers";
  }
  std::string operator()(const Range&) const { return "[low, high]"; }
  std::string operator()(const RingRef&) const { return "number or [inner, outer]"; }
  std::string operator()(const Whose*) const { return "\"own\" | \"all\" | list of names"; }
  std::string operator()(const std::vector<std::string>*) const { return "list of texts"; }
  std::string operator()(const std::vector<Coordinates>*) const { return "list of lists of numbers"; }
  std::string operator()(const Choice& place) const {
    std::string out;
    for (const auto name : place.names) out += say(out.empty() ? "\"" : " | \"", name, "\"");
    return out;
  }
};

}  // namespace

std::optional<std::string> assign(const FieldRef& place, const Value& value, const About& about) {
  return std::visit(Assigner{value, about}, place);
}

std::optional<Value> value_at(const FieldRef& place) {
  return std::visit(Shower{}, place);
}

std::string kind_of(const FieldRef& place) {
  return std::visit(Kinds{}, place);
}

std::string unknown_word(std::string_view what, std::string_view word,
                         const std::vector<std::string>& known) {
  const std::string near = nearest_word(word, known);
  std::string out = say("there is no ", what, " \"", word, "\"");
  if (!near.empty()) return out + say("; did you mean \"", near, "\"?");
  if (known.empty() || known.size() > 16) return out;
  out += "; there is ";
  for (std::size_t i = 0; i < known.size(); ++i) out += say(i == 0 ? "" : ", ", known[i]);
  return out;
}

}  // namespace sturnus
