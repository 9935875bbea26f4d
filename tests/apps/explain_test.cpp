// sturnus explain: its table, its JSON beside the next step of the same run, and what it refuses.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.h"

namespace program_test {
namespace {

class Explain : public ProgramTest {
 protected:
  nlohmann::json json_of(Words words) const {
    words.insert(words.begin(), "explain");
    words.insert(words.end(), {"--json", "e.json", "--quiet"});
    EXPECT_EQ(run_well(words).out, "");
    return nlohmann::json::parse(read("e.json"), nullptr, false);
  }
  // The boid's line of a state CSV, as numbers.
  std::vector<double> line_of(const std::string& name, int id) const {
    std::istringstream lines(read(name));
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(std::to_string(id) + ",")) continue;
      std::vector<double> numbers;
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');)
        numbers.push_back(std::strtod(cell.c_str(), nullptr));
      return numbers;
    }
    ADD_FAILURE() << "no boid " << id << " in " << name;
    return std::vector<double>(8);
  }
};

TEST_F(Explain, TheTableHasTermsNeighboursAndFormulas) {
  const Ended ended = run_well({"explain", "ucsd", "--boid", "17", "--at", "20"});
  EXPECT_SAYS(ended.out, "Boid 17 of birds in ucsd, from step 20 to the next\n");
  for (const char* part :
       {"\n  separation  ", "\n  alignment  ", "\n  cohesion  ", "\n  sum  ", "\n  boundary  ",
        "\n  acceleration  ", "Next velocity, before the speed limits (5 to 10): v + dt·a = (",
        ", the nearest 12\n", "from heading", "mean of v - own v", "UCSD (S0-7)"})
    EXPECT_SAYS(ended.out, part);
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(files().empty());
}

// cs184's boids are slow enough for the limits to leave them alone.
TEST_F(Explain, TheNextVelocityIsThatOfTheNextStep) {
  for (const char* threads : {"1", "2"}) {
    const auto told = json_of({"cs184", "--boid", "3", "--at", "30", "--threads", threads});
    run_well({"run", "cs184", "--steps", "31", "--final", "s.csv"});
    const auto line = line_of("s.csv", 3);
    EXPECT_EQ(static_cast<float>(told["next_velocity"][0]), static_cast<float>(line[4]));
    EXPECT_EQ(static_cast<float>(told["next_velocity"][1]), static_cast<float>(line[5]));
    EXPECT_EQ(told["step"], 30);
  }
}

TEST_F(Explain, TheJsonAddsUp) {
  const auto told = json_of({"vuw-core", "--boid", "5", "--at", "10", "--index", "tree", "--seed", "4"});
  ASSERT_EQ(told["acceleration"].size(), 3u);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (const auto& term : told["terms"]) {
      EXPECT_NEAR(static_cast<double>(term["felt"][axis]) * static_cast<double>(term["weight"]),
                  static_cast<double>(term["weighted"][axis]), 1e-5);
      sum += static_cast<double>(term["granted"][axis]);
    }
    EXPECT_NEAR(sum, static_cast<double>(told["sum"][axis]), 1e-5);
    EXPECT_NEAR(static_cast<double>(told["cap_factor"]) * sum + static_cast<double>(told["boundary"][axis]),
                static_cast<double>(told["acceleration"][axis]), 1e-5);
  }
  std::size_t listed = 0;
  for (const auto& one : told["neighbours"])
    listed += std::count(one["terms"].begin(), one["terms"].end(), "cohesion") > 0 ? 1u : 0u;
  const auto& terms = told["terms"];
  const auto cohesion =
      std::find_if(terms.begin(), terms.end(), [](const auto& term) { return term["name"] == "cohesion"; });
  ASSERT_NE(cohesion, terms.end());
  EXPECT_EQ((*cohesion)["neighbours"], listed);
}

TEST_F(Explain, GoesOnFromAState) {
  const auto whole = json_of({"quadtree", "--boid", "9", "--at", "12"});
  run_well({"run", "quadtree", "--steps", "8", "--final", "s.csv"});
  EXPECT_EQ(json_of({"quadtree", "--boid", "9", "--at", "12", "--initial", "s.csv", "--first-step", "8"}),
            whole);
}

TEST_F(Explain, BadQuestionsGetOneSentence) {
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"ucsd", "--boid", "1000"}, "there is no boid with id 1000 at step 0"},
      {{"ucsd", "--boid", "x"}, "--boid: must be a whole number"},
      {{"ucsd"}, "sturnus explain needs --boid"},
      {{"ucsd", "--boid", "1", "--steps", "4"}, "unknown option \"--steps\""},
      {{"ucsd", "--boid", "1", "--at", "4", "--first-step", "9"},
       "--at: step 4 is over: the boids start at step 9"},
      {{"usd", "--boid", "1"}, "ucsd"},
  };
  for (const auto& [words, sentence] : cases) {
    Words all = {"explain"};
    all.insert(all.end(), words.begin(), words.end());
    expect_refusal(all, sentence);
  }
  EXPECT_EQ(run({"explain", "ucsd", "--boid", "1", "--json", "no/e.json"}).code, 1);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace program_test
