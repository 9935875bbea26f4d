// sturnus shadertoy: a scenario as tabs to paste into the site Shadertoy.
#include <sturnus/files.h>
#include <sturnus/shaders.h>

#include <algorithm>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "output.h"
#include "scenario_options.h"

namespace program {
namespace {

using sturnus::ScenarioDef;
using sturnus::ShaderWorld;

// Every pixel and every boid looks at all boids: more of them by default would be slow on small machines.
constexpr std::int64_t usual_most = 300;

struct ShadertoyOptions {
  ScenarioOptions scenario;
  std::string folder;
  std::string world = "automatic";

  bool names_count() const {
    return scenario.count ||
           std::any_of(scenario.set.begin(), scenario.set.end(), [](const std::string& pair) {
             return pair.substr(0, pair.find('=')).ends_with(".count");
           });
  }
  ShaderWorld shader_world() const {
    if (world == "window") return ShaderWorld::window;
    return world == "scenario" ? ShaderWorld::scenario : ShaderWorld::automatic;
  }
};

// Thins every flock to its share of the usual number. Nobody disappears altogether.
void thin_out(ScenarioDef& scenario) {
  const std::int64_t all = scenario.boid_count();
  if (all <= usual_most) return;
  for (sturnus::FlockDef& flock : scenario.flocks) {
    if (flock.count > 0) flock.count = std::max<std::int64_t>(1, flock.count * usual_most / all);
  }
}

// What somebody who asked for a flock should know about the one that there is.
void tell_count(std::int64_t wanted, std::int64_t written) {
  if (written < wanted) {
    tell("note: " + counted(static_cast<std::uint64_t>(written), "boid") + " instead of " +
         std::to_string(wanted) + "; --count or --set flock.NAME.count=N says how many there shall be");
  } else if (written > usual_most) {
    tell("note: " + counted(static_cast<std::uint64_t>(written), "boid") +
         ": every pixel looks at each of them, which is slow on a small graphics card");
  }
}

// The command as typed, but for the folder.
std::string command_of(const std::vector<std::string>& words) {
  std::string command = "sturnus";
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "-o" || word == "--output") {
      ++i;
    } else if (!word.starts_with("--output=") && !word.starts_with("-o")) {
      command +=
          word.find_first_of(" '\"\\$*?[]{}();&|<>") == std::string::npos ? " " + word : " '" + word + "'";
    }
  }
  return command;
}

int write_shaders(const ShadertoyOptions& options, const std::vector<std::string>& words) {
  auto scenario = effective_scenario(options.scenario);
  if (!scenario) return refuse(scenario.problems());
  const std::int64_t wanted = scenario->boid_count();
  if (!options.names_count()) thin_out(*scenario);
  const auto tabs = shadertoy_tabs(*scenario, {options.shader_world(), command_of(words)});
  if (!tabs) return refuse(tabs.problems());
  tell_count(wanted, scenario->boid_count());

  sturnus::Status status = sturnus::make_folder(options.folder);
  for (const sturnus::ShaderTab& tab : *tabs) {
    if (status) status = sturnus::write_text(options.folder + "/" + tab.file, tab.text);
  }
  if (!status) {
    tell(status.problems());
    return failed;
  }
  print("wrote " + options.folder + "/common.glsl, buffer_a.glsl and image.glsl; try: sturnus-shadertoy " +
        options.folder + " --image flock.png\n");
  return done;
}

}  // namespace

void add_shadertoy(CLI::App& app, Request& request) {
  CLI::App* command = add_command(
      app, "shadertoy",
      "Write a scenario as shaders to paste into the site Shadertoy: at most 4096 boids, 300 unless told; of "
      "the looks only "
      "colours and sizes count",
      {"sturnus shadertoy ucsd -o shaders", "sturnus shadertoy ucsd-predator -o shaders --count 500",
       "sturnus shadertoy prog06 -o shaders --set flock.boids.cohesion.weight=0.2"});
  const auto options = std::make_shared<ShadertoyOptions>();
  add_parameter_options(*command, options->scenario);
  add_text(*command, "-o,--output", options->folder, "FOLDER",
           "Where common.glsl, buffer_a.glsl and image.glsl go")
      ->required();
  add_choice(
      *command, "--world", options->world, {"automatic", "window", "scenario"},
      "The world is the window, a unit a pixel, or the scenario's space fitted into it (default: the window "
      "where the space is measured in pixels)");
  command->callback([&request, options] {
    request.work = [options, words = request.words] { return write_shaders(*options, words); };
  });
}

}  // namespace program
