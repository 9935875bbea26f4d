// Values as files and command lines state them: text to value and back.
#include <sturnus/parameters.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sturnus {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> number_in(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

bool is_quoted(std::string_view text) {
  return text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
}

// The control character behind \u00xx, the only such form that `quoted` writes.
std::optional<char> control_character(std::string_view text) {
  int code = 0;
  if (!text.starts_with("u00") || text.size() < 5) return {};
  const auto [end, error] = std::from_chars(text.data() + 3, text.data() + 5, code, 16);
  if (error != std::errc{} || end != text.data() + 5 || code > 0x7f) return {};
  return static_cast<char>(code);
}

std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size()) {
      ++i;
      if (const auto control = control_character(text.substr(i))) {
        out += *control;
        i += 4;
      } else {
        out += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i];
      }
    } else {
      out += text[i];
    }
  }
  return out;
}

// The items between the brackets of a list; commas inside quotes or inner brackets do not divide.
std::vector<std::string_view> list_items(std::string_view inside) {
  std::vector<std::string_view> items;
  std::size_t begin = 0;
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i <= inside.size(); ++i) {
    const bool at_end = i == inside.size();
    if (at_end || (inside[i] == ',' && depth == 0 && quote == 0)) {
      const auto item = trimmed(inside.substr(begin, i - begin));
      if (!item.empty()) items.push_back(item);
      begin = i + 1;
      continue;
    }
    const char c = inside[i];
    if (quote != 0) {
      if (c == '\\') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else {
      depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    }
  }
  return items;
}

std::string quoted(std::string_view text) {
  constexpr char hex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      out += "\\u00";
      out += hex[code >> 4];
      out += hex[code & 15];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

// Letters put in, left out, replaced, or swapped with their neighbour ("uscd" is one away from "ucsd").
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), above, two_above;
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_above = std::move(above);
    above = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

namespace {

// Brackets nest no deeper than any real value; what does is text.
constexpr int deepest_list = 16;

Value parse_nested(std::string_view text, int depth) {
  text = trimmed(text);
  if (text == "true") return {true};
  if (text == "false") return {false};
  if (const auto number = number_in(text)) return {*number};
  if (is_quoted(text))
    return {text.front() == '"' ? unescaped(text.substr(1, text.size() - 2))
                                : std::string(text.substr(1, text.size() - 2))};
  if (depth < deepest_list && text.size() >= 2 && text.front() == '[' && text.back() == ']') {
    Value::List list;
    for (const auto item : list_items(text.substr(1, text.size() - 2)))
      list.push_back(parse_nested(item, depth + 1));
    return {list};
  }
  return {std::string(text)};
}

}  // namespace

Value parse_value(std::string_view text) {
  return parse_nested(text, 0);
}

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (std::isnan(value)) return "nan";
  char buffer[64];
  // Beyond 2^53 in scientific form: TOML would take plain digits for a whole number that is too large.
  const bool huge = std::abs(value) > 9007199254740992.0;
  const auto end = huge ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific)
                        : std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

std::string to_text(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value.held)) return *flag ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value.held)) return number_text(*number);
  if (const auto* text = std::get_if<std::string>(&value.held)) return quoted(*text);
  std::string out = "[";
  for (const Value& item : std::get<Value::List>(value.held)) {
    if (out.size() > 1) out += ", ";
    out += to_text(item);
  }
  return out + "]";
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace sturnus
