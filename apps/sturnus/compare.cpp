// sturnus compare: two state CSVs, boid by boid, for exercises and other engines.
#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"

namespace program {
namespace {

using sturnus::State;

struct CompareOptions {
  std::string first, second;  ///< paths
  std::string tolerance = "0";
};

// One number that a boid has in both files.
struct Cell {
  std::string column;
  double first = 0, second = 0;
  bool is_same_bits = true;

  double error() const { return std::abs(first - second); }
  std::string text() const {
    return column + ": " + sturnus::number_text(first) + " and " + sturnus::number_text(second);
  }
};

// The largest error among some columns, and where it was.
struct Largest {
  double error = -1;
  std::uint64_t id = 0;
  Cell cell;

  void take(std::uint64_t boid, const Cell& found) {
    if (!(found.error() > error)) return;
    error = found.error();
    id = boid;
    cell = found;
  }
};

// What the comparison found, boids in order of their ids.
struct Findings {
  std::size_t common = 0;
  Largest position, velocity, rest;
  std::size_t different = 0;
  std::uint64_t first_different = 0;
  std::string first_cell;
  std::vector<std::uint64_t> only_first, only_second;

  bool differ() const { return different > 0 || !only_first.empty() || !only_second.empty(); }
};

std::map<std::uint64_t, std::size_t> slots_by_id(const State& state) {
  std::map<std::uint64_t, std::size_t> slots;
  for (std::size_t i = 0; i < state.size(); ++i) slots.emplace(state.id[i], i);
  return slots;
}

// The shortest number that means this float, so that errors come out as the files have them.
double as_written(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double number = 0;
  std::from_chars(text, end, number);
  return number;
}

Cell cell_of(std::string column, float first, float second) {
  return {std::move(column), as_written(first), as_written(second),
          std::memcmp(&first, &second, sizeof first) == 0};
}

// Compares states whose dimensions agree.
class Comparison {
 public:
  Comparison(const State& first, const State& second, double tolerance)
      : first_(first), second_(second), tolerance_(tolerance) {}

  Findings run() {
    const auto firsts = slots_by_id(first_), seconds = slots_by_id(second_);
    for (const auto& [id, i] : firsts) {
      const auto other = seconds.find(id);
      if (other == seconds.end()) {
        out_.only_first.push_back(id);
      } else {
        compare_boid(id, i, other->second);
      }
    }
    for (const auto& slot : seconds) {
      if (!firsts.contains(slot.first)) out_.only_second.push_back(slot.first);
    }
    return std::move(out_);
  }

 private:
  void compare_boid(std::uint64_t id, std::size_t i, std::size_t j) {
    ++out_.common;
    id_ = id;
    has_difference_ = false;
    columns(first_.position, second_.position, {"x", "y", "z"}, i, j, out_.position);
    columns(first_.velocity, second_.velocity, {"vx", "vy", "vz"}, i, j, out_.velocity);
    columns(first_.wander, second_.wander, {"wander_x", "wander_y", "wander_z"}, i, j, out_.rest);
    columns(first_.colour, second_.colour, {"red", "green", "blue"}, i, j, out_.rest);
    look_at(cell_of("flock", first_.flock[i], second_.flock[j]), 0, out_.rest);
    look_at(cell_of("quarantined", first_.quarantined[i], second_.quarantined[j]), 0, out_.rest);
    if (has_difference_) ++out_.different;
  }

  void columns(const sturnus::Columns& first, const sturnus::Columns& second,
               const std::array<const char*, 3>& names, std::size_t i, std::size_t j, Largest& largest) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (first[axis].empty() || second[axis].empty()) continue;
      look_at(cell_of(names[axis], first[axis][i], second[axis][j]), tolerance_, largest);
    }
  }

  void look_at(const Cell& cell, double tolerance, Largest& largest) {
    largest.take(id_, cell);
    const bool is_equal = tolerance > 0 ? cell.error() <= tolerance : cell.is_same_bits;
    if (is_equal) return;
    if (out_.different == 0 && !has_difference_) {
      out_.first_different = id_;
      out_.first_cell = cell.text();
    }
    has_difference_ = true;
  }

  const State& first_;
  const State& second_;
  double tolerance_;
  std::uint64_t id_ = 0;
  bool has_difference_ = false;
  Findings out_;
};

// Columns that a step may need and only one file has; they are told and not compared.
std::string lonely_columns(const State& one, const State& other) {
  std::string out;
  if (!one.wander[0].empty() && other.wander[0].empty()) out += "wander";
  if (!one.colour[0].empty() && other.colour[0].empty()) out += out.empty() ? "colours" : " and colours";
  return out;
}

std::string largest_line(const char* what, const Largest& largest) {
  if (largest.error < 0) return {};
  const std::string line = format("largest error in %s: ", what);
  if (largest.error == 0) return line + "0\n";
  // Nine digits are all that a float has.
  return line + format("%.9g (boid %llu, ", largest.error, static_cast<unsigned long long>(largest.id)) +
         largest.cell.text() + ")\n";
}

std::string only_line(const std::string& file, const std::vector<std::uint64_t>& ids) {
  if (ids.empty()) return {};
  constexpr std::size_t most = 10;
  std::string line = "only in " + file + ": " + counted(ids.size(), "boid");
  for (std::size_t i = 0; i < ids.size() && i < most; ++i)
    line += (i == 0 ? ", " : " ") + std::to_string(ids[i]);
  return line + (ids.size() > most ? " ...\n" : "\n");
}

std::string verdict(const Findings& found, double tolerance) {
  const std::string bound =
      tolerance > 0 ? "within " + sturnus::number_text(tolerance) : std::string("equal to the bit");
  if (!found.differ()) return "all " + bound + "\n";
  std::string line = "they differ: " + std::to_string(found.different) + " of " +
                     counted(found.common, "boid") + (found.different == 1 ? " is" : " are") + " not " +
                     bound;
  return line + "\n";
}

std::string report(const CompareOptions& options, const State& first, const State& second,
                   const Findings& found, double tolerance) {
  std::string out = counted(found.common, "boid") + " in both\n";
  out += only_line(options.first, found.only_first) + only_line(options.second, found.only_second);
  for (const auto& [file, lonely] : {std::pair(options.first, lonely_columns(first, second)),
                                     std::pair(options.second, lonely_columns(second, first))}) {
    if (!lonely.empty()) out += "only in " + file + ", not compared: " + lonely + "\n";
  }
  out += largest_line("position", found.position) + largest_line("velocity", found.velocity);
  if (found.rest.error > 0) out += largest_line("the other columns", found.rest);
  if (found.different > 0) {
    out += format("first boid that differs: %llu (", static_cast<unsigned long long>(found.first_different)) +
           found.first_cell + ")\n";
  }
  return out + verdict(found, tolerance);
}

sturnus::Result<double> read_tolerance(const std::string& text) {
  double tolerance = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, tolerance);
  if (error == std::errc() && rest == end && tolerance >= 0 && std::isfinite(tolerance)) return tolerance;
  return complaint("--tolerance", "must be a number from 0 up, but is \"" + text + "\"");
}

int compare(const CompareOptions& options) {
  const auto tolerance = read_tolerance(options.tolerance);
  if (!tolerance) return refuse(tolerance.problems());
  const auto first = sturnus::read_state_csv(options.first);
  if (!first) return refuse(first.problems());
  const auto second = sturnus::read_state_csv(options.second);
  if (!second) return refuse(second.problems());
  if (first->dimensions != second->dimensions) {
    return refuse(options.first + format(" holds boids in %d dimensions, but ", first->dimensions) +
                  options.second + format(" in %d", second->dimensions));
  }
  const Findings found = Comparison(*first, *second, *tolerance).run();
  print(report(options, *first, *second, found, *tolerance));
  return found.differ() ? different : done;
}

}  // namespace

void add_compare(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "compare", "Compare two state CSVs boid by boid; ends with 0 where they agree and 3 where not",
      {"sturnus compare mine.csv reference.csv --tolerance 0.001", "sturnus compare a.csv b.csv"});
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("A.csv", options->first, "A state, as --final writes it")->required()->type_name("");
  command->add_option("B.csv", options->second, "The state to hold it to")->required()->type_name("");
  add_text(*command, "--tolerance", options->tolerance, "T",
           "Largest error that still counts as agreement (default 0: equal bits)");
  command->callback([&request, options] { request.work = [options] { return compare(*options); }; });
}

}  // namespace program
