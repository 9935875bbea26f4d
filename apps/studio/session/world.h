// The world behind the window, on whatever thread it is asked: the simulation, its past, what can be undone,
// and whom we follow. It knows no window and no clock.
#pragma once

#include <sturnus/measure.h>
#include <sturnus/simulation.h>

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "session/arrangement.h"
#include "session/frame.h"

namespace studio {

/// One line of the plots.
struct Sample {
  std::uint64_t generation = 0;
  sturnus::Measures measures;
  std::vector<std::size_t> population;  ///< by flock
  std::size_t food = 0;                 ///< pieces
  double step_seconds = 0;              ///< what the last step took
};

/// What the window wants to have in its frames besides the boids.
struct Wishes {
  bool index = false;       ///< the cells or leaves of the neighbour index
  bool neighbours = false;  ///< Instance::crowd

  friend bool operator==(const Wishes&, const Wishes&) = default;
};

class World {
 public:
  World(sturnus::Simulation simulation, std::size_t history_bytes);

  /// One step, remembered.
  void step();
  /// Does a command. `label` is what undo calls it; empty: it can't be undone. Commands of one gesture (not
  /// 0) are undone together.
  sturnus::Status act(const sturnus::Command& command, const std::string& label, std::uint64_t gesture = 0);
  /// Takes the last deed back, whatever step is looked at. A changed parameter gets its old value and the
  /// world goes on, unless the deed was done in the past or lies ahead; anything else takes the world back to
  /// the moment before it, with the future that it had. Redoing leads to where the world was when it was
  /// undone.
  bool undo() { return take_back(undo_, redo_); }
  bool redo() { return take_back(redo_, undo_); }
  /// Whether later steps were seen: whatever is done now begins another future.
  bool is_past() const { return now_.simulation.step_number() < now_.last; }

  /// Goes to a step of the past or of the future that was seen before; later commands are done again on the
  /// way. Long ways take many calls: true when there.
  bool go_to(std::uint64_t step);
  /// Another simulation in place of this one, which `undo` brings back with its past. The world then follows
  /// the file `watched`, or none.
  void replace(sturnus::Simulation simulation, const std::string& label, const std::string& watched = "");
  /// The scenario as it stands, with all that was placed and set, from its start.
  sturnus::Status restart(std::int64_t seed);
  sturnus::ScenarioDef arranged() const { return studio::arranged(now_); }
  sturnus::Status write_session(const std::string& path) const { return studio::write_session(now_, path); }
  /// Flocks or food that no command can bring: the scenario gets them, and the world goes on with them.
  sturnus::Status extend(const std::string& label, const std::function<void(sturnus::ScenarioDef&)>& add);

  /// Follows a file of which the world was made.
  void watch(const std::string& file, const sturnus::ScenarioDef& read);
  const std::string& watched() const { return now_.watched; }
  /// The watched file as it was read last.
  const sturnus::ScenarioDef& read() const { return *now_.read; }
  void set_read(const sturnus::ScenarioDef& read);

  /// Whom to follow; nobody: a number that no boid has. When it dies another one is taken.
  void track(std::optional<std::uint64_t> id) { now_.tracked = id; }
  bool is_tracking() const { return now_.tracked.has_value(); }
  /// Anybody, but not whom it took last.
  void track_any();
  /// The next boid by id, or the one before (direction -1).
  void track_next(int direction);
  /// A number for deeds that are undone together, which no hand uses.
  std::uint64_t new_gesture() { return (std::uint64_t{1} << 40) + ++gestures_; }
  void wish(const Wishes& wishes) { wishes_ = wishes; }

  /// Fills a frame with the world as it stands.
  void show(Frame& frame);
  Sample sample(double link = 0) const;

  const sturnus::Simulation& simulation() const { return now_.simulation; }
  std::uint64_t generation() const { return generation_; }
  /// Every world has a number of its own, and those that were set aside can be looked at.
  const Timeline& timeline() const { return now_; }
  std::uint64_t number() const { return now_.number; }
  std::vector<std::shared_ptr<const Timeline>> others() const;
  std::uint64_t last() const { return now_.last; }
  const History& history() const { return now_.history; }

 private:
  struct Change {
    std::string path, before, after;
  };
  struct Deed {
    std::string label;
    std::uint64_t gesture = 0;
    std::uint64_t step = 0;                   ///< at which it was done: before, both futures are the same
    std::vector<Change> changes;              ///< of parameters, in their order; or there is
    std::optional<sturnus::Snapshot> moment;  ///< the world before it (undo) or after it (redo)
    std::uint64_t last = 0;                   ///< of the moment: the last step that was seen then
    std::optional<sturnus::Snapshot> first;   ///< of the moment: with which the history started then
    std::shared_ptr<Timeline> other;          ///< or another world
  };
  std::optional<Change> change_of(const sturnus::Command& command) const;
  bool goes_on(bool is_change, std::uint64_t gesture) const;
  static void add(const Change& change, Deed& deed);
  void keep_moment(Deed& deed) const;
  bool put_back(const Deed& deed, Deed& back);
  void go_back(const Deed& deed, Deed& back);
  std::shared_ptr<Timeline> set_aside(Timeline next);
  void begin_again(Timeline next, const std::string& label);
  void begin_future(std::uint64_t step);
  void let_go();
  void remember(Deed deed);
  bool take_back(std::vector<Deed>& from, std::vector<Deed>& to);
  bool take_one_back(std::vector<Deed>& from, std::vector<Deed>& to);
  void jumped();
  void keep_tracked();
  std::size_t bytes_of_deeds() const;

  std::size_t history_bytes_;
  Timeline now_;
  std::vector<Deed> undo_, redo_;
  std::shared_ptr<const sturnus::ScenarioDef> scenario_;  ///< a copy for frames; null after a change
  Wishes wishes_;
  std::uint64_t generation_ = 1;
  std::uint64_t gestures_ = 0;
  std::uint64_t worlds_ = 0;
  std::uint64_t picks_ = 0;              ///< how often `track_any` took somebody
  std::uint64_t picked_ = 0;             ///< and whom it took last
  std::optional<std::uint64_t> way_to_;  ///< a step that `go_to` has not reached yet
  double step_seconds_ = 0;
};

}  // namespace studio
