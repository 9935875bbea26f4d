// A value, or the sentences that say why there is none.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sturnus {

/// What a person has to be told: where, and in one sentence what is wrong.
struct Problem {
  std::string file;         ///< path or scenario name; empty when there is no file
  int line = 0;             ///< 1-based; 0 when there is no line
  std::string key;          ///< dotted parameter path; empty when there is none
  std::string text;         ///< the sentence
  bool is_warning = false;  ///< warnings never stop a run

  /// "fish.toml:12: flock.fish.max_speed: 4 is below min_speed 5"
  std::string sentence() const {
    std::string out = file;
    if (line > 0) out += (out.empty() ? "line " : ":") + std::to_string(line);
    if (!out.empty()) out += ": ";
    if (!key.empty()) out += key + ": ";
    return out + (is_warning ? "warning: " : "") + text;
  }
};

using Problems = std::vector<Problem>;

/// All sentences, one a line.
inline std::string to_text(const Problems& problems) {
  std::string out;
  for (const Problem& problem : problems) out += problem.sentence() + "\n";
  return out;
}

/// True when a problem is more than a warning.
inline bool has_errors(const Problems& problems) {
  for (const Problem& problem : problems) {
    if (!problem.is_warning) return true;
  }
  return false;
}

/// A value of type T, or every problem that stands in its way. Never both, never neither.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}                  // NOLINT: a value is a result
  Result(Problems problems) : problems_(std::move(problems)) {}  // NOLINT
  Result(Problem problem) : problems_{std::move(problem)} {}     // NOLINT

  explicit operator bool() const { return value_.has_value(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

  const Problems& problems() const { return problems_; }
  std::string error() const { return to_text(problems_); }

 private:
  std::optional<T> value_;
  Problems problems_;
};

/// Success without a value, or the problems.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Problems problems) : problems_(std::move(problems)) {}  // NOLINT
  Status(Problem problem) : problems_{std::move(problem)} {}     // NOLINT

  explicit operator bool() const { return !has_errors(problems_); }
  const Problems& problems() const { return problems_; }
  std::string error() const { return to_text(problems_); }

 private:
  Problems problems_;
};

}  // namespace sturnus
