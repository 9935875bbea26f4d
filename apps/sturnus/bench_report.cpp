// Rows as lines of a table and as JSON.
#include "bench_report.h"

#include <sturnus/version.h>

#include <algorithm>
#include <cmath>

#include "json_text.h"
#include "machine.h"
#include "output.h"

namespace program {
namespace {

using Json = nlohmann::ordered_json;

std::string fixed(double number) {
  return std::isfinite(number) ? format("%.1f", number) : "-";
}

std::string percent(double share) {
  return std::isfinite(share) ? format("%.0f %%", 100 * share) : "-";
}

std::string millions(double number) {
  return std::isfinite(number) ? format("%.1f M", 1e-6 * number) : "-";
}

std::vector<std::string> cells_of(const BenchRow& row) {
  return {row.scenario,
          std::to_string(row.boids),
          std::to_string(row.threads),
          row.isa,
          row.clock(),
          fixed(row.time().min),
          fixed(row.time().median),
          fixed(row.cpu.min),
          fixed(row.steps_per_second()),
          millions(row.candidate_pairs_per_second()),
          percent(row.share[0]),
          percent(row.share[1]),
          percent(row.share[2]),
          fixed(1e-6 * static_cast<double>(row.peak_memory)),
          row.is_own_peak ? fixed(row.bytes_per_boid) : "-",
          hash_digits(row.hash)};
}

// Words stand on the left of their columns, numbers on the right.
bool is_of_words(const std::string& title) {
  return title == "case" || title == "ISA" || title == "clock";
}

Json spread_json(const Spread& spread) {
  return {{"min", number_or_null(spread.min)}, {"median", number_or_null(spread.median)}};
}

Json time_json(const BenchRow& row) {
  Json out = {{"clock", row.clock()}};
  out.update(spread_json(row.time()));
  out["cpu"] = spread_json(row.cpu);
  out["wall"] = spread_json(row.wall);
  return out;
}

Json share_json(const BenchRow& row) {
  return {{"sort", number_or_null(row.share[0])},
          {"neighbours", number_or_null(row.share[1])},
          {"motion", number_or_null(row.share[2])}};
}

Json row_json(const BenchRow& row) {
  Json out;
  out["scenario"] = row.scenario;
  out["boids"] = row.boids;
  out["threads"] = row.threads;
  out["isa"] = row.isa;
  out["index"] = row.index;
  out["path"] = row.path;
  out["ns_per_boid_and_step"] = time_json(row);
  out["steps_per_second"] = number_or_null(row.steps_per_second());
  out["candidates"] = number_or_null(row.candidates);
  out["candidate_pairs_per_second"] = number_or_null(row.candidate_pairs_per_second());
  out["neighbours"] = number_or_null(row.neighbours);
  out["neighbour_pairs_per_second"] = number_or_null(row.neighbour_pairs_per_second());
  out["share"] = share_json(row);
  out["peak_memory"] = row.peak_memory;
  out["peak_memory_of"] = row.is_own_peak ? "this case" : "all cases so far";
  out["bytes_per_boid"] = row.is_own_peak ? number_or_null(row.bytes_per_boid) : Json(nullptr);
  out["hash"] = hash_digits(row.hash);
  out["hash_after_steps"] = row.steps;
  return out;
}

}  // namespace

BenchTable::BenchTable(const std::vector<sturnus::ScenarioDef>& scenarios, std::uint64_t steps)
    : titles_{"case",       "boids",
              "threads",    "ISA",
              "clock",      "min ns",
              "median ns",  "CPU ns",
              "steps/s",    "candidate pairs/s",
              "sort",       "neighbours",
              "motion",     "peak MB",
              "bytes/boid", "hash after " + counted(steps, "step")} {
  for (const std::string& title : titles_) widths_.push_back(std::max<std::size_t>(title.size(), 6));
  for (const auto& scenario : scenarios) widths_[0] = std::max(widths_[0], scenario.name.size());
  widths_[1] = 8;
}

std::string BenchTable::laid_out(const std::vector<std::string>& cells) const {
  std::string out;
  for (std::size_t column = 0; column < cells.size(); ++column) {
    const std::string& cell = cells[column];
    const std::string room(widths_[column] - std::min(cell.size(), widths_[column]), ' ');
    out += (column == 0 ? "" : "  ") + (is_of_words(titles_[column]) ? cell + room : room + cell);
  }
  return out + "\n";
}

std::string BenchTable::header() const {
  return laid_out(titles_);
}

std::string BenchTable::line(const BenchRow& row) const {
  return laid_out(cells_of(row));
}

std::string bench_preface(const BenchLength& length) {
  return std::string("sturnus ") + sturnus::version + ", " + compiler_name() + ", on " + processor_name() +
         ", " + counted(static_cast<std::uint64_t>(processor_cores()), "core") + "\n" +
         counted(length.repeats, "repeat") + " of " + counted(length.steps, "step") + " after " +
         counted(length.warm_up, "step") + " to warm up. ns: for each boid and step, by the clock named.\n" +
         "CPU ns, and the shares of the phases: time of the thread that was busiest in each phase.\n\n";
}

std::string bench_json(const BenchOptions& options, const BenchReport& report) {
  const BenchLength length = options.length();
  Json out;
  out["version"] = sturnus::version;
  out["compiler"] = compiler_name();
  out["machine"] = {{"cpu", processor_name()}, {"cores", processor_cores()}};
  out["command"] = options.words;
  out["warm_up"] = length.warm_up;
  out["steps"] = length.steps;
  out["repeats"] = length.repeats;
  out["skipped"] = report.lacking;
  out["interrupted"] = report.interrupted;
  out["cases"] = Json::array();
  for (const BenchRow& row : report.rows) out["cases"].push_back(row_json(row));
  return json_text(out);
}

}  // namespace program
