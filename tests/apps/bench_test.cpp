// sturnus bench: every case is in the table and in the JSON, and threads and instruction sets change no bit.
#include <signal.h>
#include <sturnus/isa.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.h"
#include "bench_row.h"
#include "isas.h"

namespace program_test {
namespace {

using sturnus::test::IsaGuard;
using sturnus::test::wide_isas;

// Words of the lines of the table.
using Table = std::vector<Words>;

class Bench : public ProgramTest {
 protected:
  // The lines that end in a hash.
  static Table table_in(const std::string& text) {
    Table table;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      Words row;
      for (std::string word; words >> word;) row.push_back(word);
      if (!row.empty() && row.back().size() == 16 && row.size() > 10) table.push_back(row);
    }
    return table;
  }

  nlohmann::json json_of(const std::string& name) const {
    const std::string text = read(name);
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    EXPECT_TRUE(json.is_object()) << text;
    return json;
  }

  std::string hash_of_run(Words words) const {
    words.insert(words.begin(), "run");
    return hash_in(run_well(words).out);
  }

  // Case, boids, threads and instruction set.
  static Words name_of(const Words& row) { return {row.begin(), row.begin() + 4}; }
};

TEST_F(Bench, QuickShowsBothYardsticks) {
  const Ended ended = run_well({"bench", "--quick", "--threads", "1,2", "--isa", "scalar"});
  EXPECT_EQ(ended.err, "");
  EXPECT_SAYS(ended.out, "2 repeats of 3 steps after 2 steps");
  EXPECT_SAYS(ended.out, "hash after 8 steps");
  const Table table = table_in(ended.out);
  ASSERT_EQ(table.size(), 4u) << ended.out;
  EXPECT_EQ(name_of(table[0]), (Words{"bench-2d", "2000", "1", "scalar"}));
  EXPECT_EQ(name_of(table[1]), (Words{"bench-2d", "2000", "2", "scalar"}));
  EXPECT_EQ(name_of(table[2]), (Words{"bench-3d", "2000", "1", "scalar"}));
  EXPECT_EQ(name_of(table[3]), (Words{"bench-3d", "2000", "2", "scalar"}));
  EXPECT_EQ(table[0][4], "CPU");
  EXPECT_EQ(table[1][4], "wall");
}

TEST_F(Bench, SmallCasesComeFirst) {
  const Table table = table_in(
      run_well({"bench", "bench-3d", "two-flocks", "--boids", "300,2e2", "--threads", "1", "--quick"}).out);
  ASSERT_EQ(table.size(), 4u);
  EXPECT_EQ(table[0][0] + table[0][1], "bench-3d200");
  EXPECT_EQ(table[1][0] + table[1][1], "two-flocks200");
  EXPECT_EQ(table[2][0] + table[2][1], "bench-3d300");
  EXPECT_EQ(table[3][0] + table[3][1], "two-flocks300");
}

// "The hash is the same for all threads and instruction sets", and it is that of a run.
TEST_F(Bench, EveryWayEndsInTheHashOfARun) {
  std::string isas = "scalar";
  const IsaGuard guard;
  for (const auto& isa : wide_isas) isas += use_isa(isa.isa) ? std::string(",") + isa.name : "";
  for (const char* path : {"sparse", "dense", "auto"}) {
    const Ended ended = run_well({"bench", "bench-2d", "ucsd", "--boids", "500", "--threads", "1,2,3",
                                  "--isa", isas, "--path", path, "--steps", "2", "--repeats", "3"});
    const Table table = table_in(ended.out);
    EXPECT_GE(table.size(), 12u);
    for (const char* scenario : {"bench-2d", "ucsd"}) {
      const std::string hash = hash_of_run({scenario, "--count", "500", "--steps", "11", "--path", path});
      for (const Words& row : table) EXPECT_TRUE(row[0] != scenario || row.back() == hash) << ended.out;
    }
  }
}

TEST_F(Bench, FlocksAreScaledInProportion) {
  write("s.toml", "[[flock]]\nname = \"a\"\ncount = 30\n[[flock]]\nname = \"b\"\ncount = 11\n");
  const Ended ended =
      run_well({"bench", "s.toml", "--boids", "410", "--threads", "1", "--steps", "1", "--repeats", "1"});
  const Table table = table_in(ended.out);
  ASSERT_EQ(table.size(), 1u) << ended.out;
  EXPECT_EQ(table[0][1], "410");
  EXPECT_EQ(table[0].back(), hash_of_run({"s.toml", "--set", "flock.a.count=300", "--set",
                                          "flock.b.count=110", "--steps", "6"}));
}

TEST_F(Bench, ASpaceOfFixedSizeKeepsItsCount) {
  const Ended ended = run_well({"bench", "ucsd", "--threads", "1", "--steps", "1", "--repeats", "1"});
  const Table table = table_in(ended.out);
  ASSERT_EQ(table.size(), 1u) << ended.out;
  EXPECT_EQ(table[0][1], "1000");
}

TEST_F(Bench, AWorldWithoutBoidsIsNoTrouble) {
  write("none.toml", "[[flock]]\ncount = 0\n[space]\nmin = [0, 0]\nmax = [9, 9]\n");
  const Ended ended = run_well({"bench", "none.toml", "--threads", "1", "--json", "b.json"});
  EXPECT_EQ(table_in(ended.out).size(), 1u) << ended.out;
  EXPECT_TRUE(json_of("b.json")["cases"][0]["steps_per_second"].is_null());
  const Ended more = run({"bench", "none.toml", "--boids", "10"}, here());
  EXPECT_EQ(more.code, 2);
  EXPECT_SAYS(more.err, "--boids: none has no boids that could become more");
}

TEST_F(Bench, JsonHasAllFigures) {
  run_well({"bench", "bench-2d", "--boids", "400", "--threads", "1,2", "--index", "tree", "--isa", "scalar",
            "--steps", "2", "--repeats", "2", "--json", "b.json"});
  const nlohmann::json json = json_of("b.json");
  for (const char* key : {"version", "compiler", "machine", "command", "warm_up", "steps", "repeats",
                          "skipped", "interrupted", "cases"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_FALSE(json["machine"]["cpu"].get<std::string>().empty());
  EXPECT_GE(json["machine"]["cores"].get<int>(), 1);
  EXPECT_EQ(json["command"][1], "bench");
  EXPECT_EQ(json["interrupted"], false);
  ASSERT_EQ(json["cases"].size(), 2u);
  EXPECT_EQ(json["cases"][0]["threads"], 1);
  EXPECT_EQ(json["cases"][1]["threads"], 2);
  EXPECT_EQ(json["cases"][0]["hash"], json["cases"][1]["hash"]);
  for (const nlohmann::json& one : json["cases"]) {
    EXPECT_EQ(one["scenario"], "bench-2d");
    EXPECT_EQ(one["boids"], 400);
    EXPECT_EQ(one["isa"], "scalar");
    EXPECT_EQ(one["index"], "tree");
    EXPECT_EQ(one["path"], "auto");
    EXPECT_EQ(one["hash_after_steps"], 9);
    EXPECT_GT(one["peak_memory"].get<double>(), 1e6);
    EXPECT_TRUE(one.contains("bytes_per_boid"));
  }
}

TEST_F(Bench, TheFiguresAgreeWithEachOther) {
  run_well({"bench", "bench-2d", "--boids", "400", "--threads", "1,2", "--quick", "--json", "b.json"});
  const nlohmann::json cases = json_of("b.json")["cases"];
  ASSERT_EQ(cases.size(), 2u);
  for (const nlohmann::json& one : cases) {
    const nlohmann::json& time = one["ns_per_boid_and_step"];
    EXPECT_EQ(time["clock"], one["threads"] == 1 ? "CPU" : "wall");
    EXPECT_EQ(time["min"], time[one["threads"] == 1 ? "cpu" : "wall"]["min"]);
    EXPECT_GT(time["min"].get<double>(), 0);
    EXPECT_GE(time["median"].get<double>(), time["min"].get<double>());
    const double steps_per_second = one["steps_per_second"].get<double>();
    EXPECT_NEAR(steps_per_second * time["min"].get<double>() * 400, 1e9, 1);
    EXPECT_NEAR(one["neighbour_pairs_per_second"].get<double>(),
                400 * one["neighbours"].get<double>() * steps_per_second, 1);
    EXPECT_NEAR(one["neighbours"].get<double>(), 20, 3);
    EXPECT_NEAR(one["candidate_pairs_per_second"].get<double>(),
                400 * one["candidates"].get<double>() * steps_per_second, 1);
    EXPECT_GT(one["candidates"].get<double>(), one["neighbours"].get<double>());
    EXPECT_LT(one["candidates"].get<double>(), 400);
    double shares = 0;
    for (const char* phase : {"sort", "neighbours", "motion"}) shares += one["share"][phase].get<double>();
    EXPECT_NEAR(shares, 1, 1e-9);
  }
}

TEST_F(Bench, WhoLooksAtAllPairsHasAllBoidsAsCandidates) {
  run_well({"bench", "bench-3d", "--boids", "300", "--threads", "1,2", "--isa", "scalar,best", "--index",
            "all-pairs", "--quick", "--json", "b.json"});
  for (const nlohmann::json& one : json_of("b.json")["cases"])
    EXPECT_DOUBLE_EQ(one["candidates"].get<double>(), 300);
}

TEST_F(Bench, WhatTheMachineLacksIsSkippedAndSaid) {
  const IsaGuard guard;
  const auto lacks = [](const auto& isa) { return !sturnus::use_isa(isa.isa); };
  const auto lacking = std::find_if(std::begin(wide_isas), std::end(wide_isas), lacks);
  ASSERT_NE(lacking, std::end(wide_isas));
  const std::string name = lacking->name;
  const Ended ended = run_well(
      {"bench", "bench-2d", "--quick", "--threads", "1", "--isa", name + ",scalar", "--json", "b.json"});
  EXPECT_SAYS(ended.err, "--isa: " + name + " is skipped, because this machine lacks it; it has scalar");
  EXPECT_EQ(line_count(ended.err), 1u);
  EXPECT_EQ(table_in(ended.out).size(), 1u);
  EXPECT_EQ(json_of("b.json")["skipped"], nlohmann::json::array({name}));

  const Ended stepped = run({"run", "ucsd", "--steps", "1", "--isa", name});
  EXPECT_EQ(stepped.code, 2);
  EXPECT_SAYS(stepped.err, "--isa: this machine lacks " + name + "; it has scalar");
}

struct Refusal {
  Words words;
  int code;
  const char* sentence;
};

TEST_F(Bench, WrongWordsAreRefusedBeforeAnythingIsDone) {
  write("file.toml", "[[flock]]\nstart = { file = \"boids.csv\" }\n");
  write("boids.csv", "x,y\n1,2\n3,4\n");
  const std::vector<Refusal> refusals = {
      {{"--isa", "avx3"},
       2,
       "--isa: must be one of best, scalar, sse4, avx2, avx512, neon, but is \"avx3\"; did you mean avx2?"},
      {{"--isa", "scalar,"}, 2, "--isa: must be one of best, scalar"},
      {{"--boids", "100,many"}, 2, "--boids: must be a whole number, but is \"many\""},
      {{"--boids", "0"}, 2, "--boids: must be at least 1, but is 0"},
      {{"--threads", "1,-2"}, 2, "--threads: must be at least 0, but is -2"},
      {{"--path", "spares"},
       2,
       "--path: must be one of auto, dense, sparse, but is \"spares\"; did you mean sparse?"},
      {{"--repeats", "0"}, 2, "--repeats: must be at least 1"},
      {{"bnech-2d"}, 2, "bnech-2d"},
      {{"file.toml", "--boids", "100"}, 2, "--boids: file takes its boids from a file"},
      {{"--json", "none/b.json"}, 1, "none/b.json: cannot be written: No such file or directory"},
  };
  for (const Refusal& refusal : refusals) {
    Words words = {"bench", "--quick"};
    words.insert(words.end(), refusal.words.begin(), refusal.words.end());
    const Ended ended = run(words, here());
    EXPECT_EQ(ended.code, refusal.code) << refusal.sentence;
    EXPECT_SAYS(ended.err, refusal.sentence);
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
}

TEST_F(Bench, CtrlCWritesWhatWasMeasured) {
  Running program(sturnus_words({"bench", "bench-2d", "--boids", "2000", "--threads", "1", "--repeats",
                                 "100000", "--json", "b.json"}),
                  here());
  ASSERT_TRUE(program.wait_until_it_works());
  ::kill(program.id(), SIGINT);
  EXPECT_EQ(program.wait().code, 130);
  const nlohmann::json json = json_of("b.json");
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_EQ(json["cases"].size(), 0u);
}

program::BenchRow row_of(std::size_t group, int threads, const char* isa, std::uint64_t hash) {
  program::BenchRow row;
  row.group = group;
  row.scenario = "bench-2d";
  row.boids = 2000;
  row.threads = threads;
  row.isa = isa;
  row.steps = 8;
  row.hash = hash;
  return row;
}

TEST(BenchRow, TwoHashesInOneGroupAreNamed) {
  const auto first = row_of(0, 1, "avx2", 10), second = row_of(0, 2, "avx2", 10),
             other = row_of(1, 1, "avx2", 11);
  EXPECT_EQ(program::disagreement({}), "");
  EXPECT_EQ(program::disagreement({first, second, other}), "");
  EXPECT_EQ(
      program::disagreement({first, second, other, row_of(1, 2, "sse4", 255)}),
      "bench-2d with 2000 boids: after 8 steps 1 thread on avx2 ends in the hash 000000000000000b, but 2 "
      "threads on sse4 end in the hash 00000000000000ff; they must be the same");
}

TEST(BenchRow, SpreadIsTheLeastAndTheMiddle) {
  EXPECT_EQ(program::spread_of({3, 1, 8}).min, 1);
  EXPECT_EQ(program::spread_of({3, 1, 8}).median, 3);
  EXPECT_EQ(program::spread_of({4, 1, 8, 2}).median, 3);
  EXPECT_EQ(program::spread_of({7}).median, 7);
}

}  // namespace
}  // namespace program_test
