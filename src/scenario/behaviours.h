// Reynolds' steering behaviours in a scenario: their parameters, what can be wrong with them, their terms.
#pragma once

#include "scenario/field_parts.h"
#include "scenario/model.h"

namespace sturnus {

/// The tables of one flock, for the one list of parameters.
void visit_behaviours(FlockDef& flock, FieldVisitor& visitor);

/// Appends what is wrong with them.
void check_behaviours(const ScenarioDef& scenario, Problems& problems);

/// Adds the terms of the flock `own`, not yet in order.
void compile_behaviours(const ScenarioDef& scenario, std::size_t own, FlockModel& out);

/// What the whole model needs because some flock uses it: who is watched, and how far is looked.
void gather_behaviours(Model& model);

}  // namespace sturnus
