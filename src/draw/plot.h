// Line plots of time series: panels one below the other over a shared axis of steps.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/workers.h"
#include "draw/theme.h"
#include "sturnus/picture.h"

namespace sturnus {

/// One series. Values that are no finite number leave a gap; missing ones at the end count as such.
struct PlotLine {
  std::string name;            ///< shown when the panel has several lines
  std::vector<double> values;  ///< one for each of Plot::x, in the panel's unit
};

struct PlotPanel {
  std::string title;
  std::string unit;  ///< shown after the title; empty for plain numbers
  std::vector<PlotLine> lines;
  /// Ends of the axis, in the unit, where the range is known (0 and 1 for an order parameter); NaN: from the
  /// data.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

struct Plot {
  std::string title;             ///< above everything; empty for none
  std::string x_title = "step";  ///< what x counts
  std::vector<double> x;         ///< rising
  std::vector<PlotPanel> panels;
};

/// A size at which the panels of a plot are pleasant to read, for a width in pixels.
Size plot_size(const Plot& plot, int width);

/// The plot as a picture, the same for any number of workers.
Image draw_plot(const Plot& plot, const Theme& theme, Size size, const Workers& workers);

}  // namespace sturnus
