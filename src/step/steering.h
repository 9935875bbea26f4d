// From sums over neighbours to one acceleration: every term, its weight, the arbitration, the turn at the
// edge.
#pragma once

#include <algorithm>

#include "rules/rules.h"
#include "step/step.h"
#include "world/columns.h"

namespace sturnus {

/// The terms of one boid at a time.
template <int D>
class Steering {
 public:
  Steering(const Model& model, State& state, const Scratch& scratch, PartScratch& part)
      : model_(model),
        state_(state),
        scratch_(scratch),
        sums_(part.sums),
        image_(image_of(model)),
        moment_{model.seed, state.step},
        others_{state, scratch.watched, {}, image_, part.kernel.spans} {
    if (model.uses_lists) others_.near = {scratch.index.get(), cloud_of(model, state), image_, state.id};
  }

  Self<D> self(std::size_t i) const {
    return {state_.id[i], at<D>(state_.position, i), at<D>(state_.velocity, i)};
  }

  Vec<D> acceleration(std::size_t i) {
    return acceleration(i, [](const TermModel&, const Vec<D>&, const Vec<D>&) {});
  }

  /// The same; `told` hears of every term, in its order, what it asked for and what of its weighted vector
  /// was granted.
  template <class Told>
  Vec<D> acceleration(std::size_t i, Told&& told) {
    const FlockModel& flock = model_.flocks[state_.flock[i]];
    const Self<D> own = self(i);
    Arbiter<D> arbiter(flock.arbitration, flock.max_acceleration);
    for (const TermModel& term : flock.terms) {
      const Vec<D> felt = feel(term, flock, own, i);
      told(term, felt, arbiter.is_done() ? Vec<D>{} : arbiter.add(felt * term.weight));
    }
    return arbiter.result() + boundary_turn(model_, own.position);
  }

  /// What a term asks for, before its weight.
  Vec<D> feel(const TermModel& term, const FlockModel& flock, const Self<D>& own, std::size_t i) {
    const auto row = static_cast<std::size_t>(term.row);
    switch (term.kind) {
      case TermKind::separation:
        return separation<D>(term, sums_.at(row, i));
      case TermKind::alignment:
        return alignment<D>(term, sums_.at(row, i), own);
      case TermKind::cohesion:
        return cohesion<D>(term, sums_.at(row, i));
      case TermKind::flee:
        return flee<D>(term, sums_.at(row, i), own, flock.max_speed);
      case TermKind::cruise:
        return cruise<D>(term, own);
      case TermKind::wander:
        return wander(term, own, i);
      case TermKind::noise:
        return noise_acceleration<D>(term, own, moment_);
      case TermKind::targets:
        return targets_pull<D>(model_, scratch_.targets, state_.flock[i], own, image_);
      case TermKind::pointer:
        return pointer_pull<D>(model_.pointer, state_.pointer, own, image_, flock.max_speed);
      case TermKind::pursue:
        return pursuit(flock.behaviours.pursue, others_, own, flock.max_speed);
      case TermKind::evade:
        return evasion(flock.behaviours.evade, others_, own, flock.max_speed);
      case TermKind::follow_path:
        return path_following(flock.behaviours.path, image_, own, flock.max_speed);
      case TermKind::follow_wall:
        return wall_following(flock.behaviours.wall, image_, own, flock.max_speed);
      case TermKind::flow:
        return flow_following(flock.behaviours.flow, image_, own);
      case TermKind::follow_leader:
        return leader_following(flock.behaviours.leader, others_, own, flock.max_speed);
      case TermKind::avoid_collisions:
        return collision_avoidance(flock.behaviours.avoidance, others_, own);
      case TermKind::queue:
        return queuing(flock.behaviours.queue, others_, own);
      case TermKind::custom:
        return scratch_.custom[row][0].empty() ? Vec<D>{} : at<D>(scratch_.custom[row], i);
      case TermKind::avoid_obstacles:
        return avoid_obstacles<D>(term, flock, model_, scratch_.obstacles, own);
      case TermKind::hunt:
        return hunt(i);
      case TermKind::feed:
        return feed(*flock.feed, scratch_.pieces, own, flock.max_speed);
      case TermKind::hide:
        return hiding(flock.behaviours.hide, model_, scratch_.obstacles, others_, own, flock.max_speed);
    }
    return {};
  }

 private:
  // The walk goes on even where the arbitration does not grant it anything.
  Vec<D> wander(const TermModel& term, const Self<D>& own, std::size_t i) {
    const Vec<D> next = wandered<D>(term, own, at<D>(state_.wander, i), moment_);
    put(state_.wander, i, next);
    return next;
  }

  // What was found before anybody moved.
  Vec<D> hunt(std::size_t i) const {
    const Hunters& hunters = scratch_.hunters;
    const auto found = std::lower_bound(hunters.slots.begin(), hunters.slots.end(), i);
    if (found == hunters.slots.end() || *found != i) return {};
    return at<D>(hunters.pull, static_cast<std::size_t>(found - hunters.slots.begin()));
  }

  const Model& model_;
  State& state_;
  const Scratch& scratch_;
  const SumBlock& sums_;
  Wrapping image_;
  Moment moment_;
  Others<D> others_;
};

}  // namespace sturnus
