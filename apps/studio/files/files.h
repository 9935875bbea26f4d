// Files that come into the world and go out of it: opened, watched, dropped, pasted and saved.
#pragma once

#include <sturnus/scenario.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace studio {

struct Desk;

class Files {
 public:
  /// Watches the file that the world was made of.
  void watch(Desk& desk, const sturnus::ScenarioDef& scenario);
  /// Opens a scenario's file in place of the world, or says what is wrong with it.
  void open(Desk& desk, const std::string& path);
  /// Opens a scenario that is no file of its own.
  void open(Desk& desk, const sturnus::ScenarioDef& scenario);
  /// A file that was dropped on the window: a scenario, or a state whose boids replace those that are there.
  void drop(Desk& desk, const std::string& path);
  /// Looks twice a second whether the file that the world follows has changed.
  void poll(Desk& desk);
  const std::string& watched() const { return path_; }

  /// The scenario with all that was placed and set, as text in the clipboard.
  void copy(Desk& desk) const;
  void paste(Desk& desk);

  /// Each writes a file of its own; an empty name: one is made of the scenario's name and the step. What is
  /// placed and set belongs to the scenario, whatever else was done to the session alone.
  void save_scenario(Desk& desk, const std::string& name = "") const;
  void save_session(Desk& desk, const std::string& name = "") const;
  void save_state(Desk& desk, const std::string& name = "") const;

 private:
  /// How a file looked from outside.
  struct Look {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Look&, const Look&) = default;
  };
  static std::optional<Look> look_at(const std::string& path);
  void follow(Desk& desk);

  std::string path_;                                    ///< the world's file; empty: nothing is watched
  std::shared_ptr<const sturnus::ScenarioDef> opened_;  ///< of the world that is shown
  std::optional<Look> look_;
  double next_look_ = 0;  ///< seconds since the start
};

/// A name in the current folder that no file has: the scenario's name, the step, -2, -3 ... if need be, and
/// the ending.
std::string new_name(const Desk& desk, const std::string& ending);

}  // namespace studio
