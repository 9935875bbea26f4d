// Workers over oneTBB with a static split; serial where the library is built without it.
#include "base/workers.h"

#include <algorithm>
#include <thread>

#ifdef STURNUS_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include "base/float_settings.h"

namespace sturnus {
namespace {

int cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

struct Workers::Team {
  explicit Team(int wanted)
      : count(wanted > 0 ? wanted : cores())
#ifdef STURNUS_TBB
        ,
        arena(count)
#endif
  {
#ifdef STURNUS_TBB
    // One limit for all teams, since the lowest of several counts; threads are only started where a team
    // asks.
    static const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                             static_cast<std::size_t>(std::max(256, cores())));
#endif
  }
  int count;
#ifdef STURNUS_TBB
  tbb::task_arena arena;
#endif
};

Workers::Workers(int count) : team_(std::make_unique<Team>(count)) {}
Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

int Workers::count() const {
  return team_->count;
}

namespace {

// Where a part begins: after as many things as make up its share of the weight.
std::size_t begin_of(std::size_t part, std::size_t parts, std::size_t n,
                     std::span<const std::uint64_t> weights) {
  if (weights.empty()) return n * part / parts;
  const std::uint64_t share = weights.back() / parts * part;
  const auto found = std::upper_bound(weights.begin(), weights.end(), share);
  return part == parts ? n : part == 0 ? 0 : static_cast<std::size_t>(found - weights.begin());
}

}  // namespace

void Workers::run(std::size_t n, std::span<const std::uint64_t> weights, Erased body) const {
  const auto parts = std::min<std::size_t>(static_cast<std::size_t>(team_->count), n);
  const auto run_part = [&](std::size_t part) {
    const FloatSettings settings;
    const std::size_t begin = begin_of(part, parts, n, weights);
    const std::size_t end = begin_of(part + 1, parts, n, weights);
    if (begin < end) body.call(body.body, begin, end, static_cast<int>(part));
  };
#ifdef STURNUS_TBB
  if (parts > 1) {
    team_->arena.execute(
        [&] { tbb::parallel_for(std::size_t{0}, parts, run_part, tbb::static_partitioner()); });
    return;
  }
#endif
  for (std::size_t part = 0; part < parts; ++part) run_part(part);
}

}  // namespace sturnus
