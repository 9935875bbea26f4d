// Keeping, thinning and finding the states of the past.
#include "session/history.h"

#include <algorithm>

namespace studio {
namespace {

constexpr std::uint64_t first_interval = 5;  // steps

std::size_t size_of(const sturnus::Columns& columns) {
  std::size_t size = 0;
  for (const auto& column : columns) size += column.size() * sizeof(float);
  return size;
}

}  // namespace

std::size_t size_of(const sturnus::State& state) {
  const std::size_t boid = sizeof(std::uint64_t) + 2;
  const std::size_t life = state.life.full.size() * (4 * sizeof(double) + sizeof(std::uint64_t));
  return state.size() * boid + life + size_of(state.position) + size_of(state.velocity) +
         size_of(state.wander) + size_of(state.colour) + size_of(state.food.position) +
         state.food.size() * (sizeof(std::uint64_t) + 1) + state.obstacles.size() * sizeof(sturnus::Obstacle);
}

void History::start(const sturnus::Simulation& simulation) {
  moments_.clear();
  bytes_ = 0;
  every_ = first_interval;
  add(simulation);
}

void History::follow(const sturnus::Simulation& simulation) {
  const std::uint64_t step = simulation.step_number();
  if (step < moments_.back().snapshot.step() + every_) return;
  add(simulation);
  while (bytes_ > budget_ && moments_.size() > 2) thin();
}

void History::amend(const sturnus::Simulation& simulation) {
  if (moments_.back().snapshot.step() != simulation.step_number()) return;
  bytes_ -= moments_.back().bytes;
  moments_.pop_back();
  if (moments_.empty()) add(simulation);
}

void History::cut(std::uint64_t step) {
  while (moments_.size() > 1 && moments_.back().snapshot.step() > step) {
    bytes_ -= moments_.back().bytes;
    moments_.pop_back();
  }
}

void History::shrink(std::size_t bytes) {
  const std::uint64_t every = every_;
  while (bytes_ > bytes && moments_.size() > 1) thin();
  every_ = every;
}

const sturnus::Snapshot& History::before(std::uint64_t step) const {
  const auto after = std::upper_bound(
      moments_.begin(), moments_.end(), step,
      [](std::uint64_t wanted, const Moment& moment) { return wanted < moment.snapshot.step(); });
  return (after == moments_.begin() ? after : after - 1)->snapshot;
}

void History::add(const sturnus::Simulation& simulation) {
  moments_.push_back({simulation.snapshot(), size_of(simulation.view().state())});
  bytes_ += moments_.back().bytes;
}

void History::thin() {
  std::vector<Moment> kept;
  bytes_ = 0;
  for (std::size_t i = 0; i < moments_.size(); i += 2) {
    bytes_ += moments_[i].bytes;
    kept.push_back(std::move(moments_[i]));
  }
  moments_ = std::move(kept);
  every_ *= 2;
}

}  // namespace studio
