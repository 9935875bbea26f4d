// The lines behind the plots: gathered, cut and saved.
#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include <algorithm>

#include "panels/plots.h"

namespace studio {
namespace {

constexpr std::size_t most_lines = std::size_t{1} << 16;

std::uint64_t step_of(const PlotLine& line) {
  return line.sample.measures.step;
}

bool is_before(const PlotLine& line, std::uint64_t step) {
  return step_of(line) < step;
}

void cut_after(PlotsState& plots, std::uint64_t step) {
  plots.lines.erase(std::lower_bound(plots.lines.begin(), plots.lines.end(), step + 1, is_before),
                    plots.lines.end());
}

void put(PlotsState& plots, PlotLine line) {
  const auto at = std::lower_bound(plots.lines.begin(), plots.lines.end(), step_of(line), is_before);
  if (at != plots.lines.end() && step_of(*at) == step_of(line)) {
    *at = std::move(line);
  } else {
    plots.lines.insert(at, std::move(line));
  }
}

// Every second line stays when there are too many.
void thin(PlotsState& plots) {
  if (plots.lines.size() < most_lines) return;
  for (std::size_t i = 0; 2 * i < plots.lines.size(); ++i) plots.lines[i] = std::move(plots.lines[2 * i]);
  plots.lines.resize((plots.lines.size() + 1) / 2);
}

}  // namespace

void gather_samples(Desk& desk) {
  PlotsState& plots = desk.plots;
  const Frame& frame = *desk.frame;
  if (plots.opened != frame.opened) plots.lines.clear();
  plots.opened = frame.opened;
  for (Sample& sample : desk.session.take_samples()) {
    const bool is_old = sample.generation < frame.generation && sample.measures.step > frame.reach.last;
    if (!is_old && sample.population.size() == frame.scenario->flocks.size())
      put(plots, {std::move(sample), desk.frame_seconds});
  }
  if (plots.generation != frame.generation || frame.reach.last < plots.last)
    cut_after(plots, frame.reach.last);
  plots.generation = frame.generation;
  plots.last = frame.reach.last;
  thin(plots);
}

std::string plots_csv(const PlotsState& plots, const sturnus::ScenarioDef& scenario) {
  std::string text = sturnus::measures_header(scenario);
  text += ",food,step_seconds,frame_seconds\n";
  for (const PlotLine& line : plots.lines) {
    text += sturnus::measures_line(line.sample.measures);
    text += "," + std::to_string(line.sample.food) + "," + sturnus::number_text(line.sample.step_seconds) +
            "," + sturnus::number_text(line.frame_seconds) + "\n";
  }
  return text;
}

}  // namespace studio
