// The flocks that are measured, through the public interface alone.
#pragma once

#include <sturnus/files.h>
#include <sturnus/simulation.h>

#include <string>

#include "yardsticks/yardstick.h"

namespace bench {

/// Something is wrong that makes every further figure worthless; `what` is a sentence.
struct Failure {
  std::string what;
};

/// A shipped scenario with that many boids in its first flock.
sturnus::ScenarioDef scenario(const std::string& name, std::int64_t boids);

/// The base case in two or three dimensions: 20 neighbours in a radius of 10.
sturnus::ScenarioDef base_case(int dimensions, std::int64_t boids);

/// Changes the radii so that `neighbours` are in reach at the density of the base case; separation reaches
/// `share` of that.
void reach_neighbours(sturnus::ScenarioDef& scenario, double neighbours, double share);

/// Scenario quadtree without its noise, which no two programs draw alike.
sturnus::ScenarioDef quadtree_case(std::int64_t boids);

/// Where boids are when it is not all over the space.
enum class Spread { uniform, clumped, lost };
const char* name_of(Spread spread);

/// The base case with its boids spread so. clumped: in balls of 200 boids within one radius of their middle;
/// lost: at the usual density in one corner of an open world a million long, with one in a hundred astray.
sturnus::Simulation spread_flock(int dimensions, std::int64_t boids, Spread spread, sturnus::IndexKind index);

/// A simulation of the scenario, or a Failure.
sturnus::Simulation opened(const sturnus::ScenarioDef& scenario, int threads = 1);

/// The numbers of a base case or of the quadtree case, for a yardstick.
Numbers numbers_of(const sturnus::ScenarioDef& scenario);

/// The flock as it stands, by rank of id.
Flock flock_of(const sturnus::View& view);

}  // namespace bench
