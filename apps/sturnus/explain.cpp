// sturnus explain: what one boid feels at one step, term by term.
#include <sturnus/files.h>

#include <memory>

#include "command_line.h"
#include "commands.h"
#include "course.h"
#include "explain_report.h"
#include "isa_option.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

struct ExplainOptions {
  ScenarioOptions scenario;
  WorkOptions work;
  std::optional<std::int64_t> boid, at, neighbours;
  std::string json;
  std::string isa = "best";
};

constexpr std::int64_t usual_neighbours = 12;

// How many steps lie between where the boids stand and the step that is asked about.
sturnus::Result<std::uint64_t> steps_to(const ExplainOptions& options, const sturnus::Simulation& flock) {
  const std::uint64_t first = flock.step_number();
  const auto at = static_cast<std::uint64_t>(options.at.value_or(static_cast<std::int64_t>(first)));
  if (at >= first) return at - first;
  return complaint(
      "--at", "step " + std::to_string(at) + " is over: the boids start at step " + std::to_string(first));
}

int tell_of(const ExplainOptions& options, const sturnus::Simulation& flock) {
  const auto explanation = flock.explain(static_cast<std::uint64_t>(*options.boid));
  if (!explanation) return refuse(explanation.problems());
  if (!options.work.quiet) {
    const auto most = static_cast<std::size_t>(options.neighbours.value_or(usual_neighbours));
    print(explanation_text(*explanation, flock.scenario(), most));
  }
  if (options.json.empty()) return done;
  const auto status = sturnus::write_text(options.json, explanation_json(*explanation, flock.scenario()));
  return status ? done : fail(status.problems());
}

int explain(const ExplainOptions& options) {
  if (!use_isa_named(options.isa)) {
    return refuse("--isa: this machine lacks " + options.isa + "; it has " + isas_here());
  }
  const auto scenario = effective_scenario(options.scenario);
  if (!scenario) return refuse(scenario.problems());
  if (!options.json.empty()) {
    if (const auto status = sturnus::check_file(options.json); !status) return fail(status.problems());
  }
  auto flock = sturnus::open_simulation(*scenario, options.work.thread_count());
  if (!flock) return refuse(flock.problems());
  const auto steps = steps_to(options, *flock);
  if (!steps) return refuse(steps.problems());
  const Course course = follow(*flock, *steps, false, !options.work.quiet);
  if (course.interrupted) return interrupted;
  return tell_of(options, *flock);
}

}  // namespace

void add_explain(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "explain", "Tell what one boid feels at one step: every term, its neighbours, what is granted",
      {"sturnus explain ucsd --boid 17 --at 100", "sturnus explain cs184 --boid 3 --at 50 --json why.json",
       "sturnus explain ucsd --boid 17 --at 60 --initial s.csv --first-step 50"});
  const auto options = std::make_shared<ExplainOptions>();
  add_scenario_options(*command, options->scenario);
  command->remove_option(command->get_option("--steps"));
  add_whole(*command, "--boid", options->boid, 0, 9007199254740991, "The boid's id")->required();
  add_whole(*command, "--at", options->at, 0, 1000000000000000,
            "The step at which it is asked (default: where the boids start)");
  add_whole(*command, "--neighbours", options->neighbours, 0, 1000000000,
            "How many of them to list, nearest first (default 12); the JSON has all");
  add_text(*command, "--json", options->json, "FILE", "Write all of it as JSON too");
  add_work_options(*command, options->work);
  add_choice(*command, "--isa", options->isa, isa_names(),
             "Instruction set of the sums over neighbours. No result depends on it");
  command->callback([&request, options] { request.work = [options] { return explain(*options); }; });
}

}  // namespace program
