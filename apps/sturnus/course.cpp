// The loop of a run, with a clock around the steps.
#include "course.h"

#include <chrono>
#include <limits>

#include "interrupts.h"
#include "output.h"
#include "progress.h"

namespace program {
namespace {

void timed_step(sturnus::Simulation& flock, Course& course) {
  using Clock = std::chrono::steady_clock;
  course.boid_steps += static_cast<double>(flock.view().size());
  const auto start = Clock::now();
  flock.step();
  course.seconds += std::chrono::duration<double>(Clock::now() - start).count();
  ++course.steps;
}

bool is_due(const sturnus::Simulation& flock) {
  return flock.step_number() % static_cast<std::uint64_t>(flock.scenario().run.measure_every) == 0;
}

}  // namespace

double Course::nanoseconds() const {
  return boid_steps > 0 ? 1e9 * seconds / boid_steps : std::numeric_limits<double>::quiet_NaN();
}

Course follow(sturnus::Simulation& flock, std::uint64_t steps, bool measured, bool with_progress) {
  Course course;
  const Interrupts interrupts;
  Progress progress(steps, with_progress);
  if (measured) course.rows.push_back(measure(flock.view()));
  while (course.steps < steps && !interrupts.asked()) {
    timed_step(flock, course);
    if (measured && is_due(flock)) course.rows.push_back(measure(flock.view()));
    progress.show(course.steps);
  }
  course.interrupted = course.steps < steps;
  if (measured && course.rows.back().step != flock.step_number())
    course.rows.push_back(measure(flock.view()));
  return course;
}

void tell_report(const sturnus::Simulation& flock) {
  const sturnus::StepReport report = flock.report();
  if (report.quarantined > 0) {
    tell("warning: " + counted(report.quarantined, "boid") + " met a bad number and went out of play");
  }
  if (report.births_refused > 0) {
    tell("note: " + counted(report.births_refused, "boid") +
         " could not be born because the flock was at its population_cap");
  }
  if (report.commands_in_vain > 0) {
    tell("warning: " + counted(report.commands_in_vain, "event") +
         " named a boid that was not there, or found no free place for one");
  }
}

std::string measures_csv(const sturnus::ScenarioDef& scenario, const std::vector<sturnus::Measures>& rows) {
  std::string text = sturnus::measures_header(scenario) + "\n";
  for (const sturnus::Measures& row : rows) text += measures_line(row) + "\n";
  return text;
}

}  // namespace program
