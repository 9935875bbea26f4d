// Who is near a place when all have moved: the index still knows where they stood, and nobody went farther
// than the longest way.
#pragma once

#include "neighbours/query.h"
#include "step/step.h"

namespace sturnus {

/// The longest way (length) that a boid of [begin, end) went from one place to another; a little more for the
/// sake of rounding.
template <int D>
float longest_way(const Columns& from, const Columns& to, const Wrapping& image, std::size_t begin,
                  std::size_t end);

/// After the motion of a step, while the slots are still those of its beginning.
template <int D>
class Moved {
 public:
  Moved(const Model& model, const State& state, Scratch& scratch, const Workers& workers)
      : index_(scratch.is_indexed ? scratch.index.get() : nullptr),
        reach_(model.reach),
        count_(state.size()) {
    if (index_ == nullptr) return;
    for (PartScratch& part : scratch.parts) part.longest = 0;
    workers.for_ranges(count_, [&](std::size_t begin, std::size_t end, int part) {
      scratch.parts[static_cast<std::size_t>(part)].longest =
          longest_way<D>(scratch.previous_position, state.position, image_of(model), begin, end);
    });
    for (const PartScratch& part : scratch.parts) longest_ = std::max(longest_, part.longest);
  }

  /// Whether the index is of use for such a distance (length).
  bool can_ask(float radius) const { return index_ != nullptr && radius + longest_ <= reach_; }

  /// Calls f(slot) for all in play who are within the radius of a place, and for some others.
  template <class F>
  void visit(const Vec<D>& at, float radius, std::vector<Span>& spans, F&& f) const {
    if (!can_ask(radius)) {
      for (std::size_t i = 0; i < count_; ++i) f(i);
      return;
    }
    const std::array<float, 3> place = widened(at);
    index_->spans(place, place, radius + longest_, spans);
    for (const Span span : spans) {
      for (std::size_t i = span.begin; i < span.end; ++i) f(i);
    }
  }

 private:
  const NeighbourIndex* index_;
  float reach_;
  std::size_t count_;
  float longest_ = 0;
};

}  // namespace sturnus
