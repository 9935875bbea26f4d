// The one list of parameters: parser, printer, --set, `keys` and every later panel are visitors of it.
#pragma once

#include <sturnus/scenario.h>

#include <functional>
#include <string_view>

namespace sturnus {

/// A value as a file or a command line states it.
struct Value {
  using List = std::vector<Value>;
  std::variant<bool, double, std::string, List> held;
};

/// One value from text: 12, inf, true, "wrap", wrap, [0, 12], [hawks]. Text that is none of these is a
/// string.
Value parse_value(std::string_view text);
/// The same value as TOML text.
std::string to_text(const Value& value);

/// One `key = value` of a file of settings, and the line on which it stands.
struct Entry {
  std::string key;
  Value value;
  int line = 0;  ///< 1-based
};
/// A file of plain settings, for programs: TOML without tables. The entries come in the order of the file.
Result<std::vector<Entry>> parse_entries(const std::string& text, const std::string& file);

/// What is known of a parameter besides its value.
struct About {
  const char* unit;        ///< "length", "length per time", "degrees", "" for a plain number
  const char* text;        ///< one sentence
  double low = -infinity;  ///< least allowed number
  double high = infinity;  ///< largest allowed number
  bool may_be_infinite = false;
  const char* formula = "";
  const char* source = "";  ///< course document row or paper
};

/// An enumeration seen as text.
struct Choice {
  std::vector<std::string_view> names;
  std::function<int()> get;
  std::function<void(int)> set;
};

/// Two numbers [low, high] in one key.
struct Range {
  double* low;
  double* high;
};

/// `radius = outer` or `ring = [inner, outer]`: one thing in two spellings.
struct RingRef {
  double* inner;
  double* outer;
};

/// Numbers in one key: dimensions of them, or (margin) one for all.
struct CoordinatesRef {
  Coordinates* at;
  bool one_for_all = false;
};

/// A place where a parameter is kept.
using FieldRef =
    std::variant<double*, std::int64_t*, bool*, std::string*, std::optional<double>*, CoordinatesRef, Range,
                 RingRef, Whose*, std::vector<std::string>*, std::vector<Coordinates>*, Choice>;

class FieldVisitor;

/// A table that may be absent, or a list of tables.
struct Items {
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;
  std::function<void(std::size_t, FieldVisitor&)> visit;
  std::function<std::string(std::size_t)> name;  ///< how paths call an item; empty function: by its index
  /// Calls an item something; given where names may be left out and are then made up.
  std::function<void(std::size_t, std::string)> rename;
  std::function<int*(std::size_t)> order;  ///< place in the file, where it matters; may be empty
  bool at_most_one = false;                ///< a table that may be absent
  bool has_header = false;                 ///< stands under a [[header]] of its own, not in braces
  std::string_view short_key;              ///< a plain value in place of the table means this key
};

/// What a visitor of the parameter list implements. Tables nest; keys come in the order of the documentation.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;
  virtual void field(std::string_view key, FieldRef value, const About& about) = 0;
  /// A table that is always there. `short_key`: a plain value in its place means this key of it.
  virtual void table(std::string_view key, const About& about,
                     const std::function<void(FieldVisitor&)>& visit, std::string_view short_key = {}) = 0;
  virtual void items(std::string_view key, const About& about, const Items& items) = 0;
};

/// Shows every parameter of a scenario to the visitor (events are not parameters).
void visit(ScenarioDef& scenario, FieldVisitor& visitor);

/// Sets one parameter by its path, e.g. "flock.birds.separation.radius" to 30. Says what is wrong otherwise,
/// with "did you mean"; the scenario is then as it was. The whole is not checked: see `check`.
Status set_parameter(ScenarioDef& scenario, std::string_view path, const Value& value);

/// Whether a parameter keeps its value while a flock runs: commands can't set it.
bool is_fixed_while_running(std::string_view path);

/// Text of one parameter's value, or the problem.
Result<std::string> get_parameter(const ScenarioDef& scenario, std::string_view path);

/// A row of the reference table.
struct ParameterRow {
  std::string path;   ///< with NAME for a flock's name
  std::string value;  ///< the default, as TOML
  std::string kind;   ///< "number", "integer", "true or false", "text", "open | closed", ...
  About about;
};
/// All parameters with their defaults.
std::vector<ParameterRow> parameter_rows();

/// The word of `known` nearest to `word`, or empty when none is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// Shortest text that reads back to the same number; "inf" for infinity.
std::string number_text(double value);

}  // namespace sturnus
