// What the visiting functions of parameters are made of, and the keys that many terms share.
#pragma once

#include <sturnus/parameters.h>

#include <initializer_list>
#include <iterator>
#include <utility>

#include "scenario/common_checks.h"

namespace sturnus {

template <class Enum>
Choice choice(Enum& value, std::initializer_list<std::string_view> names) {
  return {names, [&value] { return static_cast<int>(value); },
          [&value](int index) { value = static_cast<Enum>(index); }};
}

template <class Def>
Items list_of(std::vector<Def>& items, void (*visit_item)(Def&, FieldVisitor&)) {
  Items out;
  out.size = [&items] { return items.size(); };
  out.resize = [&items](std::size_t size) { items.resize(size); };
  out.visit = [&items, visit_item](std::size_t i, FieldVisitor& visitor) { visit_item(items[i], visitor); };
  if constexpr (requires(Def def) { def.order; }) {
    out.order = [&items](std::size_t i) { return &items[i].order; };
  }
  return out;
}

template <class Def>
Items maybe(std::optional<Def>& item, void (*visit_item)(Def&, FieldVisitor&)) {
  Items out;
  out.at_most_one = true;
  out.size = [&item] { return item ? std::size_t{1} : std::size_t{0}; };
  out.resize = [&item](std::size_t size) {
    if (size == 0) item.reset();
    if (size > 0 && !item) item.emplace();
  };
  out.visit = [&item, visit_item](std::size_t, FieldVisitor& visitor) { visit_item(*item, visitor); };
  if constexpr (requires(Def def) { def.order; }) {
    out.order = [&item](std::size_t) { return &item->order; };
  }
  return out;
}

inline Choice edge_choice(Edge& edge) {
  return choice(edge, {"open", "closed"});
}
inline Choice strength_choice(Strength& strength) {
  return choice(strength, {"d", "1", "1/d"});
}
inline Choice combine_choice(Combine& combine) {
  return choice(combine, {"sum", "mean"});
}
inline Choice form_choice(SteeringForm& form) {
  return {{std::begin(form_names), std::end(form_names)},
          [&form] { return static_cast<int>(form); },
          [&form](int index) { form = static_cast<SteeringForm>(index); }};
}

inline constexpr About weight_about{"", "how much the term counts in the sum of accelerations", -1e9, 1e9};
inline constexpr About field_of_view_about{"degrees",
                                           "full angle of sight around the heading; default: the flock's",
                                           0,
                                           360,
                                           false,
                                           "v·o >= cos(half)·|v|·d",
                                           "quadtree project (S3-5)"};
inline constexpr About priority_about{"",
                                      "order under arbitration budget and first, low numbers first",
                                      -1000000,
                                      1000000,
                                      false,
                                      "",
                                      "VUW CGRA 354 (S2-30)"};
inline constexpr About on_about{"", "a switch that keeps the weight", 0, 1, false, "", "CS 184 (S4-21)"};

/// The lists of src/scenario/fields_creatures.cpp.
void visit_hunt(Hunt& hunt, FieldVisitor& visitor);
void visit_jump(Jump& jump, FieldVisitor& visitor);
void visit_hunger(Hunger& hunger, FieldVisitor& visitor);
void visit_feed(Feed& feed, FieldVisitor& visitor);
void visit_food(FoodDef& food, FieldVisitor& visitor);

}  // namespace sturnus
