// The list of settings, each with what it accepts.
#include "choices.h"

#include <sturnus/files.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace prog06 {
namespace {

using sturnus::Value;

constexpr double farthest = 1e6;    // length; a camera farther away sees nothing
constexpr int largest_side = 4096;  // pixels; of a window
constexpr double largest_seed = 9007199254740992.0;

std::string expected(const std::string& what, const Value& value) {
  return "must be " + what + ", but is " + to_text(value);
}

std::string take_number(const Value& value, double low, double high, const std::string& what, double& place) {
  const auto* number = std::get_if<double>(&value.held);
  if (number == nullptr || !(*number >= low && *number <= high)) return expected(what, value);
  place = *number;
  return {};
}

// A list of numbers, all of them within [low, high]; empty when it is anything else.
std::vector<double> numbers_in(const Value& value, double low, double high) {
  std::vector<double> out;
  const auto* list = std::get_if<Value::List>(&value.held);
  if (list == nullptr) return {};
  for (const Value& item : *list) {
    const auto* number = std::get_if<double>(&item.held);
    if (number == nullptr || !(*number >= low && *number <= high)) return {};
    out.push_back(*number);
  }
  return out;
}

std::optional<sturnus::Point3> point_in(const Value& value) {
  const std::vector<double> numbers = numbers_in(value, -farthest, farthest);
  if (numbers.size() != 3) return {};
  return sturnus::Point3{static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
                         static_cast<float>(numbers[2])};
}

// 640x480
std::vector<double> sides_in(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x') return {};
  const auto second = std::from_chars(first.ptr + 1, end, height);
  if (second.ec != std::errc() || second.ptr != end) return {};
  return {static_cast<double>(width), static_cast<double>(height)};
}

std::string take_size(Choices& choices, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.held);
  const std::vector<double> sides = text != nullptr ? sides_in(*text) : numbers_in(value, 0, largest_side);
  if (sides.size() == 2) {
    const double least = std::min(sides[0], sides[1]), most = std::max(sides[0], sides[1]);
    const bool is_whole = sides[0] == std::floor(sides[0]) && sides[1] == std::floor(sides[1]);
    if (is_whole && least >= sturnus::min_picture_side && most <= largest_side) {
      choices.size = {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
      return {};
    }
  }
  return expected("two sides of 16 to 4096 pixels such as 640x480", value);
}

std::string take_eye(Choices& choices, const Value& value) {
  choices.eye = point_in(value);
  return choices.eye ? "" : expected("three numbers such as 0, 0, 2", value);
}

std::string take_target(Choices& choices, const Value& value) {
  const auto point = point_in(value);
  if (!point) return expected("three numbers such as 0, 0, 0", value);
  choices.target = *point;
  return {};
}

std::string take_field_of_view(Choices& choices, const Value& value) {
  return take_number(value, 1, 170, "an angle from 1 to 170 degrees", choices.field_of_view);
}

std::string take_boid_size(Choices& choices, const Value& value) {
  return take_number(value, 1e-4, 10, "a number from 0.0001 to 10", choices.boid_size);
}

std::string take_dimensions(Choices& choices, const Value& value) {
  double number = 0;
  std::string error = take_number(value, 2, 3, "2 or 3", number);
  if (error.empty() && number != std::floor(number)) error = expected("2 or 3", value);
  if (error.empty()) choices.dimensions = static_cast<int>(number);
  return error;
}

std::string take_seed(Choices& choices, const Value& value) {
  const std::string what = "a whole number of at least 0";
  double number = 0;
  std::string error = take_number(value, 0, largest_seed, what, number);
  if (error.empty() && number != std::floor(number)) error = expected(what, value);
  if (error.empty()) choices.seed = static_cast<std::int64_t>(number);
  return error;
}

// One PATH=VALUE, or in a file a list of them.
std::string take_parameters(Choices& choices, const Value& value) {
  if (const auto* list = std::get_if<Value::List>(&value.held)) {
    for (const Value& item : *list) {
      if (std::string error = take_parameters(choices, item); !error.empty()) return error;
    }
    return {};
  }
  const auto* text = std::get_if<std::string>(&value.held);
  if (text == nullptr || text->find('=') == std::string::npos) {
    return expected("a text such as \"flock.boids.max_speed=0.03\"", value);
  }
  choices.parameters.push_back({*text, "", 0});
  return {};
}

std::string unknown_setting(const std::string& key) {
  std::vector<std::string> known;
  std::string all;
  for (const Setting& setting : settings()) {
    known.push_back(setting.key);
    all += (all.empty() ? "" : ", ") + setting.key;
  }
  const std::string near = sturnus::nearest_word(key, known);
  return "there is no such setting; " + (near.empty() ? "there are " + all : "did you mean " + near + "?");
}

}  // namespace

sturnus::Point3 eye_of(const Choices& choices) {
  constexpr sturnus::Point3 above = {0, 0, 2}, aside = {0.9f, 0.7f, 2.1f};
  return choices.eye.value_or(choices.dimensions == 2 ? above : aside);
}

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all = {
      {"size", "WxH", "size of the window and of the picture in pixels (720x720)", false, false, take_size},
      {"eye", "X,Y,Z", "where the camera stands (0,0,2; in 3D 0.9,0.7,2.1)", true, false, take_eye},
      {"target", "X,Y,Z", "what it looks at (0,0,0)", true, false, take_target},
      {"field_of_view", "DEGREES", "its full vertical angle (40)", false, false, take_field_of_view},
      {"boid_size", "FACTOR", "size of the boids; 1 draws cones 0.5 long (0.06)", false, false,
       take_boid_size},
      {"dimensions", "2|3", "a flat box, or a cube (2)", false, false, take_dimensions},
      {"seed", "N", "another start (6)", false, false, take_seed},
      {"set", "PATH=VALUE", "any other parameter of the scenario prog06; may repeat", false, true,
       take_parameters},
  };
  return all;
}

const Setting* setting_of(const std::string& key) {
  for (const Setting& setting : settings()) {
    if (setting.key == key) return &setting;
  }
  return nullptr;
}

sturnus::Status apply_file(const std::string& path, Choices& choices) {
  const auto text = sturnus::read_text(path);
  if (!text) return text.problems();
  const auto entries = sturnus::parse_entries(*text, path);
  if (!entries) return entries.problems();
  sturnus::Problems problems;
  for (const sturnus::Entry& entry : *entries) {
    const Setting* setting = setting_of(entry.key);
    const std::size_t known = choices.parameters.size();
    const std::string error =
        setting != nullptr ? setting->take(choices, entry.value) : unknown_setting(entry.key);
    if (!error.empty()) problems.push_back({path, entry.line, entry.key, error, false});
    for (std::size_t i = known; i < choices.parameters.size(); ++i) {
      choices.parameters[i].file = path;
      choices.parameters[i].line = entry.line;
    }
  }
  return problems;
}

}  // namespace prog06
