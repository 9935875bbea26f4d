// sturnus compare: one changed number is found exactly, wherever it is; and what it refuses.
#include <cmath>

#include "apps/program.h"

namespace program_test {
namespace {

constexpr const char* header = "id,flock,x,y,z,vx,vy,vz\n";

class Compare : public ProgramTest {
 protected:
  // Three boids with numbers that are exact in binary, one number of one of them changed by `error`.
  static std::string table(int boid = -1, int column = 0, double error = 0) {
    std::string out = header;
    for (int i = 0; i < 3; ++i) {
      out += std::to_string(10 + i) + ",0";
      for (int cell = 0; cell < 6; ++cell)
        out.append(",").append(std::to_string(i + 0.25 * cell + (i == boid && cell == column ? error : 0)));
      out += "\n";
    }
    return out;
  }
  Ended compare(Words options = {}) const {
    options.insert(options.begin(), {"compare", "a.csv", "b.csv"});
    return run(options);
  }
};

TEST_F(Compare, AFileAgreesWithItselfAndWithAShuffledCopy) {
  run_well({"run", "cs184", "--steps", "5", "--final", "a.csv"});
  run_well({"run", "cs184", "--steps", "5", "--index", "all-pairs", "--final", "b.csv", "--count", "500"});
  std::filesystem::copy_file(path("a.csv"), path("c.csv"));
  const Ended same = run_well({"compare", "a.csv", "c.csv"});
  EXPECT_EQ(same.out,
            "500 boids in both\nlargest error in position: 0\nlargest error in velocity: 0\nall equal to the "
            "bit\n");
  EXPECT_EQ(same.err, "");
  EXPECT_EQ(compare({"--tolerance", "0.01"}).code, 0);  // another index adds in another order
}

TEST_F(Compare, OneChangedNumberIsFoundExactly) {
  const std::vector<std::string> names = {"x", "y", "z", "vx", "vy", "vz"};
  write("a.csv", table());
  for (int boid = 0; boid < 3; ++boid) {
    for (int column = 0; column < 6; ++column) {
      write("b.csv", table(boid, column, 0.5));
      const Ended ended = compare();
      EXPECT_EQ(ended.code, 3);
      const std::string id = std::to_string(10 + boid);
      const std::string& name = names[static_cast<std::size_t>(column)];
      const bool is_place = column < 3;
      EXPECT_SAYS(ended.out, std::string("largest error in ") + (is_place ? "position" : "velocity") +
                                 ": 0.5 (boid " + id + ", " + name + ": ");
      EXPECT_SAYS(ended.out,
                  std::string("largest error in ") + (is_place ? "velocity" : "position") + ": 0\n");
      EXPECT_SAYS(ended.out, "first boid that differs: " + id + " (" + name + ": ");
      EXPECT_SAYS(ended.out, "they differ: 1 of 3 boids is not equal to the bit\n");
      EXPECT_EQ(compare({"--tolerance", "0.5"}).code, 0);
      EXPECT_EQ(compare({"--tolerance", "0.49"}).code, 3);
    }
  }
}

TEST_F(Compare, TheLeastBitCountsWithoutATolerance) {
  write("a.csv", "id,x,y\n0,0,1\n");
  write("b.csv", "id,x,y\n0,-0,1.0000001\n");
  const Ended ended = compare();
  EXPECT_EQ(ended.code, 3);
  EXPECT_SAYS(ended.out, "first boid that differs: 0 (x: 0 and -0)");
  EXPECT_EQ(compare({"--tolerance", "1e-6"}).code, 0);
}

TEST_F(Compare, BoidsThatOnlyOneFileHasAreTold) {
  write("a.csv", "id,flock,x,y\n3,0,1,1\n9,0,2,2\n");
  write("b.csv", "id,flock,x,y\n9,1,2,2\n4,0,1,1\n5,0,1,1\n");
  const Ended ended = compare({"--tolerance", "1"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.out,
            "1 boid in both\nonly in a.csv: 1 boid, 3\nonly in b.csv: 2 boids, 4 5\n"
            "largest error in position: 0\nlargest error in velocity: 0\n"
            "largest error in the other columns: 1 (boid 9, flock: 0 and 1)\n"
            "first boid that differs: 9 (flock: 0 and 1)\n"
            "they differ: 1 of 1 boid is not within 1\n");
}

TEST_F(Compare, BadInputGetsOneSentence) {
  write("a.csv", table());
  write("flat.csv", "id,x,y\n0,1,2\n");
  write("bad.csv", "id,x,y\n0,1,two\n");
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"a.csv", "flat.csv"}, "a.csv holds boids in 3 dimensions, but flat.csv in 2"},
      {{"a.csv", "none.csv"}, "none.csv: "},
      {{"bad.csv", "a.csv"}, "bad.csv:2: y: must be a number, but found \"two\""},
      {{"a.csv", "a.csv", "--tolerance", "-1"}, "--tolerance: must be a number from 0 up, but is \"-1\""},
      {{"a.csv", "a.csv", "--tolerance", "nan"}, "--tolerance: must be a number from 0 up"},
      {{"a.csv"}, "sturnus compare needs B.csv"},
  };
  for (const auto& [words, sentence] : cases) {
    Words all = {"compare"};
    all.insert(all.end(), words.begin(), words.end());
    expect_refusal(all, sentence);
  }
}

}  // namespace
}  // namespace program_test
