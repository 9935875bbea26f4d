// A running flock: create it from a scenario, step it, look at it, act on it.
//
// A simulation knows no window, no file and no clock. Everything that is done to it goes through commands
// that are logged with their step, so a session played by hand is a scenario with events and replays bit for
// bit.
#pragma once

#include <sturnus/explain.h>
#include <sturnus/result.h>
#include <sturnus/scenario.h>
#include <sturnus/view.h>
#include <sturnus/watch.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace sturnus {

/// Boids read from state CSV files, by the file's name as the scenario says it.
using BoidTables = std::map<std::string, State>;

struct SimulationOptions {
  int threads = 0;    ///< 0: one for each core; no result depends on it
  BoidTables tables;  ///< what `run.initial` and `start.file` name; `open_simulation` in files.h reads them
};

/// Where a rule writes what it wants: accelerations of boids, by slot of the view that it was given.
class Accelerations {
 public:
  Accelerations(Columns& columns, std::size_t slots);
  /// Adds to the acceleration of one boid, length per time squared; z is ignored in two dimensions.
  void add(std::size_t slot, float x, float y, float z = 0);
  std::size_t size() const { return size_; }

 private:
  Columns* columns_;
  std::size_t size_;
};

/// A user's own rule: looks at the flock before each step and writes accelerations. It must be a function of
/// what it sees and of nothing else if runs are to be reproducible.
using Rule = std::function<void(const View&, Accelerations&)>;

/// A moment to come back to: the scenario as it stood, the state, and the events so far. Kept in memory.
class Snapshot {
 public:
  std::uint64_t step() const;

 private:
  friend class Simulation;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// What becomes of events that were done by hand after the moment that is restored: they are done again when
/// their step comes, until the next `push`; or they never were; or those are done that were still to come
/// when the moment was kept, whatever was done since.
enum class Later { again, never, as_then };

/// What a run met besides flocking.
struct StepReport {
  std::size_t quarantined = 0;       ///< boids out of play because of a bad number
  std::size_t commands_in_vain = 0;  ///< events that named a boid that is not there, or found no free place
  std::size_t births_refused = 0;    ///< boids not born because their flock was at its population_cap
  std::size_t eaten = 0;             ///< boids that hunters caught
  std::size_t starved = 0;           ///< hunters that died of hunger
  std::size_t born = 0;              ///< boids born of food
};

class Simulation {
 public:
  /// A world at its first step, or every reason why there is none: what `check` finds, a table that is
  /// missing, more boids than the memory holds. The world stands at `run.first_step` with that step's events
  /// done.
  static Result<Simulation> create(const ScenarioDef& scenario, const SimulationOptions& options = {});

  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// One step of `time.dt`.
  void step();
  /// That many steps.
  void run(std::uint64_t steps);

  /// Does a command now, between two steps, and logs it; says what is wrong with it otherwise.
  Status push(const Command& command);

  View view() const;
  /// Covers every array of the state and does not depend on the order of storage.
  std::uint64_t hash() const;
  std::uint64_t step_number() const;
  StepReport report() const;
  /// Threads in use.
  int threads() const;

  /// The scenario as it stands now, with every parameter that was set.
  const ScenarioDef& scenario() const;
  /// The scenario as it began, with all events since: running it ends in the same hash.
  ScenarioDef recording() const;

  Snapshot snapshot() const;
  /// Back to that moment. Acting after a rewind begins a new branch: what was done by hand later is forgotten
  /// with the next `push`, or at once.
  void restore(const Snapshot& snapshot, Later later = Later::again);

  /// Adds a rule of one's own, with a weight of 1 and a place in the order of terms. Kept over `restore`; not
  /// part of the scenario.
  void add_rule(std::string name, std::int64_t priority, Rule rule);
  /// Accelerations from outside, felt in the next step only, by slot of the present view; forgotten when a
  /// command adds or erases boids before that.
  Accelerations external();

  /// Tells `watch` of the parts of every later step; null: nobody. It has to outlive the simulation or be
  /// taken off before. Changes no result.
  void watch(StepWatch* watch);

  /// What the boid with this id would feel in a step from here, to the bits that the step computes; or why
  /// nobody can say: there is no such boid, or it is out of play. Changes nothing. Asks the user's own rules
  /// once more; what events are still to do at this very step, as after `restore`, is not foreseen.
  Result<Explanation> explain(std::uint64_t id) const;

  /// Where the scenario's targets are now, in file order; z is 0 in two dimensions. Length.
  std::vector<std::array<float, 3>> target_places() const;

  /// The places of the neighbour index's cells or leaves, for pictures: min and max corner of each.
  std::vector<std::array<std::array<float, 3>, 2>> index_boxes() const;

  /// Fills all working memory with garbage; no result may change. For tests.
  void poison_scratch();

 private:
  struct World;
  explicit Simulation(std::unique_ptr<World> world);
  std::unique_ptr<World> world_;
};

}  // namespace sturnus
