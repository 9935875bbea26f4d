// One simulation with its past and with what is known of where it came from: what another world sets aside
// as a whole, and what undo brings back.
#pragma once

#include <sturnus/simulation.h>

#include <memory>
#include <string>
#include <vector>

#include "session/history.h"

namespace studio {

struct Timeline {
  Timeline(sturnus::Simulation begun, std::size_t history_bytes)
      : simulation(std::move(begun)),
        history(history_bytes),
        last(simulation.step_number()),
        opened(std::make_shared<const sturnus::ScenarioDef>(simulation.scenario())),
        events(simulation.recording().run.events) {
    history.start(simulation);
  }

  std::uint64_t number = 0;  ///< no two worlds of a visit have the same; the first one's is 0
  sturnus::Simulation simulation;
  History history;
  std::uint64_t last;                                  ///< the last step that was seen
  std::shared_ptr<const sturnus::ScenarioDef> opened;  ///< the scenario as it was opened
  std::vector<sturnus::Event> events;                  ///< of the scenario; others were done by hand
  std::string watched;                                 ///< a file whose changes the world follows; or empty
  std::shared_ptr<const sturnus::ScenarioDef> read;    ///< as that file was read last
  std::optional<std::uint64_t> tracked;                ///< id of the boid that is followed
  /// Where the simulation began in the middle of another one's run: the scenario from its very start, and the
  /// boids with which it began.
  std::shared_ptr<const sturnus::ScenarioDef> base;
  std::shared_ptr<const sturnus::State> start;
};

}  // namespace studio
