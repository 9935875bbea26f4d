// What `sturnus bench` is asked for, and the cases that this makes.
#pragma once

#include <sturnus/scenario.h>

#include <optional>
#include <string>
#include <vector>

#include "bench_timing.h"

namespace program {

struct BenchOptions {
  std::vector<std::string> scenarios;        ///< shipped names or paths; none: bench-2d and bench-3d
  std::vector<std::int64_t> boids;           ///< none: what suits the scenario
  std::vector<std::int64_t> threads;         ///< 0: all cores; none: 1 and all cores
  std::vector<std::string> isas = {"best"};  ///< names that --isa takes
  std::string path, index;                   ///< empty: the scenario's
  std::optional<std::int64_t> steps, repeats;
  std::string json;  ///< a file, or empty
  bool quick = false;
  std::vector<std::string> words;  ///< the command line

  BenchLength length() const;
};

/// The scenarios with their boids, checked, the smallest first. Warnings go to standard error.
sturnus::Result<std::vector<sturnus::ScenarioDef>> bench_scenarios(const BenchOptions& options);

/// Numbers of threads, each once.
std::vector<int> bench_threads(const BenchOptions& options);

/// An instruction set: the name that chooses it, such as "best", and its own.
struct BenchIsa {
  std::string wanted, name;
};
/// The instruction sets that were asked for, each once, and the names of those that the machine lacks.
struct BenchIsas {
  std::vector<BenchIsa> here;
  std::vector<std::string> lacking;
};
BenchIsas bench_isas(const BenchOptions& options);

}  // namespace program
