// Ticks at round numbers.
#include "draw/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sturnus {
namespace {

struct Prefix {
  double size;
  const char* name;
};

Prefix prefix_for(double largest) {
  if (largest >= 1e9) return {1e9, "G"};
  if (largest >= 1e6) return {1e6, "M"};
  if (largest >= 1e4) return {1e3, "k"};
  return {1, ""};
}

std::string formatted(const char* format, int decimals, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, decimals, value);
  return text;
}

double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (factor * power >= rough * 0.999) return factor * power;
  }
  return 10 * power;
}

// Digits after the point that tell neighbouring ticks apart.
int decimals_of(double step) {
  for (int decimals = 0; decimals < 9; ++decimals) {
    const double scaled = step * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return 9;
}

}  // namespace

std::vector<double> Axis::ticks() const {
  std::vector<double> found;
  const double slack = 1e-9 * (high - low);
  for (double index = std::ceil((low - slack) / step); index * step <= high + slack; ++index) {
    found.push_back(index * step);
    if (found.size() > 100) break;  // steps too fine for the size of the numbers
  }
  return found;
}

std::string Axis::text(double tick) const {
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest >= 1e13 || step < 1e-6) return formatted("%.*g", 4, tick);
  const Prefix prefix = prefix_for(largest);
  const double value = std::abs(tick) < 1e-9 * step ? 0 : tick / prefix.size;
  const std::string digits = formatted("%.*f", decimals_of(step / prefix.size), value);
  return value == 0 ? digits : digits + prefix.name;
}

Axis nice_axis(double low, double high, int wanted, bool widen) {
  if (!(high > low)) {
    const double room = low != 0 ? 0.5 * std::abs(low) : 1;
    // A constant zero or positive series keeps zero at the bottom, where one expects it.
    low = low == 0 ? 0 : low - room;
    high = high + room;
  }
  Axis axis{low, high, round_step((high - low) / std::max(1, wanted))};
  if (!widen) return axis;
  axis.low = axis.step * std::floor(low / axis.step + 1e-9);
  axis.high = axis.step * std::ceil(high / axis.step - 1e-9);
  return axis;
}

std::string short_number(double value) {
  if (!std::isfinite(value)) return "–";
  const double size = std::abs(value);
  if (size >= 1e13 || (size > 0 && size < 1e-4)) return formatted("%.*e", 2, value);
  const Prefix prefix = prefix_for(size);
  std::string text = formatted("%.*g", 4, value / prefix.size) + prefix.name;
  return text == "-0" ? "0" : text;
}

}  // namespace sturnus
