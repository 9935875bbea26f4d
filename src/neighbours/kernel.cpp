// The reference kernel: one boid, one neighbour, one row at a time. Clear before fast.
#include "neighbours/kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/hash.h"
#include "neighbours/passes.h"

namespace sturnus {
namespace {

template <int D>
Vec<D> at(const std::array<const float*, 3>& columns, std::size_t i) {
  Vec<D> v;
  for (int axis = 0; axis < D; ++axis) v[axis] = columns[static_cast<std::size_t>(axis)][i];
  return v;
}

// Nearer than this (squared) boids push no harder; it is the least normal float, so that division is safe. At
// one point their offset is zero, and so is what they feel.
constexpr float least_distance_squared = std::numeric_limits<float>::min();

// The boid that is steered, with what its filters need again and again.
template <int D>
struct Target {
  std::uint64_t id;
  Vec<D> position;
  Vec<D> velocity;
  float speed;
  std::uint32_t salt;  ///< of (seed, step, id), for sampling
};

// One neighbour as seen from the target.
template <int D>
struct Neighbour {
  std::size_t slot;
  Vec<D> offset;
  float distance_squared;
};

template <int D>
bool sees(const NeighbourRow& row, const Target<D>& target, const Neighbour<D>& neighbour) {
  if (row.sees_all) return true;
  const float distance = std::sqrt(neighbour.distance_squared);
  return dot(target.velocity, neighbour.offset) >= row.cos_half_view * target.speed * distance;
}

template <int D>
bool sampled(const NeighbourRow& row, const Target<D>& target, std::uint64_t neighbour_id) {
  if (row.sample_below == 0) return true;
  return static_cast<std::uint32_t>(mix(neighbour_id ^ (std::uint64_t{target.salt} << 32)) >> 32) <
         row.sample_below;
}

// All filters but that nobody is its own neighbour.
template <int D>
bool passes(const NeighbourRow& row, const Target<D>& target, const Boids& sources,
            const Neighbour<D>& neighbour) {
  const bool in_ring =
      row.inner_squared <= neighbour.distance_squared && neighbour.distance_squared < row.outer_squared;
  if (!in_ring || (row.flocks & sources.flock_bit(neighbour.slot)) == 0) return false;
  return sees(row, target, neighbour) && sampled(row, target, sources.id[neighbour.slot]);
}

template <int D>
Neighbour<D> neighbour_at(const Boids& sources, std::size_t i, const Vec<D>& from, const Wrapping& image) {
  const Vec<D> o = offset(from, at<D>(sources.position, i), image);
  return {i, o, dot(o, o)};
}

NeighbourSum rounded(RunningSum sum) {
  sum.fold();
  NeighbourSum out;
  out.count = sum.count;
  for (std::size_t axis = 0; axis < 3; ++axis) out.value[axis] = static_cast<float>(sum.whole[axis]);
  return out;
}

void add(RunningSum& sum, const std::array<const float*, 3>& columns, int components, std::size_t i) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(components); ++axis)
    sum.part[axis] += columns[axis][i];
}

template <int D>
void add_offset(RunningSum& sum, Strength strength, bool few, const Neighbour<D>& neighbour) {
  float scale = 1;
  if (strength != Strength::grows) {
    const float squared = std::max(neighbour.distance_squared, least_distance_squared);
    scale = 1.0f / (strength == Strength::fades ? squared : std::sqrt(squared));
  }
  for (int axis = 0; axis < D; ++axis) {
    const float value = neighbour.offset[axis] * scale;
    const auto i = static_cast<std::size_t>(axis);
    if (strength == Strength::fades && !few) {
      sum.whole[i] += double{value};
    } else {
      sum.part[i] += value;
    }
  }
}

template <int D>
void add_contribution(RunningSum& sum, const NeighbourRow& row, const Boids& sources, bool few,
                      const Neighbour<D>& neighbour) {
  ++sum.count;
  switch (row.quantity) {
    case Quantity::offset:
      return add_offset(sum, row.strength, few, neighbour);
    case Quantity::velocity:
      return add(sum, sources.velocity, D, neighbour.slot);
    case Quantity::heading:
      return add(sum, sources.heading, D, neighbour.slot);
    case Quantity::colour:
      return add(sum, sources.colour, 3, neighbour.slot);
  }
}

// What is walked: the candidates of a batch, for the rows of a flock that belong to the pass.
struct Walk {
  const FlockModel& flock;
  std::uint64_t rows;
  const Boids& sources;
  std::span<const Span> spans;
  const Wrapping& image;
  bool few;
};

template <int D>
void add_neighbour(const Walk& walk, const Target<D>& target, std::size_t i, std::span<RunningSum> sums) {
  const Boids& sources = walk.sources;
  const auto neighbour = neighbour_at<D>(sources, i, target.position, walk.image);
  if (!(neighbour.distance_squared < walk.flock.reach_squared) || sources.id[i] == target.id) return;
  for (std::size_t r = 0; r < walk.flock.rows.size(); ++r) {
    const NeighbourRow& row = walk.flock.rows[r];
    if ((walk.rows >> r & 1) != 0 && passes(row, target, sources, neighbour))
      add_contribution(sums[r], row, sources, walk.few, neighbour);
  }
}

template <int D>
void add_neighbours(const Walk& walk, const Target<D>& target, std::span<RunningSum> sums) {
  std::uint32_t seen = 0;
  for (const Span span : walk.spans) {
    assert(span.end <= walk.sources.count);
    for (std::size_t i = span.begin; i < span.end; ++i) {
      add_neighbour<D>(walk, target, i, sums);
      if (++seen % candidates_in_float == 0 && !walk.few) {
        for (RunningSum& sum : sums) sum.fold();
      }
    }
  }
}

}  // namespace

void find_stretches(const Boids& boids, const Workers& workers, std::vector<Stretch>& stretches) {
  stretches.resize((boids.count + batch_size - 1) / batch_size);
  workers.for_ranges(stretches.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t stretch = begin; stretch < end; ++stretch) {
      const std::size_t last = std::min<std::size_t>(boids.count, (stretch + 1) * batch_size);
      std::uint64_t found = 0;
      for (std::size_t i = stretch * batch_size; i < last; ++i) found |= boids.flock_bit(i);
      stretches[stretch].flocks = found;
    }
  });
  for (std::size_t i = stretches.size(); i-- > 0;) {
    const bool goes_on = i + 1 < stretches.size() && stretches[i].flocks == stretches[i + 1].flocks;
    stretches[i].next = goes_on ? stretches[i + 1].next : i + 1;
  }
}

template <int D>
Summed summed_by(const NeighbourRow& row, const Boids& boids) {
  switch (row.quantity) {
    case Quantity::offset:
      return {boids.position, &Totals::position, D};
    case Quantity::velocity:
      return {boids.velocity, &Totals::velocity, D};
    case Quantity::heading:
      return {boids.heading, &Totals::heading, D};
    case Quantity::colour:
      return {boids.colour, &Totals::colour, 3};
  }
  return {boids.position, &Totals::position, D};
}

template <int D>
void add_boid(Totals& totals, const Boids& boids, std::size_t i) {
  totals.count += 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    totals.position[axis] += double{boids.position[axis][i]};
    totals.velocity[axis] += double{boids.velocity[axis][i]};
    if (boids.heading[axis] != nullptr) totals.heading[axis] += double{boids.heading[axis][i]};
  }
  for (std::size_t channel = 0; channel < 3 && boids.colour[0] != nullptr; ++channel) {
    totals.colour[channel] += double{boids.colour[channel][i]};
  }
}

namespace {

void add_totals(Totals& to, const Totals& from) {
  to.count += from.count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to.position[axis] += from.position[axis];
    to.velocity[axis] += from.velocity[axis];
    to.heading[axis] += from.heading[axis];
    to.colour[axis] += from.colour[axis];
  }
}

}  // namespace

template <int D>
void population_totals(const Boids& boids, std::size_t flocks, const Workers& workers,
                       std::vector<Totals>& parts, std::vector<Totals>& totals) {
  constexpr std::size_t block_size = 4096;
  const std::size_t blocks = (boids.count + block_size - 1) / block_size;
  parts.assign(blocks * flocks, {});
  workers.for_ranges(blocks, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t last = std::min(boids.count, (block + 1) * block_size);
      for (std::size_t i = block * block_size; i < last; ++i) {
        if (!boids.is_hidden(i)) add_boid<D>(parts[block * flocks + boids.flock[i]], boids, i);
      }
    }
  });
  totals.assign(flocks, {});
  for (std::size_t i = 0; i < parts.size(); ++i) add_totals(totals[i % flocks], parts[i]);
}

namespace {

// Totals of the flocks that a row looks at, minus the boid itself, as if it had summed over all others.
template <int D>
NeighbourSum whole_population(const NeighbourRow& row, const Boids& boids, std::size_t self,
                              std::span<const Totals> totals) {
  Totals total;
  for (std::size_t flock = 0; flock < totals.size(); ++flock) {
    if ((row.flocks >> flock & 1) != 0) add_totals(total, totals[flock]);
  }
  const Summed summed = summed_by<D>(row, boids);
  const bool self_counted = (row.flocks & boids.flock_bit(self)) != 0;
  const double count = total.count - (self_counted ? 1 : 0);
  NeighbourSum out;
  out.count = static_cast<std::uint32_t>(count);
  for (std::size_t axis = 0; axis < summed.components; ++axis) {
    const double mine = summed.own[axis][self];
    double others = (total.*summed.total)[axis] - (self_counted ? mine : 0);
    if (row.quantity == Quantity::offset) others -= count * mine;
    out.value[axis] = static_cast<float>(others);
  }
  return out;
}

template <int D>
Target<D> target_at(const Boids& targets, std::size_t j, const NeighbourQuestion& question) {
  const auto velocity = at<D>(targets.velocity, j);
  const std::uint64_t salt = fold(fold(fold(0, question.model->seed), question.step), targets.id[j]);
  return {targets.id[j], at<D>(targets.position, j), velocity, length(velocity),
          static_cast<std::uint32_t>(salt)};
}

}  // namespace

template <int D>
bool is_few(std::size_t candidates, const SumPass& pass) {
  return candidates <= (pass.is_dense ? few_of_a_plain_sum : few_candidates[D - 2]);
}

template <int D>
void sum_batch(const Boids& targets, Span batch, const Boids& sources, std::span<const Span> spans,
               const NeighbourQuestion& question, const SumPass& pass, KernelScratch& scratch,
               SumBlock& sums) {
  const Model& model = *question.model;
  const bool few = is_few<D>(candidates(spans), pass);
  for (std::size_t j = batch.begin; j < batch.end; ++j) {
    if ((targets.flock_bit(j) & pass.steered) == 0) continue;
    const std::size_t f = targets.flock[j];
    scratch.running.assign(model.most_rows, {});
    const Walk walk{model.flocks[f], pass.rows[f], sources, spans, question.image, few};
    add_neighbours<D>(walk, target_at<D>(targets, j, question), scratch.running);
    for (std::size_t r = 0; r < walk.flock.rows.size(); ++r) {
      if ((walk.rows >> r & 1) != 0) sums.put(r, j, rounded(scratch.running[r]));
    }
  }
}

template <int D>
bool is_counted(const NeighbourRow& row, const Boids& targets, std::size_t j, const Boids& sources,
                std::size_t i, const NeighbourQuestion& question) {
  if (targets.id[j] == sources.id[i]) return false;
  if (row.whole_population) return (row.flocks & sources.flock_bit(i)) != 0;
  const auto target = target_at<D>(targets, j, question);
  return passes(row, target, sources, neighbour_at<D>(sources, i, target.position, question.image));
}

template <int D>
void add_populations(const Boids& targets, Span batch, const NeighbourQuestion& question, SumBlock& sums) {
  for (std::size_t j = batch.begin; j < batch.end; ++j) {
    if (targets.is_hidden(j)) continue;
    const FlockModel& flock = question.model->flocks[targets.flock[j]];
    for (std::size_t r = 0; r < flock.rows.size(); ++r) {
      if (flock.rows[r].whole_population)
        sums.put(r, j, whole_population<D>(flock.rows[r], targets, j, question.totals));
    }
  }
}

void SumBlock::spoil() {
  if (values_.empty()) return;
  std::memset(values_.data(), 0xff, values_.size() * sizeof(float));
  std::memset(counts_.data(), 0xff, counts_.size() * sizeof(std::uint32_t));
}

template void population_totals<2>(const Boids&, std::size_t, const Workers&, std::vector<Totals>&,
                                   std::vector<Totals>&);
template void population_totals<3>(const Boids&, std::size_t, const Workers&, std::vector<Totals>&,
                                   std::vector<Totals>&);
template bool is_few<2>(std::size_t, const SumPass&);
template bool is_few<3>(std::size_t, const SumPass&);
template void sum_batch<2>(const Boids&, Span, const Boids&, std::span<const Span>, const NeighbourQuestion&,
                           const SumPass&, KernelScratch&, SumBlock&);
template void sum_batch<3>(const Boids&, Span, const Boids&, std::span<const Span>, const NeighbourQuestion&,
                           const SumPass&, KernelScratch&, SumBlock&);
template bool is_counted<2>(const NeighbourRow&, const Boids&, std::size_t, const Boids&, std::size_t,
                            const NeighbourQuestion&);
template bool is_counted<3>(const NeighbourRow&, const Boids&, std::size_t, const Boids&, std::size_t,
                            const NeighbourQuestion&);
template Summed summed_by<2>(const NeighbourRow&, const Boids&);
template Summed summed_by<3>(const NeighbourRow&, const Boids&);
template void add_boid<2>(Totals&, const Boids&, std::size_t);
template void add_boid<3>(Totals&, const Boids&, std::size_t);
template void add_populations<2>(const Boids&, Span, const NeighbourQuestion&, SumBlock&);
template void add_populations<3>(const Boids&, Span, const NeighbourQuestion&, SumBlock&);

}  // namespace sturnus
