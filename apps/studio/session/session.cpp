// The loop of the simulation's thread: orders, ways to other steps, steps, and frames of them.
#include "session/session.h"

#include <chrono>

namespace studio {
namespace {

// Measuring may take this share of the time that steps take.
constexpr double measuring_share = 0.25;

double seconds_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Session::Session(sturnus::Simulation simulation, const SessionOptions& options)
    : options_(options), world_(std::move(simulation), options.history_bytes) {
  generation_ = world_.generation();
  run_to_ = now_ = world_.simulation().step_number();
  measure();
  publish();
  thread_ = std::thread([this] { work(); });
}

Session::~Session() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Session::run_to(std::uint64_t step, std::uint64_t generation) {
  const std::lock_guard lock(mutex_);
  if (generation != generation_) return;
  run_to_ = step;
  wake_.notify_all();
}

void Session::go_to(std::uint64_t step) {
  const std::lock_guard lock(mutex_);
  wanted_ = step;
  wake_.notify_all();
}

void Session::order(std::function<sturnus::Status(World&)> what) {
  const std::lock_guard lock(mutex_);
  orders_.push_back(std::move(what));
  wake_.notify_all();
}

void Session::act(sturnus::Command command, std::string label, std::uint64_t gesture) {
  order([command = std::move(command), label = std::move(label), gesture](World& world) {
    return world.act(command, label, gesture);
  });
}

std::shared_ptr<const Frame> Session::frame() {
  const std::lock_guard lock(mutex_);
  if (!is_taken_ && is_changed_) wake_.notify_all();
  is_taken_ = true;
  return shown_;
}

std::vector<Sample> Session::take_samples() {
  const std::lock_guard lock(mutex_);
  return std::exchange(samples_, {});
}

std::vector<Note> Session::take_notes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(notes_, {});
}

void Session::note(Note note) {
  const std::lock_guard lock(mutex_);
  notes_.push_back(std::move(note));
}

void Session::hand_back(std::function<void(Desk&)> what) {
  const std::lock_guard lock(mutex_);
  handed_back_.push_back(std::move(what));
}

std::vector<std::function<void(Desk&)>> Session::take_handed_back() {
  const std::lock_guard lock(mutex_);
  return std::exchange(handed_back_, {});
}

void Session::settle() {
  std::unique_lock lock(mutex_);
  is_taken_ = true;
  wake_.notify_all();
  settled_.wait(lock, [this] { return is_idle() && !is_busy_ && !is_changed_; });
}

bool Session::is_idle() const {
  return orders_.empty() && !wanted_ && now_ >= run_to_;
}

void Session::work() {
  std::unique_lock lock(mutex_);
  while (!quit_) {
    is_busy_ = do_one_thing(lock);
    const bool is_due = is_changed_ && (is_taken_ || is_idle());
    if (is_due && !wanted_) {
      lock.unlock();
      publish();
      lock.lock();
    }
    if (is_busy_) continue;
    settled_.notify_all();
    wake_.wait(lock, [this] { return quit_ || !is_idle() || (is_changed_ && is_taken_); });
  }
}

// One order, one step of a way, or one step. Returns false when there is nothing to do.
bool Session::do_one_thing(std::unique_lock<std::mutex>& lock) {
  if (is_idle()) return false;
  is_busy_ = true;
  if (wanted_) {
    const std::uint64_t wanted = *wanted_;
    lock.unlock();
    const bool is_there = world_.go_to(wanted);
    lock.lock();
    if (is_there && wanted_ == wanted) wanted_.reset();
  } else if (!orders_.empty()) {
    const auto orders = std::exchange(orders_, {});
    const bool rests = now_ >= run_to_;
    lock.unlock();
    for (const auto& what : orders) {
      if (const sturnus::Status status = what(world_); !status.problems().empty())
        note({status.error(), !status});
    }
    if (rests) measure_change();
    lock.lock();
  } else {
    lock.unlock();
    world_.step();
    measure();
    lock.lock();
  }
  now_ = world_.simulation().step_number();
  if (world_.generation() != generation_) run_to_ = now_;
  generation_ = world_.generation();
  is_changed_ = true;
  return true;
}

// Every so many steps as the scenario says, unless it took too long.
void Session::measure() {
  const sturnus::Simulation& simulation = world_.simulation();
  const auto every = static_cast<std::uint64_t>(simulation.scenario().run.measure_every);
  Sample sample;
  since_measure_ += 1;
  if (simulation.step_number() % every != 0) return;
  if (!options_.measures_all && measure_seconds_ > 0 &&
      since_measure_ * 0.02 * measuring_share < measure_seconds_)
    return;
  measure_seconds_ = seconds_of([&] { sample = world_.sample(); });
  since_measure_ = 0;
  const std::lock_guard lock(mutex_);
  samples_.push_back(std::move(sample));
}

// What was changed while the world stands still, which no step will measure; not for every motion of the
// mouse where it takes long.
void Session::measure_change() {
  using Clock = std::chrono::steady_clock;
  const std::chrono::duration<double> passed = Clock::now() - changed_;
  if (!options_.measures_all && passed.count() * measuring_share < measure_seconds_) return;
  Sample sample;
  measure_seconds_ = seconds_of([&] { sample = world_.sample(); });
  changed_ = Clock::now();
  const std::lock_guard lock(mutex_);
  samples_.push_back(std::move(sample));
}

void Session::publish() {
  const std::shared_ptr<Frame> frame = free_frame();
  world_.show(*frame);
  frame->serial = ++serial_;
  const std::lock_guard lock(mutex_);
  shown_ = frame;
  is_taken_ = false;
  is_changed_ = false;
}

// A frame that nobody holds any longer keeps its memory for a later one.
std::shared_ptr<Frame> Session::free_frame() {
  for (const auto& frame : pool_) {
    if (frame.use_count() == 1) return frame;
  }
  pool_.push_back(std::make_shared<Frame>());
  return pool_.back();
}

}  // namespace studio
