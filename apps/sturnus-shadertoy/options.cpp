// The options with their sentences, and what they may be.
#include "options.h"

#include <sturnus/files.h>

#include "command_line.h"

namespace shadertoy {
namespace {

using program::complaint;
using sturnus::Status;

Status read_size(const Options& options, Plan& plan) {
  if (options.size.empty()) return {};
  const auto size = program::picture_size("--size", options.size);
  if (!size) return size.problems();
  plan.size = *size;
  return {};
}

Status read_mouse(const Options& options, Plan& plan) {
  if (options.mouse.empty()) return {};
  plan.mouse = program::two_numbers(options.mouse, ',');
  if (!plan.mouse)
    return complaint("--mouse", "write X,Y in pixels, such as 640,360, but found \"" + options.mouse + "\"");
  const auto [x, y] = *plan.mouse;
  if (x >= 0 && x < plan.size.width && y >= 0 && y < plan.size.height) return {};
  return complaint("--mouse", "\"" + options.mouse + "\" lies outside the picture of " +
                                  std::to_string(plan.size.width) + "x" + std::to_string(plan.size.height) +
                                  " pixels");
}

Status check_names(const Options& options) {
  if (!options.image.empty() &&
      (!program::is_picture_name(options.image) || sturnus::is_movie_name(options.image)))
    return complaint("--image", "\"" + options.image + "\" must end in .png or .ppm, and is one picture");
  if (!options.movie.empty() && !sturnus::is_movie_name(options.movie)) {
    return complaint("--movie", "\"" + options.movie +
                                    "\" must end in .mp4 or .gif, or be a pattern such as frames/%05d.png");
  }
  if (sturnus::is_numbered_name(options.state)) {
    if (const auto name = sturnus::numbered_name(options.state, 0); !name) return name.problems();
  }
  return {};
}

Status check_something_wanted(const Options& options) {
  if (!(options.state + options.image + options.movie + options.sources).empty()) return {};
  return sturnus::Problem{
      "sturnus-shadertoy", 0, "",
      "nothing is asked for; say what to write with --state, --image, --movie or --sources", false};
}

}  // namespace

void add_options(CLI::App& app, Options& options) {
  app.add_option("DIR", options.folder, "Folder with buffer_a.glsl, image.glsl and perhaps common.glsl")
      ->required()
      ->type_name("");
  program::add_whole(app, "--frames", options.frames, 0, 1000000000,
                     "Number of the last frame; frame 0 sets up (default 100)");
  program::add_text(app, "--size", options.size, "WxH", "Of the picture, in pixels (default 1280x720)");
  program::add_text(app, "--mouse", options.mouse, "X,Y",
                    "Hold the mouse pressed at this pixel, y upwards, from frame 0");
  program::add_text(app, "--state", options.state, "FILE.csv",
                    "Write the boids of the last frame; states/%05d.csv: of every frame");
  program::add_text(app, "--image", options.image, "FILE", "Write the last frame, .png or .ppm");
  program::add_text(app, "--movie", options.movie, "FILE",
                    "Write all frames, .mp4 or .gif with 60 frames in a second, or frames/%05d.png");
  program::add_text(app, "--sources", options.sources, "FOLDER",
                    "Write the complete shaders buffer_a.frag and image.frag, for a linter");
  app.add_flag("--quiet", options.quiet, "Say nothing but what went wrong");
}

sturnus::Result<Plan> plan_of(const Options& options) {
  Plan plan;
  plan.folder = options.folder;
  plan.frames = options.frames.value_or(plan.frames);
  plan.state = options.state;
  plan.image = options.image;
  plan.movie = options.movie;
  plan.sources = options.sources;
  plan.quiet = options.quiet;
  for (const auto read : {read_size, read_mouse}) {
    if (const Status status = read(options, plan); !status) return status.problems();
  }
  for (const auto check : {check_names, check_something_wanted}) {
    if (const Status status = check(options); !status) return status.problems();
  }
  return plan;
}

}  // namespace shadertoy
