// The commands that explain and check: list, show, keys, new, check; help, and words that nobody expected.
#include <algorithm>
#include <regex>
#include <sstream>

#include "apps/program.h"

namespace program_test {
namespace {

class Commands : public ProgramTest {};

const Words all_commands = {"run", "render", "list",  "show",    "keys",
                            "new", "check",  "bench", "explain", "compare"};

TEST_F(Commands, WithoutWordsThereAreThreeThingsToTry) {
  const Ended ended = run_well({});
  EXPECT_SAYS(ended.out, "Three things to try");
  EXPECT_SAYS(ended.out, "sturnus run ucsd");
  EXPECT_SAYS(ended.out, "sturnus render murmuration -o birds.mp4");
  EXPECT_SAYS(ended.out, "sturnus new my.toml --from ucsd");
  EXPECT_LT(line_count(ended.out), 12u);
  EXPECT_EQ(ended.err, "");
}

TEST_F(Commands, VersionIsOneLine) {
  const Ended ended = run_well({"--version"});
  EXPECT_TRUE(std::regex_match(ended.out, std::regex("sturnus [0-9]+\\.[0-9]+\\.[0-9]+\n"))) << ended.out;
}

TEST_F(Commands, HelpNamesEveryCommandAndTheExitCodes) {
  const Ended ended = run_well({"--help"});
  for (const std::string& command : all_commands) EXPECT_SAYS(ended.out, "\n  " + command + " ");
  EXPECT_SAYS(ended.out,
              "0 done, 1 failed while running, 2 bad usage or input, 3 compared files differ, 130");
}

TEST_F(Commands, HelpOfEveryCommandHasExamples) {
  for (const std::string& command : all_commands) {
    const Ended ended = run_well({command, "--help"});
    EXPECT_SAYS(ended.out, "Usage: sturnus " + command);
    EXPECT_SAYS(ended.out, "Examples:\n  sturnus " + command);
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
  }
}

TEST_F(Commands, HelpShowsEveryOption) {
  const std::string run_help = run_well({"run", "--help"}).out;
  for (const char* option :
       {"--steps", "--count", "--seed", "--threads", "--index all-pairs|grid|tree", "--set key=value",
        "--initial", "--first-step", "--final", "--measures", "--plot", "-o,", "--json", "--quiet",
        "--path auto|dense|sparse", "--isa best|scalar|sse4|avx2|avx512|neon"}) {
    EXPECT_SAYS(run_help, option);
  }
  const std::string render_help = run_well({"render", "--help"}).out;
  for (const char* option :
       {"-o,", "--steps", "--fps", "--size WxH", "--every", "--trails", "--show index|velocities|vectors",
        "--boid", "--zoom", "--sheet", "--theme dark|light", "--no-caption", "--count", "--seed", "--set",
        "--threads", "--index", "--initial"}) {
    EXPECT_SAYS(render_help, option);
  }
}

TEST_F(Commands, ListHasALineForEveryScenario) {
  const Ended ended = run_well({"list"});
  for (const char* group : {"courses\n", "gallery\n", "steering\n", "bench\n"}) EXPECT_SAYS(ended.out, group);
  const std::vector<std::string> names = shipped_names(ended.out);
  for (const char* name : {"ucsd", "prog06", "vuw-core", "quadtree", "cs184", "parker", "adams", "two-flocks",
                           "murmuration", "bench-2d", "bench-3d"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
  EXPECT_SAYS(ended.out, "UCSD boids: ");
}

// "The effective scenario, as TOML that loads again": the same text again, and the same run.
TEST_F(Commands, ShowIsAFixedPointWithTheSameHashForEveryScenario) {
  for (const std::string& name : shipped_names(run_well({"list"}).out)) {
    const std::string shown = run_well({"show", name}).out;
    EXPECT_TRUE(shown.starts_with("# " + name + ":")) << shown.substr(0, 80);
    write(name + ".toml", shown);
    EXPECT_EQ(run_well({"show", name + ".toml"}).out, shown) << name;
    const std::string hash = hash_in(run_well({"run", name, "--steps", "3"}).out);
    EXPECT_EQ(hash.size(), 16u);
    EXPECT_EQ(hash_in(run_well({"run", name + ".toml", "--steps", "3"}).out), hash) << name;
  }
}

TEST_F(Commands, ShowAppliesOptions) {
  const std::string shown =
      run_well({"show", "ucsd", "--set", "flock.birds.max_speed=12", "--seed", "99", "--count", "77",
                "--steps", "55", "--index", "tree", "--first-step", "5", "--initial", "s.csv"})
          .out;
  for (const char* line : {"max_speed = 12\n", "seed = 99\n", "count = 77\n", "steps = 55\n",
                           "kind = \"tree\"\n", "first_step = 5\n", "initial = \"s.csv\"\n"}) {
    EXPECT_SAYS(shown, line);
  }
}

TEST_F(Commands, KeysExplainsEveryParameter) {
  const Ended ended = run_well({"keys"});
  for (const char* path :
       {"\nseed\n", "\nspace.dimensions\n", "\nflock.NAME.separation.weight\n", "\nindex.kind\n"}) {
    EXPECT_SAYS(ended.out, path);
  }
  EXPECT_SAYS(run_well({"keys", "turn"}).out, "unit: degrees; range: 0 to 360");
  EXPECT_SAYS(run_well({"keys", "separation.strength"}).out, "source: UCSD");
  EXPECT_SAYS(run_well({"keys", "time.integrator"}).out, "formula: ");
}

// The paths in the output of `keys`: lines that do not begin with a space.
std::set<std::string> paths_in(const std::string& text) {
  std::set<std::string> paths;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != ' ') paths.insert(line);
  }
  return paths;
}

TEST_F(Commands, KeysFindsByPartByWildcardAndByPath) {
  const auto found = [&](const std::string& pattern) { return paths_in(run_well({"keys", pattern}).out); };
  EXPECT_TRUE(found("radius").contains("flock.NAME.flee.radius"));
  EXPECT_EQ(found("COHESION.radius"), std::set<std::string>{"flock.NAME.cohesion.radius"});
  EXPECT_TRUE(found("flock.*.weight").contains("flock.NAME.flee.weight"));
  EXPECT_FALSE(found("flock.*.weight").contains("pointer.weight"));
  EXPECT_TRUE(found("*.weight").contains("pointer.weight"));
  EXPECT_EQ(found("s??d"), std::set<std::string>{"seed"});
}

TEST_F(Commands, KeysTakesAPathWithAFlocksName) {
  EXPECT_EQ(paths_in(run_well({"keys", "flock.birds.separation.radius"}).out),
            std::set<std::string>{"flock.NAME.separation.radius"});
}

TEST_F(Commands, KeysSaysWhatWasMeant) {
  const Ended ended = run({"keys", "cohesoin"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_SAYS(ended.err, "no key matches \"cohesoin\"; did you mean cohesion?");
  EXPECT_EQ(line_count(ended.err), 1u);
}

TEST_F(Commands, KeysMakesTheReferenceDocument) {
  const std::string text = run_well({"keys", "--markdown"}).out;
  EXPECT_TRUE(text.starts_with("# Scenario keys\n")) << text.substr(0, 80);
  EXPECT_SAYS(text, "\n## `flock.NAME.separation`\n");
  EXPECT_SAYS(text, "| `weight` | number |");
  EXPECT_SAYS(text, "\"open\" \\| \"closed\"");
  const std::size_t paths = paths_in(run_well({"keys"}).out).size();
  std::size_t rows = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) continue;
    if (line.starts_with("| `")) ++rows;
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
      bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    EXPECT_EQ(bars, 8u) << line;
  }
  EXPECT_EQ(rows, paths);
}

TEST_F(Commands, NewCopiesAScenarioWithItsComments) {
  const Ended ended = run_well({"new", "my.toml", "--from", "ucsd"});
  EXPECT_SAYS(ended.out, "wrote my.toml; try: sturnus run my.toml");
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(read("my.toml").starts_with("# "));
  EXPECT_EQ(run_well({"show", "my.toml"}).out.substr(2 + 2), run_well({"show", "ucsd"}).out.substr(2 + 4));
  run_well({"new", "again.toml", "--from", "my.toml"});
  EXPECT_EQ(read("again.toml"), read("my.toml"));
}

TEST_F(Commands, NewReplacesOnlyWhenForced) {
  write("my.toml", "mine");
  const Ended refused = run({"new", "my.toml", "--from", "ucsd"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_SAYS(refused.err, "my.toml: the file is there already; --force replaces it");
  EXPECT_EQ(read("my.toml"), "mine");
  run_well({"new", "my.toml", "--from", "ucsd", "--force"});
  EXPECT_NE(read("my.toml"), "mine");
}

TEST_F(Commands, NewTakesTheNameAsItIs) {
  const Ended ended = run_well({"new", "ucsd", "--from", "parker"});
  EXPECT_TRUE(exists("ucsd"));
  EXPECT_SAYS(ended.err, "without .toml");
  EXPECT_SAYS(ended.out, "sturnus run ./ucsd");  // the bare name is the shipped scenario's
}

TEST_F(Commands, NewFailsWithASentence) {
  const Ended unknown = run({"new", "my.toml", "--from", "uscd"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_SAYS(unknown.err, "did you mean \"ucsd\"?");
  const Ended nowhere = run({"new", "no/my.toml", "--from", "ucsd"});
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_SAYS(nowhere.err, "no/my.toml: cannot be written");
  EXPECT_TRUE(files().empty());
}

TEST_F(Commands, CheckSaysOkForEveryShippedScenario) {
  Words words = {"check"};
  const std::vector<std::string> names = shipped_names(run_well({"list"}).out);
  words.insert(words.end(), names.begin(), names.end());
  const Ended ended = run_well(words);
  for (const std::string& name : names) EXPECT_SAYS(ended.out, name + ": ok\n");
  EXPECT_EQ(ended.err, "");
}

TEST_F(Commands, CheckSaysAllProblemsAtOnceWithTheirLines) {
  write("bad.toml",
        "[[flock]]\nmin_speed = 5\nmax_speed = 4\ncount = 1.5\nfoo = 1\n[space]\ndimensions = 4\n");
  write("good.toml", "[[flock]]\ncount = 3\n");
  const Ended ended = run({"check", "bad.toml", "good.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "good.toml: ok\n");
  EXPECT_SAYS(ended.err, "bad.toml:3: flock.boids.max_speed: 4 is below min_speed 5\n");
  EXPECT_SAYS(ended.err, "bad.toml:4: flock.boids.count: ");
  EXPECT_SAYS(ended.err, "bad.toml:5: flock.boids.foo: ");
  EXPECT_SAYS(ended.err, "bad.toml:7: space.dimensions: ");
  EXPECT_EQ(line_count(ended.err), 4u);
}

TEST_F(Commands, CheckReadsTheStateFilesToo) {
  write("s.toml", "[[flock]]\nstart = { file = \"s.csv\" }\n");
  EXPECT_SAYS(run({"check", "s.toml"}).err, "s.csv: cannot be read");
  write("s.csv", "id,flock,x,y,vx,vy\n0,0,1,2,3,x\n");
  const Ended ended = run({"check", "s.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_SAYS(ended.err, "s.csv:2: vy: ");
}

struct Mistake {
  Words words;
  std::string sentence;
};

TEST_F(Commands, UnexpectedAndMissingWordsGetOneSentence) {
  const std::vector<Mistake> mistakes = {
      {{"rnu", "ucsd"}, "unknown command \"rnu\"; did you mean run?"},
      {{"rendr", "ucsd", "-o", "x.png"}, "unknown command \"rendr\"; did you mean render?"},
      {{"xyzzy"}, "unknown command \"xyzzy\" (sturnus --help lists them)"},
      {{"ucsd"}, "\"ucsd\" is a scenario, not a command; try: sturnus run ucsd"},
      {{"--verson"}, "unknown option \"--verson\"; did you mean --version?"},
      {{"--steps", "3", "run", "ucsd"}, "\"--steps\" comes after the command"},
      {{"run"}, "sturnus run needs SCENARIO; for example: sturnus run ucsd"},
      {{"run", "--hepl"}, "sturnus run: unknown option \"--hepl\"; did you mean --help?"},
      {{"run", "ucsd", "--stpes", "3"}, "unknown option \"--stpes\"; did you mean --steps?"},
      {{"run", "ucsd", "--stpes=3"}, "unknown option \"--stpes\"; did you mean --steps?"},
      {{"run", "ucsd", "-x"}, "unknown option \"-x\""},
      {{"run", "ucsd", "parker"}, "\"parker\" is one word too many"},
      {{"run", "ucsd", "--steps"}, "--steps needs a value"},
      {{"run", "ucsd", "--set"}, "--set needs a value"},
      {{"render", "ucsd"}, "sturnus render needs --output; for example: sturnus render ucsd -o flock.png"},
      {{"show"}, "sturnus show needs SCENARIO"},
      {{"new"}, "sturnus new needs FILE"},
      {{"new", "my.toml"}, "sturnus new needs --from"},
      {{"check"}, "sturnus check needs FILE"},
      {{"list", "all"}, "\"all\" is one word too many"},
      {{"keys", "a", "b"}, "\"b\" is one word too many"},
      {{"show", "uscd"}, "no file \"uscd\"; did you mean \"ucsd\"?"},
      {{"check", "no.toml"}, "no.toml: cannot be read: No such file"},
  };
  for (const Mistake& mistake : mistakes) {
    expect_refusal(mistake.words, mistake.sentence);
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Commands, AFullDiskUnderStandardOutputIsAFailure) {
  for (const Words& words : {Words{"list"}, Words{"keys"}, Words{"show", "ucsd"}, Words{"--help"}, Words{}}) {
    StartOptions options;
    options.output = "/dev/full";
    const Ended ended = run(words, options);
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.err, "the standard output cannot be written: No space left on device\n");
  }
}

TEST_F(Commands, AReaderWhoGoesAwayEndsItQuietly) {
  StartOptions options;
  options.closed_output = true;
  const Ended ended = run({"keys"}, options);
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.err, "");
}

}  // namespace
}  // namespace program_test
