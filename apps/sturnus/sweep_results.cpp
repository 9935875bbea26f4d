// What a sweep tells of each run, and how it reads its values.
#include <algorithm>
#include <cmath>
#include <limits>

#include "command_line.h"
#include "sweep.h"

namespace program {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr const char* population = "population.";

bool hunts(const sturnus::FlockDef& flock) {
  return flock.hunt.has_value();
}

// Boids caught in the run for each hunter at its beginning and each unit of time.
double captures(const sturnus::Simulation& flock, const Course& course) {
  const sturnus::ScenarioDef& scenario = flock.scenario();
  double hunters = 0;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    if (hunts(scenario.flocks[i])) hunters += static_cast<double>(course.rows.front().populations[i]);
  }
  return static_cast<double>(flock.report().eaten) /
         (hunters * static_cast<double>(course.steps) * scenario.time.dt);
}

// Over the second half of the run, when the flock has found itself.
double settled(const sturnus::MeasureColumn& column, const Course& course) {
  const std::uint64_t first = course.rows.front().step, last = course.rows.back().step;
  double sum = 0, count = 0;
  for (const sturnus::Measures& row : course.rows) {
    const double value = column.value(row);
    if (2 * (row.step - first) < last - first || std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : not_known;
}

double population_of(const std::string& name, const sturnus::Simulation& flock, const Course& course) {
  const auto& flocks = flock.scenario().flocks;
  for (std::size_t i = 0; i < flocks.size(); ++i) {
    if (flocks[i].name == name) return static_cast<double>(course.rows.back().populations[i]);
  }
  return not_known;
}

}  // namespace

sturnus::Result<Variation> variation_of(const std::string& option, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return complaint(
        option, "write key=value,value,..., such as flock.NAME.count=10,20,50, but found \"" + text + "\"");
  Variation out{text.substr(0, equals), {}};
  std::size_t begin = equals + 1;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin) return complaint(option, "a value is missing in \"" + text + "\"");
    out.values.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (out.values.empty()) return complaint(option, "a value is missing in \"" + text + "\"");
  return out;
}

std::vector<std::string> result_names(const sturnus::ScenarioDef& scenario) {
  std::vector<std::string> names;
  for (const sturnus::MeasureColumn& column : sturnus::measure_columns()) names.push_back(column.name);
  for (const sturnus::FlockDef& flock : scenario.flocks) names.push_back(population + flock.name);
  if (std::any_of(scenario.flocks.begin(), scenario.flocks.end(), hunts))
    names.insert(names.end(), {"captures", "eaten", "starved"});
  names.push_back("born");
  return names;
}

double result_of(const std::string& name, const sturnus::Simulation& flock, const Course& course) {
  for (const sturnus::MeasureColumn& column : sturnus::measure_columns()) {
    if (column.name == name) return settled(column, course);
  }
  if (name.starts_with(population))
    return population_of(name.substr(std::string(population).size()), flock, course);
  const sturnus::StepReport report = flock.report();
  if (name == "captures") return captures(flock, course);
  if (name == "eaten") return static_cast<double>(report.eaten);
  if (name == "starved") return static_cast<double>(report.starved);
  if (name == "born") return static_cast<double>(report.born);
  return not_known;
}

Spread spread_of(const std::vector<double>& runs) {
  double count = 0, sum = 0, squares = 0;
  for (const double value : runs) {
    if (!std::isfinite(value)) continue;
    ++count;
    sum += value;
  }
  if (!(count > 0)) return {not_known, not_known};
  const double mean = sum / count;
  for (const double value : runs) {
    if (std::isfinite(value)) squares += (value - mean) * (value - mean);
  }
  return {mean, count > 1 ? std::sqrt(squares / (count - 1)) : not_known};
}

}  // namespace program
