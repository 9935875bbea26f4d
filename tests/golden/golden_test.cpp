// The same bits everywhere: every shipped scenario against its known hashes, for several thread counts, with
// garbage in the working memory, and on every instruction set, compared at every step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include "everything.h"
#include "isas.h"
#include "support.h"

namespace sturnus::test {
namespace {

constexpr const char* golden_file = STURNUS_GOLDEN;
constexpr const char* how_to_update =
    "\nIf the change is meant, write the hashes anew: STURNUS_UPDATE_GOLDEN=1 sturnus-tests "
    "'--gtest_filter=*Golden*'"
    "\nand say in CHANGELOG.md why results changed.";
constexpr std::int64_t most_boids = 2000;

/// The shipped scenarios, and the one with everything switched on.
const std::vector<ShippedScenario>& golden_scenarios() {
  static const std::vector<ShippedScenario> all = [] {
    std::vector<ShippedScenario> scenarios = shipped_scenarios();
    scenarios.push_back({"everything", "tests", everything});
    return scenarios;
  }();
  return all;
}

/// "name step" to the hash in sixteen digits.
using Hashes = std::map<std::string, std::string>;

Hashes read_hashes() {
  Hashes hashes;
  std::ifstream file(golden_file);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string name, step, hash;
    words >> name >> step >> hash;
    hashes[name + " " + step] = hash;
  }
  return hashes;
}

void write_hashes(const Hashes& hashes) {
  std::ofstream file(golden_file);
  file << "# State hashes of the shipped scenarios with at most " << most_boids
       << " boids: name, step, hash.\n";
  for (const ShippedScenario& shipped : golden_scenarios()) {
    for (const int mark : {1, 10, 100, 1000}) {
      const std::string key = std::string(shipped.name) + " " + std::to_string(mark);
      if (const auto found = hashes.find(key); found != hashes.end())
        file << key << " " << found->second << "\n";
    }
  }
}

std::string text_of(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// The scenario with all its flocks smaller in proportion, so that there are at most 2000 boids.
ScenarioDef reduced(const ShippedScenario& shipped) {
  ScenarioDef scenario = take(parse_scenario(shipped.text, shipped.name));
  const std::int64_t all = scenario.boid_count();
  for (FlockDef& flock : scenario.flocks) {
    if (all > most_boids) flock.count = std::max<std::int64_t>(1, flock.count * most_boids / all);
  }
  return scenario;
}

/// The id of the first boid that two worlds have differently, for the message.
std::string first_difference(const Simulation& one, const Simulation& other) {
  for (const std::uint32_t slot : one.view().slots_by_id()) {
    const std::uint64_t id = one.view().id(slot);
    const auto there = other.view().slot(id);
    if (!there) return "boid " + std::to_string(id) + " is missing";
    if (one.view().position(slot) != other.view().position(*there) ||
        one.view().velocity(slot) != other.view().velocity(*there)) {
      return "boid " + std::to_string(id) + " is the first that differs";
    }
  }
  return "no place or velocity differs";
}

class Golden : public testing::TestWithParam<std::size_t> {
 protected:
  const ShippedScenario& shipped() const { return golden_scenarios()[GetParam()]; }

  /// Runs one, two, three and eight threads and a poisoned world side by side.
  void run_all(std::uint64_t steps) {
    const ScenarioDef scenario = reduced(shipped());
    std::vector<Simulation> worlds;
    for (const int threads : {1, 2, 3, 8, 1}) worlds.push_back(start(scenario, threads));
    for (std::uint64_t step = 1; step <= steps; ++step) {
      worlds.back().poison_scratch();
      for (Simulation& world : worlds) world.step();
      for (std::size_t i = 1; i < worlds.size(); ++i) {
        ASSERT_EQ(worlds[i].hash(), worlds.front().hash())
            << shipped().name << ", step " << step << ", world " << i
            << " of 1, 2, 3, 8 threads and poison: " << first_difference(worlds.front(), worlds[i]);
      }
      note(worlds.front());
    }
  }

  void note(const Simulation& world) {
    const std::uint64_t step = world.step_number();
    if (step == 1 || step == 10 || step == 100 || step == 1000)
      found_[std::string(shipped().name) + " " + std::to_string(step)] = text_of(world.hash());
  }

  void compare_with_file() const {
    Hashes known = read_hashes();
    if (const char* update = std::getenv("STURNUS_UPDATE_GOLDEN");
        update != nullptr && std::string(update) == "1") {
      for (const auto& [key, hash] : found_) known[key] = hash;
      return write_hashes(known);
    }
    for (const auto& [key, hash] : found_) {
      EXPECT_EQ(known[key], hash) << "the golden hash of \"" << key << "\" has changed" << how_to_update;
    }
  }

  Hashes found_;
};

class FullGolden : public Golden {};
class BriefGolden : public Golden {};

// One world and few steps, for processors that are only imitated.
TEST_P(BriefGolden, SameBitsForTenSteps) {
  Simulation world = start(reduced(shipped()));
  for (int step = 1; step <= 10; ++step) {
    world.step();
    note(world);
  }
  compare_with_file();
}

TEST_P(Golden, SameBitsForAnyThreadsAndGarbage) {
  ASSERT_NO_FATAL_FAILURE(run_all(100));
  compare_with_file();
}

TEST_P(FullGolden, SameBitsForAThousandSteps) {
  ASSERT_NO_FATAL_FAILURE(run_all(1000));
  compare_with_file();
}

/// A scenario on one instruction set, beside the plain loop.
class GoldenIsa : public testing::TestWithParam<std::tuple<std::size_t, NamedIsa>> {};

TEST_P(GoldenIsa, SameBitsAsThePlainLoop) {
  const auto& [number, isa] = GetParam();
  const IsaGuard guard;
  if (!use_isa(isa.isa)) GTEST_SKIP() << "this machine has no " << isa.name;
  const ScenarioDef scenario = reduced(golden_scenarios()[number]);
  Simulation plain = start(scenario);
  Simulation wide = start(scenario, 2);
  for (int step = 1; step <= 20; ++step) {
    ASSERT_TRUE(use_isa(Isa::plain));
    plain.step();
    ASSERT_TRUE(use_isa(isa.isa));
    wide.step();
    ASSERT_EQ(wide.hash(), plain.hash()) << golden_scenarios()[number].name << ", step " << step << ": "
                                         << isa_in_use() << ", " << first_difference(plain, wide);
  }
}

std::vector<std::size_t> every_scenario() {
  std::vector<std::size_t> indexes;
  while (indexes.size() < golden_scenarios().size()) indexes.push_back(indexes.size());
  return indexes;
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = golden_scenarios()[info.param].name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string name_of_both(const testing::TestParamInfo<GoldenIsa::ParamType>& info) {
  return name_of({std::get<0>(info.param), 0}) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Shipped, GoldenIsa,
                         testing::Combine(testing::ValuesIn(every_scenario()), testing::ValuesIn(wide_isas)),
                         name_of_both);
INSTANTIATE_TEST_SUITE_P(Shipped, Golden, testing::ValuesIn(every_scenario()), name_of);
INSTANTIATE_TEST_SUITE_P(Shipped, BriefGolden, testing::ValuesIn(every_scenario()), name_of);
INSTANTIATE_TEST_SUITE_P(Full, FullGolden, testing::ValuesIn(every_scenario()), name_of);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Golden);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BriefGolden);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FullGolden);

TEST(GoldenFile, HoldsTheHashesOfShippedScenariosOnly) {
  std::map<std::string, int> lines;
  for (const auto& [key, hash] : read_hashes()) ++lines[key.substr(0, key.find(' '))];
  for (const ShippedScenario& shipped : golden_scenarios()) lines.erase(shipped.name);
  for (const auto& [name, count] : lines)
    ADD_FAILURE() << name << " is not shipped any more" << how_to_update;
}

}  // namespace
}  // namespace sturnus::test
