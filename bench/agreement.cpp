// The comparison of two flocks.
#include "agreement.h"

#include <algorithm>
#include <cmath>

#include "flocks.h"

namespace bench {
namespace {

constexpr double tolerance = 1e-4;

double length_of(const std::array<std::vector<float>, 3>& columns, std::size_t i) {
  double squared = 0;
  for (const auto& column : columns) {
    if (!column.empty()) squared += double{column[i]} * double{column[i]};
  }
  return std::sqrt(squared);
}

double velocity_gap(const Flock& one, const Flock& other, std::size_t i) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3 && !one.velocity[axis].empty(); ++axis) {
    const double gap = double{one.velocity[axis][i]} - double{other.velocity[axis][i]};
    squared += gap * gap;
  }
  return std::sqrt(squared) / std::max(length_of(one.velocity, i), 1e-30);
}

double place_gap(const Numbers& numbers, const Flock& one, const Flock& other, std::size_t i) {
  double squared = 0;
  double widest = 0;
  for (std::size_t axis = 0; axis < 3 && !one.position[axis].empty(); ++axis) {
    double gap = std::fabs(double{one.position[axis][i]} - double{other.position[axis][i]});
    if (numbers.course == Course::wrapped) gap = std::min(gap, double{numbers.size[axis]} - gap);
    squared += gap * gap;
    widest = std::max(widest, double{numbers.size[axis]});
  }
  const double rounding = widest * 0x1p-22;
  return std::max(0.0, std::sqrt(squared) - rounding) / (double{numbers.max_speed} * double{numbers.dt});
}

}  // namespace

Agreement compare(const Numbers& numbers, const Flock& one, const Flock& other) {
  Agreement out{one.size(), 0, 0};
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double gap = std::max(velocity_gap(one, other, i), place_gap(numbers, one, other, i));
    if (gap <= tolerance) {
      out.largest = std::max(out.largest, gap);
    } else {
      ++out.off;
    }
  }
  return out;
}

Json agreed(const Numbers& numbers, const std::string& who, const Flock& start, const Flock& ours,
            const Flock& theirs) {
  if (ours.size() != theirs.size()) throw Failure{who + " has another number of boids than our engine"};
  const Agreement blind = compare(numbers, ours, start);
  if (2 * blind.off < blind.boids)
    throw Failure{"the comparison can't tell a step from no step, so it proves nothing"};
  const Agreement found = compare(numbers, ours, theirs);
  if (1000 * found.off > found.boids) {
    throw Failure{who + " does not compute the same step: " + std::to_string(found.off) + " of " +
                  std::to_string(found.boids) + " boids differ by more than a ten-thousandth"};
  }
  return {{"boids", found.boids}, {"off", found.off}, {"largest_of_the_others", found.largest}};
}

}  // namespace bench
