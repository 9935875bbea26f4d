// The Shadertoy flock: the shipped tabs are current, what a shader can't express is refused, the shaders do
// what their transcript does, and one step of the engine does what one frame does.
#include <sturnus/files.h>
#include <sturnus/simulation.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "program.h"
#include "shader_transcript.h"

namespace program_test {
namespace {

using shader_transcript::Boid;
using shader_transcript::Inputs;

class Shadertoy : public ProgramTest {
 protected:
  Ended play(const Words& arguments) const {
    Words words{STURNUS_SHADERTOY};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Running running(words, here());
    return running.wait();
  }

  // Writes the shaders of a scenario and plays `frames` frames of them; the states lie in states/.
  void play_scenario(const Words& shadertoy, const Words& player, int frames) const {
    Words words{"shadertoy", "-o", path("shaders")};
    words.insert(words.end(), shadertoy.begin(), shadertoy.end());
    run_well(words);
    std::filesystem::create_directory(path("states"));
    Words all{path("shaders"), "--frames", std::to_string(frames), "--state", path("states/%05d.csv")};
    all.insert(all.end(), player.begin(), player.end());
    const Ended ended = play(all);
    ASSERT_EQ(ended.code, 0) << ended.err;
  }

  sturnus::State state(int frame) const {
    char name[32];
    std::snprintf(name, sizeof name, "states/%05d.csv", frame);
    auto read = sturnus::read_state_csv(path(name));
    EXPECT_TRUE(read) << read.error();
    return read ? *read : sturnus::State{};
  }
};

sturnus::ScenarioDef scenario_of(const std::string& name, std::int64_t count = 0) {
  auto scenario = sturnus::load_scenario(name);
  EXPECT_TRUE(scenario) << scenario.error();
  if (count > 0) scenario->flocks[0].count = count;
  return *scenario;
}

double component(const sturnus::Columns& columns, std::size_t axis, std::size_t i) {
  return columns[axis].empty() ? 0.0 : double{columns[axis][i]};
}

// How far two places are apart on any axis, by the nearest image where the world wraps.
double apart(double a, double b, double world) {
  const double plain = std::abs(a - b);
  return world > 0 ? std::min(plain, std::abs(world - plain)) : plain;
}

// ---- the shipped files ----

TEST_F(Shadertoy, ShippedTabsAreThoseOfTheShippedScenarios) {
  run_well({"shadertoy", "ucsd-predator", "-o", path("flat")});
  run_well({"shadertoy", "ucsd-3d", "-o", path("space")});
  const std::string shipped = STURNUS_SOURCE "/shadertoy/";
  const auto text = [](const std::string& file) { return *sturnus::read_text(file); };
  EXPECT_EQ(read("flat/common.glsl"), text(shipped + "common.glsl"))
      << "sturnus shadertoy ucsd-predator -o shadertoy";
  EXPECT_EQ(read("space/common.glsl"), text(shipped + "common_3d.glsl"))
      << "sturnus shadertoy ucsd-3d -o DIR, then copy DIR/common.glsl to shadertoy/common_3d.glsl";
  for (const char* tab : {"/buffer_a.glsl", "/image.glsl"}) {
    EXPECT_EQ(read("flat" + std::string(tab)), text(shipped + tab));
    EXPECT_EQ(read("space" + std::string(tab)), text(shipped + tab));
  }
}

TEST_F(Shadertoy, EveryTabNamesItsTabAndChannels) {
  const auto head = [](const char* tab) {
    const std::string text = *sturnus::read_text(std::string(STURNUS_SOURCE "/shadertoy/") + tab);
    return text.substr(0, text.find("\n\n"));
  };
  EXPECT_SAYS(head("common.glsl"), "Tab \"Common\"");
  EXPECT_SAYS(head("buffer_a.glsl"), "Tab \"Buffer A\"");
  EXPECT_SAYS(head("buffer_a.glsl"), "iChannel0 = Buffer A, filter nearest, wrap clamp");
  EXPECT_SAYS(head("buffer_a.glsl"), "iChannel1 = RGBA Noise Medium (Textures), filter linear, wrap repeat");
  EXPECT_SAYS(head("image.glsl"), "Tab \"Image\"");
  EXPECT_SAYS(head("image.glsl"), "iChannel0 = Buffer A, filter nearest, wrap clamp");
}

// Every scenario that a shader can express is valid GLSL for any compiler, not only for the one at hand.
TEST_F(Shadertoy, EveryExpressibleScenarioIsValidGlsl) {
  if (std::system("command -v glslangValidator >/dev/null") != 0)
    GTEST_SKIP() << "glslangValidator is not installed";
  int expressed = 0;
  for (const auto& scenario : sturnus::shipped_scenarios()) {
    const std::string folder = path(scenario.name);
    if (run({"shadertoy", scenario.name, "-o", folder}).code != 0) continue;
    ASSERT_EQ(play({folder, "--frames", "0", "--size", "64x64", "--sources", folder}).code, 0)
        << scenario.name;
    for (const char* pass : {"/buffer_a.frag", "/image.frag"}) {
      Running validator({"/usr/bin/env", "glslangValidator", folder + pass}, here());
      const Ended ended = validator.wait();
      EXPECT_EQ(ended.code, 0) << scenario.name << pass << "\n" << ended.out;
    }
    ++expressed;
  }
  EXPECT_GE(expressed, 10);
}

// ---- the command ----

TEST_F(Shadertoy, SaysWhatAShaderCannotExpress) {
  const auto refused = [&](const Words& more) {
    Words words{"shadertoy", "-o", path("out")};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 2);
    EXPECT_FALSE(exists("out"));
    return ended.err;
  };
  const std::string colours = refused({"cs184"});
  EXPECT_SAYS(colours, "flock.fish.colour.averaging: a shader's colours don't drift");
  EXPECT_SAYS(colours, "flock.fish.colour.noise: a shader's colours don't drift");
  EXPECT_SAYS(colours, "flock.fish.colour.start: a shader's flock has one colour");
  EXPECT_SAYS(refused({"ucsd", "--set", "flock.birds.arbitration=budget"}), "flock.birds.arbitration: ");
  EXPECT_SAYS(refused({"ucsd", "--set", "flock.birds.separation.sample=0.5"}),
              "flock.birds.separation.sample: ");
  EXPECT_SAYS(refused({"ucsd", "--count", "5000"}), "at most 4096 boids, here are 5000");
  write("events.toml",
        "run = { events = [[5, \"set\", \"flock.boids.max_speed\", 2]] }\n[[flock]]\ncount = 10\n");
  EXPECT_SAYS(refused({path("events.toml")}), "run.events: a shader has no events");
  write("state.csv", "id,flock,x,y,vx,vy\n0,0,1,1,1,1\n");
  write("file.toml", "[[flock]]\ncount = 1\nstart = { file = \"state.csv\" }\n");
  EXPECT_SAYS(refused({path("file.toml")}), "flock.boids.start.file: a shader can't read boids from a file");
}

TEST_F(Shadertoy, BakesAtMostThreeHundredBoidsUnlessTold) {
  const auto count = [&](const Words& more) {
    Words words{"shadertoy", "-o", path("out")};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::string text = read("out/common.glsl");
    const auto at = text.find("const int COUNT = ");
    return std::make_pair(text.substr(at + 18, text.find(';', at) - at - 18), ended.err);
  };
  EXPECT_EQ(count({"ucsd"}).first, "300");
  EXPECT_SAYS(count({"ucsd"}).second, "300 boids instead of 1000");
  EXPECT_EQ(count({"ucsd", "--count", "700"}), std::make_pair(std::string("700"), std::string()));
  EXPECT_EQ(count({"ucsd", "--set", "flock.birds.count=20"}).first, "20");
  EXPECT_EQ(count({"two-flocks"}).first, "300");
}

TEST_F(Shadertoy, BakesTheScenariosNumbers) {
  run_well({"shadertoy", "ucsd", "-o", path("out"), "--set", "flock.birds.cohesion.weight=0.0625", "--set",
            "flock.birds.max_speed=12.5"});
  const std::string text = read("out/common.glsl");
  EXPECT_SAYS(text, "12.5");
  EXPECT_SAYS(text, "0.0625");
  EXPECT_SAYS(text, "WORLD_IS_WINDOW = true");
  run_well({"shadertoy", "ucsd", "-o", path("out"), "--world", "scenario"});
  EXPECT_SAYS(read("out/common.glsl"), "WORLD_IS_WINDOW = false");
}

TEST_F(Shadertoy, AnUnwritableFolderIsASentence) {
  write("file", "");
  const Ended ended = run({"shadertoy", "ucsd", "-o", path("file/out")});
  EXPECT_EQ(ended.code, 1);
  EXPECT_SAYS(ended.err, "file/out");
}

// ---- the shaders against their transcript ----

struct Played {
  const char* scenario;
  std::int64_t count;  // of the first flock; 0: the scenario's
  bool world_is_window;
  bool pressed;
  double allowed;  // in the scenario's length: 1e-3 of a pixel at 720 pixels
};

void PrintTo(const Played& played, std::ostream* out) {
  *out << played.scenario << (played.pressed ? " with the mouse" : "");
}

class ShaderAgainstTranscript : public Shadertoy, public testing::WithParamInterface<Played> {};

TEST_P(ShaderAgainstTranscript, AHundredFrames) {
  constexpr int frames = 100;
  const Played& played = GetParam();
  const auto scenario = scenario_of(played.scenario, played.count);
  Inputs inputs;
  inputs.world_is_window = played.world_is_window;
  inputs.pressed = played.pressed;
  inputs.mouse = {400, 500};
  Words shadertoy{played.scenario};
  if (played.count > 0)
    shadertoy.insert(shadertoy.end(), {"--set", "flock." + scenario.flocks[0].name +
                                                    ".count=" + std::to_string(played.count)});
  play_scenario(shadertoy, played.pressed ? Words{"--mouse", "400,500"} : Words{}, frames);
  if (HasFatalFailure()) return;

  std::vector<Boid> flock = start(scenario, inputs);
  double largest = 0;
  for (int frame = 0; frame <= frames; ++frame) {
    if (frame > 0) flock = next(scenario, inputs, flock, frame);
    const sturnus::State shader = state(frame);
    ASSERT_EQ(shader.size(), flock.size());
    const auto extent = extent_of(scenario);
    const bool wraps = scenario.space.boundary.kind == sturnus::BoundaryKind::wrap;
    for (std::size_t i = 0; i < flock.size(); ++i) {
      const float mine[] = {flock[i].position.x, flock[i].position.y, flock[i].position.z};
      for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
        const double world = wraps ? extent.max[axis] - extent.min[axis] : 0;
        const double difference = apart(component(shader.position, axis, i), double{mine[axis]}, world);
        ASSERT_TRUE(difference <= played.allowed)
            << "frame " << frame << ", boid " << i << ", axis " << axis << ": " << difference;
        largest = std::max(largest, difference);
      }
    }
  }
  std::printf("%s%s: %d frames, largest difference %.2g (allowed %.2g)\n", played.scenario,
              played.pressed ? " with the mouse" : "", frames, largest, played.allowed);
}

INSTANTIATE_TEST_SUITE_P(
    Scenarios, ShaderAgainstTranscript,
    testing::Values(Played{"ucsd", 300, true, false, 1e-3}, Played{"ucsd-predator", 0, true, false, 1e-3},
                    Played{"ucsd-predator", 0, true, true, 1e-3}, Played{"ucsd-3d", 0, false, false, 1e-3},
                    Played{"quadtree", 200, true, false, 1e-3}, Played{"two-flocks", 150, true, false, 1e-3},
                    Played{"vuw-core", 200, false, false, 1e-4}));

// ---- one frame against one step of the engine ----

class ShaderAgainstEngine : public Shadertoy, public testing::WithParamInterface<const char*> {
 protected:
  // The engine's one step from a state that the shader had.
  static sturnus::State stepped(sturnus::ScenarioDef scenario, const sturnus::State& from) {
    scenario.run.initial = "state";
    sturnus::SimulationOptions options;
    options.threads = 1;
    options.tables["state"] = from;
    auto flock = sturnus::Simulation::create(scenario, options);
    EXPECT_TRUE(flock) << flock.error();
    flock->step();
    return flock->view().state();
  }
};

double distance(const sturnus::State& state, std::size_t i, std::size_t j) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double o = component(state.position, axis, i) - component(state.position, axis, j);
    squared += o * o;
  }
  return std::sqrt(squared);
}

std::vector<double> radii(const sturnus::FlockDef& flock) {
  std::vector<double> out;
  for (const auto& term : flock.separation) out.push_back(term.radius);
  for (const auto& term : flock.alignment) out.push_back(term.radius);
  for (const auto& term : flock.cohesion) out.push_back(term.radius);
  for (const auto& term : flock.flee) out.push_back(term.radius);
  return out;
}

// Whether some neighbour is so near to a radius that rounding decides who counts.
bool is_on_a_radius(const sturnus::State& state, std::size_t i, const std::vector<double>& all) {
  for (std::size_t j = 0; j < state.size(); ++j) {
    const double d = distance(state, i, j);
    for (const double radius : all) {
      if (i != j && std::abs(d - radius) <= 1e-6 * radius) return true;
    }
  }
  return false;
}

TEST_P(ShaderAgainstEngine, EveryFrameIsAStep) {
  constexpr int frames = 100;
  const auto scenario = scenario_of(GetParam());
  const bool is_ucsd = std::string(GetParam()) == "ucsd";
  play_scenario({GetParam()}, {}, frames);
  if (HasFatalFailure()) return;

  double largest = 0;
  std::size_t exempt = 0, compared = 0;
  sturnus::State before = state(0);
  ASSERT_EQ(before.size(), 300u);
  ASSERT_TRUE(is_ucsd || before.size() == static_cast<std::size_t>(scenario.boid_count()));
  for (int frame = 1; frame <= frames; ++frame) {
    const sturnus::State after = state(frame);
    const sturnus::State engine = stepped(scenario, before);
    for (std::size_t slot = 0; slot < engine.size(); ++slot) {
      const auto i = static_cast<std::size_t>(engine.id[slot]);
      const sturnus::FlockDef& flock = scenario.flocks[engine.flock[slot]];
      if (flock.wander) continue;  // strays by other random numbers
      ++compared;
      if (is_on_a_radius(before, i, radii(flock))) {
        ++exempt;
        continue;
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double difference =
            std::abs(component(engine.position, axis, slot) - component(after.position, axis, i));
        ASSERT_TRUE(difference <= 1e-3) << "frame " << frame << ", boid " << i << ": " << difference;
        largest = std::max(largest, difference);
      }
    }
    before = after;
  }
  EXPECT_GE(compared, 299u * frames);
  EXPECT_LE(static_cast<double>(exempt), 0.005 * static_cast<double>(compared));
  std::printf("%s: %d frames, largest difference %.2g px, exempt %.4f %%\n", GetParam(), frames, largest,
              100.0 * static_cast<double>(exempt) / static_cast<double>(compared));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShaderAgainstEngine, testing::Values("ucsd", "ucsd-predator", "ucsd-3d"));

}  // namespace
}  // namespace program_test
