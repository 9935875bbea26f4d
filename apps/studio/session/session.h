// The simulation's own thread, and the counter over which the window orders and is served. The window is
// never kept waiting, whatever a step costs.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "session/world.h"

namespace studio {

struct Desk;

/// What a person has to be told.
struct Note {
  std::string text;  ///< sentences
  bool is_problem = false;
};

struct SessionOptions {
  std::size_t history_bytes = std::size_t{512} << 20;
  /// For tests and films: every line of measures is taken, however long it lasts.
  bool measures_all = false;
};

class Session {
 public:
  Session(sturnus::Simulation simulation, const SessionOptions& options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Steps until this one is reached; orders come first. Meant for one generation: not heard after a jump.
  void run_to(std::uint64_t step, std::uint64_t generation);
  /// To a step of the past, or of the future that was seen before.
  void go_to(std::uint64_t step);
  /// Does something with the world between two steps, in the order of the calls. What it says is noted.
  void order(std::function<sturnus::Status(World&)> what);
  /// The same for a command, as `World::act`.
  void act(sturnus::Command command, std::string label, std::uint64_t gesture = 0);

  /// The newest frame; never null.
  std::shared_ptr<const Frame> frame();
  /// Lines of measures since the last call.
  std::vector<Sample> take_samples();
  std::vector<Note> take_notes();
  void note(Note note);
  /// What an order wants to have done on the window's thread, and all of that since the last call.
  void hand_back(std::function<void(Desk&)> what);
  std::vector<std::function<void(Desk&)>> take_handed_back();
  /// Waits until everything ordered is done and shown.
  void settle();

 private:
  void work();
  bool is_idle() const;
  bool do_one_thing(std::unique_lock<std::mutex>& lock);
  void publish();
  void measure();
  void measure_change();
  std::shared_ptr<Frame> free_frame();

  SessionOptions options_;
  World world_;                               // the thread's own
  std::vector<std::shared_ptr<Frame>> pool_;  // the thread's own
  std::uint64_t serial_ = 0;                  // the thread's own
  double measure_seconds_ = 0, since_measure_ = 0;
  std::chrono::steady_clock::time_point changed_{};  // when a world at rest was measured; the thread's own
  std::mutex mutex_;
  std::condition_variable wake_, settled_;
  std::vector<std::function<sturnus::Status(World&)>> orders_;
  std::optional<std::uint64_t> wanted_;  // a step to go to
  std::uint64_t run_to_ = 0;
  std::uint64_t now_ = 0;
  std::uint64_t generation_ = 0;
  std::shared_ptr<const Frame> shown_;
  bool is_taken_ = true;     // whether the window has looked at what is shown
  bool is_changed_ = false;  // whether the world differs from what is shown
  bool is_busy_ = false;
  bool quit_ = false;
  std::vector<Sample> samples_;
  std::vector<Note> notes_;
  std::vector<std::function<void(Desk&)>> handed_back_;
  std::thread thread_;
};

}  // namespace studio
