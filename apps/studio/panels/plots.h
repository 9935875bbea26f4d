// Measures over time.
#pragma once

#include "desk.h"

namespace studio {

/// Takes the session's new lines, and drops those of a future that is gone.
void gather_samples(Desk& desk);
/// Which plots are shown, and files of them: in its menu where the bar is short.
void show_plot_chips(Desk& desk, bool is_short);
void show_plot_files(Desk& desk);
void show_plots(Desk& desk);
/// The slider over the steps, with undo and redo.
void show_timeline(Desk& desk, bool is_short);

/// The lines as CSV: step, measures, population by flock, food, and the seconds of steps and frames.
std::string plots_csv(const PlotsState& plots, const sturnus::ScenarioDef& scenario);

}  // namespace studio
