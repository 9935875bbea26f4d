// sturnus render: a picture, a sheet of pictures, or a video of a flock.
#include <sturnus/files.h>
#include <sturnus/render.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "course.h"
#include "interrupts.h"
#include "output.h"
#include "progress.h"
#include "scenario_options.h"

namespace program {
namespace {

using sturnus::Image;
using sturnus::Simulation;
using sturnus::Status;

constexpr std::int64_t default_steps = 300;
constexpr double default_frames_per_second = 30;
constexpr sturnus::Size sheet_picture = {480, 270};  // four of them make 1920

struct RenderOptions {
  ScenarioOptions scenario;
  WorkOptions work;
  std::string output;
  std::string frames_per_second;
  std::string size;
  std::optional<std::int64_t> every;
  bool trails = false;
  std::vector<std::string> show;
  std::optional<std::int64_t> boid;  ///< whose vectors are shown
  bool zoom = false;
  std::string sheet;
  std::string theme = "dark";
  bool no_caption = false;

  bool is_movie() const { return sturnus::is_movie_name(output); }
  bool is_sheet() const { return !sheet.empty(); }
  bool shows(const char* what) const { return std::find(show.begin(), show.end(), what) != show.end(); }
};

// How the flock is drawn, after the options are understood.
struct Plan {
  std::string output;
  std::uint64_t steps = 0;
  std::uint64_t every = 1;  ///< movies: steps from frame to frame
  double frames_per_second = default_frames_per_second;
  int columns = 0, rows = 0;  ///< sheets: pictures across and down
  bool with_progress = true;
  sturnus::RenderOptions drawing;
};

// What was drawn when it is over.
struct Outcome {
  std::uint64_t frames = 0;
  sturnus::Size size;
  bool interrupted = false;
};

Status check_combination(const RenderOptions& options) {
  const std::string& name = options.output;
  if (!options.is_movie() && !is_picture_name(name)) {
    return complaint(
        "-o",
        "\"" + name + "\" must end in .png, .ppm, .mp4 or .gif, or be a pattern such as frames/%05d.png");
  }
  if (options.is_movie() && options.is_sheet())
    return complaint("--sheet", "\"" + name + "\" is a video; a sheet is one picture, .png or .ppm");
  for (const auto& [name_of_option, is_given] :
       {std::pair("--boid", options.boid.has_value()), std::pair("--zoom", options.zoom)}) {
    if (is_given && !options.shows("vectors"))
      return complaint(name_of_option, "goes with --show vectors, which draws what one boid feels");
  }
  if (options.is_movie()) return {};
  if (options.every)
    return complaint("--every", "\"" + name + "\" is one picture; this option is for videos");
  if (!options.frames_per_second.empty())
    return complaint("--fps", "\"" + name + "\" is one picture; this option is for videos");
  return {};
}

Status read_size(const RenderOptions& options, Plan& plan) {
  if (options.is_sheet()) plan.drawing.picture.size = sheet_picture;
  if (options.size.empty()) return {};
  const auto size = picture_size("--size", options.size);
  if (!size) return size.problems();
  plan.drawing.picture.size = *size;
  return {};
}

Status read_sheet(const RenderOptions& options, Plan& plan) {
  if (!options.is_sheet()) return {};
  const auto sheet = two_numbers(options.sheet);
  if (!sheet || sheet->first < 1 || sheet->second < 1 || sheet->first > 100 || sheet->second > 100) {
    return complaint("--sheet", "write columns x rows, such as 4x3, but found \"" + options.sheet + "\"");
  }
  plan.columns = sheet->first;
  plan.rows = sheet->second;
  const sturnus::Size size = plan.drawing.picture.size;
  if (plan.columns * size.width > sturnus::max_picture_side ||
      plan.rows * size.height > sturnus::max_picture_side) {
    return complaint("--sheet", "the sheet would be wider or higher than " +
                                    std::to_string(sturnus::max_picture_side) +
                                    " pixels; give smaller pictures with --size");
  }
  const auto pictures = static_cast<std::uint64_t>(plan.columns) * static_cast<std::uint64_t>(plan.rows);
  if (plan.steps + 1 < pictures) {
    return complaint("--sheet", std::to_string(pictures) + " moments need at least " +
                                    counted(pictures - 1, "step") + ", but there are " +
                                    std::to_string(plan.steps));
  }
  return {};
}

Status read_frames_per_second(const RenderOptions& options, Plan& plan) {
  const std::string& text = options.frames_per_second;
  if (text.empty()) return {};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, plan.frames_per_second);
  if (error == std::errc() && rest == end && plan.frames_per_second >= 1 && plan.frames_per_second <= 1000)
    return {};
  return complaint("--fps", "must be a number from 1 to 1000, but is \"" + text + "\"");
}

// The plan, or the first thing that is wrong with the options.
sturnus::Result<Plan> plan_of(const RenderOptions& options) {
  Plan plan;
  plan.output = options.output;
  plan.steps = static_cast<std::uint64_t>(options.scenario.steps.value_or(default_steps));
  plan.every = static_cast<std::uint64_t>(options.every.value_or(1));
  plan.with_progress = !options.work.quiet;
  plan.drawing.trails = options.trails;
  plan.drawing.index = options.shows("index");
  plan.drawing.velocities = options.shows("velocities");
  plan.drawing.vectors = options.shows("vectors");
  if (options.boid) plan.drawing.boid = static_cast<std::uint64_t>(*options.boid);
  plan.drawing.zoom = options.zoom;
  plan.drawing.caption =
      !options.no_caption && !options.is_sheet();  // a sheet's pictures have captions of their own
  plan.drawing.threads = options.work.thread_count();
  plan.drawing.picture.theme =
      options.theme == "light" ? sturnus::ThemeName::light : sturnus::ThemeName::dark;
  for (const auto& part : {check_combination(options), read_size(options, plan), read_sheet(options, plan),
                           read_frames_per_second(options, plan)}) {
    if (!part) return part.problems();
  }
  return plan;
}

// A flock that is looked at while it steps, until it is there or Ctrl-C comes.
class Watch {
 public:
  Watch(Simulation& flock, const Plan& plan)
      : flock_(flock), renderer_(plan.drawing), progress_(plan.steps, plan.with_progress) {
    renderer_.follow(flock_);
  }

  /// Steps until so many steps are done in all.
  void step_to(std::uint64_t step) {
    for (; done_ < step && !interrupts_.asked(); ++done_) {
      flock_.step();
      renderer_.follow(flock_);
      progress_.show(done_ + 1);
    }
    cut_short_ = done_ < step;
  }
  Image frame() { return renderer_.frame(flock_); }
  bool was_cut_short() const { return cut_short_; }

 private:
  Simulation& flock_;
  sturnus::Renderer renderer_;
  Interrupts interrupts_;
  Progress progress_;
  std::uint64_t done_ = 0;
  bool cut_short_ = false;
};

sturnus::Result<Outcome> render_picture(Simulation& flock, const Plan& plan) {
  Watch watch(flock, plan);
  watch.step_to(plan.steps);
  const Image picture = watch.frame();
  if (const Status status = sturnus::save_picture(plan.output, picture); !status) return status.problems();
  return Outcome{1, picture.size(), watch.was_cut_short()};
}

sturnus::Result<Outcome> render_sheet(Simulation& flock, const Plan& plan) {
  Watch watch(flock, plan);
  const auto count = static_cast<std::uint64_t>(plan.columns * plan.rows);
  std::vector<Image> pictures;
  std::vector<std::string> captions;
  for (std::uint64_t i = 0; i < count && !watch.was_cut_short(); ++i) {
    watch.step_to(count > 1 ? plan.steps * i / (count - 1) : plan.steps);
    pictures.push_back(watch.frame());
    captions.push_back("step " + std::to_string(flock.step_number()));
  }
  const Image sheet = picture_sheet(pictures, captions, plan.columns, plan.drawing.picture.theme);
  if (const Status status = sturnus::save_picture(plan.output, sheet); !status) return status.problems();
  return Outcome{pictures.size(), sheet.size(), watch.was_cut_short()};
}

sturnus::Result<Outcome> render_movie(Simulation& flock, const Plan& plan) {
  const sturnus::Size size = plan.drawing.picture.size;
  auto movie = sturnus::Movie::open(plan.output, size, plan.frames_per_second);
  if (!movie) return movie.problems();
  Watch watch(flock, plan);
  Outcome outcome{0, size, false};
  for (std::uint64_t step = 0; step <= plan.steps && !watch.was_cut_short(); step += plan.every) {
    watch.step_to(step);
    if (const Status status = movie->add(watch.frame()); !status) return status.problems();
    ++outcome.frames;
  }
  outcome.interrupted = watch.was_cut_short();
  if (const Status status = movie->finish(); !status) return status.problems();
  return outcome;
}

void print_outcome(const Plan& plan, const Simulation& flock, const Outcome& outcome) {
  print("wrote " + plan.output + format(": %dx%d, ", outcome.size.width, outcome.size.height) +
        (outcome.frames > 1 ? counted(outcome.frames, plan.columns > 0 ? "picture" : "frame") + ", " : "") +
        format("step %llu, ", static_cast<unsigned long long>(flock.step_number())) +
        counted(flock.view().size(), "boid") +
        format(", hash %016llx\n", static_cast<unsigned long long>(flock.hash())));
}

// Whoever is not there may still come where events add boids.
Status check_boid(const RenderOptions& options, const Simulation& flock) {
  if (!options.boid || flock.view().slot(static_cast<std::uint64_t>(*options.boid))) return {};
  if (!flock.recording().run.events.empty()) return {};
  return complaint("--boid", "there is no boid with id " + std::to_string(*options.boid));
}

int render(const RenderOptions& options) {
  const auto plan = plan_of(options);
  if (!plan) return refuse(plan.problems());
  const auto scenario = effective_scenario(options.scenario);
  if (!scenario) return refuse(scenario.problems());
  if (const Status status = sturnus::check_output(options.output); !status) return fail(status.problems());
  auto flock = sturnus::open_simulation(*scenario, options.work.thread_count());
  if (!flock) return refuse(flock.problems());
  if (const Status status = check_boid(options, *flock); !status) return refuse(status.problems());
  const auto outcome = options.is_movie()   ? render_movie(*flock, *plan)
                       : options.is_sheet() ? render_sheet(*flock, *plan)
                                            : render_picture(*flock, *plan);
  tell_report(*flock);
  if (!outcome) return fail(outcome.problems());
  if (!options.work.quiet) print_outcome(*plan, *flock, *outcome);
  return outcome->interrupted ? interrupted : done;
}

}  // namespace

void add_render(CLI::App& app, Request& request) {
  CLI::App* command =
      add_command(app, "render", "Draw a scenario: a picture, a sheet of pictures, or a video",
                  {"sturnus render ucsd -o flock.png", "sturnus render murmuration -o birds.mp4 --steps 600",
                   "sturnus render ucsd -o flock.gif --size 640x360 --every 2",
                   "sturnus render ucsd -o sheet.png --sheet 4x3",
                   "sturnus render quadtree -o tree.png --index tree --show index",
                   "sturnus render ucsd -o why.png --show vectors --boid 17",
                   "sturnus render ucsd -o frames/%05d.png --trails --theme light"});
  const auto options = std::make_shared<RenderOptions>();
  add_scenario_options(*command, options->scenario);
  command->get_option("--steps")->description(
      "How many steps to do before or during the drawing (default 300)");
  add_text(*command, "-o,--output", options->output, "FILE",
           "A .png, .ppm, .mp4, .gif, or frames/%05d.png for numbered pictures")
      ->required();
  add_text(*command, "--size", options->size, "WxH",
           "Of the picture, in pixels (default 1280x720; in a sheet each, 480x270)");
  add_text(*command, "--fps", options->frames_per_second, "F", "Videos: frames in a second (default 30)");
  add_whole(*command, "--every", options->every, 1, 1000000000000000,
            "Videos: steps from frame to frame (default 1)");
  add_text(*command, "--sheet", options->sheet, "CxR",
           "One picture of moments evenly spaced over the steps, such as 4x3");
  command->add_flag("--trails", options->trails, "Draw where each boid was");
  command
      ->add_option("--show", options->show,
                   "Draw the index's boxes, an arrow along each velocity, or what one boid feels")
      ->type_name("index|velocities|vectors")
      ->allow_extra_args(false)
      ->check(one_of({"index", "velocities", "vectors"}));
  add_whole(*command, "--boid", options->boid, 0, 9007199254740991,
            "Whose vectors (default: of the boid nearest to the middle)");
  command->add_flag("--zoom", options->zoom, "With vectors: show only what that boid can see");
  add_choice(*command, "--theme", options->theme, {"dark", "light"}, "Colours for screens or for print");
  command->add_flag("--no-caption", options->no_caption, "Leave out title, step and count");
  add_work_options(*command, options->work);
  command->callback([&request, options] { request.work = [options] { return render(*options); }; });
}

}  // namespace program
