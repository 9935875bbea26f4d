// sturnus run: what it prints and writes, and that runs repeat, continue and can be interrupted.
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "apps/program.h"

namespace program_test {
namespace {

class Run : public ProgramTest {
 protected:
  std::string hash_of(Words words) const {
    words.insert(words.begin(), "run");
    const std::string hash = hash_in(run_well(words).out);
    EXPECT_EQ(hash.size(), 16u);
    return hash;
  }
  nlohmann::json json_of(const std::string& text) const {
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    EXPECT_TRUE(json.is_object()) << text;
    return json;
  }
};

TEST_F(Run, EndsWithOneLine) {
  const Ended ended = run_well({"run", "ucsd", "--steps", "7", "--count", "50"});
  const std::regex line(
      "7 steps, 50 boids, [0-9]+\\.[0-9]{3} s, [0-9]+\\.[0-9] ns per boid and step, hash [0-9a-f]{16}\n");
  EXPECT_TRUE(std::regex_match(ended.out, line)) << ended.out;
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(files().empty());
}

TEST_F(Run, NothingToDoIsDoneAtOnce) {
  EXPECT_SAYS(run_well({"run", "ucsd", "--steps", "0"}).out,
              "0 steps, 1000 boids, 0.000 s, - ns per boid and step, hash ");
  EXPECT_SAYS(run_well({"run", "ucsd", "--steps", "1", "--count", "0"}).out, "1 step, 0 boids, ");
  EXPECT_SAYS(run_well({"run", "ucsd", "--steps", "2", "--count", "1"}).out, "2 steps, 1 boid, ");
}

TEST_F(Run, TheScenarioSaysHowLongWhenNobodyElseDoes) {
  write("short.toml", "[run]\nsteps = 12\n[[flock]]\ncount = 5\n");
  EXPECT_SAYS(run_well({"run", "short.toml"}).out, "12 steps, 5 boids");
}

TEST_F(Run, OptionsChangeTheRun) {
  const std::string plain = hash_of({"ucsd", "--steps", "5"});
  EXPECT_EQ(hash_of({"ucsd", "--steps", "5"}), plain);
  EXPECT_NE(hash_of({"ucsd", "--steps", "6"}), plain);
  EXPECT_NE(hash_of({"ucsd", "--steps", "5", "--seed", "4"}), plain);
  EXPECT_NE(hash_of({"ucsd", "--steps", "5", "--count", "999"}), plain);
  EXPECT_NE(hash_of({"ucsd", "--steps", "5", "--set", "flock.birds.max_speed=9"}), plain);
  EXPECT_NE(hash_of({"quadtree", "--steps", "5", "--first-step", "9"}),
            hash_of({"quadtree", "--steps", "5"}));
}

TEST_F(Run, OptionsMeanWhatTheKeysMean) {
  EXPECT_EQ(hash_of({"ucsd", "--steps", "5", "--seed", "4", "--count", "90"}),
            hash_of({"ucsd", "--set", "run.steps=5", "--set", "seed=4", "--set", "flock.birds.count=90"}));
  EXPECT_EQ(hash_of({"ucsd", "--steps", "5", "--index", "tree"}),
            hash_of({"ucsd", "--steps", "5", "--set", "index.kind=tree"}));
  EXPECT_EQ(hash_of({"two-flocks", "--steps", "1e1", "--set", "flock.dusk.separation.on=false"}),
            hash_of({"two-flocks", "--steps=10", "--set=flock.dusk.separation.on=false"}));
}

TEST_F(Run, TheLastOfTwoValuesCounts) {
  EXPECT_SAYS(run_well({"run", "ucsd", "--steps", "5", "--steps", "3"}).out, "3 steps, ");
  EXPECT_EQ(hash_of({"ucsd", "--steps", "2", "--set", "seed=1", "--set", "seed=2"}),
            hash_of({"ucsd", "--steps", "2", "--seed", "2"}));
}

TEST_F(Run, EveryIndexRuns) {
  for (const char* index : {"grid", "tree", "all-pairs"}) {
    EXPECT_EQ(hash_of({"ucsd", "--steps", "3", "--count", "100", "--index", index}).size(), 16u) << index;
  }
}

TEST_F(Run, FinalThenInitialContinuesBitForBit) {
  const std::string whole = hash_of({"ucsd", "--steps", "40"});
  const Ended first = run_well({"run", "ucsd", "--steps", "25", "--final", "s.csv"});
  EXPECT_EQ(first.err, "wrote s.csv (step 25); continue with --initial s.csv --first-step 25\n");
  EXPECT_EQ(hash_of({"ucsd", "--steps", "15", "--initial", "s.csv", "--first-step", "25"}), whole);
}

// quadtree has noise: its random numbers depend on the step, so that --first-step is needed.
TEST_F(Run, NoiseContinuesFromTheFirstStep) {
  const std::string whole = hash_of({"quadtree", "--steps", "40"});
  run_well({"run", "quadtree", "--steps", "25", "--final", "s.csv"});
  EXPECT_EQ(hash_of({"quadtree", "--steps", "15", "--initial", "s.csv", "--first-step", "25"}), whole);
  EXPECT_NE(hash_of({"quadtree", "--steps", "15", "--initial", "s.csv"}), whole);
}

TEST_F(Run, AStateThatWasReadIsWrittenAgainByteForByte) {
  for (const char* name : {"ucsd", "vuw-core", "two-flocks"}) {
    run_well({"run", name, "--steps", "5", "--final", "a.csv"});
    run_well({"run", name, "--steps", "0", "--initial", "a.csv", "--first-step", "5", "--final", "b.csv"});
    EXPECT_EQ(read("a.csv"), read("b.csv")) << name;
    EXPECT_TRUE(read("a.csv").starts_with(std::string(name) == "vuw-core" ? "id,flock,x,y,z,vx,vy,vz\n"
                                                                          : "id,flock,x,y,vx,vy\n"));
  }
}

// The scenario's own files lie beside it; the command line's where the caller stands.
TEST_F(Run, PathsAreRelativeToWhoNamesThem) {
  const std::string whole = hash_of({"ucsd", "--steps", "10"});
  run_well({"run", "ucsd", "--steps", "5", "--final", "s.csv"});
  std::filesystem::create_directory(path("deep"));
  run_well({"new", "deep/own.toml", "--from", "ucsd"});
  EXPECT_EQ(hash_of({"deep/own.toml", "--steps", "5", "--initial", "s.csv", "--first-step", "5"}), whole);
  std::filesystem::rename(path("s.csv"), path("deep/s.csv"));
  EXPECT_EQ(hash_of({"deep/own.toml", "--steps", "5", "--set", "run.initial=s.csv", "--first-step", "5"}),
            whole);
}

TEST_F(Run, ThreadsChangeNoBit) {
  for (const char* name : {"ucsd", "vuw-core", "murmuration", "quadtree"}) {
    std::string hash, measures, state;
    for (const char* threads : {"1", "2", "3"}) {
      const Ended ended = run_well(
          {"run", name, "--steps", "20", "--threads", threads, "--measures", "m.csv", "--final", "s.csv"});
      if (hash.empty()) {
        hash = hash_in(ended.out);
        measures = read("m.csv");
        state = read("s.csv");
      }
      EXPECT_EQ(hash_in(ended.out), hash) << name << " with " << threads;
      EXPECT_EQ(read("m.csv"), measures) << name << " with " << threads;
      EXPECT_EQ(read("s.csv"), state) << name << " with " << threads;
    }
  }
}

TEST_F(Run, MeasuresAreTakenAtTheStartInBetweenAndAtTheEnd) {
  run_well({"run", "ucsd", "--count", "50", "--steps", "25", "--measures", "m.csv", "--set",
            "run.measure.every=10"});
  const std::string text = read("m.csv");
  EXPECT_TRUE(text.starts_with("step,boids,polarisation,")) << text;
  for (const char* begin : {"\n0,50,", "\n10,50,", "\n20,50,", "\n25,50,"}) EXPECT_SAYS(text, begin);
  EXPECT_EQ(line_count(text), 5u);
}

TEST_F(Run, DevicesAreWrittenDirectly) {
  const Ended ended =
      run_well({"run", "ucsd", "--count", "5", "--steps", "1", "--measures", "/dev/stdout", "--quiet"});
  EXPECT_TRUE(ended.out.starts_with("step,boids,")) << ended.out;
  EXPECT_EQ(line_count(ended.out), 3u);
}

TEST_F(Run, PlotIsAPicture) {
  run_well({"run", "ucsd", "--count", "50", "--steps", "25", "--plot", "p.png"});
  EXPECT_TRUE(is_png(read("p.png")));
  run_well({"run", "ucsd", "--count", "50", "--steps", "25", "--plot", "p.ppm"});
  EXPECT_TRUE(read("p.ppm").starts_with("P6\n"));
}

TEST_F(Run, JsonSaysTheSame) {
  const Ended plain = run_well({"run", "ucsd", "--steps", "5", "--seed", "3"});
  const nlohmann::json json = json_of(run_well({"run", "ucsd", "--steps", "5", "--seed", "3", "--threads",
                                                "2", "--json", "--measures", "m.csv"})
                                          .out);
  EXPECT_EQ(json["hash"], hash_in(plain.out));
  EXPECT_EQ(json["steps"], 5);
  EXPECT_EQ(json["last_step"], 5);
  EXPECT_EQ(json["boids"], 1000);
  EXPECT_EQ(json["seed"], 3);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["scenario"], "ucsd");
  EXPECT_EQ(json["interrupted"], false);
  EXPECT_GT(json["seconds"].get<double>(), 0);
  EXPECT_NEAR(json["ns_per_boid_and_step"].get<double>(), 1e9 * json["seconds"].get<double>() / 5000, 1e-3);
  EXPECT_GT(json["last_measures"]["polarisation"].get<double>(), 0);
}

TEST_F(Run, QuietSaysNothing) {
  const Ended ended = run_well({"run", "ucsd", "--steps", "5", "--final", "s.csv", "-o", "dir", "--quiet"});
  EXPECT_EQ(ended.out + ended.err, "");
  EXPECT_TRUE(exists("s.csv"));
}

const std::set<std::string> experiment = {"dir",           "dir/scenario.toml", "dir/measures.csv",
                                          "dir/final.csv", "dir/plot.png",      "dir/run.json"};

TEST_F(Run, AFolderIsOneExperiment) {
  const Ended ended =
      run_well({"run", "two-flocks", "--steps", "35", "--set", "flock.dawn.max_speed=2.5", "-o", "dir"});
  EXPECT_SAYS(ended.err, "again with: sturnus run dir/scenario.toml");
  EXPECT_EQ(files(), experiment);
  EXPECT_TRUE(is_png(read("dir/plot.png")));
  const nlohmann::json json = json_of(read("dir/run.json"));
  EXPECT_EQ(json["hash"], hash_in(ended.out));
  EXPECT_EQ(json["command"].size(), 9u);
  EXPECT_EQ(json["command"][1], "run");
  const Ended again = run_well({"run", "dir/scenario.toml", "--measures", "m.csv", "--final", "s.csv"});
  EXPECT_EQ(hash_in(again.out), hash_in(ended.out));
  EXPECT_EQ(read("m.csv"), read("dir/measures.csv"));
  EXPECT_EQ(read("s.csv"), read("dir/final.csv"));
}

TEST_F(Run, AFolderRepeatsEveryShippedScenario) {
  for (const std::string& name : shipped_names(run_well({"list"}).out)) {
    const std::string hash = hash_of({name, "--steps", "12", "-o", "all/" + name});
    EXPECT_EQ(hash_of({"all/" + name + "/scenario.toml"}), hash) << name;
  }
}

TEST_F(Run, AFolderKeepsTheEvents) {
  write("e.toml",
        "[run]\nsteps = 30\nevents = [[5, \"set\", \"flock.a.max_speed\", 3], [10, \"add\", \"a\", 7, [10, "
        "20], 5], "
        "[15, \"erase\", [0, 0], 40], [20, \"pointer\", \"repel\", [5, 5]]]\n"
        "[[flock]]\nname = \"a\"\ncount = 100\nmax_speed = 2.5\n");
  const std::string hash = hash_of({"e.toml", "-o", "dir"});
  EXPECT_SAYS(read("dir/scenario.toml"), "[15, \"erase\", [0, 0], 40]");
  EXPECT_SAYS(read("dir/scenario.toml"), "\nmax_speed = 2.5\n");  // as it began, not as it stood in the end
  EXPECT_EQ(hash_of({"dir/scenario.toml"}), hash);
  write("without.toml", "[run]\nsteps = 30\n[[flock]]\nname = \"a\"\ncount = 100\nmax_speed = 2.5\n");
  EXPECT_NE(hash_of({"without.toml"}), hash);
}

TEST_F(Run, AFolderHoldsTheStateThatItBeganWith) {
  run_well({"run", "quadtree", "--steps", "25", "--final", "s.csv"});
  const std::string hash =
      hash_of({"quadtree", "--steps", "10", "--initial", "s.csv", "--first-step", "25", "-o", "dir"});
  EXPECT_EQ(read("dir/initial.csv"), read("s.csv"));
  std::filesystem::remove(path("s.csv"));
  std::filesystem::rename(path("dir"), path("moved"));
  EXPECT_EQ(hash_of({"moved/scenario.toml"}), hash);
  EXPECT_EQ(hash_of({"moved/scenario.toml", "-o", "moved"}), hash);  // over itself
  EXPECT_EQ(hash_of({"moved/scenario.toml"}), hash);
}

TEST_F(Run, AFolderHoldsTheFlocksOwnFilesToo) {
  write("in/boids.csv", "id,flock,x,y,vx,vy\n0,0,1,2,3,4\n1,0,4,2,-1,0\n");
  write("in/s.toml",
        "[run]\nsteps = 9\n[[flock]]\nname = \"a\"\nstart = { file = \"boids.csv\" }\n[[flock]]\nname = "
        "\"b\"\ncount = 3\n");
  const std::string hash = hash_of({"in/s.toml", "-o", "dir"});
  EXPECT_EQ(read("dir/start-a.csv"), read("in/boids.csv"));
  std::filesystem::remove_all(path("in"));
  EXPECT_EQ(hash_of({"dir/scenario.toml"}), hash);
}

TEST_F(Run, AStateMayComeFromAPipe) {
  run_well({"run", "ucsd", "--steps", "5", "--final", "s.csv"});
  StartOptions options;
  options.input = path("s.csv");
  const Ended ended = run(
      {"run", "ucsd", "--steps", "5", "--initial", "/dev/stdin", "--first-step", "5", "-o", "dir"}, options);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(hash_in(ended.out), hash_of({"ucsd", "--steps", "10"}));
  EXPECT_EQ(hash_of({"dir/scenario.toml"}), hash_in(ended.out));
}

TEST_F(Run, CtrlCWritesWhatWasDone) {
  Running running(sturnus_words({"run", "ucsd", "--steps", "1e12", "--count", "100", "--final", "s.csv",
                                 "--measures", "m.csv", "--plot", "p.png", "-o", "dir"}),
                  here());
  ASSERT_TRUE(running.wait_until_it_works());
  ::kill(running.id(), SIGINT);
  const Ended ended = running.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  const std::string hash = hash_in(ended.out);
  EXPECT_EQ(hash.size(), 16u) << ended.out;
  EXPECT_TRUE(is_png(read("p.png")));
  EXPECT_EQ(line_count(read("s.csv")), 101u);
  EXPECT_EQ(read("m.csv"), read("dir/measures.csv"));
  const nlohmann::json json = json_of(read("dir/run.json"));
  EXPECT_EQ(json["interrupted"], true);
  // As many steps as it did, once more, end in the same hash.
  EXPECT_EQ(hash_of({"dir/scenario.toml"}), hash);
  EXPECT_EQ(hash_of({"ucsd", "--count", "100", "--steps", std::to_string(json["steps"].get<std::int64_t>())}),
            hash);
}

// Longer than half a second, and on a terminal.
TEST_F(Run, ProgressIsShownOnlyToAPersonWhoWaits) {
  const auto said_in_a_while = [&](bool terminal, const Words& more) {
    StartOptions options = here();
    options.terminal = terminal;
    Words words = {"run", "ucsd", "--steps", "1e12", "--count", "50"};
    words.insert(words.end(), more.begin(), more.end());
    Running running(sturnus_words(words), options);
    EXPECT_TRUE(running.wait_until_it_works());
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
    ::kill(running.id(), SIGINT);
    return running.wait().err;
  };
  const std::string shown = said_in_a_while(true, {});
  EXPECT_SAYS(shown, " of 1000000000000");
  EXPECT_TRUE(shown.ends_with("\r\x1b[K")) << "the bar goes away";
  EXPECT_EQ(said_in_a_while(true, {"--quiet"}), "");
  EXPECT_EQ(said_in_a_while(false, {}), "");
  StartOptions options;
  options.terminal = true;
  EXPECT_EQ(run({"run", "ucsd", "--steps", "2", "--count", "50"}, options).err, "");
}

TEST_F(Run, AFullDiskLeavesNothingAndStillTellsTheHash) {
  for (const char* option : {"--final", "--measures"}) {
    const Ended ended = run({"run", "ucsd", "--steps", "3", option, "/dev/full"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.err, "/dev/full: cannot be written: No space left on device\n");
    EXPECT_EQ(hash_in(ended.out), hash_of({"ucsd", "--steps", "3"}));
  }
  StartOptions options;
  options.output = "/dev/full";
  EXPECT_EQ(run({"run", "ucsd", "--steps", "3", "--final", "s.csv"}, options).code, 1);
  EXPECT_EQ(files(), std::set<std::string>{"s.csv"});
}

// Found before the first step: a run of 1e12 steps would not come back.
TEST_F(Run, WhatCannotBeWrittenIsFoundBeforeTheFirstStep) {
  write("file", "");
  std::filesystem::create_directory(path("folder"));
  const Words begin = {"run", "ucsd", "--steps", "1e12"};
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"--final", "no/s.csv"}, "no/s.csv: cannot be written: No such file or directory"},
      {{"--measures", "no/m.csv"}, "no/m.csv: cannot be written: No such file or directory"},
      {{"--plot", "no/p.png"}, "no/p.png: cannot be written: No such file or directory"},
      {{"--final", "folder"}, "folder: cannot be written: Is a directory"},
      {{"-o", "file"}, "file: the folder cannot be created"},
      {{"-o", "file/dir"}, "the folder cannot be created"},
  };
  for (const auto& [end, sentence] : cases) {
    Words words = begin;
    words.insert(words.end(), end.begin(), end.end());
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 1) << sentence;
    EXPECT_EQ(ended.out, "");
    EXPECT_SAYS(ended.err, sentence);
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
  }
  EXPECT_EQ(files(), (std::set<std::string>{"file", "folder"}));
}

TEST_F(Run, WhatStoodThereBeforeStaysWhenTheRunIsRefused) {
  write("s.csv", "precious");
  EXPECT_EQ(run({"run", "ucsd", "--steps", "1", "--set", "flock.birds.count=-1", "--final", "s.csv"}).code,
            2);
  EXPECT_EQ(read("s.csv"), "precious");
}

}  // namespace
}  // namespace program_test
