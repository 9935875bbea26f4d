// From sums over neighbours to one acceleration: every term, its weight, the arbitration, the turn at the
// edge.
#include "rules/rules.h"
#include "step/step.h"
#include "world/columns.h"

namespace sturnus {
namespace {

// The terms of one boid.
template <int D>
class Steering {
 public:
  Steering(const Model& model, State& state, const Scratch& scratch)
      : model_(model),
        state_(state),
        scratch_(scratch),
        image_(image_of(model)),
        moment_{model.seed, state.step} {}

  Vec<D> acceleration(std::size_t i) {
    const FlockModel& flock = model_.flocks[state_.flock[i]];
    const Self<D> self(state_.id[i], at<D>(state_.position, i), at<D>(state_.velocity, i));
    Arbiter<D> arbiter(flock.arbitration, flock.max_acceleration);
    for (const TermModel& term : flock.terms) {
      const Vec<D> felt = feel(term, flock, self, i);
      if (!arbiter.is_done()) arbiter.add(felt * term.weight);
    }
    return arbiter.result() + boundary_turn(model_, self.position);
  }

 private:
  Vec<D> feel(const TermModel& term, const FlockModel& flock, const Self<D>& self, std::size_t i) {
    const auto row = static_cast<std::size_t>(term.row);
    const NeighbourSum* sums = scratch_.sums.data() + i * model_.most_rows;
    switch (term.kind) {
      case TermKind::separation:
        return separation<D>(term, sums[row]);
      case TermKind::alignment:
        return alignment<D>(term, sums[row], self);
      case TermKind::cohesion:
        return cohesion<D>(term, sums[row]);
      case TermKind::flee:
        return flee<D>(term, sums[row], self, flock.max_speed);
      case TermKind::cruise:
        return cruise<D>(term, self);
      case TermKind::wander:
        return wander(term, self, i);
      case TermKind::noise:
        return noise_acceleration<D>(term, self, moment_);
      case TermKind::pointer:
        return pointer_pull<D>(model_.pointer, state_.pointer, self, image_, flock.max_speed);
      case TermKind::custom:
        return at<D>(scratch_.custom[row], i);
    }
    return {};
  }

  // The walk goes on even where the arbitration does not grant it anything.
  Vec<D> wander(const TermModel& term, const Self<D>& self, std::size_t i) {
    const Vec<D> next = wandered<D>(term, self, at<D>(state_.wander, i), moment_);
    put(state_.wander, i, next);
    return next;
  }

  const Model& model_;
  State& state_;
  const Scratch& scratch_;
  Wrapping image_;
  Moment moment_;
};

template <int D>
void combine_in(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    Steering<D> steering(model, state, scratch);
    for (std::size_t i = begin; i < end; ++i) {
      put(scratch.acceleration, i, state.quarantined[i] != 0 ? Vec<D>{} : steering.acceleration(i));
    }
  });
}

void drift_colours(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.next_colour, 3, state.size());
  workers.for_ranges(state.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      const FlockModel& flock = model.flocks[state.flock[i]];
      Vec<3> colour = at<3>(state.colour, i);
      if (state.quarantined[i] == 0) {
        const NeighbourSum* sum =
            flock.colour_row < 0
                ? nullptr
                : &scratch.sums[i * model.most_rows + static_cast<std::size_t>(flock.colour_row)];
        colour = drifted_colour(flock, colour, sum, state.id[i], {model.seed, state.step});
      }
      put(scratch.next_colour, i, colour);
    }
  });
  state.colour.swap(scratch.next_colour);
}

}  // namespace

void combine(const Model& model, State& state, Scratch& scratch, const Workers& workers) {
  fit(scratch.acceleration, model.dimensions, state.size());
  model.dimensions == 3 ? combine_in<3>(model, state, scratch, workers)
                        : combine_in<2>(model, state, scratch, workers);
  if (model.uses_colour) drift_colours(model, state, scratch, workers);
}

}  // namespace sturnus
