// The reference table in the documentation is the one that the program prints.
#include <fstream>
#include <sstream>

#include "program.h"

namespace program_test {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Documentation, ScenarioKeysAreTheParameterList) {
  const Ended ended = Running(sturnus_words({"keys", "--markdown"}), {}).wait();
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, file_text(STURNUS_SOURCE "/docs/scenario-keys.md"))
      << "docs/scenario-keys.md is old; write it anew: sturnus keys --markdown > docs/scenario-keys.md";
}

}  // namespace
}  // namespace program_test
