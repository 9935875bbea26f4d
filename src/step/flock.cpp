// From places to places, block by block: neighbours, steering, motion.
#include <algorithm>
#include <utility>

#include "scenario/targets.h"
#include "step/motion.h"
#include "step/step.h"
#include "step/watched.h"
#include "world/columns.h"

namespace sturnus {
namespace {

// So many batches are summed, then steered: few enough that their sums stay in the nearest memory.
constexpr std::size_t batches_in_block = 64;

template <int D>
void fill_headings(const State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.heading, D, state.size());
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) put(scratch.heading, i, unit(at<D>(state.velocity, i)));
  });
}

Boids boids_of(const Model& model, const State& state, const Scratch& scratch) {
  Boids boids;
  boids.count = state.size();
  boids.position = pointers(state.position);
  boids.velocity = pointers(state.velocity);
  if (model.uses_headings) boids.heading = pointers(scratch.heading);
  boids.colour = pointers(state.colour);
  boids.id = state.id.data();
  boids.flock = state.flock.data();
  if (is_any_hidden(state)) boids.hidden = state.quarantined.data();
  boids.flocks = ~std::uint64_t{0} >> (64 - model.flocks.size());
  return boids;
}

void find_batches(const State& state, Scratch& scratch) {
  if (scratch.is_indexed) return scratch.index->batches(scratch.batches);
  scratch.batches.clear();
  cut(0, static_cast<std::uint32_t>(state.size()), scratch.batches);
}

std::size_t block_count(const Scratch& scratch) {
  return (scratch.batches.size() + batches_in_block - 1) / batches_in_block;
}

std::span<const Span> block_at(const Scratch& scratch, std::size_t block) {
  const std::size_t first = block * batches_in_block;
  const std::size_t count = std::min(batches_in_block, scratch.batches.size() - first);
  return std::span(scratch.batches).subspan(first, count);
}

// How much work a block is: the candidates of some of its batches.
template <int D>
std::uint64_t weight_of(const Model& model, const Boids& boids, const Scratch& scratch, std::size_t block,
                        std::vector<Span>& spans) {
  if (!scratch.is_indexed) return 1;
  const auto batches = block_at(scratch, block);
  std::uint64_t sum = 100 * batches.size();  // what costs the same for all
  for (std::size_t i = 0; i < batches.size(); i += 16) {
    const Box box = wide_box<D>(boids, batches[i]);
    scratch.index->spans(box.low, box.high, model.reach, spans);
    sum += candidates(spans) * std::min<std::size_t>(16, batches.size() - i);
  }
  return sum;
}

// Only where somebody shares the work.
template <int D>
void weigh_blocks(const Model& model, const Boids& boids, Scratch& scratch, const Workers& workers) {
  scratch.weights.assign(block_count(scratch), 0);
  if (workers.count() == 1) return;
  workers.for_ranges(scratch.weights.size(), [&](std::size_t begin, std::size_t end, int part) {
    std::vector<Span>& spans = scratch.parts[static_cast<std::size_t>(part)].kernel.spans;
    for (std::size_t block = begin; block < end; ++block)
      scratch.weights[block] = weight_of<D>(model, boids, scratch, block, spans);
  });
  for (std::size_t block = 1; block < scratch.weights.size(); ++block)
    scratch.weights[block] += scratch.weights[block - 1];
}

void drift_colours(const Model& model, const State& state, Scratch& scratch, const SumBlock& sums,
                   std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (state.quarantined[i] != 0) continue;
    const FlockModel& flock = model.flocks[state.flock[i]];
    NeighbourSum sum;
    if (flock.colour_row >= 0) sum = sums.at(static_cast<std::size_t>(flock.colour_row), i);
    put(scratch.next_colour, i,
        drifted_colour(flock, at<3>(state.colour, i), sum, state.id[i], {model.seed, state.step}));
  }
}

// Who is out of play stays where he is; he may be in no batch.
template <int D>
void keep_the_hidden(const Model& model, const State& state, Scratch& scratch) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (state.quarantined[i] == 0) continue;
    put(scratch.previous_position, i, at<D>(state.position, i));
    put(scratch.previous_velocity, i, at<D>(state.velocity, i));
    if (model.uses_colour) put(scratch.next_colour, i, at<3>(state.colour, i));
  }
}

// What dense passes need of the boids as they stand.
template <int D>
void sum_cells(const Boids& boids, Scratch& scratch, const Workers& workers) {
  for (SumPass& pass : scratch.passes.all()) {
    if (pass.is_dense && scratch.is_indexed)
      pass.cells.build<D>(scratch.index->layout(), boids, pass.looked_at, workers);
  }
}

// What one part of the work does block after block.
template <int D>
void flock_part(const Model& model, State& state, Scratch& scratch, const Boids& boids,
                const NeighbourQuestion& question, std::size_t first, std::size_t last, StepWatch* watch,
                int part) {
  PartScratch& own = scratch.parts[static_cast<std::size_t>(part)];
  Motion<D> motion{model, state, scratch, own, {model, state, scratch, own}, boids, image_of(model)};
  for (std::size_t block = first; block < last; ++block) {
    const auto batches = block_at(scratch, block);
    const std::size_t begin = batches.front().begin;
    const std::size_t end = batches.back().end;
    {
      const Watched watched(watch, Phase::neighbours, part);
      own.sums.fit(model.most_rows, begin, end);
      neighbour_sums<D>(boids, batches, boids, question, own.kernel, own.sums);
    }
    if (watch != nullptr) watch->looked_at(std::exchange(own.kernel.pairs, 0), part);
    const Watched watched(watch, Phase::motion, part);
    question.passes->are_wide() ? move_wide(motion, begin, end) : move_plain(motion, begin, end);
    if (model.is_solid && !scratch.obstacles.empty())
      question.passes->are_wide() ? keep_out_wide(motion, begin, end) : keep_out(motion, begin, end);
    if (model.uses_colour) drift_colours(model, state, scratch, own.sums, begin, end);
  }
}

// What was computed becomes the state.
void take_over(const Model& model, State& state, Scratch& scratch) {
  state.position.swap(scratch.previous_position);
  state.velocity.swap(scratch.previous_velocity);
  if (model.uses_colour) state.colour.swap(scratch.next_colour);
  for (const PartScratch& part : scratch.parts) {
    for (const std::uint32_t i : part.fallen) state.quarantined[i] = 1;
  }
}

void make_room(const Model& model, const State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.previous_position, model.dimensions, state.size());
  fit(scratch.previous_velocity, model.dimensions, state.size());
  if (model.uses_colour) fit(scratch.next_colour, 3, state.size());
  scratch.parts.resize(static_cast<std::size_t>(workers.count()));
  for (PartScratch& part : scratch.parts) part.fallen.clear();
}

// Everything that sums over neighbours need.
template <int D>
Asked ask(const Model& model, const State& state, Scratch& scratch, const Workers& workers) {
  place_targets(model, state.step, scratch.targets);
  if (model.uses_headings) fill_headings<D>(state, scratch, workers);
  Boids boids = boids_of(model, state, scratch);
  if (model.flocks.size() > 1) {
    find_stretches(boids, workers, scratch.stretches);
    boids.stretches = scratch.stretches.data();
  }
  if (model.uses_totals)
    population_totals<D>(boids, model.flocks.size(), workers, scratch.total_parts, scratch.totals);
  const NeighbourQuestion question{&model,          scratch.is_indexed ? scratch.index.get() : nullptr,
                                   image_of(model), scratch.totals,
                                   state.step,      &scratch.passes};
  find_batches(state, scratch);
  sum_cells<D>(boids, scratch, workers);
  return {boids, question};
}

template <int D>
void flock_in(const Model& model, State& state, Scratch& scratch, StepWatch* watch, const Workers& workers) {
  make_room(model, state, scratch, workers);
  const Asked asked = ask<D>(model, state, scratch, workers);
  weigh_blocks<D>(model, asked.boids, scratch, workers);
  if (asked.boids.hidden != nullptr) keep_the_hidden<D>(model, state, scratch);
  workers.for_weighted(scratch.weights, [&](std::size_t begin, std::size_t end, int part) {
    flock_part<D>(model, state, scratch, asked.boids, asked.question, begin, end, watch, part);
  });
  take_over(model, state, scratch);
}

}  // namespace

template <int D>
Asked sum_around(const Model& model, const State& state, Scratch& scratch, std::size_t slot,
                 const Workers& workers) {
  const Asked asked = ask<D>(model, state, scratch, workers);
  const auto batch = std::find_if(scratch.batches.begin(), scratch.batches.end(),
                                  [&](const Span& span) { return span.begin <= slot && slot < span.end; });
  scratch.parts.resize(1);
  PartScratch& part = scratch.parts.front();
  part.sums.fit(model.most_rows, batch->begin, batch->end);
  neighbour_sums<D>(asked.boids, {&*batch, 1}, asked.boids, asked.question, part.kernel, part.sums);
  return asked;
}

template Asked sum_around<2>(const Model&, const State&, Scratch&, std::size_t, const Workers&);
template Asked sum_around<3>(const Model&, const State&, Scratch&, std::size_t, const Workers&);

void flock(const Model& model, State& state, Scratch& scratch, StepWatch* watch, const Workers& workers) {
  model.dimensions == 3 ? flock_in<3>(model, state, scratch, watch, workers)
                        : flock_in<2>(model, state, scratch, watch, workers);
}

}  // namespace sturnus
