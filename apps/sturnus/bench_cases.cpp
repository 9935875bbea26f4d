// From options to scenarios of the wanted size, numbers of threads and instruction sets.
#include "bench_cases.h"

#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <cmath>

#include "command_line.h"
#include "isa_option.h"
#include "machine.h"
#include "output.h"

namespace program {
namespace {

using sturnus::FlockDef;
using sturnus::ScenarioDef;
using sturnus::Status;

const std::vector<std::int64_t> usual_sizes = {10000, 100000, 1000000};
constexpr std::int64_t quick_size = 2000;

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

bool takes_boids_from_files(const ScenarioDef& scenario) {
  return !scenario.run.initial.empty() ||
         std::any_of(scenario.flocks.begin(), scenario.flocks.end(),
                     [](const FlockDef& flock) { return !flock.start.file.empty(); });
}

bool grows_with_its_boids(const ScenarioDef& scenario) {
  return scenario.space.min.empty() && scenario.space.max.empty();
}

// Where nobody says: a space of fixed size would be crammed by a million, so such a scenario keeps its count.
std::vector<std::int64_t> sizes_for(const BenchOptions& options, const ScenarioDef& scenario) {
  if (!options.boids.empty()) return options.boids;
  if (takes_boids_from_files(scenario)) return {scenario.boid_count()};
  if (options.quick) return {quick_size};
  return grows_with_its_boids(scenario) ? usual_sizes : std::vector{scenario.boid_count()};
}

// Shares `count` boids among the flocks as they were shared before.
Status scale(ScenarioDef& scenario, std::int64_t count) {
  const std::int64_t before = scenario.boid_count();
  if (count == before) return {};
  if (takes_boids_from_files(scenario)) {
    return complaint("--boids",
                     scenario.name + " takes its boids from a file, which says how many there are");
  }
  if (before == 0) return complaint("--boids", scenario.name + " has no boids that could become more");
  std::int64_t counted_before = 0, given = 0;
  for (FlockDef& flock : scenario.flocks) {
    counted_before += flock.count;
    const double share = static_cast<double>(counted_before) / static_cast<double>(before);
    flock.count = std::llround(static_cast<double>(count) * share) - given;
    given += flock.count;
  }
  return {};
}

Status set_word(ScenarioDef& scenario, const char* key, const std::string& word) {
  return word.empty() ? Status() : set_parameter(scenario, key, {word});
}

sturnus::Result<ScenarioDef> load(const BenchOptions& options, const std::string& name) {
  sturnus::Problems warnings;
  auto scenario = sturnus::load_scenario(name, &warnings);
  if (!scenario) return scenario;
  tell(warnings);
  if (const Status status = set_word(*scenario, "index.kind", options.index); !status)
    return status.problems();
  if (const Status status = set_word(*scenario, "index.path", options.path); !status)
    return status.problems();
  return scenario;
}

Status add_sizes(const BenchOptions& options, const ScenarioDef& scenario, std::vector<ScenarioDef>& all) {
  for (const std::int64_t size : sizes_for(options, scenario)) {
    ScenarioDef scaled = scenario;
    if (Status status = scale(scaled, size); !status) return status;
    if (const sturnus::Problems problems = check(scaled); has_errors(problems)) return problems;
    all.push_back(std::move(scaled));
  }
  return {};
}

}  // namespace

BenchLength BenchOptions::length() const {
  BenchLength length;
  if (quick) length = {2, 3, 2};
  if (steps) length.steps = static_cast<std::uint64_t>(*steps);
  if (repeats) length.repeats = static_cast<std::uint64_t>(*repeats);
  return length;
}

sturnus::Result<std::vector<ScenarioDef>> bench_scenarios(const BenchOptions& options) {
  std::vector<std::string> names = options.scenarios;
  if (names.empty()) names = {"bench-2d", "bench-3d"};
  std::vector<ScenarioDef> all;
  for (const std::string& name : names) {
    const auto scenario = load(options, name);
    if (!scenario) return scenario.problems();
    if (const Status status = add_sizes(options, *scenario, all); !status) return status.problems();
  }
  std::stable_sort(all.begin(), all.end(), [](const ScenarioDef& a, const ScenarioDef& b) {
    return a.boid_count() < b.boid_count();
  });
  return all;
}

std::vector<int> bench_threads(const BenchOptions& options) {
  std::vector<std::int64_t> wanted = options.threads;
  if (wanted.empty()) wanted = {1, 0};
  std::vector<int> threads;
  for (const std::int64_t count : wanted)
    add_once(threads, count == 0 ? processor_cores() : static_cast<int>(count));
  return threads;
}

BenchIsas bench_isas(const BenchOptions& options) {
  BenchIsas isas;
  for (const std::string& wanted : options.isas) {
    if (!use_isa_named(wanted)) {
      add_once(isas.lacking, wanted);
      continue;
    }
    const std::string name = isa_name_in_use();
    const auto same = [&](const BenchIsa& other) { return other.name == name; };
    if (std::none_of(isas.here.begin(), isas.here.end(), same)) isas.here.push_back({wanted, name});
  }
  return isas;
}

}  // namespace program
