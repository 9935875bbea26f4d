// What there is to measure in a flock: order, shape, spacing. All in double, over boids in order of their
// ids.
#pragma once

#include <sturnus/view.h>

#include <string>
#include <vector>

namespace sturnus {

/// Measures of one moment. A value that has no meaning there (no moving boid, no earlier step) is NaN.
struct Measures {
  std::uint64_t step = 0;
  std::size_t boids = 0;    ///< not counting those in quarantine
  double polarisation = 0;  ///< |mean heading| over moving boids, 0 to 1 (Vicsek 1995)
  double milling = 0;       ///< |mean unit(p - c) x heading| about the centre of mass c, 0 to 1 (Couzin 2002)
  double speed = 0;         ///< mean |v|, length per time
  double turning = 0;       ///< mean angle between successive headings, degrees in one step
  double nearest_distance = 0;           ///< mean distance to the nearest other boid, length
  double neighbours = 0;                 ///< mean number of others within `link` and the field of view
  std::size_t clusters = 0;              ///< components connected by distances up to `link`, single boids too
  double largest_cluster = 0;            ///< share of all boids in the largest cluster, 0 to 1
  std::vector<std::size_t> populations;  ///< boids of each flock, in the scenario's order, as `boids` counts
};

/// Measures a flock as it stands. `link` (length): 0 takes the scenario's run.measure.link, and where that is
/// 0 too the largest finite radius of any term.
Measures measure(const View& view, double link = 0);

/// |mean heading| over moving boids; NaN when none moves (Vicsek 1995).
double polarisation(const View& view);

/// For every slot how many others are within `link` (as for `measure`) and in its field of view; 0 for boids
/// in quarantine.
std::vector<std::uint32_t> neighbour_counts(const View& view, double link = 0);

/// One measure for people and files.
struct MeasureColumn {
  const char* name;   ///< in files: "polarisation"
  const char* title;  ///< in plots: "Polarisation"
  const char* unit;   ///< "length", "degrees", ""
  double low, high;   ///< range where it is known; NaN otherwise
  double (*value)(const Measures&);
};
/// Every measure but the step, in the order of the struct.
const std::vector<MeasureColumn>& measure_columns();

/// "step,boids,polarisation,..." and one line of it, without line ends. NaN is an empty field. With several
/// flocks there is a last column "population.NAME" for each.
std::string measures_header(const ScenarioDef& scenario);
std::string measures_line(const Measures& measures);

}  // namespace sturnus
