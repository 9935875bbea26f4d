// The program `sturnus-shadertoy`: plays a pair of Shadertoy shaders without a display, and writes what they
// make.
#include <sturnus/files.h>

#include <ctime>
#include <optional>

#include "boids.h"
#include "command_line.h"
#include "headless.h"
#include "interrupts.h"
#include "main_program.h"
#include "options.h"
#include "output.h"
#include "player.h"
#include "progress.h"

namespace shadertoy {
namespace {

using sturnus::Status;

constexpr double frames_per_second = 60;

Status write_sources(const Plan& plan, const Shaders& shaders) {
  if (plan.sources.empty()) return {};
  if (const Status status = sturnus::make_folder(plan.sources); !status) return status;
  const Status status = sturnus::write_text(plan.sources + "/buffer_a.frag", buffer_a_shader(shaders));
  return status ? sturnus::write_text(plan.sources + "/image.frag", image_shader(shaders)) : status;
}

// The name of the state file of a frame. That the pattern is good was found out with the options.
std::string state_name(const Plan& plan, int frame) {
  return sturnus::is_numbered_name(plan.state) ? *sturnus::numbered_name(plan.state, frame) : plan.state;
}

Status check_outputs(const Plan& plan) {
  for (const std::string& name : {plan.image, plan.movie}) {
    if (name.empty()) continue;
    if (const Status status = sturnus::check_output(name); !status) return status;
  }
  if (plan.state.empty()) return {};
  const std::string first = state_name(plan, 0);
  if (first != plan.state && !program::folder_of(first).empty()) {
    if (const Status status = sturnus::make_folder(program::folder_of(first)); !status) return status;
  }
  return sturnus::check_output(first);
}

// Everything that is written while the frames go by.
class Writers {
 public:
  Writers(const Plan& plan, const std::optional<Boids>& boids) : plan_(plan), boids_(boids) {}

  Status open() {
    if (plan_.movie.empty()) return {};
    auto movie = sturnus::Movie::open(plan_.movie, plan_.size, frames_per_second);
    if (!movie) return movie.problems();
    movie_.emplace(std::move(*movie));
    return {};
  }

  Status take(Player& player, bool is_last) {
    Status status;
    if (boids_ && (is_last || sturnus::is_numbered_name(plan_.state))) {
      const sturnus::State state = boids_->read(player.buffer_a(), player.frame());
      status = sturnus::write_text(state_name(plan_, player.frame()), sturnus::state_csv(state));
    }
    const bool shows = is_last && !plan_.image.empty();
    if (!status || (!movie_ && !shows)) return status;
    const sturnus::Image picture = player.picture();
    if (movie_) status = movie_->add(picture);
    if (status && shows) status = sturnus::save_picture(plan_.image, picture);
    return status;
  }

  Status finish() { return movie_ ? movie_->finish() : Status(); }

 private:
  const Plan& plan_;
  const std::optional<Boids>& boids_;
  std::optional<sturnus::Movie> movie_;
};

struct Outcome {
  int frame = 0;
  bool interrupted = false;
};

sturnus::Result<Outcome> play(Player& player, const Plan& plan, const std::optional<Boids>& boids) {
  Writers writers(plan, boids);
  if (const Status status = writers.open(); !status) return status.problems();
  program::Interrupts interrupts;
  program::Progress progress(static_cast<std::uint64_t>(plan.frames), !plan.quiet);
  for (bool is_last = false; !is_last;) {
    player.advance();
    is_last = player.frame() == plan.frames || interrupts.asked();
    Status status = writers.take(player, is_last);
    if (status) status = player.check();
    if (!status) return status.problems();
    progress.show(static_cast<std::uint64_t>(player.frame()));
  }
  if (const Status status = writers.finish(); !status) return status.problems();
  return Outcome{player.frame(), player.frame() < plan.frames};
}

std::string names_of(const Plan& plan) {
  std::string names;
  for (const std::string& name : {plan.state, plan.image, plan.movie}) {
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  }
  if (plan.sources.empty()) return names;
  return names + (names.empty() ? "" : ", ") + plan.sources + "/buffer_a.frag, " + plan.sources +
         "/image.frag";
}

void print_outcome(const Plan& plan, const Outcome& outcome, const Headless& headless) {
  const double seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  program::print(
      "wrote " + names_of(plan) +
      program::format(": frames 0 to %d, %dx%d, ", outcome.frame, plan.size.width, plan.size.height) +
      headless.renderer() + program::format(", %.1f s CPU\n", seconds));
}

int play_shaders(const Plan& plan, const Shaders& shaders) {
  const auto headless = Headless::open();
  if (!headless) return program::fail(headless.problems());
  auto passes = compile(shaders);
  if (!passes) return program::refuse(passes.problems());
  std::optional<Boids> boids;
  if (!plan.state.empty()) {
    auto found = Boids::find(shaders, plan.size);
    if (!found) return program::refuse(found.problems());
    boids.emplace(std::move(*found));
  }
  auto player = Player::open(std::move(*passes), plan.size, plan.mouse);
  if (!player) return program::fail(player.problems());
  const auto outcome = play(*player, plan, boids);
  if (!outcome) return program::fail(outcome.problems());
  if (!plan.quiet) print_outcome(plan, *outcome, **headless);
  return outcome->interrupted ? program::interrupted : program::done;
}

int run(const Options& options) {
  const auto plan = plan_of(options);
  if (!plan) return program::refuse(plan.problems());
  const auto shaders = read_shaders(plan->folder);
  if (!shaders) return program::refuse(shaders.problems());
  Status status = check_outputs(*plan);
  if (status) status = write_sources(*plan, *shaders);
  if (!status) return program::fail(status.problems());
  if (plan->plays()) return play_shaders(*plan, *shaders);
  if (!plan->quiet) program::print("wrote " + names_of(*plan) + "\n");
  return program::done;
}

}  // namespace
}  // namespace shadertoy

int main(int count, char** words) {
  CLI::App app("Plays a pair of Shadertoy shaders without a display, and writes what they make.",
               "sturnus-shadertoy");
  app.footer(
      "Examples:\n"
      "  sturnus-shadertoy shadertoy --image flock.png\n"
      "  sturnus-shadertoy shadertoy --frames 100 --state out.csv --image out.png\n"
      "  sturnus-shadertoy shadertoy --size 640x360 --mouse 320,180 --movie flock.mp4\n"
      "  sturnus-shadertoy shadertoy --sources complete && glslangValidator complete/*.frag\n"
      "Exit codes: 0 done, 1 failed while running, 2 bad usage or input, 130 interrupted.");
  shadertoy::Options options;
  program::Request request;
  request.words.assign(words, words + count);
  request.work = [&options] { return shadertoy::run(options); };
  return program::main_program(app, request, [&options](CLI::App& described, program::Request&) {
    shadertoy::add_options(described, options);
  });
}
