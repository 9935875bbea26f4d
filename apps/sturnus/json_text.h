// JSON as the commands write it.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace program {

/// A number that means nothing is null.
inline nlohmann::ordered_json number_or_null(double number) {
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

/// Indented text that ends its last line; bytes that are no UTF-8 are replaced.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace program
