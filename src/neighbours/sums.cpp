// Batch by batch: who may be near, and which kernel sums them.
#include <sturnus/isa.h>

#include <algorithm>

#include "neighbours/kernel.h"
#include "neighbours/wide.h"

namespace sturnus {
namespace {

// The box of a batch's targets.
struct Box {
  std::array<float, 3> low{}, high{};
  bool is_empty() const { return !(low[0] <= high[0]); }
};

template <int D>
Box box_of(const Boids& targets, Span batch) {
  Box box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    float low = FlockModel::infinity_f;
    float high = -FlockModel::infinity_f;
    for (std::size_t j = batch.begin; j < batch.end; ++j) {
      const float at = targets.position[axis][j];
      const bool counts = targets.flock_bit[j] != 0;
      low = counts && at < low ? at : low;
      high = counts && at > high ? at : high;
    }
    box.low[axis] = low;
    box.high[axis] = high;
  }
  return box;
}

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

// What is known of all boids before the first batch.
struct Common {
  std::vector<WideProgram> programs;  ///< empty: the plain kernel
  std::uint64_t checked = 0;
};

Common common_of(const Boids& targets, const Boids& sources, const Model& model) {
  Common common;
  const bool are_the_same = targets.id == sources.id && targets.count == sources.count;
  if (!are_the_same || isa_in_use() == "plain") return common;
  for (const FlockModel& flock : model.flocks) common.programs.push_back(wide_program(flock));
  for (const WideProgram& program : common.programs) {
    if (!program.fits) return {};
  }
  bool is_somebody_hidden = false;
  for (std::size_t i = 0; i < sources.count; ++i) {
    common.checked |= sources.flock_bit[i];
    is_somebody_hidden |= sources.flock_bit[i] == 0;
  }
  if (is_somebody_hidden) common.checked = 0;
  return common;
}

// Every flock that has a boid in the batch, one after the other.
template <int D>
void wide_batch(const Boids& boids, Span batch, const Wrapping& image, std::span<const Span> spans,
                const Common& common, const Model& model, std::span<NeighbourSum> sums) {
  std::uint64_t left = 0;
  for (std::size_t j = batch.begin; j < batch.end; ++j) left |= boids.flock_bit[j];
  for (std::size_t flock = 0; left != 0; ++flock, left >>= 1) {
    if ((left & 1) == 0) continue;
    wide_sums<D>({&boids, batch, spans, image, common.checked, flock, &common.programs[flock],
                  model.most_rows, sums.data()});
  }
}

}  // namespace

template <int D>
void neighbour_sums(const Boids& targets, std::span<const Span> batches, const Boids& sources,
                    const NeighbourQuestion& question, std::span<NeighbourSum> sums) {
  const Model& model = *question.model;
  const Common common = common_of(targets, sources, model);
  std::vector<Span> spans;
  for (const Span batch : batches) {
    const Box box = box_of<D>(targets, batch);
    if (box.is_empty()) continue;
    NeighbourSum* first = sums.data() + std::size_t{batch.begin} * model.most_rows;
    std::fill(first, first + std::size_t{batch.end - batch.begin} * model.most_rows, NeighbourSum{});
    if (question.index != nullptr) {
      question.index->spans(box.low, box.high, spans);
      if (common.programs.empty()) {
        sum_batch<D>(targets, batch, sources, spans, question, sums);
      } else {
        Wrapping image = question.image;
        image.wraps = image.wraps && is_near_the_seam<D>(box, model);
        wide_batch<D>(targets, batch, image, spans, common, model, sums);
      }
    }
    if (model.uses_totals) add_populations<D>(targets, batch, question, sums);
  }
}

template void neighbour_sums<2>(const Boids&, std::span<const Span>, const Boids&, const NeighbourQuestion&,
                                std::span<NeighbourSum>);
template void neighbour_sums<3>(const Boids&, std::span<const Span>, const Boids&, const NeighbourQuestion&,
                                std::span<NeighbourSum>);

}  // namespace sturnus
