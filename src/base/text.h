// Builds sentences out of text and numbers; numbers read back to the same value.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace sturnus {

inline void append(std::string& out, std::string_view text) {
  out += text;
}

template <class Number>
requires std::is_arithmetic_v<Number>
void append(std::string& out, Number number) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  out.append(buffer, end);
}

/// say("radius ", 3.5, " is odd") is "radius 3.5 is odd".
template <class... Parts>
std::string say(const Parts&... parts) {
  std::string out;
  (append(out, parts), ...);
  return out;
}

}  // namespace sturnus
