// prog06's way from animation data to geometry, held to the assignment's words.
#include <gtest/gtest.h>

#include <cmath>

#include "cones.h"

namespace prog06 {
namespace {

using sturnus::Frame3;
using sturnus::Point3;

constexpr sturnus::Rgba colour = sturnus::rgb(0x123456);

TEST(Prog06Cones, CornersAreThoseOfTheAssignment) {
  const Point3 p = {0.5f, -0.25f, 2};
  const Frame3 frame;  // u, v and w are the axes
  const auto faces = cone(p, frame, 1, colour);
  const Point3 nose = {0.5f, -0.25f, 2.5f};
  const Point3 u = {0.7f, -0.25f, 2}, v = {0.5f, -0.05f, 2}, minus_u = {0.3f, -0.25f, 2},
               minus_v = {0.5f, -0.45f, 2};
  const Point3 expected[4][3] = {
      {nose, u, v}, {nose, v, minus_u}, {nose, minus_u, minus_v}, {nose, minus_v, u}};
  for (std::size_t face = 0; face < 4; ++face) {
    EXPECT_EQ(faces[face].colour, colour);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(faces[face].corners[corner][axis], expected[face][corner][axis], 1e-6)
            << face << ' ' << corner << ' ' << axis;
      }
    }
  }
}

TEST(Prog06Cones, TheSizeMultipliesAllOffsets) {
  const auto whole = cone({}, *sturnus::frame_along({1, 2, 3}), 1, colour);
  const auto half = cone({}, *sturnus::frame_along({1, 2, 3}), 0.5f, colour);
  for (std::size_t face = 0; face < 4; ++face) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_FLOAT_EQ(half[face].corners[corner][axis], 0.5f * whole[face].corners[corner][axis]);
      }
    }
  }
}

// A world of three boids with these ids and velocities.
struct World {
  sturnus::State state;
  sturnus::ScenarioDef scenario;
  sturnus::Columns none;

  World() {
    state.id = {2, 0, 1};
    state.next_id = 3;
    state.flock = {0, 0, 0};
    state.quarantined = {0, 0, 0};
    state.position = {{{1, 2, 3}, {4, 5, 6}, {}}};
    state.velocity = {{{0, -3, 0}, {2, 0, 0}, {}}};
  }
  sturnus::View view() const { return {state, scenario, none, none}; }
};

TEST(Prog06Cones, ABoidAtRestKeepsTheFrameItHad) {
  World world;
  Cones cones(1);
  cones.follow(world.view());
  EXPECT_EQ(cones.frame(2).w, (Point3{0, 1, 0}));
  EXPECT_EQ(cones.frame(0).w, (Point3{-1, 0, 0}));
  EXPECT_EQ(cones.frame(1).w, (Point3{1, 0, 0}));  // never moved
  // The storage order changes, and everybody stops or meets a bad number.
  world.state.id = {0, 1, 2};
  world.state.velocity = {{{0, 0, NAN}, {0, -1, 0}, {}}};
  cones.follow(world.view());
  EXPECT_EQ(cones.frame(0).w, (Point3{-1, 0, 0}));
  EXPECT_EQ(cones.frame(1).w, (Point3{0, -1, 0}));
  EXPECT_EQ(cones.frame(2).w, (Point3{0, 1, 0}));
}

TEST(Prog06Cones, EveryBoidIsFourTrianglesAtItsPlaceAlongItsVelocity) {
  World world;
  Cones cones(0.1f);
  cones.follow(world.view());
  const auto triangles = cones.triangles(world.view());
  ASSERT_EQ(triangles.size(), 12u);
  EXPECT_NEAR(triangles[0].corners[0][0], 1, 1e-6);  // the first in storage: id 2 at (1, 4), upwards
  EXPECT_NEAR(triangles[0].corners[0][1], 4.05, 1e-6);
  EXPECT_NEAR(triangles[4].corners[0][0], 1.95, 1e-6);  // id 0 at (2, 5), to the left
  world.state.quarantined[1] = 1;
  EXPECT_EQ(cones.triangles(world.view()).size(), 8u);
}

TEST(Prog06Cones, OppositeHeadingsHaveDifferentColours) {
  EXPECT_NE(heading_colour({1, 0, 0}), heading_colour({-1, 0, 0}));
  EXPECT_NE(heading_colour({0, 1, 0}), heading_colour({0, -1, 0}));
  const sturnus::Rgba towards = heading_colour({0, 0, 1});
  EXPECT_EQ(towards.r, towards.g);
  EXPECT_EQ(towards.g, towards.b);
}

}  // namespace
}  // namespace prog06
