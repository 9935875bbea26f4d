// Sentences out of text and numbers.
#include "base/text.h"

#include <gtest/gtest.h>

namespace sturnus {
namespace {

TEST(Say, JoinsTextAndNumbersThatReadBack) {
  EXPECT_EQ(say("radius ", 3.5, " is odd"), "radius 3.5 is odd");
  EXPECT_EQ(say(1, " of ", std::size_t{20}, std::string(" boids")), "1 of 20 boids");
  EXPECT_EQ(say(0.1), "0.1");
  EXPECT_EQ(say(), "");
}

}  // namespace
}  // namespace sturnus
