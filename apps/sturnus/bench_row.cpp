// Figures that follow from others, and the promise that threads and instruction sets change no bit.
#include "bench_row.h"

#include <algorithm>

#include "output.h"

namespace program {
namespace {

std::string ending_of(const BenchRow& row) {
  return counted(static_cast<std::uint64_t>(row.threads), "thread") + " on " + row.isa +
         (row.threads == 1 ? " ends" : " end") + " in the hash " + hash_digits(row.hash);
}

}  // namespace

Spread spread_of(std::vector<double> figures) {
  std::sort(figures.begin(), figures.end());
  const std::size_t half = figures.size() / 2;
  const bool is_odd = figures.size() % 2 == 1;
  return {figures.front(), is_odd ? figures[half] : 0.5 * (figures[half - 1] + figures[half])};
}

double BenchRow::steps_per_second() const {
  return 1e9 / (time().min * static_cast<double>(boids));
}

double BenchRow::candidate_pairs_per_second() const {
  return candidates * static_cast<double>(boids) * steps_per_second();
}

double BenchRow::neighbour_pairs_per_second() const {
  return neighbours * static_cast<double>(boids) * steps_per_second();
}

std::string hash_digits(std::uint64_t hash) {
  return format("%016llx", static_cast<unsigned long long>(hash));
}

std::string disagreement(const std::vector<BenchRow>& rows) {
  for (const BenchRow& row : rows) {
    const auto first = std::find_if(rows.begin(), rows.end(),
                                    [&](const BenchRow& other) { return other.group == row.group; });
    if (first->hash == row.hash) continue;
    return row.scenario + " with " + counted(row.boids, "boid") + ": after " + counted(row.steps, "step") +
           " " + ending_of(*first) + ", but " + ending_of(row) + "; they must be the same";
  }
  return {};
}

}  // namespace program
