// The picture of one boid's terms: arrows as long as they should be, reaches, and neighbours where they are
// seen.
#include "observe/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace sturnus::test {
namespace {

SceneColours some_colours() {
  SceneColours out;
  out.outline = rgb(0x111111);
  out.surface = rgb(0x222222);
  out.text = rgb(0xffffff);
  for (std::size_t i = 0; i < out.terms.size(); ++i) out.terms[i] = rgb(0xa00000 + static_cast<unsigned>(i));
  return out;
}
const SceneColours colours = some_colours();

ScenarioDef two_terms() {
  ScenarioDef scenario = bare();
  scenario.space.boundary.kind = BoundaryKind::wrap;
  scenario.flocks.front().separation = {{.weight = 1, .radius = 10}};
  scenario.flocks.front().cohesion = {{.weight = 0.1, .radius = 40, .order = 1}};
  return scenario;
}

// One near, one farther away over the seam, one out of sight.
const std::vector<Placed> boids = {{{-995, 0}, {1, 0}}, {{-995, 5}}, {{985, 0}}, {{-900, 0}}};

struct Picture {
  Explanation told;
  DrawList list;
  std::vector<Rgba> colour;  ///< by id, because these boids are few
};

Picture picture_of(const ScenarioDef& scenario) {
  const Simulation simulation = world_of(scenario, boids);
  Picture out{take(simulation.explain(0)), {}, {}};
  add_vectors(simulation.view(), out.told, colours, 60, out.list);
  const auto by_slot = vector_colours(simulation.view(), out.told, colours);
  for (const std::uint32_t slot : simulation.view().slots_by_id()) out.colour.push_back(by_slot[slot]);
  return out;
}

float length_of(const Arrow& arrow) {
  return length(arrow.to - arrow.from);
}

TEST(Vectors, ArrowsStartAtTheBoidAndKeepTheirProportions) {
  const Picture picture = picture_of(two_terms());
  ASSERT_EQ(picture.list.arrows.size(), 3u);  // the acceleration and two terms
  float longest = 0;
  for (const Arrow& arrow : picture.list.arrows) {
    EXPECT_EQ(arrow.from, (Vec<3>{{-995, 0, 0}}));
    longest = std::max(longest, length_of(arrow));
  }
  EXPECT_NEAR(longest, 60, 1e-3);
  // Separation -(0, 5)/25; cohesion 0.1 of the mean of (0, 5) and (-20, 0).
  const double scale = 60 / std::hypot(1.0, 0.25);  // cohesion is the longest
  const Vec<3> separation = picture.list.arrows[1].to - picture.list.arrows[1].from;
  EXPECT_NEAR(separation[1], -0.2 * scale, 1e-3);
  const Vec<3> cohesion = picture.list.arrows[2].to - picture.list.arrows[2].from;
  EXPECT_NEAR(cohesion[0], -1 * scale, 1e-3);
  EXPECT_NEAR(cohesion[1], 0.25 * scale, 1e-3);
}

TEST(Vectors, EachNeighbourHasTheColourOfTheTermThatLooksLeastFar) {
  const Picture picture = picture_of(two_terms());
  EXPECT_EQ(picture.colour[0], colours.text);
  EXPECT_EQ(picture.colour[1], colours.terms[0]);
  EXPECT_EQ(picture.colour[2], colours.terms[2]);
  for (const Rgba term : colours.terms) EXPECT_NE(picture.colour[3], term);
}

TEST(Vectors, WhoIsSeenOverTheSeamStandsWhereTheBoidSeesHim) {
  const Picture picture = picture_of(two_terms());
  ASSERT_EQ(picture.list.glyphs.size(), 1u);
  EXPECT_EQ(picture.list.glyphs.front().position, (Vec<3>{{-1015, 0, 0}}));
  ScenarioDef open = two_terms();
  open.space.boundary.kind = BoundaryKind::open;
  EXPECT_TRUE(picture_of(open).list.glyphs.empty());
}

TEST(Vectors, ReachesAreRingsAndWithABlindAngleArcs) {
  const Picture all_round = picture_of(two_terms());
  ASSERT_EQ(all_round.list.rings.size(), 2u);
  EXPECT_FLOAT_EQ(all_round.list.rings[0].radius, 10);
  EXPECT_FLOAT_EQ(all_round.list.rings[1].radius, 40);
  ScenarioDef scenario = two_terms();
  scenario.flocks.front().field_of_view = 200;
  const Picture picture = picture_of(scenario);
  EXPECT_TRUE(picture.list.rings.empty());
  for (const Segment& segment : picture.list.segments) {
    for (const Vec<3>& end : {segment.from, segment.to}) {
      const Vec<3> o = end - Vec<3>{{-995, 0, 0}};
      const bool on_an_arc =
          std::abs(length(o) - 10) < 1e-3 || std::abs(length(o) - 40) < 1e-3 || length(o) == 0;
      EXPECT_TRUE(on_an_arc) << length(o);
      EXPECT_GE(o[0], std::cos(100.01 * 3.14159265 / 180) * length(o) - 1e-3);
    }
  }
}

TEST(Vectors, WhatIsNotGrantedIsAThinLine) {
  ScenarioDef scenario = two_terms();
  scenario.flocks.front().arbitration = Arbitration::budget;
  scenario.flocks.front().max_acceleration = 0.5;
  const Picture picture = picture_of(scenario);
  // 0.2 of separation, then what is left for cohesion.
  const Vec<3> cohesion = picture.list.arrows[2].to - picture.list.arrows[2].from;
  ASSERT_EQ(picture.list.segments.size(), 1u);
  const Segment& rest = picture.list.segments.front();
  EXPECT_EQ(rest.from, picture.list.arrows[2].to);
  EXPECT_NEAR(length(cohesion) / length(rest.to - picture.list.arrows[2].from), 0.3 / std::hypot(1, 0.25),
              1e-4);
}

TEST(Vectors, TheBoidInTheMiddleIsTheNearestToIt) {
  EXPECT_EQ(boid_in_the_middle(world_of(bare(), {{{9, 0}}, {{-5, 1}}, {{5, 1}}}).view()), 1u);
  EXPECT_EQ(boid_in_the_middle(world_of(bare(), {}).view()), std::nullopt);
}

}  // namespace
}  // namespace sturnus::test
