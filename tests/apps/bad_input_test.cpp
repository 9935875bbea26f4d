// Bad input: each case ends with 2 and says in one sentence which file, line and key is wrong, and leaves
// nothing.
#include "apps/program.h"

namespace program_test {
namespace {

class BadInput : public ProgramTest {};

struct BadScenario {
  const char* text;
  const char* sentence;
};

TEST_F(BadInput, Scenarios) {
  const std::vector<BadScenario> cases = {
      {"[[flock]]\ncount = 3\nmax_sped = 4\n",
       "s.toml:3: flock.boids.max_sped: there is no key \"max_sped\"; did you mean \"max_speed\"?"},
      {"sedd = 3\n[[flock]]\n", "s.toml:1: sedd: there is no key \"sedd\"; did you mean \"seed\"?"},
      {"[[flock]]\ncount = \"many\"\n",
       "s.toml:2: flock.boids.count: must be a whole number, but found \"many\""},
      {"[[flock]]\n\nmax_speed = [1, 2]\n",
       "s.toml:3: flock.boids.max_speed: must be a number, but found [1, 2]"},
      {"[[flock]]\nseparation = { radius = -4 }\n",
       "s.toml:2: flock.boids.separation.radius: must not be negative, but is -4"},
      {"[[flock]]\nseparation = { ring = [9, 4] }\n",
       "s.toml:2: flock.boids.separation.radius: must be [inner, outer] with the smaller first"},
      {"[[flock]]\ncohesion = { radius = inf }\n",
       "s.toml:2: flock.boids.cohesion.radius: an infinite radius means the whole population"},
      {"[[flock]]\nalignment = { radius = inf, field_of_view = 90 }\n",
       "s.toml:2: flock.boids.alignment.radius: an infinite radius"},
      {"[[flock]]\nmin_speed = 5\nmax_speed = 4\n",
       "s.toml:3: flock.boids.max_speed: 4 is below min_speed 5"},
      {"[[flock]]\ncount = -1\n", "s.toml:2: flock.boids.count: must not be negative, but is -1"},
      {"[[flock]]\nseparation = { strength = \"d2\" }\n",
       "s.toml:2: flock.boids.separation.strength: must be one of"},
      {"[[flock]\n", "s.toml:1: "},
      {"[[flock]]\nseparation = {\n radius = 3 }\n", "a term in braces { } stands on one line"},
      {"", "s.toml: flock: the file has no [[flock]]"},
      {"[run]\nevents = [[3, \"sett\", \"seed\", 1]]\n[[flock]]\n", "s.toml:2: run.events: "},
      {"[[flock]]\nstart = { file = \"boids.csv\" }\n",
       "boids.csv: cannot be read: No such file or directory"},
  };
  for (const BadScenario& bad : cases) {
    write("s.toml", bad.text);
    expect_refusal({"run", "s.toml", "--steps", "1", "--final", "f.csv", "--plot", "p.png", "-o", "dir"},
                   bad.sentence);
    expect_refusal({"render", "s.toml", "--steps", "1", "-o", "p.png"}, bad.sentence);
    expect_refusal({"check", "s.toml"}, bad.sentence);
  }
}

TEST_F(BadInput, CrossingMarginsAreAWarning) {
  write("s.toml",
        "[space]\nmin = [0, 0]\nmax = [100, 300]\nboundary = { kind = \"turn\", margin = 60, strength = 1 "
        "}\n[[flock]]\ncount = 9\n");
  const std::string warning =
      "s.toml:4: space.boundary.margin: warning: the margins of 60 cross on the x axis";
  const Ended checked = run_well({"check", "s.toml"});
  EXPECT_EQ(checked.out, "s.toml: ok, with 1 warning\n");
  EXPECT_SAYS(checked.err, warning);
  const Ended ended = run_well({"run", "s.toml", "--steps", "1", "--seed", "3"});
  EXPECT_SAYS(ended.err, warning);
  EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
}

TEST_F(BadInput, AWarningThatComesWithAnOptionIsToldToo) {
  const Ended ended =
      run_well({"run", "ucsd", "--count", "5", "--steps", "1", "--set", "space.boundary.margin=700"});
  EXPECT_SAYS(ended.err, "ucsd: space.boundary.margin: warning: the margins of 700 cross");
}

TEST_F(BadInput, StateFiles) {
  const std::vector<BadScenario> cases = {
      {"id,flock,x,y,vx,vy\n0,0,1,2,3,4\n1,0,1,2,nan,1\n", "s.csv:3: vx: "},
      {"id,flock,x,y,vx,vy\n0,0,inf,2,3,1\n", "s.csv:2: x: "},
      {"id,flock,x,y,vx,vy\n0,0,1,2,1\n", "s.csv:2: has 5 columns, but the header has 6"},
      {"id,flock,x,y,vx,vy\n0,0,1,2,1,1,1\n", "s.csv:2: has 7 columns, but the header has 6"},
      {"id,flock,x,y,vx,vy\n0,0,1,2,1,one\n", "s.csv:2: vy: must be a number, but found \"one\""},
      {"id,flok,x,y,vx,vy\n0,0,1,2,1,1\n", "s.csv:1: flok: there is no such column; did you mean \"flock\"?"},
      {"id,flock,x,y,z,vx,vy,vz\n0,0,1,2,3,1,1,1\n",
       "\"s.csv\" holds boids in 3 dimensions, but the space has 2"},
      {"id,flock,x,y,vx,vy\n0,7,1,2,3,1\n", "\"s.csv\" holds a boid of flock 7"},
      {"", "s.csv: the file is empty"},
  };
  for (const BadScenario& bad : cases) {
    write("s.csv", bad.text);
    expect_refusal({"run", "ucsd", "--steps", "1", "--initial", "s.csv", "--final", "f.csv", "-o", "dir"},
                   bad.sentence);
    expect_refusal({"render", "ucsd", "--steps", "1", "--initial", "s.csv", "-o", "p.png"}, bad.sentence);
  }
  expect_refusal({"run", "ucsd", "--initial", "no.csv"}, "no.csv: cannot be read: No such file or directory");
  expect_refusal({"run", "ucsd", "--initial", "."}, ".: cannot be read: it is a folder");
}

TEST_F(BadInput, MissingFiles) {
  expect_refusal({"run", "no.toml"}, "no.toml: cannot be read: No such file or directory");
  expect_refusal({"run", "no/such/dir"}, "no/such/dir: cannot be read: No such file or directory");
  expect_refusal({"run", "./"}, "./: cannot be read: it is a folder");
  expect_refusal({"run", "uscd"},
                 "there is no shipped scenario and no file \"uscd\"; did you mean \"ucsd\"?");
}

TEST_F(BadInput, Options) {
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"--steps", "abc"}, "--steps: must be a whole number, but is \"abc\""},
      {{"--steps", "1.5"}, "--steps: must be a whole number, but is \"1.5\""},
      {{"--steps", "-1"}, "--steps: must be at least 0, but is -1"},
      {{"--steps", ""}, "--steps: must be a whole number, but is \"\""},
      {{"--count", "-5"}, "--count: must be at least 0, but is -5"},
      {{"--count", "nan"}, "--count: must be a whole number"},
      {{"--seed", "1e30"}, "--seed: must be a whole number"},
      {{"--threads", "-2"}, "--threads: must be at least 0"},
      {{"--threads", "1e9"}, "--threads: must be at most 1024"},
      {{"--index", "tre"},
       "--index: must be one of all-pairs, grid, tree, but is \"tre\"; did you mean tree?"},
      {{"--set", "seed"}, "--set: write key=value, such as flock.NAME.max_speed=12, but found \"seed\""},
      {{"--set", "=3"}, "--set: write key=value"},
      {{"--set", "flock.birds.max_sped=3"}, "--set: flock.birds.max_sped: "},
      {{"--set", "flock.birds.max_sped=3"}, "did you mean \"max_speed\"?"},
      {{"--set", "flock.brids.max_speed=3"}, "did you mean \"birds\"?"},
      {{"--set", "sede=3"}, "did you mean \"seed\"?"},
      {{"--set", "flock.birds.separation.radius=-3"},
       "--set: flock.birds.separation.radius: must not be negative, but is -3"},
      {{"--set", "flock.birds.max_speed=fast"},
       "--set: flock.birds.max_speed: must be a number, but found \"fast\""},
      {{"--set", "flock.birds.max_speed=1"}, "ucsd: flock.birds.max_speed: 1 is below min_speed 5"},
      {{"--plot", "p.jpg"}, "--plot: \"p.jpg\" must end in .png or .ppm"},
      {{"--final", "x.csv", "--measures", "x.csv"}, "x.csv: two outputs have this name"},
  };
  for (const auto& [end, sentence] : cases) {
    Words words = {"run", "ucsd"};
    words.insert(words.end(), end.begin(), end.end());
    expect_refusal(words, sentence);
  }
}

TEST_F(BadInput, CountNeedsOneFlock) {
  expect_refusal(
      {"run", "two-flocks", "--count", "50"},
      "--count: there are 2 flocks; say which with --set flock.dawn.count=50 or --set flock.dusk.count=50");
}

// 40 thousand million boids: ten terabytes, which no machine that runs tests has.
TEST_F(BadInput, MoreBoidsThanMemoryIsSaidBeforeAllocating) {
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += "[[flock]]\nname = \"f" + std::to_string(i) + "\"\ncount = 1_000_000_000\n";
  write("s.toml", text);
  const std::string sentence = "s.toml: flock.count: 40000000000 boids need about ";
  expect_refusal({"run", "s.toml", "--final", "s.csv", "-o", "dir"}, sentence);
  expect_refusal({"render", "s.toml", "-o", "p.png"}, sentence);
}

}  // namespace
}  // namespace program_test
