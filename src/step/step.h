// One step of a flock, and the phases that it is made of.
#pragma once

#include "scenario/model.h"
#include "step/scratch.h"

namespace sturnus {

/// Moves the state on by one time step; what is worth telling is added to the report.
void step(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
          const Outside& outside, StepReport& report, const Workers& workers);

/// Puts boids with values that are not finite or beyond 1e15 out of play: at rest, where they last were well.
void quarantine(const Model& model, State& state, const Workers& workers);
/// The places of the boids, as an index needs them. Hidden are those in quarantine.
Cloud cloud_of(const Model& model, const State& state);
/// How the model's space wraps.
Wrapping image_of(const Model& model);

/// Sorts the state by place.
void sort_by_place(const Model& model, State& state, Scratch& scratch, const Workers& workers);

/// What comes before anybody moves: bad numbers, the order of storage, what rules from outside ask for.
void prepare(const Model& model, const ScenarioDef& scenario, State& state, Scratch& scratch,
             const Outside& outside, const Workers& workers);

/// The boids as the kernels see them, and what is asked about them.
struct Asked {
  Boids boids;
  NeighbourQuestion question;
};
/// After `prepare`: the sums over neighbours of one boid and those who stand in its batch, to the bits that
/// `flock` steers by, in the first part's `sums`. They are good until state or scratch change.
template <int D>
Asked sum_around(const Model& model, const State& state, Scratch& scratch, std::size_t slot,
                 const Workers& workers);
/// Finds who hunts and what each sees, and where food lies, for the terms of this step; jumps begin.
void look_around(const Model& model, State& state, Scratch& scratch, const Workers& workers);

/// Sums over neighbours, accelerations, velocities, places, and the next colours: boids are taken block by
/// block, so that what was summed is still near when it is used.
void flock(const Model& model, State& state, Scratch& scratch, StepWatch* watch, const Workers& workers);

}  // namespace sturnus
