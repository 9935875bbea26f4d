// Who is a predator, and the predators and food that worlds without any are given.
#pragma once

#include <sturnus/scenario.h>

namespace studio {

/// A flock that hunts, or from which others flee.
bool is_predator(const sturnus::ScenarioDef& scenario, std::size_t flock);
/// Flocks by file order, predators or all others.
std::vector<std::size_t> flocks_that(const sturnus::ScenarioDef& scenario, bool are_predators);

/// Adds a flock of predators, nobody yet, that hunts all other flocks; those flee from it. Speeds and lengths
/// follow those of the first flock and of the space.
void give_predators(sturnus::ScenarioDef& scenario);
/// Adds a kind of food, no piece yet, and everybody who eats none so far eats it.
void give_food(sturnus::ScenarioDef& scenario);

}  // namespace studio
