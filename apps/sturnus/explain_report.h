// What a boid feels, as a text for people and as JSON.
#pragma once

#include <sturnus/explain.h>

#include <string>

namespace program {

/// Tables of terms, neighbours (at most so many) and formulas.
std::string explanation_text(const sturnus::Explanation& explanation, const sturnus::ScenarioDef& scenario,
                             std::size_t most_neighbours);
/// All of it; numbers read back to the same floats.
std::string explanation_json(const sturnus::Explanation& explanation, const sturnus::ScenarioDef& scenario);

}  // namespace program
