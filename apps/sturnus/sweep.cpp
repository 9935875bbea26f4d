// sturnus sweep: runs a scenario for each value of a parameter, and tells what comes of it.
#include "sweep.h"

#include <sturnus/files.h>
#include <sturnus/render.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "inputs.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

using sturnus::ScenarioDef;
using sturnus::Status;

struct SweepOptions {
  ScenarioOptions scenario;
  WorkOptions work;
  std::string over, by;
  std::vector<std::string> results;
  std::optional<std::int64_t> repeats;
  std::string csv, plot;
};

// What is to be done: for each value of `by` a curve, for each value of `over` a point.
struct Plan {
  Variation over;
  Variation by{"", {""}};
  std::vector<std::string> results;
  std::int64_t repeats = 1;
};

// One point of one curve: for each result, its mean and scatter over the repeats.
struct Point {
  std::string by, over;
  std::vector<Spread> results;
};

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

// A plot has numbers from left to right.
Status check_plot(const SweepOptions& options, const Plan& plan) {
  if (options.plot.empty()) return {};
  if (!is_picture_name(options.plot))
    return complaint("--plot", "\"" + options.plot + "\" must end in .png or .ppm");
  double last = -std::numeric_limits<double>::infinity();
  for (const std::string& text : plan.over.values) {
    const auto value = number_of(text);
    if (!value || !(*value > last))
      return complaint("--plot",
                       "the values of --over must be finite numbers that rise, but \"" + text + "\" is not");
    last = *value;
  }
  return {};
}

Status check_results(const std::vector<std::string>& results, const ScenarioDef& scenario) {
  const std::vector<std::string> known = result_names(scenario);
  for (const std::string& name : results) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all;
    for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
    return complaint("--measure",
                     "there is no " + quoted_with_guess(name, known) + "; this scenario has " + all);
  }
  return {};
}

sturnus::Result<Plan> plan_of(const SweepOptions& options) {
  Plan plan;
  const auto over = variation_of("--over", options.over);
  if (!over) return over.problems();
  plan.over = *over;
  if (!options.by.empty()) {
    const auto by = variation_of("--by", options.by);
    if (!by) return by.problems();
    plan.by = *by;
  }
  plan.results = options.results;
  plan.repeats = options.repeats.value_or(1);
  if (const Status status = check_plot(options, plan); !status) return status.problems();
  return plan;
}

sturnus::Result<ScenarioDef> varied(const SweepOptions& options, const Plan& plan, const std::string& by,
                                    const std::string& over) {
  ScenarioOptions changed = options.scenario;
  if (!plan.by.key.empty()) changed.set.push_back(plan.by.key + "=" + by);
  changed.set.push_back(plan.over.key + "=" + over);
  return effective_scenario(changed);
}

// Every scenario of the plan is right before the first one runs.
Status check_all(const SweepOptions& options, const Plan& plan) {
  for (const std::string& by : plan.by.values) {
    for (const std::string& over : plan.over.values) {
      const auto scenario = varied(options, plan, by, over);
      if (!scenario) return scenario.problems();
      if (const Status status = check_results(plan.results, *scenario); !status) return status;
    }
  }
  return {};
}

// The repeats of one point, each with the next seed; empty when interrupted.
sturnus::Result<std::optional<Point>> run_point(const SweepOptions& options, const Plan& plan,
                                                const std::string& by, const std::string& over) {
  auto scenario = varied(options, plan, by, over);
  if (!scenario) return scenario.problems();
  const auto inputs = read_inputs(*scenario);
  if (!inputs) return inputs.problems();
  std::vector<std::vector<double>> runs(plan.results.size());
  for (std::int64_t repeat = 0; repeat < plan.repeats; ++repeat, ++scenario->seed) {
    auto flock = open_simulation(*scenario, *inputs, options.work.thread_count());
    if (!flock) return flock.problems();
    const Course course = follow(*flock, static_cast<std::uint64_t>(scenario->run.steps), true, false);
    if (course.interrupted) return std::optional<Point>{};
    for (std::size_t i = 0; i < runs.size(); ++i)
      runs[i].push_back(result_of(plan.results[i], *flock, course));
  }
  Point point{by, over, {}};
  for (const std::vector<double>& values : runs) point.results.push_back(spread_of(values));
  return std::optional<Point>{point};
}

std::string csv_number(double value) {
  return std::isnan(value) ? std::string() : format("%.9g", value);
}

std::string csv_of(const Plan& plan, const std::vector<Point>& points) {
  std::string text = plan.by.key.empty() ? "" : plan.by.key + ",";
  text += plan.over.key;
  for (const std::string& name : plan.results)
    text += "," + name + (plan.repeats > 1 ? "," + name + "_sd" : "");
  text += "\n";
  for (const Point& point : points) {
    text += (plan.by.key.empty() ? "" : point.by + ",") + point.over;
    for (const Spread& result : point.results)
      text += "," + csv_number(result.mean) + (plan.repeats > 1 ? "," + csv_number(result.deviation) : "");
    text += "\n";
  }
  return text;
}

std::string last_word(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

sturnus::Image plot_of(const Plan& plan, const std::vector<Point>& points, const std::string& title) {
  sturnus::SweepPlot plot;
  plot.title = title;
  plot.parameter = plan.over.key;
  for (const std::string& value : plan.over.values) plot.values.push_back(*number_of(value));
  for (std::size_t result = 0; result < plan.results.size(); ++result) {
    sturnus::SweepPlot::Panel panel{plan.results[result], {}};
    for (const std::string& by : plan.by.values) {
      panel.curves.push_back({last_word(plan.by.key) + " " + by, {}});
      for (const Point& point : points) {
        if (point.by == by) panel.curves.back().results.push_back(point.results[result].mean);
      }
    }
    plot.panels.push_back(std::move(panel));
  }
  return plot_sweep(plot, sturnus::ThemeName::dark);
}

int write_results(const SweepOptions& options, const Plan& plan, const std::vector<Point>& points) {
  const std::string csv = csv_of(plan, points);
  if (options.csv.empty()) print(csv);
  bool failed_once = false;
  const auto keep = [&](const Status& status) {
    if (!status) tell(status.problems());
    failed_once = failed_once || !status;
  };
  if (!options.csv.empty()) keep(sturnus::write_text(options.csv, csv));
  if (!options.plot.empty() && !points.empty()) {
    const auto scenario = varied(options, plan, plan.by.values.front(), plan.over.values.front());
    const std::string title = scenario->title.empty() ? scenario->name : scenario->title;
    keep(sturnus::save_picture(options.plot, plot_of(plan, points, title)));
  }
  return failed_once ? failed : done;
}

int sweep(const SweepOptions& options) {
  const auto plan = plan_of(options);
  if (!plan) return refuse(plan.problems());
  if (const Status status = check_all(options, *plan); !status) return refuse(status.problems());
  for (const std::string& path : {options.csv, options.plot}) {
    if (path.empty()) continue;
    if (const Status status = sturnus::check_output(path); !status) return fail(status.problems());
  }
  std::vector<Point> points;
  for (const std::string& by : plan->by.values) {
    for (const std::string& over : plan->over.values) {
      const auto point = run_point(options, *plan, by, over);
      if (!point) return refuse(point.problems());
      if (!*point) {
        const int code = write_results(options, *plan, points);
        return code == done ? interrupted : code;
      }
      points.push_back(**point);
      if (options.work.quiet) continue;
      tell((by.empty() ? "" : plan->by.key + " = " + by + ", ") + plan->over.key + " = " + over + ": done");
    }
  }
  return write_results(options, *plan, points);
}

}  // namespace

void add_sweep(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "sweep", "Run a scenario for each value of a parameter, and tell what comes of it",
      {"sturnus sweep ucsd --over flock.birds.max_acceleration=0.1,0.2,0.4 --measure polarisation,turning",
       "sturnus sweep confusion --over flock.prey.count=10,40,160 --by flock.hunter.hunt.confusion=0,0.01 "
       "--measure captures --repeats 4 --plot captures.png",
       "sturnus sweep bench-2d --over flock.boids.noise.turn=0,60,120,240 --measure polarisation --csv "
       "order.csv"});
  const auto options = std::make_shared<SweepOptions>();
  add_scenario_options(*command, options->scenario);
  add_text(*command, "--over", options->over, "key=v,v,...", "The parameter, and the values that it takes")
      ->required();
  add_text(*command, "--by", options->by, "key=v,v,...",
           "A second parameter: a curve for each of its values");
  command
      ->add_option("--measure", options->results,
                   "What to tell of each run: measures, population.FLOCK, captures, "
                   "eaten, starved, born")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->default_val(std::vector<std::string>{"polarisation", "turning"})
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_whole(*command, "--repeats", options->repeats, 1, 10000,
            "Runs for each value, each with the next seed; their mean is told, and their standard deviation");
  add_text(*command, "--csv", options->csv, "FILE.csv", "Write the table there instead of printing it");
  add_text(*command, "--plot", options->plot, "FILE.png", "Draw the curves");
  add_work_options(*command, options->work);
  command->callback([&request, options] { request.work = [options] { return sweep(*options); }; });
}

}  // namespace program
