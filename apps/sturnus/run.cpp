// sturnus run: steps a flock, measures it, and writes what it became.
#include <sturnus/files.h>
#include <sturnus/render.h>
#include <sturnus/version.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench_row.h"
#include "command_line.h"
#include "commands.h"
#include "course.h"
#include "inputs.h"
#include "isa_option.h"
#include "json_text.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

using sturnus::ScenarioDef;
using sturnus::Simulation;
using sturnus::Status;

struct RunOptions {
  ScenarioOptions scenario;
  WorkOptions work;
  std::string final_state;
  std::string measures;
  std::string plot;
  std::string folder;
  std::string isa = "best";
  bool json = false;
  std::vector<std::string> words;  ///< the command line

  bool wants_measures() const { return !measures.empty() || !plot.empty() || !folder.empty(); }
};

std::string in_folder(const RunOptions& options, const std::string& name) {
  return options.folder.back() == '/' ? options.folder + name : options.folder + "/" + name;
}

// The outputs that were asked for by name.
std::vector<std::string> named_outputs(const RunOptions& options) {
  std::vector<std::string> paths = {options.final_state, options.measures, options.plot};
  std::erase(paths, "");
  return paths;
}

// What can be said against the names alone; empty when nothing can.
std::string complaint_about(const RunOptions& options) {
  if (!options.plot.empty() && !is_picture_name(options.plot)) {
    return "--plot: \"" + options.plot + "\" must end in .png or .ppm";
  }
  const std::vector<std::string> paths = named_outputs(options);
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    if (!path->starts_with("/dev/") && std::find(paths.begin(), path, *path) != path) {
      return *path + ": two outputs have this name";
    }
  }
  return {};
}

Status check_outputs(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (Status status = sturnus::check_output(path); !status) return status;
  }
  return {};
}

Status prepare_folder(const RunOptions& options, const Inputs& copies) {
  if (options.folder.empty()) return {};
  if (Status status = sturnus::make_folder(options.folder); !status) return status;
  std::vector<std::string> paths;
  for (const char* name : {"scenario.toml", "measures.csv", "final.csv", "plot.png", "run.json"}) {
    paths.push_back(in_folder(options, name));
  }
  for (const auto& copy : copies) paths.push_back(in_folder(options, copy.first));
  return check_outputs(paths);
}

std::string hash_text(const Simulation& flock) {
  return hash_digits(flock.hash());
}

std::string closing_line(const Simulation& flock, const Course& course) {
  const std::string speed = std::isnan(course.nanoseconds()) ? "-" : format("%.1f", course.nanoseconds());
  return counted(course.steps, "step") + ", " + counted(flock.view().size(), "boid") +
         format(", %.3f s, %s ns per boid and step, hash %s\n", course.seconds, speed.c_str(),
                hash_text(flock).c_str());
}

nlohmann::ordered_json last_measures(const Course& course) {
  nlohmann::ordered_json out;
  for (const sturnus::MeasureColumn& column : sturnus::measure_columns()) {
    out[column.name] = number_or_null(column.value(course.rows.back()));
  }
  return out;
}

std::string summary_json(const RunOptions& options, const Simulation& flock, const Course& course) {
  nlohmann::ordered_json out;
  out["version"] = sturnus::version;
  out["command"] = options.words;
  out["scenario"] = options.scenario.scenario;
  out["seed"] = flock.scenario().seed;
  out["threads"] = flock.threads();
  out["steps"] = course.steps;
  out["last_step"] = flock.step_number();
  out["boids"] = flock.view().size();
  out["quarantined"] = flock.report().quarantined;
  out["seconds"] = course.seconds;
  out["ns_per_boid_and_step"] = number_or_null(course.nanoseconds());
  out["hash"] = hash_text(flock);
  out["interrupted"] = course.interrupted;
  if (!course.rows.empty()) out["last_measures"] = last_measures(course);
  return json_text(out);
}

// Writes results one after the other; what fails is told and the rest still written.
class Writer {
 public:
  void text(const std::string& path, const std::string& content) {
    if (!path.empty()) keep(sturnus::write_text(path, content));
  }
  void picture(const std::string& path, const sturnus::Image& image) {
    if (!path.empty()) keep(sturnus::save_picture(path, image));
  }
  bool has_failed() const { return failed_; }

 private:
  void keep(const Status& status) {
    if (!status) tell(status.problems());
    failed_ = failed_ || !status;
  }
  bool failed_ = false;
};

sturnus::Image plot_of(const Simulation& flock, const Course& course) {
  return plot_measures(course.rows, flock.scenario(), sturnus::ThemeName::dark);
}

// The scenario as it began, with its events and exactly the steps that were done.
std::string recorded_scenario(const Simulation& flock, const Course& course, const Inputs& inputs,
                              Inputs& copies) {
  ScenarioDef recorded = with_inputs_beside(flock.recording(), inputs, copies);
  recorded.run.steps = static_cast<std::int64_t>(course.steps);
  return "# " + recorded.name + ", as `sturnus run` recorded it; running it again ends in the hash " +
         hash_text(flock) + ".\n" + to_toml(recorded);
}

// run.json comes last: where it is, the folder is whole.
void write_folder(const RunOptions& options, const Simulation& flock, const Course& course,
                  const Inputs& inputs, Writer& writer) {
  if (options.folder.empty()) return;
  Inputs copies;
  const std::string scenario = recorded_scenario(flock, course, inputs, copies);
  for (const auto& [name, text] : copies) writer.text(in_folder(options, name), text);
  writer.text(in_folder(options, "scenario.toml"), scenario);
  writer.text(in_folder(options, "measures.csv"), measures_csv(flock.scenario(), course.rows));
  writer.text(in_folder(options, "final.csv"), state_csv(flock.view().state()));
  writer.picture(in_folder(options, "plot.png"), plot_of(flock, course));
  if (!writer.has_failed()) writer.text(in_folder(options, "run.json"), summary_json(options, flock, course));
}

bool write_results(const RunOptions& options, const Simulation& flock, const Course& course,
                   const Inputs& inputs) {
  Writer writer;
  if (!options.final_state.empty()) writer.text(options.final_state, state_csv(flock.view().state()));
  if (!options.measures.empty()) writer.text(options.measures, measures_csv(flock.scenario(), course.rows));
  if (!options.plot.empty()) writer.picture(options.plot, plot_of(flock, course));
  write_folder(options, flock, course, inputs, writer);
  return !writer.has_failed();
}

void tell_how_to_go_on(const RunOptions& options, const Simulation& flock) {
  if (options.work.quiet) return;
  const std::string& path = options.final_state;
  if (!path.empty() && !path.starts_with("/dev/")) {
    const std::string step = std::to_string(flock.step_number());
    tell("wrote " + path + " (step " + step + "); continue with --initial " + path + " --first-step " + step);
  }
  if (!options.folder.empty()) {
    tell("wrote " + options.folder + "; again with: sturnus run " + in_folder(options, "scenario.toml"));
  }
}

void print_summary(const RunOptions& options, const Simulation& flock, const Course& course) {
  if (options.json) {
    print(summary_json(options, flock, course));
  } else if (!options.work.quiet) {
    print(closing_line(flock, course));
  }
}

int run_and_write(const RunOptions& options, Simulation& flock, std::uint64_t steps, const Inputs& inputs) {
  const Course course = follow(flock, steps, options.wants_measures(), !options.work.quiet);
  tell_report(flock);
  const bool written = write_results(options, flock, course, inputs);
  if (written) tell_how_to_go_on(options, flock);
  print_summary(options, flock, course);
  if (!written) return failed;
  return course.interrupted ? interrupted : done;
}

int run(const RunOptions& options) {
  if (const std::string complaint = complaint_about(options); !complaint.empty()) return refuse(complaint);
  if (!use_isa_named(options.isa)) {
    return refuse("--isa: this machine lacks " + options.isa + "; it has " + isas_here());
  }
  const auto scenario = effective_scenario(options.scenario);
  if (!scenario) return refuse(scenario.problems());
  const auto inputs = read_inputs(*scenario);
  if (!inputs) return refuse(inputs.problems());
  if (const Status status = check_outputs(named_outputs(options)); !status) return fail(status.problems());
  auto flock = open_simulation(*scenario, *inputs, options.work.thread_count());
  if (!flock) return refuse(flock.problems());
  Inputs copies;
  with_inputs_beside(*scenario, *inputs, copies);
  if (const Status status = prepare_folder(options, copies); !status) return fail(status.problems());
  return run_and_write(options, *flock, static_cast<std::uint64_t>(scenario->run.steps), *inputs);
}

}  // namespace

void add_run(CLI::App& app, Request& request) {
  CLI::App* command =
      add_command(app, "run", "Run a scenario, measure it, write what it became",
                  {"sturnus run ucsd", "sturnus run bench-2d --count 100000 --steps 20 --threads 2",
                   "sturnus run ucsd --set flock.birds.max_speed=12 --measures m.csv --plot m.png",
                   "sturnus run ucsd --steps 50 --final s.csv",
                   "sturnus run ucsd --steps 50 --initial s.csv --first-step 50   # goes on",
                   "sturnus run murmuration -o experiment"});
  const auto options = std::make_shared<RunOptions>();
  add_scenario_options(*command, options->scenario);
  add_text(*command, "--final", options->final_state, "STATE.csv",
           "Write the last state, to go on from with --initial");
  add_text(*command, "--measures", options->measures, "FILE.csv", "Write the measures");
  add_text(*command, "--plot", options->plot, "FILE.png", "Draw the course of the measures");
  add_text(*command, "-o,--output", options->folder, "DIR",
           "Write all of it into one folder, with what is needed to repeat it");
  command->add_flag("--json", options->json, "Print the summary as JSON");
  add_work_options(*command, options->work);
  add_choice(*command, "--isa", options->isa, isa_names(),
             "Instruction set of the sums over neighbours. No result depends on it");
  command->callback([&request, options] {
    options->words = request.words;
    request.work = [options] { return run(*options); };
  });
}

}  // namespace program
