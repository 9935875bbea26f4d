// What `sturnus bench` prints and writes.
#pragma once

#include <string>
#include <vector>

#include "bench_cases.h"
#include "bench_row.h"

namespace program {

/// The table that is printed line by line while the cases run.
class BenchTable {
 public:
  /// `steps`: after which the hash is taken.
  BenchTable(const std::vector<sturnus::ScenarioDef>& scenarios, std::uint64_t steps);
  std::string header() const;
  std::string line(const BenchRow& row) const;

 private:
  std::string laid_out(const std::vector<std::string>& cells) const;
  std::vector<std::string> titles_;
  std::vector<std::size_t> widths_;
};

/// What stands above the table: who measured, on what, and what the columns mean.
std::string bench_preface(const BenchLength& length);

/// All that is known at the end.
struct BenchReport {
  std::vector<BenchRow> rows;
  std::vector<std::string> lacking;  ///< instruction sets
  bool interrupted = false;
};
std::string bench_json(const BenchOptions& options, const BenchReport& report);

}  // namespace program
