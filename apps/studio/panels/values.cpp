// Parameters as text, and spans for their sliders.
#include "panels/values.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

using sturnus::Value;

Value value(const std::vector<std::string>& names) {
  Value::List list;
  for (const std::string& name : names) list.push_back({name});
  return {list};
}
Value value(const sturnus::Coordinates& numbers) {
  Value::List list;
  for (const double number : numbers) list.push_back({number});
  return {list};
}

struct Text {
  std::string operator()(const double* place) const { return sturnus::number_text(*place); }
  std::string operator()(const std::int64_t* place) const { return std::to_string(*place); }
  std::string operator()(const bool* place) const { return *place ? "true" : "false"; }
  std::string operator()(const std::string* place) const { return to_text(Value{*place}); }
  std::string operator()(const std::optional<double>* place) const {
    return *place ? sturnus::number_text(**place) : "";
  }
  std::string operator()(const sturnus::CoordinatesRef& place) const {
    if (place.one_for_all && place.at->size() == 1) return sturnus::number_text(place.at->front());
    return place.at->empty() ? "" : to_text(value(*place.at));
  }
  std::string operator()(const sturnus::Range& place) const {
    return to_text(value(sturnus::Coordinates{*place.low, *place.high}));
  }
  std::string operator()(const sturnus::RingRef& place) const {
    if (*place.inner == 0) return sturnus::number_text(*place.outer);
    return to_text(value(sturnus::Coordinates{*place.inner, *place.outer}));
  }
  std::string operator()(const sturnus::Whose* place) const {
    if (place->kind == sturnus::Whose::Kind::named) return to_text(value(place->names));
    return place->kind == sturnus::Whose::Kind::own ? "\"own\"" : "\"all\"";
  }
  std::string operator()(const std::vector<std::string>* place) const { return to_text(value(*place)); }
  std::string operator()(const std::vector<sturnus::Coordinates>* place) const {
    Value::List list;
    for (const sturnus::Coordinates& numbers : *place) list.push_back(value(numbers));
    return list.empty() ? "" : to_text(Value{list});
  }
  std::string operator()(const sturnus::Choice& place) const {
    return to_text(Value{std::string(place.names[static_cast<std::size_t>(place.get())])});
  }
};

// Writes down what it sees.
class Lister : public sturnus::FieldVisitor {
 public:
  Lister(std::string prefix, std::map<std::string, std::string>& values)
      : prefix_(std::move(prefix)), values_(values) {}
  void field(std::string_view key, sturnus::FieldRef place, const sturnus::About&) override {
    values_[prefix_ + std::string(key)] = text_of(place);
  }
  void table(std::string_view key, const sturnus::About&,
             const std::function<void(FieldVisitor&)>& visit_inside, std::string_view) override {
    Lister inner(prefix_ + std::string(key) + ".", values_);
    visit_inside(inner);
  }
  void items(std::string_view key, const sturnus::About&, const sturnus::Items& items) override {
    for (std::size_t i = 0; i < items.size(); ++i) {
      Lister inner(path_of_item(prefix_, key, items, i) + ".", values_);
      items.visit(i, inner);
    }
  }

 private:
  std::string prefix_;
  std::map<std::string, std::string>& values_;
};

// The least of 1, 2, 5, 10, ... that is not below a number.
double round_up(double number) {
  const double decade = std::pow(10, std::floor(std::log10(number)));
  for (const double part : {1.0, 2.0, 5.0}) {
    if (part * decade >= number * 0.999) return part * decade;
  }
  return 10 * decade;
}

constexpr double widest_known = 1000;  // ranges up to this are spanned as they are

double usual_scale(std::string_view key, const sturnus::About& about, double side) {
  const std::string_view unit = about.unit;
  if (key == "weight") return 0.25;
  if (unit == "length") return side / 16;
  if (unit == "degrees") return 90;
  return 0.5;
}

}  // namespace

std::string text_of(const sturnus::FieldRef& place) {
  return std::visit(Text{}, place);
}

std::map<std::string, std::string> values_of(const sturnus::ScenarioDef& scenario) {
  sturnus::ScenarioDef copy = scenario;  // visiting hands out places to write to
  std::map<std::string, std::string> values;
  Lister lister("", values);
  visit(copy, lister);
  return values;
}

std::string path_of_item(const std::string& prefix, std::string_view key, const sturnus::Items& items,
                         std::size_t index) {
  std::string path = prefix + std::string(key);
  if (items.name) return path + "." + items.name(index);
  if (items.size() > 1) path += "." + std::to_string(index);
  return path;
}

std::optional<std::string> scaled(const std::string& text, double factor) {
  Value value = sturnus::parse_value(text);
  const auto scale = [factor](Value& one) {
    auto* number = std::get_if<double>(&one.held);
    if (number == nullptr || !std::isfinite(*number)) return false;
    *number *= factor;
    return true;
  };
  auto* list = std::get_if<Value::List>(&value.held);
  const bool is_scaled = list != nullptr ? std::all_of(list->begin(), list->end(), scale) : scale(value);
  if (!is_scaled) return {};
  return to_text(value);
}

std::vector<std::string> paths_of_rows(const std::map<std::string, std::string>& values,
                                       const std::string& flock, const std::string& kind,
                                       const std::string& key) {
  const std::string begin = "flock." + flock + "." + kind + ".";
  if (values.contains(begin + key)) return {begin + key};
  std::vector<std::string> paths;
  for (int i = 0; values.contains(begin + std::to_string(i) + "." + key); ++i)
    paths.push_back(begin + std::to_string(i) + "." + key);
  return paths;
}

Span span_of(std::string_view key, const sturnus::About& about, double usual, double now, double side) {
  const bool is_known = about.low > -widest_known && about.high < widest_known && about.low < about.high;
  if (is_known) return {about.low, about.high, false};
  const double scale = std::isfinite(usual) && usual != 0 ? std::abs(usual) : usual_scale(key, about, side);
  const bool is_weight = key == "weight" || key == "strength";
  double high = round_up(scale * (is_weight ? 10 : 4));
  if (std::isfinite(now) && std::abs(now) > high) high = round_up(std::abs(now));
  high = std::min(high, about.high);
  const bool is_signed = about.low < 0 && (usual < 0 || now < 0);
  return {is_signed ? -high : std::max(about.low, 0.0), high, is_weight && !is_signed};
}

}  // namespace studio
