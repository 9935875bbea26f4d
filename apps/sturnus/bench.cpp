// sturnus bench: how fast this machine steps a flock, and that no result depends on how.
#include <sturnus/files.h>
#include <sturnus/measure.h>
#include <sturnus/parameters.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "bench_cases.h"
#include "bench_report.h"
#include "command_line.h"
#include "commands.h"
#include "isa_option.h"
#include "machine.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

using sturnus::ScenarioDef;
using sturnus::Simulation;

// How many neighbours a boid has on average. It takes long, so it is asked once for each state.
double mean_neighbours(const Simulation& flock) {
  return measure(flock.view()).neighbours;
}

std::array<double, 3> shares(const PhaseClock::Seconds& seconds) {
  const double all = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return {seconds[0] / all, seconds[1] / all, seconds[2] / all};
}

void fill_memory(BenchRow& row, const MemoryWatch& memory) {
  row.peak_memory = memory.peak();
  row.is_own_peak = memory.is_own_peak();
  const double added = static_cast<double>(row.peak_memory) - static_cast<double>(memory.before());
  row.bytes_per_boid = added / static_cast<double>(row.boids);
}

void fill_times(BenchRow& row, const BenchTimes& times) {
  row.wall = spread_of(times.wall);
  row.cpu = spread_of(times.cpu);
  row.share = shares(times.phases);
  row.candidates = times.candidates;
}

// A parameter that is a word, without its quotation marks.
std::string word_of(const ScenarioDef& scenario, const char* key) {
  return std::get<std::string>(sturnus::parse_value(*get_parameter(scenario, key)).held);
}

void fill_names(BenchRow& row, const ScenarioDef& scenario) {
  row.scenario = scenario.name;
  row.index = word_of(scenario, "index.kind");
  row.path = word_of(scenario, "index.path");
}

// All cases one after the other, and what became of them.
class Bench {
 public:
  Bench(const BenchOptions& options, const std::vector<ScenarioDef>& scenarios, const BenchIsas& isas)
      : options_(options),
        scenarios_(scenarios),
        isas_(isas),
        table_(scenarios, options.length().all_steps()) {
    report_.lacking = isas.lacking;
  }

  /// Returns the exit code.
  int run() {
    print(bench_preface(options_.length()) + table_.header());
    for (std::size_t group = 0; group < scenarios_.size(); ++group) {
      for (const int threads : bench_threads(options_)) {
        for (const BenchIsa& isa : isas_.here) {
          if (const int code = run_case(group, threads, isa); code != done) return code;
        }
      }
    }
    return done;
  }

  const BenchReport& report() const { return report_; }

 private:
  int run_case(std::size_t group, int threads, const BenchIsa& isa) {
    use_isa_named(isa.wanted);
    const MemoryWatch memory;
    auto flock = sturnus::open_simulation(scenarios_[group], threads);
    if (!flock) return refuse(flock.problems());
    const auto times = measure_steps(*flock, options_.length(), interrupts_);
    report_.interrupted = !times;
    if (!times) return interrupted;
    BenchRow row;
    row.group = group;
    row.threads = flock->threads();
    row.isa = isa.name;
    row.boids = flock->view().size();
    fill_names(row, scenarios_[group]);
    fill_times(row, *times);
    fill_memory(row, memory);
    row.steps = flock->step_number() - static_cast<std::uint64_t>(scenarios_[group].run.first_step);
    row.hash = flock->hash();
    row.neighbours = neighbours_of(row, *flock);
    report_.rows.push_back(row);
    print(table_.line(row));
    show_output();
    return done;
  }

  double neighbours_of(const BenchRow& row, const Simulation& flock) const {
    const bool has_sibling = !report_.rows.empty() && report_.rows.back().group == row.group;
    return has_sibling ? report_.rows.back().neighbours : mean_neighbours(flock);
  }

  const BenchOptions& options_;
  const std::vector<ScenarioDef>& scenarios_;
  const BenchIsas& isas_;
  const BenchTable table_;
  const Interrupts interrupts_;
  BenchReport report_;
};

void tell_of_memory(const BenchReport& report) {
  const auto is_shared = [](const BenchRow& row) { return !row.is_own_peak; };
  if (std::any_of(report.rows.begin(), report.rows.end(), is_shared)) {
    tell("peak MB is the most of all cases so far, because this system can't forget an earlier peak");
  }
}

int write_and_judge(const BenchOptions& options, const BenchReport& report, int code) {
  tell_of_memory(report);
  if (!options.json.empty()) {
    if (const auto status = sturnus::write_text(options.json, bench_json(options, report)); !status)
      return fail(status.problems());
  }
  const std::string sentence = disagreement(report.rows);
  if (sentence.empty()) return code;
  tell(sentence);
  return failed;
}

int bench(const BenchOptions& options) {
  const auto scenarios = bench_scenarios(options);
  if (!scenarios) return refuse(scenarios.problems());
  if (!options.json.empty()) {
    if (const auto status = sturnus::check_file(options.json); !status) return fail(status.problems());
  }
  const BenchIsas isas = bench_isas(options);
  for (const std::string& name : isas.lacking) {
    tell("--isa: " + name + " is skipped, because this machine lacks it; it has " + isas_here());
  }
  Bench work(options, *scenarios, isas);
  const int code = work.run();
  return code == bad_input ? code : write_and_judge(options, work.report(), code);
}

void describe(CLI::App& command, BenchOptions& options) {
  command
      .add_option("SCENARIO", options.scenarios,
                  "Shipped scenarios (sturnus list) or files; none:\nbench-2d and bench-3d")
      ->type_name("");
  add_wholes(command, "--boids", options.boids, 1, 1000000000,
             "Boids in all flocks, shared as in the scenario. Not given:\n"
             "1e4, 1e5 and 1e6 where the space grows with them, and\n"
             "else as many as the scenario has");
  add_wholes(command, "--threads", options.threads, 0, 1024,
             "Threads; 0: one for each core. Not given: 1 and 0");
  add_choices(command, "--isa", options.isas, isa_names(),
              "Instruction sets of the sums over neighbours; those that\nthe machine lacks are skipped");
  add_search_options(command, options.index, options.path);
  add_whole(command, "--steps", options.steps, 1, 1000000, "Steps in each repeat; not given: 10");
  add_whole(command, "--repeats", options.repeats, 1, 100000, "Repeats; not given: 5");
  add_text(command, "--json", options.json, "FILE", "Write the figures as JSON too");
  command.add_flag("--quick", options.quick, "A glance: 2000 boids, 2 repeats of 3 steps where not given");
}

}  // namespace

void add_bench(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "bench", "Measure the speed of steps, and check that all ways end in the same bits",
      {"sturnus bench                                   # takes a minute or two", "sturnus bench --quick",
       "sturnus bench bench-3d --boids 1e5 --threads 1,2,4 --json speed.json",
       "sturnus bench ucsd two-flocks --isa scalar,sse4,avx2,avx512 --threads 1",
       "sturnus bench bench-2d --boids 20000 --index tree --steps 20 --repeats 9"});
  const auto options = std::make_shared<BenchOptions>();
  describe(*command, *options);
  command->callback([&request, options] {
    options->words = request.words;
    request.work = [options] { return bench(*options); };
  });
}

}  // namespace program
