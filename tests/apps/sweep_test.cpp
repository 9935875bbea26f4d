// sturnus sweep: what the table says, that it is what single runs say, and what is refused.
#include <cmath>
#include <sstream>

#include "apps/program.h"

namespace program_test {
namespace {

class Sweep : public ProgramTest {
 protected:
  using Table = std::vector<std::vector<std::string>>;

  static Table table_of(const std::string& csv) {
    Table table;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      table.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
    }
    return table;
  }
  Words words(Words more) const {
    const Words first = {"sweep", "cs184-feeding-frenzy", "--steps", "40", "--quiet"};
    more.insert(more.begin(), first.begin(), first.end());
    return more;
  }
};

TEST_F(Sweep, TellsOfEachValueWhatARunWithItTells) {
  const Table table = table_of(
      run_well(words({"--over", "flock.fish.count=100,200", "--measure", "population.fish,eaten"})).out);
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[0], (std::vector<std::string>{"flock.fish.count", "population.fish", "eaten"}));
  for (const std::size_t row : {1u, 2u}) {
    const int count = row == 1 ? 100 : 200;
    run_well({"run", "cs184-feeding-frenzy", "--steps", "40", "--quiet", "--set",
              "flock.fish.count=" + std::to_string(count), "--measures", "m.csv"});
    const Table measures = table_of(read("m.csv"));
    ASSERT_EQ(measures[0][10], "population.fish");
    EXPECT_EQ(table[row][0], std::to_string(count));
    EXPECT_EQ(table[row][1], measures.back()[10]);
    EXPECT_EQ(std::stoi(table[row][1]) + std::stoi(table[row][2]), count);  // nobody is born there
  }
}

TEST_F(Sweep, RepeatsTakeTheNextSeedsAndTellHowTheyScatter) {
  const auto eaten = [&](const std::string& seed) {
    const Table one = table_of(
        run_well(words({"--over", "flock.fish.count=150", "--measure", "eaten", "--seed", seed})).out);
    return std::stod(one[1][1]);
  };
  const Table both = table_of(run_well(words({"--over", "flock.fish.count=150", "--measure", "eaten",
                                              "--seed", "5", "--repeats", "2"}))
                                  .out);
  EXPECT_EQ(both[0], (std::vector<std::string>{"flock.fish.count", "eaten", "eaten_sd"}));
  const double a = eaten("5"), b = eaten("6");
  EXPECT_NEAR(std::stod(both[1][1]), (a + b) / 2, 1e-6);
  EXPECT_NEAR(std::stod(both[1][2]), std::abs(a - b) / std::sqrt(2.0), 1e-6);
}

TEST_F(Sweep, DrawsACurveForEachValueOfASecondParameter) {
  const Ended ended = run_well(words({"--over", "flock.fish.count=50,100", "--by", "flock.sharks.count=2,4,6",
                                      "--measure", "captures", "--csv", "t.csv", "--plot", "p.png"}));
  EXPECT_EQ(ended.out, "");
  const Table table = table_of(read("t.csv"));
  ASSERT_EQ(table.size(), 7u);
  EXPECT_EQ(table[0], (std::vector<std::string>{"flock.sharks.count", "flock.fish.count", "captures"}));
  EXPECT_EQ(table[4][0] + " " + table[4][1], "4 100");
  EXPECT_EQ(read("p.png").substr(1, 3), "PNG");
}

TEST_F(Sweep, RefusesBeforeItRuns) {
  const auto refused = [&](Words more) {
    const Ended ended = run(words(std::move(more)));
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(files().empty());
    return ended.err;
  };
  EXPECT_SAYS(refused({"--over", "flock.fish.count"}), "write key=value,value");
  EXPECT_SAYS(refused({"--over", "flock.fish.count=1,,2"}), "a value is missing");
  EXPECT_SAYS(refused({"--over", "flock.fisch.count=1"}), "did you mean");
  EXPECT_SAYS(refused({"--over", "flock.fish.count=10,-1"}), "count");
  EXPECT_SAYS(refused({"--over", "flock.fish.count=1", "--measure", "turnin"}), "did you mean turning?");
  EXPECT_SAYS(refused({"--over", "flock.fish.count=20,10", "--plot", "p.png"}), "numbers that rise");
  EXPECT_SAYS(refused({"--over", "flock.fish.count=10", "--plot", "p.gif"}), "must end in .png or .ppm");
  EXPECT_SAYS(refused({}), "--over");
}

}  // namespace
}  // namespace program_test
