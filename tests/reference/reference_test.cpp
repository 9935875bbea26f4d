// What holds for all five references.
#include <vector>

#include "on_paper.h"

namespace reference {
namespace {

TEST(References, AnEmptyWorldStaysEmpty) {
  for (const Step& step : {ucsd({}), prog06({}), vuw_core({}), quadtree({}), cs184({})}) {
    EXPECT_TRUE(step.next.position.empty());
    EXPECT_TRUE(step.exempt.empty());
  }
}

TEST(References, ALoneBoidFeelsNoNeighbourTerm) {
  const Boids lone = boids({{{250, 250}, {5, 0}}});
  EXPECT_TRUE(near(ucsd(lone).next.velocity[0], {5, 0}));
  EXPECT_TRUE(near(quadtree(lone).next.velocity[0], {5, 0}));
  EXPECT_TRUE(near(cs184(boids({{{250, 250}, {2.5, 0}}})).next.velocity[0], {2.5, 0}));
}

}  // namespace
}  // namespace reference
