// What comes of a scenario when one parameter takes one value after the other.
#pragma once

#include <sturnus/result.h>
#include <sturnus/scenario.h>

#include <string>
#include <vector>

#include "course.h"

namespace program {

/// A parameter and what it is set to: "flock.fish.count=10,20,50".
struct Variation {
  std::string key;
  std::vector<std::string> values;
};
sturnus::Result<Variation> variation_of(const std::string& option, const std::string& text);

/// What a sweep can tell of the runs of a scenario: its measures, then `population.NAME` of each flock, then
/// what became of hunters and prey.
std::vector<std::string> result_names(const sturnus::ScenarioDef& scenario);

/// One such result of one run; NaN where it has no meaning. Measures are means over the second half of the
/// run, populations those at its end.
double result_of(const std::string& name, const sturnus::Simulation& flock, const Course& course);

/// Mean of several runs, and how they scatter; runs without a number do not count.
struct Spread {
  double mean = 0;       ///< NaN when no run has a number
  double deviation = 0;  ///< standard deviation of the runs; NaN for fewer than two
};
Spread spread_of(const std::vector<double>& runs);

}  // namespace program
