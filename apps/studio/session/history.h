// States of the past within a memory budget, so that a run can be wound back.
#pragma once

#include <sturnus/simulation.h>

#include <vector>

namespace studio {

/// Keeps a state every few steps. When the budget is used up it keeps every second one, and from then on
/// takes them half as often; the first stays.
class History {
 public:
  explicit History(std::size_t budget_bytes) : budget_(budget_bytes) {}

  /// Forgets everything and starts at this moment.
  void start(const sturnus::Simulation& simulation);
  /// Remembers this moment if it is time.
  void follow(const sturnus::Simulation& simulation);
  /// After a command: a moment that was taken at this very step is no longer what it was.
  void amend(const sturnus::Simulation& simulation);
  /// Forgets what lies after a step: another future begins.
  void cut(std::uint64_t step);
  /// Keeps every second moment until they fit into so much memory, bytes.
  void shrink(std::size_t bytes);

  /// The latest moment that is not after a step (or the first).
  const sturnus::Snapshot& before(std::uint64_t step) const;
  /// The moment with which it starts, and another in its place: of another future that begins there.
  const sturnus::Snapshot& front() const { return moments_.front().snapshot; }
  void set_front(const sturnus::Snapshot& moment) { moments_.front().snapshot = moment; }
  std::uint64_t first() const { return moments_.front().snapshot.step(); }
  std::size_t bytes() const { return bytes_; }
  std::size_t size() const { return moments_.size(); }

 private:
  struct Moment {
    sturnus::Snapshot snapshot;
    std::size_t bytes = 0;
  };
  void add(const sturnus::Simulation& simulation);
  void thin();

  std::size_t budget_;
  std::size_t bytes_ = 0;
  std::uint64_t every_ = 1;
  std::vector<Moment> moments_;
};

/// About how much memory a copy of a state takes, bytes.
std::size_t size_of(const sturnus::State& state);

}  // namespace studio
