// Round numbers for the axis of a plot, and how numbers are written there.
#pragma once

#include <string>
#include <vector>

namespace sturnus {

/// A range with ticks at round numbers. `low` and `high` are finite and low < high.
struct Axis {
  double low = 0;
  double high = 1;
  double step = 1;  ///< between ticks: 1, 2, 2.5 or 5 times a power of ten

  /// The ticks inside the range, in rising order.
  std::vector<double> ticks() const;

  /// A tick as it is written beside the axis: all ticks of an axis with the same decimals and the same k, M
  /// or G.
  std::string text(double tick) const;
};

/// Covers low to high with about `wanted` ticks, at least one. With `widen`, the ends move out to ticks.
/// An empty range (a constant series) gets room on both sides.
Axis nice_axis(double low, double high, int wanted, bool widen);

/// A single value, written in about four digits.
std::string short_number(double value);

}  // namespace sturnus
