// The Shadertoy flock: the shipped tabs are current, what a shader can't express is refused, the shaders do
// what their transcript does, and one step of the engine does what one frame does.
#include <sturnus/files.h>
#include <sturnus/parameters.h>
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
  EXPECT_EQ(count({"ucsd", "--count", "700"}).first, "700");
  EXPECT_SAYS(count({"ucsd", "--count", "700"}).second, "700 boids: every pixel looks at each of them");
  EXPECT_EQ(count({"ucsd", "--count", "200"}).second, "");
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

TEST_F(Shadertoy, TellsTheCommandThatMakesTheTabsAgain) {
  run_well(
      {"shadertoy", "ucsd", "-o", path("out"), "--count", "20", "--set", "space.boundary.margin=[100, 80]"});
  EXPECT_SAYS(read("out/common.glsl"),
              "// Written by: sturnus shadertoy ucsd --count 20 --set 'space.boundary.margin=[100, 80]'\n");
}

TEST_F(Shadertoy, SpaceIsNotAWindow) {
  const Ended ended = run({"shadertoy", "vuw-core", "-o", path("out"), "--world", "window"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_SAYS(ended.err, "space.dimensions: a space of three dimensions can't be the window");
}

// Another flock pasted over one that flies must not take its texels for its own.
TEST_F(Shadertoy, AnotherFlockBeginsAnew) {
  run_well({"shadertoy", "ucsd", "-o", path("shaders"), "--count", "50"});
  ASSERT_EQ(play({path("shaders"), "--frames", "0", "--state", path("first.csv")}).code, 0);
  const std::string own = read("shaders/buffer_a.glsl");
  write("shaders/buffer_a.glsl", "#define mainImage own\n" + own +
                                     "\n#undef mainImage\nvoid mainImage(out vec4 c, in vec2 at) {\n"
                                     "  if (iFrame == 0) c = vec4(1.0);\n  else own(c, at);\n}\n");
  ASSERT_EQ(play({path("shaders"), "--frames", "1", "--state", path("anew.csv")}).code, 0);
  EXPECT_EQ(read("anew.csv"), read("first.csv"));
}

TEST_F(Shadertoy, FlocksStartWhereTheScenarioSays) {
  const auto started = [&](const std::string& start, const Words& more) {
    write("start.toml",
          "[space]\nmin = [0, 0]\nmax = [960, 540]\nboundary = \"open\"\n[[flock]]\ncount = 200\nstart = " +
              start + "\n");
    run_well({"shadertoy", path("start.toml"), "-o", path("shaders")});
    Words words{path("shaders"), "--frames", "0", "--state", path("start.csv")};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(play(words).code, 0);
    return *sturnus::read_state_csv(path("start.csv"));
  };
  const auto expect_ring = [](const sturnus::State& state, double x, double y, double inner, double outer) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      const double r = std::hypot(component(state.position, 0, i) - x, component(state.position, 1, i) - y);
      EXPECT_TRUE(r >= inner - 1e-2 && r <= outer + 1e-2) << i << " at " << r;
    }
  };
  const Words small{"--size", "400x224"};
  expect_ring(started("{ region = \"ball\", radius = 30, speed = [1, 1] }", small), 200, 112, 0, 30);
  expect_ring(
      started("{ region = \"ring\", radius = 30, inner = 20, centre = [100, 50], speed = [1, 1] }", small),
      100, 50, 20, 30);
  const sturnus::State box = started(
      "{ region = \"box\", min = [100, 100], max = [200, 120], speed = [2, 3], heading = [3, 4] }", small);
  for (std::size_t i = 0; i < box.size(); ++i) {
    EXPECT_TRUE(box.position[0][i] >= 100 && box.position[0][i] <= 200);
    EXPECT_TRUE(box.position[1][i] >= 100 && box.position[1][i] <= 120);
    EXPECT_NEAR(box.velocity[1][i] / box.velocity[0][i], 4.0 / 3.0, 1e-5);
    EXPECT_TRUE(box.velocity[0][i] >= 1.199f && box.velocity[0][i] <= 1.801f);
  }
}

TEST_F(Shadertoy, NumbersThatCannotBeReckonedWithSpoilNobody) {
  write("far.toml",
        "[[flock]]\ncount = 20\nmax_speed = inf\nstart = { region = \"space\", speed = [1e30, 1e30] }\n");
  run_well({"shadertoy", path("far.toml"), "-o", path("shaders")});
  ASSERT_EQ(play({path("shaders"), "--frames", "3", "--state", path("far.csv")}).code, 0);
  EXPECT_EQ(read("far.csv").find("nan"), std::string::npos);
  EXPECT_EQ(read("far.csv").find("inf"), std::string::npos);
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

struct Case {
  const char* scenario;
  std::vector<const char*> set;  // what differs from the shipped one
  int frames = 10;
  bool pressed = false;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.scenario;
  for (const char* pair : one.set) *out << " " << pair;
}

class ShaderAgainstEngine : public Shadertoy, public testing::WithParamInterface<Case> {
 protected:
  // The engine's one step from a state that the shader had.
  static sturnus::State stepped(sturnus::ScenarioDef scenario, const sturnus::State& from, bool pressed) {
    scenario.run.initial = "state";
    sturnus::SimulationOptions options;
    options.threads = 1;
    options.tables["state"] = from;
    auto flock = sturnus::Simulation::create(scenario, options);
    EXPECT_TRUE(flock) << flock.error();
    if (pressed) {
      EXPECT_TRUE(flock->push(sturnus::MovePointer{sturnus::PointerMode::attract, {400, 500}, true}));
    }
    flock->step();
    return flock->view().state();
  }
};

// What rounding may decide: a neighbour at a radius, or at the edge of the field of view.
class Doubts {
 public:
  Doubts(const sturnus::ScenarioDef& scenario, const sturnus::FlockDef& flock, const sturnus::State& state)
      : state_(state), extent_(extent_of(scenario)) {
    wraps_ = scenario.space.boundary.kind == sturnus::BoundaryKind::wrap;
    view_ = flock.field_of_view;
    gather(flock.separation);
    gather(flock.alignment);
    gather(flock.cohesion);
    for (const auto& term : flock.flee) radii_.push_back(term.radius);
  }

  bool about(std::size_t i) const {
    for (std::size_t j = 0; j < state_.size(); ++j) {
      if (i != j && is_doubtful(i, j)) return true;
    }
    return false;
  }

 private:
  template <class Term>
  void gather(const std::vector<Term>& terms) {
    for (const Term& term : terms) {
      radii_.push_back(term.radius);
      if (term.inner > 0) radii_.push_back(term.inner);
    }
  }

  bool is_doubtful(std::size_t i, std::size_t j) const {
    double squared = 0, along = 0, speed_squared = 0;
    for (std::size_t axis = 0; axis < extent_.min.size(); ++axis) {
      double o = component(state_.position, axis, j) - component(state_.position, axis, i);
      const double size = extent_.max[axis] - extent_.min[axis];
      if (wraps_) o -= size * std::round(o / size);
      const double v = component(state_.velocity, axis, i);
      squared += o * o;
      along += v * o;
      speed_squared += v * v;
    }
    const double d = std::sqrt(squared);
    for (const double radius : radii_) {
      if (std::isfinite(radius) && std::abs(d - radius) <= 1e-6 * radius) return true;
    }
    const double cosine = std::cos(view_ / 360 * 3.14159265358979324);
    const double scale = std::sqrt(speed_squared) * d;
    return view_ < 360 && std::abs(along - cosine * scale) <= 1e-6 * scale;
  }

  const sturnus::State& state_;
  sturnus::Extent extent_;
  bool wraps_;
  double view_;
  std::vector<double> radii_;
};

bool is_random(const sturnus::FlockDef& flock) {
  return flock.wander || (flock.noise && (flock.noise->acceleration > 0 || flock.noise->turn > 0));
}

TEST_P(ShaderAgainstEngine, EveryFrameIsAStep) {
  const Case& one = GetParam();
  auto scenario = scenario_of(one.scenario);
  if (scenario.flocks.size() == 1) scenario.flocks[0].count = 300;
  Words words{one.scenario, "--world", one.pressed ? "window" : "scenario"};
  if (scenario.flocks.size() == 1) words.insert(words.end(), {"--count", "300"});
  for (const char* pair : one.set) {
    const std::string text = pair;
    const auto equals = text.find('=');
    ASSERT_TRUE(
        set_parameter(scenario, text.substr(0, equals), sturnus::parse_value(text.substr(equals + 1))))
        << pair;
    words.insert(words.end(), {"--set", text});
  }
  // A fitted world does not depend on the size of the picture, and a small one is quickly drawn.
  play_scenario(words, one.pressed ? Words{"--mouse", "400,500"} : Words{"--size", "64x64"}, one.frames);
  if (HasFatalFailure()) return;

  const auto extent = extent_of(scenario);
  const double pixel = (extent.max[1] - extent.min[1]) / 720;
  const bool wraps = scenario.space.boundary.kind == sturnus::BoundaryKind::wrap;
  double largest = 0;
  std::size_t exempt = 0, compared = 0;
  sturnus::State before = state(0);
  ASSERT_EQ(before.size(), static_cast<std::size_t>(scenario.boid_count()));
  for (int frame = 1; frame <= one.frames; ++frame) {
    const sturnus::State after = state(frame);
    const sturnus::State engine = stepped(scenario, before, one.pressed);
    for (std::size_t slot = 0; slot < engine.size(); ++slot) {
      const auto i = static_cast<std::size_t>(engine.id[slot]);
      const sturnus::FlockDef& flock = scenario.flocks[engine.flock[slot]];
      if (is_random(flock)) continue;  // strays by other random numbers
      ++compared;
      if (Doubts(scenario, flock, before).about(i)) {
        ++exempt;
        continue;
      }
      for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
        const double difference =
            apart(component(engine.position, axis, slot), component(after.position, axis, i),
                  wraps ? extent.max[axis] - extent.min[axis] : 0) /
            pixel;
        ASSERT_TRUE(difference <= 1e-3) << "frame " << frame << ", boid " << i << ": " << difference;
        largest = std::max(largest, difference);
      }
    }
    before = after;
  }
  EXPECT_GE(compared, 299u * static_cast<unsigned>(one.frames));
  EXPECT_LE(static_cast<double>(exempt), 0.005 * static_cast<double>(compared));
  std::printf("%s: %d frames, largest difference %.2g px, exempt %.4f %%\n",
              testing::PrintToString(one).c_str(), one.frames, largest,
              100.0 * static_cast<double>(exempt) / static_cast<double>(compared));
}

constexpr const char* quiet = "flock.birds.noise.acceleration=0";

INSTANTIATE_TEST_SUITE_P(
    Scenarios, ShaderAgainstEngine,
    testing::Values(Case{"ucsd", {}, 100}, Case{"ucsd-predator", {}, 100}, Case{"ucsd-3d", {}, 100},
                    Case{"ucsd-predator", {}, 10, true},
                    Case{"ucsd-predator", {"pointer.form=seek", "flock.birds.flee.form=seek"}, 10, true},
                    Case{"ucsd-predator",
                         {"pointer.form=linear", "pointer.radius=300", "flock.birds.flee.form=linear"},
                         10,
                         true},
                    Case{"prog06", {}}, Case{"parker", {}}, Case{"vuw-core", {}}, Case{"quadtree", {quiet}},
                    Case{"ucsd", {"space.boundary.kind=bounce", "flock.birds.max_acceleration=0.3"}},
                    Case{"ucsd",
                         {"space.boundary.kind=wrap", "time.dt=0.5", "time.integrator=explicit-euler"}},
                    Case{"ucsd-3d", {"space.boundary.kind=bounce", "flock.birds.field_of_view=200"}},
                    Case{"ucsd",
                         {"flock.birds.separation.strength=1", "flock.birds.separation.combine=sum",
                          "flock.birds.separation.edge=closed", "flock.birds.alignment.match=heading",
                          "flock.birds.alignment.relative=false", "flock.birds.alignment.count_self=true",
                          "flock.birds.cohesion.strength=1/d", "flock.birds.cohesion.ring=[30, 150]",
                          "flock.birds.cohesion.count_self=true"}}));

}  // namespace
}  // namespace program_test
