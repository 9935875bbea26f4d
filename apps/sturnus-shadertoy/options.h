// What the command line asks of the runner.
#pragma once

#include <sturnus/picture.h>
#include <sturnus/result.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace CLI {
class App;
}

namespace shadertoy {

/// The options as typed.
struct Options {
  std::string folder;
  std::optional<std::int64_t> frames;
  std::string size, mouse;
  std::string state, image, movie, sources;
  bool quiet = false;
};

void add_options(CLI::App& app, Options& options);

/// What is to be done, after the options are understood.
struct Plan {
  std::string folder;
  std::int64_t frames = 100;  ///< the last one's number; the first is 0
  sturnus::Size size;
  std::optional<std::pair<int, int>> mouse;  ///< pixel where it is held pressed, y upwards
  std::string state, image, movie, sources;  ///< empty: not wanted
  bool quiet = false;

  bool plays() const { return !state.empty() || !image.empty() || !movie.empty(); }
};

/// The plan, or the first thing that is wrong with the options.
sturnus::Result<Plan> plan_of(const Options& options);

}  // namespace shadertoy
