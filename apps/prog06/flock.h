// The simulation of the assignment, out of the shipped scenario and the six arguments.
#pragma once

#include <sturnus/simulation.h>

#include "choices.h"

namespace prog06 {

/// The flock at its start, or what is wrong with the numbers, in the words of the command line and the file.
sturnus::Result<sturnus::Simulation> open_flock(const Choices& choices);

/// The mouse holds a place, or lets go of it.
void hold(sturnus::Simulation& flock, sturnus::PointerMode mode, const sturnus::Point3& at, bool pressed);

}  // namespace prog06
