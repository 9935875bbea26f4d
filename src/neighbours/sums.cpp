// Batch by batch: who may be near, and which kernel sums them.
#include <algorithm>
#include <bit>

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

std::uint64_t flocks_among(const Boids& boids, std::span<const Span> spans) {
  std::uint64_t found = 0;
  for (const Span& span : spans) found |= boids.flocks_in(span.begin, span.end);
  return found;
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
                const Wrapping& image, const SumPass& pass, SumBlock& sums) {
  WideBatch wide;
  wide.boids = &boids;
  wide.targets = batch;
  wide.spans = spans;
  wide.few = is_few<D>(candidates(spans), pass);
  wide.image = image;
  wide.near = flocks_among(boids, spans);
  wide.programs = pass.programs.data();
  wide.steered = pass.steered & members.flocks;
  wide.is_mixed = members.is_mixed;
  wide.program = wide.programs + std::countr_zero(wide.steered);
  wide.sums = &sums;
  // Hunters are few, and most boids have none near: their sums cost no more than without hunters.
  WideProgram without;
  if (!wide.is_mixed && has_idle_rows(*wide.program, wide.near)) {
    without = without_idle_rows(*wide.program, wide.near);
    wide.program = &without;
  }
  wide_sums<D>(wide);
}

}  // namespace

template <int D>
void neighbour_sums(const Boids& targets, std::span<const Span> batches, const Boids& sources,
                    const NeighbourQuestion& question, KernelScratch& scratch, SumBlock& sums) {
  const Model& model = *question.model;
  for (const Span batch : batches) {
    const Members members = members_of(targets, batch);
    if (members.flocks == 0) continue;
    const Box box = wide_box<D>(targets, batch);
    Wrapping image = question.image;
    image.wraps = image.wraps && is_near_the_seam<D>(box, model);
    for (const SumPass& pass : question.passes->all()) {
      if ((pass.steered & members.flocks) == 0) continue;
      const auto spans = find_candidates(question.index, box, pass, scratch);
      scratch.pairs += std::uint64_t{batch.end - batch.begin} * candidates(spans);
      if (question.passes->are_wide()) {
        wide_batch<D>(targets, batch, members, spans, image, pass, sums);
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
