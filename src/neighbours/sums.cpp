// Batch by batch: who may be near, and which kernel sums them.
#include <algorithm>
#include <bit>
#include <cmath>

#include "neighbours/kernel.h"
#include "neighbours/passes.h"

namespace sturnus {
namespace {

// Whether a boid of the box may be near to another one over the seam.
template <int D>
bool is_near_the_seam(const Box& box, const Model& model) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double room = double{model.reach} * 1.001 + double{model.size[axis]} * 1e-6;
    if (box.low[axis] - room < double{model.min[axis]} || box.high[axis] + room > double{model.max[axis]})
      return true;
  }
  return false;
}

// The flocks that boids of the batch belong to; 0 for the hidden.
struct Members {
  std::uint64_t flocks = 0;
  bool is_mixed = false;
};

Members members_of(const Boids& boids, Span batch) {
  const std::uint64_t present = boids.flocks_in(batch.begin, batch.end);
  if (boids.hidden == nullptr && std::has_single_bit(present)) return {present, false};
  std::uint64_t any = 0;
  std::uint64_t all = ~std::uint64_t{0};
  for (std::size_t j = batch.begin; j < batch.end; ++j) {
    any |= boids.flock_bit(j);
    all &= boids.flock_bit(j);
  }
  return {any, any != all};
}

// A batch's box, and how far its boids look (length).
struct Look {
  const Box& box;
  float reach;
  const Wrapping& image;
};

// Whether somebody may be within the reach of a place in the box; a little more for the sake of rounding.
template <int D>
bool may_be_near(const Boids& boids, std::size_t i, const Look& look) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float low = look.box.low[axis], high = look.box.high[axis];
    const float room = 0.5f * (high - low) + 1.0001f * look.reach + 1e-5f * (std::abs(low) + std::abs(high));
    float o = std::abs(boids.position[axis][i] - (low + 0.5f * (high - low)));
    if (look.image.wraps && o > look.image.half[axis]) o = std::abs(look.image.size[axis] - o);
    if (o > room + 1e-5f * look.image.size[axis]) return false;
  }
  return true;
}

// The flocks that boids of a batch may have neighbours of. Those of its own flocks need not be asked, and
// others only until one of theirs is found near.
template <int D>
std::uint64_t flocks_near(const Boids& boids, std::uint64_t own, std::span<const Span> spans,
                          const Look& look) {
  std::uint64_t near = own;
  for (const Span& span : spans) {
    if ((boids.flocks_in(span.begin, span.end) & ~near) == 0) continue;
    for (std::size_t i = span.begin; i < span.end; ++i) {
      if ((boids.flock_bit(i) & ~near) != 0 && may_be_near<D>(boids, i, look)) near |= boids.flock_bit(i);
    }
  }
  return near;
}

// Whom the kernel has to ask; who comes in whole cells is left in the scratch.
std::span<const Span> find_candidates(const NeighbourIndex* index, const Box& box, const SumPass& pass,
                                      KernelScratch& scratch) {
  if (pass.is_dense && index != nullptr) {
    index->ring(box.low, box.high, pass.inner, pass.reach, scratch.ring);
    return scratch.ring.edge;
  }
  scratch.ring.whole.clear();
  scratch.spans.clear();
  if (index != nullptr) index->spans(box.low, box.high, pass.reach, scratch.spans);
  return scratch.spans;
}

template <int D>
void wide_batch(const Boids& boids, Span batch, const Members& members, std::span<const Span> spans,
                const Look& look, const SumPass& pass, SumBlock& sums) {
  const std::uint64_t steered = pass.steered & members.flocks;
  WideBatch wide{.boids = &boids,
                 .targets = batch,
                 .box = &look.box,
                 .spans = spans,
                 .few = is_few<D>(candidates(spans), pass),
                 .image = &look.image,
                 .near = flocks_near<D>(boids, members.flocks, spans, look),
                 .programs = pass.programs.data(),
                 .program = pass.programs.data() + std::countr_zero(steered),
                 .steered = steered,
                 .is_mixed = members.is_mixed,
                 .sums = &sums};
  if (wide.is_mixed || !has_idle_rows(*wide.program, wide.near)) return wide_sums<D>(wide);
  // Hunters are few, and most boids have none near: their sums cost no more than without hunters.
  const WideProgram without = without_idle_rows(*wide.program, wide.near);
  wide.program = &without;
  wide_sums<D>(wide);
}

}  // namespace

template <int D>
void neighbour_sums(const Boids& targets, std::span<const Span> batches, const Boids& sources,
                    const NeighbourQuestion& question, KernelScratch& scratch, SumBlock& sums) {
  const Model& model = *question.model;
  Wrapping inside = question.image;
  inside.wraps = false;
  for (const Span& batch : batches) {
    const Members members = members_of(targets, batch);
    if (members.flocks == 0) continue;
    const Box box = wide_box<D>(targets, batch);
    const Wrapping& image = question.image.wraps && is_near_the_seam<D>(box, model) ? question.image : inside;
    for (const SumPass& pass : question.passes->all()) {
      if ((pass.steered & members.flocks) == 0) continue;
      const auto spans = find_candidates(question.index, box, pass, scratch);
      scratch.pairs += std::uint64_t{batch.end - batch.begin} * candidates(spans);
      if (question.passes->are_wide()) {
        wide_batch<D>(targets, batch, members, spans, {box, pass.reach, image}, pass, sums);
      } else {
        sum_batch<D>(targets, batch, sources, spans, question, pass, scratch, sums);
      }
      if (pass.is_dense)
        add_whole_cells<D>(targets, batch, question, pass, scratch.ring.whole, scratch, sums);
    }
    if (model.uses_totals) add_populations<D>(targets, batch, question, sums);
  }
}

template void neighbour_sums<2>(const Boids&, std::span<const Span>, const Boids&, const NeighbourQuestion&,
                                KernelScratch&, SumBlock&);
template void neighbour_sums<3>(const Boids&, std::span<const Span>, const Boids&, const NeighbourQuestion&,
                                KernelScratch&, SumBlock&);

}  // namespace sturnus
