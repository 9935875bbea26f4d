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
  tell("note: " + counted(static_cast<std::uint64_t>(scenario.boid_count()), "boid") + " instead of " +
       std::to_string(all) + "; --count or --set flock.NAME.count=N says how many there shall be");
}

int write_shaders(const ShadertoyOptions& options) {
  auto scenario = effective_scenario(options.scenario);
  if (!scenario) return refuse(scenario.problems());
  if (!options.names_count()) thin_out(*scenario);
  const auto tabs = shadertoy_tabs(*scenario, options.shader_world());
  if (!tabs) return refuse(tabs.problems());

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
      app, "shadertoy", "Write a scenario as shaders to paste into the site Shadertoy",
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
  command->callback([&request, options] { request.work = [options] { return write_shaders(*options); }; });
}

}  // namespace program
