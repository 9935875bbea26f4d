// State CSV: one boid a line in storage order, numbers that read back to the same bits.
#include <sturnus/files.h>

#include <sturnus/parameters.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"

namespace sturnus {
namespace {

// Where a named column's numbers go.
struct Column {
  std::string name;
  std::vector<float>* floats = nullptr;
  std::vector<std::uint64_t>* ids = nullptr;
  std::vector<std::uint8_t>* small = nullptr;
  std::vector<double>* doubles = nullptr;
};

// A state beside the one value that it keeps for all boids, which a table can only repeat in every line.
struct Table {
  State state;
  std::vector<std::uint64_t> next_id;
};

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr const char* channel_names[] = {"red", "green", "blue"};

// All columns that a state of so many dimensions may have, in the order of the file.
std::vector<Column> columns_of(Table& table, int dimensions) {
  State& state = table.state;
  std::vector<Column> out = {{"id", nullptr, &state.id, nullptr}, {"flock", nullptr, nullptr, &state.flock}};
  const auto axes = static_cast<std::size_t>(dimensions);
  for (std::size_t axis = 0; axis < axes; ++axis)
    out.push_back({axis_names[axis], &state.position[axis], nullptr, nullptr});
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.push_back({say("v", axis_names[axis]), &state.velocity[axis], nullptr, nullptr});
  }
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.push_back({say("wander_", axis_names[axis]), &state.wander[axis], nullptr, nullptr});
  }
  for (std::size_t i = 0; i < 3; ++i) out.push_back({channel_names[i], &state.colour[i], nullptr, nullptr});
  out.push_back({"quarantined", nullptr, nullptr, &state.quarantined});
  out.push_back({"full", nullptr, nullptr, nullptr, &state.life.full});
  out.push_back({"fasting", nullptr, nullptr, nullptr, &state.life.fasting});
  out.push_back({"jump", nullptr, nullptr, nullptr, &state.life.jump});
  out.push_back({"rest", nullptr, nullptr, nullptr, &state.life.rest});
  out.push_back({"focus", nullptr, &state.life.focus, nullptr});
  out.push_back({"next_id", nullptr, &table.next_id, nullptr});
  return out;
}

// The columns of a piece of food; it leaves the others empty.
std::vector<Column> food_columns_of(Table& table, int dimensions) {
  Food& food = table.state.food;
  std::vector<Column> out = {{"id", nullptr, &food.id, nullptr}};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis)
    out.push_back({axis_names[axis], &food.position[axis], nullptr, nullptr});
  out.push_back({"next_id", nullptr, &table.next_id, nullptr});
  out.push_back({"food", nullptr, nullptr, &food.kind});
  return out;
}

// The column of that name, or null.
const Column* column_named(const std::vector<Column>& columns, std::string_view name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

bool is_written(const Column& column, const State& state) {
  if (column.name == "quarantined") {
    return std::any_of(state.quarantined.begin(), state.quarantined.end(),
                       [](std::uint8_t flag) { return flag != 0; });
  }
  if (column.name == "next_id" || column.name == "focus") return !column.ids->empty();
  if (column.doubles != nullptr) return !column.doubles->empty();
  return column.ids != nullptr || column.small != nullptr || !column.floats->empty() ||
         (state.size() == 0 && (column.name.size() == 1 || column.name[0] == 'v'));
}

void append_cell(std::string& out, const Column& column, std::size_t i) {
  if (column.floats != nullptr) append(out, (*column.floats)[i]);
  if (column.doubles != nullptr) append(out, (*column.doubles)[i]);
  if (column.ids != nullptr && (*column.ids)[i] != nobody) append(out, (*column.ids)[i]);
  if (column.small != nullptr) append(out, int{(*column.small)[i]});
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    cells.push_back(cell);
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

template <class Number>
bool read_number(std::string_view cell, Number& number) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc{} && end == cell.data() + cell.size();
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file) : rest_(text), file_(file) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  Result<State> run() {
    if (!read_header()) return problem_;
    std::string_view line;
    while (next_line(line)) {
      if (!line.empty() && !read_row(line)) return problem_;
    }
    finish();
    return std::move(state_);
  }

 private:
  bool next_line(std::string_view& line) {
    if (rest_.empty()) return false;
    ++line_number_;
    const auto end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return true;
  }

  bool fail(std::string key, std::string text) {
    problem_ = {file_, line_number_, std::move(key), std::move(text), false};
    return false;
  }

  bool read_header() {
    std::string_view line;
    if (!next_line(line))
      return fail("", "the file is empty; a state CSV begins with the line id,flock,x,y,vx,vy");
    const auto names = split(line);
    state_.dimensions = std::find(names.begin(), names.end(), "z") != names.end() ? 3 : 2;
    auto possible = columns_of(table_, state_.dimensions);
    std::vector<std::string> known;
    for (const Column& column : possible) known.push_back(column.name);
    known.push_back("food");
    for (const std::string_view name : names) {
      const auto found = std::find(known.begin(), known.end(), name);
      if (found == known.end()) {
        const std::string near = nearest_word(name, known);
        return fail(std::string(name),
                    say("there is no such column",
                        near.empty() ? "; a state CSV has id,flock,x,y,vx,vy or id,flock,x,y,z,vx,vy,vz"
                                     : "; did you mean \"",
                        near, near.empty() ? "" : "\"?"));
      }
      if (has(name)) return fail(std::string(name), "the column stands there twice");
      const auto number = static_cast<std::size_t>(found - known.begin());
      columns_.push_back(number < possible.size() ? possible[number] : Column{"food"});
    }
    food_columns_ = food_columns_of(table_, state_.dimensions);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(state_.dimensions); ++axis) {
      if (!has(axis_names[axis])) return fail(axis_names[axis], "the column is missing");
    }
    return true;
  }

  bool has(std::string_view name) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& column) { return column.name == name; });
  }

  bool read_row(std::string_view line) {
    const auto cells = split(line);
    if (cells.size() != columns_.size()) {
      return fail("", say("has ", cells.size(), " columns, but the header has ", columns_.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns_[i].name == "food" && !cells[i].empty()) return read_food(cells);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns_[i].name != "food" && !read_cell(columns_[i], cells[i])) return false;
    }
    ++rows_;
    return true;
  }

  // A line whose column food has a number is a piece of that kind.
  bool read_food(const std::vector<std::string_view>& cells) {
    if (!has("id")) return fail("food", "pieces of food need the column id");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Column* column = column_named(food_columns_, columns_[i].name);
      if (column == nullptr && !cells[i].empty())
        return fail(columns_[i].name, say("must be empty for a piece of food, but found \"", cells[i], "\""));
      if (column != nullptr && !read_cell(*column, cells[i])) return false;
    }
    return true;
  }

  bool read_cell(const Column& column, std::string_view cell) {
    if (column.floats != nullptr) {
      float number = 0;
      if (cell.starts_with('+')) cell.remove_prefix(1);
      if (!read_number(cell, number))
        return fail(column.name, say("must be a number, but found \"", cell, "\""));
      if (!(std::abs(number) <= 1e15f))
        return fail(column.name, say("must be finite and at most 1e15, but found ", cell));
      column.floats->push_back(number);
      return true;
    }
    if (column.doubles != nullptr) return read_clock(column, cell);
    if (column.name == "focus" && cell.empty()) {
      column.ids->push_back(nobody);
      return true;
    }
    std::uint64_t number = 0;
    if (!read_number(cell, number)) {
      return fail(column.name, say("must be a whole number from 0 up, but found \"", cell, "\""));
    }
    if (column.ids != nullptr) {
      if (number >= std::uint64_t{1} << 48)
        return fail(column.name, say("must be below 2^48, but found ", number));
      column.ids->push_back(number);
      return true;
    }
    const std::uint64_t most = column.name == "flock" || column.name == "food" ? 63 : 1;
    if (number > most) return fail(column.name, say("must be at most ", most, ", but found ", number));
    column.small->push_back(static_cast<std::uint8_t>(number));
    return true;
  }

  bool read_clock(const Column& column, std::string_view cell) {
    double time = 0;
    if (!read_number(cell, time) || !(time >= 0 && time <= 1e15))
      return fail(column.name, say("must be a time from 0 to 1e15, but found \"", cell, "\""));
    column.doubles->push_back(time);
    return true;
  }

  // Fills in the columns that real data often lacks.
  void finish() {
    for (std::size_t i = 0; !has("id") && i < rows_; ++i) state_.id.push_back(i);
    state_.flock.resize(rows_);
    state_.quarantined.resize(rows_);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(state_.dimensions); ++axis)
      state_.velocity[axis].resize(rows_);
    for (const std::uint64_t id : state_.id) state_.next_id = std::max(state_.next_id, id + 1);
    for (const std::uint64_t id : state_.food.id) state_.next_id = std::max(state_.next_id, id + 1);
    fill_clocks(state_.life);
    for (const std::uint64_t next : table_.next_id) state_.next_id = std::max(state_.next_id, next);
  }

  // Clocks that belong together come together.
  void fill_clocks(Life& life) {
    if (life.full.size() != life.fasting.size()) {
      life.full.resize(rows_);
      life.fasting.resize(rows_);
    }
    if (life.jump.size() != life.rest.size()) {
      life.jump.resize(rows_);
      life.rest.resize(rows_);
    }
  }

  std::string_view rest_;
  std::string file_;
  int line_number_ = 0;
  std::size_t rows_ = 0;
  std::vector<Column> columns_, food_columns_;
  Table table_;
  State& state_ = table_.state;
  Problem problem_;
};

// The first line in which an id comes a second time; 0 when none does.
Problem repeated_id(const State& state, const std::string& file) {
  std::vector<std::uint64_t> sorted = state.id;
  sorted.insert(sorted.end(), state.food.id.begin(), state.food.id.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return {};
  return {file, 0, "id", say("two boids have the id ", *twice), false};
}

}  // namespace

std::string state_csv(const State& state) {
  Table table{state, {}};  // columns_of hands out places to write to
  const State& copy = table.state;
  const std::size_t lines = copy.size() + copy.food.size();
  std::uint64_t after_newest = 0;
  for (const auto* ids : {&copy.id, &copy.food.id}) {
    for (const std::uint64_t id : *ids) after_newest = std::max(after_newest, id + 1);
  }
  if (lines > 0 && after_newest != copy.next_id) table.next_id.assign(lines, copy.next_id);
  std::vector<Column> columns;
  for (const Column& column : columns_of(table, copy.dimensions)) {
    if (is_written(column, copy)) columns.push_back(column);
  }
  std::string out;
  if (copy.food.size() > 0) columns.push_back({"food"});
  for (const Column& column : columns) out += say(out.empty() ? "" : ",", column.name);
  out += "\n";
  for (std::size_t i = 0; i < copy.size(); ++i) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      if (column > 0) out += ",";
      append_cell(out, columns[column], i);
    }
    out += "\n";
  }
  const std::vector<Column> of_food = food_columns_of(table, copy.dimensions);
  for (std::size_t i = 0; i < copy.food.size(); ++i) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      if (column > 0) out += ",";
      if (const Column* own = column_named(of_food, columns[column].name)) append_cell(out, *own, i);
    }
    out += "\n";
  }
  return out;
}

Result<State> parse_state_csv(std::string_view text, const std::string& file) {
  auto state = CsvReader(text, file).run();
  if (!state) return state;
  Problem twice = repeated_id(*state, file);
  if (!twice.text.empty()) return twice;
  return state;
}

Result<State> read_state_csv(const std::string& path) {
  auto text = read_text(path);
  if (!text) return text.problems();
  return parse_state_csv(*text, path);
}

}  // namespace sturnus
