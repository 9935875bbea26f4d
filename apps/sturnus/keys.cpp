// sturnus keys: every parameter with its kind, default, unit, range, formula and source.
#include <sturnus/parameters.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

using sturnus::ParameterRow;

struct KeysOptions {
  std::string pattern;
  bool markdown = false;
};

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

// * stands for any letters, ? for one.
bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.front() == '*') {
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  }
  return !text.empty() && (pattern.front() == '?' || pattern.front() == text.front()) &&
         matches(pattern.substr(1), text.substr(1));
}

// A pattern with wildcards covers a path from any of its names to its end; other text occurs anywhere.
bool fits(const std::string& pattern, const std::string& path) {
  if (pattern.find_first_of("*?") == std::string::npos) return path.find(pattern) != std::string::npos;
  for (std::size_t begin = 0; begin != std::string::npos;) {
    if (matches(pattern, std::string_view(path).substr(begin))) return true;
    const auto dot = path.find('.', begin);
    begin = dot == std::string::npos ? dot : dot + 1;
  }
  return false;
}

std::vector<ParameterRow> rows_for(const std::string& pattern) {
  std::vector<ParameterRow> rows = sturnus::parameter_rows();
  std::erase_if(rows, [&](const ParameterRow& row) { return !fits(lower(pattern), lower(row.path)); });
  return rows;
}

// flock.birds.max_speed, as --set has it, means flock.NAME.max_speed here.
std::string with_flock_named(const std::string& path) {
  const auto dot = path.find('.', 6);
  if (!path.starts_with("flock.") || dot == std::string::npos) return path;
  return "flock.NAME" + path.substr(dot);
}

std::string nearest_key(const std::string& pattern) {
  std::vector<std::string> known;
  for (const ParameterRow& row : sturnus::parameter_rows()) {
    known.push_back(row.path);
    known.push_back(row.path.substr(row.path.find_last_of('.') + 1));
    const auto begin = row.path.starts_with("flock.NAME.") ? 11u : 0u;
    known.push_back(row.path.substr(begin, row.path.find('.', begin) - begin));
  }
  return sturnus::nearest_word(lower(with_flock_named(pattern)), known);
}

bool is_number(const ParameterRow& row) {
  return row.kind.find("number") != std::string::npos || row.kind == "[low, high]";
}

std::string range_text(const ParameterRow& row) {
  const double low = row.about.low, high = row.about.high;
  if (!is_number(row)) return {};
  const bool has_low = low > -sturnus::infinity, has_high = high < sturnus::infinity;
  const std::string may = row.about.may_be_infinite ? " or inf" : "";
  if (has_low && has_high) return sturnus::number_text(low) + " to " + sturnus::number_text(high) + may;
  if (has_low) return "from " + sturnus::number_text(low) + may;
  if (has_high) return "up to " + sturnus::number_text(high) + may;
  return {};
}

// One key as a paragraph.
std::string paragraph(const ParameterRow& row) {
  std::string out = row.path + "\n    " + row.about.text + "\n    " + row.kind;
  out += "; default " + (row.value.empty() ? "not given" : row.value);
  if (*row.about.unit != '\0') out += "; unit: " + std::string(row.about.unit);
  if (const std::string range = range_text(row); !range.empty()) out += "; range: " + range;
  out += "\n";
  if (*row.about.formula != '\0') out += "    formula: " + std::string(row.about.formula) + "\n";
  if (*row.about.source != '\0') out += "    source: " + std::string(row.about.source) + "\n";
  return out;
}

// A vertical bar would divide a table's cell.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) out += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return out;
}

std::string code(const std::string& text) {
  return text.empty() ? "" : "`" + escaped(text) + "`";
}

// The table that a key stands in: "flock.NAME.separation" of "flock.NAME.separation.weight".
std::string table_of(const std::string& path) {
  const auto dot = path.find_last_of('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

std::string markdown_row(const ParameterRow& row) {
  std::string text = escaped(row.about.text);
  if (*row.about.formula != '\0') text += "; formula: " + code(row.about.formula);
  const std::string cells[] = {code(row.path.substr(row.path.find_last_of('.') + 1)),
                               escaped(row.kind),
                               code(row.value),
                               escaped(row.about.unit),
                               escaped(range_text(row)),
                               text,
                               escaped(row.about.source)};
  std::string out = "|";
  for (const std::string& cell : cells) out += " " + cell + " |";
  return out + "\n";
}

std::string markdown(const std::vector<ParameterRow>& rows) {
  std::string out =
      "# Scenario keys\n\n"
      "<!-- Written by `sturnus keys --markdown`; do not edit by hand. -->\n\n"
      "Every key of a scenario file with its kind, default, unit and range. On the command line and in "
      "events a key is\n"
      "its path, `--set flock.birds.separation.radius=30`, with the flock's name in place of `NAME`. Where a "
      "default is\n"
      "empty, the key is not given by default. `events` in `[run]` is described in model.md, \"Commands and "
      "events\".\n";
  std::vector<std::string> tables;
  for (const ParameterRow& row : rows) {
    const std::string table = table_of(row.path);
    if (std::find(tables.begin(), tables.end(), table) == tables.end()) tables.push_back(table);
  }
  for (const std::string& table : tables) {
    out += "\n## " + (table.empty() ? "Top of the file" : "`" + table + "`") + "\n\n";
    out += "| key | kind | default | unit | range | meaning | source |\n|---|---|---|---|---|---|---|\n";
    for (const ParameterRow& row : rows) {
      if (table_of(row.path) == table) out += markdown_row(row);
    }
  }
  return out;
}

int keys(const KeysOptions& options) {
  std::vector<ParameterRow> rows = rows_for(options.pattern);
  if (rows.empty()) rows = rows_for(with_flock_named(options.pattern));
  if (rows.empty()) {
    const std::string near = nearest_key(options.pattern);
    return refuse("sturnus keys: no key matches \"" + options.pattern + "\"" +
                  (near.empty() ? " (sturnus keys lists all)" : "; did you mean " + near + "?"));
  }
  if (options.markdown) {
    print(markdown(rows));
    return done;
  }
  for (const ParameterRow& row : rows) print((&row == &rows.front() ? "" : "\n") + paragraph(row));
  return done;
}

}  // namespace

void add_keys(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "keys", "Explain the keys of scenario files",
      {"sturnus keys separation", "sturnus keys 'flock.*.radius'", "sturnus keys --markdown > keys.md"});
  const auto options = std::make_shared<KeysOptions>();
  command->add_option("PATTERN", options->pattern,
                      "Part of a key, or a pattern with * and ?; all keys without it");
  command->add_flag("--markdown", options->markdown, "Print the reference tables as a Markdown document");
  command->callback([&request, options] { request.work = [options] { return keys(*options); }; });
}

}  // namespace program
