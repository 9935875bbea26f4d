// The program `sturnus-studio`: a window on a flock. Ends with 0, 1 (no window, or it failed) or 2 (bad
// input).
#include <sturnus/files.h>

#include <algorithm>
#include <cstdio>

#include "command_line.h"
#include "main_program.h"
#include "output.h"
#include "script/play.h"
#include "studio.h"

namespace {

using namespace program;

struct Words {
  std::string scenario = "murmuration";
  std::string size = "1280x800";
  std::string theme = "dark";
  std::string script, video;
  bool frame_times = false;
  std::optional<std::int64_t> threads, history;
};

studio::StudioOptions options_of(const Words& words, sturnus::Size size) {
  studio::StudioOptions options;
  options.points = size;
  options.threads = static_cast<int>(words.threads.value_or(0));
  options.history_bytes = static_cast<std::size_t>(words.history.value_or(512)) << 20;
  options.theme = words.theme == "light" ? sturnus::ThemeName::light : sturnus::ThemeName::dark;
  options.in_lockstep = !words.script.empty();
  options.measures_frames = words.frame_times;
  if (!options.in_lockstep) options.memory = studio::memory_path();
  return options;
}

sturnus::Result<studio::Script> read_script(const Words& words) {
  if (words.script.empty()) {
    if (!words.video.empty()) return complaint("--video", "films a script: give one with --script FILE");
    return studio::Script();
  }
  const auto text = sturnus::read_text(words.script);
  if (!text) return text.problems();
  if (!words.video.empty()) {
    const sturnus::Status status = sturnus::check_output(words.video);
    if (!status) return status.problems();
  }
  return studio::parse_script(*text, words.script);
}

void print_times(const studio::Studio& studio, std::size_t boids) {
  const studio::FrameTimes& times = studio.times();
  const auto mean = [](double seconds, std::size_t count) {
    return seconds * 1e3 / static_cast<double>(std::max<std::size_t>(1, count));
  };
  std::printf("%zu boids, %zu frames, %zu steps: upload %.2f ms, draw %.1f ms, panels %.1f ms\n", boids,
              times.frames, times.steps, mean(times.upload, times.steps), mean(times.draw, times.frames),
              mean(times.panels, times.frames));
}

int show(const Words& words) {
  const auto size = picture_size("--size", words.size);
  if (!size) return refuse(size.problems());
  const auto script = read_script(words);
  if (!script) return refuse(script.problems());
  const auto scenario = sturnus::load_scenario(words.scenario);
  if (!scenario) return refuse(scenario.problems());
  const studio::StudioOptions options = options_of(words, *size);
  auto simulation = sturnus::open_simulation(*scenario, options.threads);
  if (!simulation) return refuse(simulation.problems());
  auto opened = studio::Studio::open(std::move(*simulation), options);
  if (!opened) return fail(opened.problems());
  studio::Studio& studio = **opened;
  studio.desk().files.watch(studio.desk(), *scenario);
  if (!words.script.empty()) {
    studio.frame();  // the first one makes ready what the others need
    studio.forget_times();
    const sturnus::Status played = studio::play(studio, *script, {words.video});
    if (!played) return fail(played.problems());
    if (words.frame_times) print_times(studio, studio.desk().frame->boids.size());
    return done;
  }
  while (studio.frame()) {
  }
  return done;
}

void describe(CLI::App& app, Request& request, Words& words) {
  app.add_option("SCENARIO", words.scenario,
                 "name of a shipped scenario, or a file; murmuration unless told");
  add_text(app, "--size", words.size, "WxH", "size of the window in points, 1280x800 unless told");
  add_choice(app, "--theme", words.theme, {"dark", "light"}, "colours: dark or light");
  add_whole(app, "--threads", words.threads, 0, 1024, "threads of the simulation; 0: one for each core");
  add_whole(app, "--history", words.history, 1, 1 << 20, "MiB of memory for winding back, 512 unless told");
  add_text(app, "--script", words.script, "FILE",
           "a visit to play: lines such as  click top.play  or  wait 60");
  add_text(app, "--video", words.video, "OUT.mp4", "a film of that visit, .mp4 or .gif");
  app.add_flag("--frame-times", words.frame_times,
               "after a script: what upload, drawing and panels took a frame, with each waited for");
  app.footer(
      "Press ? in the window for its keys. Drop scenarios and states on it to open them.\n"
      "Exit codes: 0 done, 1 no window or failed while running, 2 bad usage or input.");
  request.work = [&words] { return show(words); };
}

}  // namespace

int main(int count, char** words) {
  CLI::App app("A window on a flock: place creatures, pull sliders, follow one bird and see why it turns.",
               "sturnus-studio");
  Request request;
  request.words.assign(words, words + count);
  Words chosen;
  return main_program(app, request,
                      [&](CLI::App& described, Request& asked) { describe(described, asked, chosen); });
}
