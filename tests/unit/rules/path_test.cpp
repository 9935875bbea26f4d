// Places on polylines, path following and wall following.
#include <vector>

#include "vectors.h"

namespace sturnus::test {
namespace {

const std::vector<Vector> square = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};

TEST(PolylinePlaces, NearestIsThePerpendicularOrACorner) {
  const OnPolyline below = nearest_on({square}, {4, -3, 0});
  expect_close(below.at, {4, 0, 0});
  expect_close(below.along, {1, 0, 0});
  EXPECT_FLOAT_EQ(below.distance, 3);
  EXPECT_EQ(below.piece, 0u);
  EXPECT_FLOAT_EQ(below.into_piece, 4);
  expect_close(nearest_on({square}, {13, -4, 0}).at, {10, 0, 0});
  EXPECT_FLOAT_EQ(nearest_on({square}, {13, -4, 0}).distance, 5);
  expect_close(nearest_on({square}, {-1, 4, 0}).at, {0, 0, 0});        // the line is open there
  expect_close(nearest_on({square, true}, {-1, 4, 0}).at, {0, 4, 0});  // and closed here
  EXPECT_EQ(nearest_on({square, true}, {5, 5, 0}).piece, 0u);          // the first of equals
}

TEST(PolylinePlaces, FurtherOnGoesRoundCornersAndEndsWithTheLine) {
  const OnPolyline begin = nearest_on({square}, {4, -3, 0});
  expect_close(further_on({square}, begin, 5).at, {9, 0, 0});
  expect_close(further_on({square}, begin, 9).at, {10, 3, 0});
  expect_close(further_on({square}, begin, 100).at, {0, 10, 0});
  expect_close(further_on({square, true}, begin, 30).at, {0, 6, 0});
  expect_close(further_on({square, true}, begin, 38).at, {2, 0, 0});
}

TEST(PolylinePlaces, OfPointsThatCoincideAreNoTrouble) {
  const std::vector<Vector> twice = {{1, 1, 0}, {1, 1, 0}, {5, 1, 0}};
  expect_close(further_on({twice}, nearest_on({twice}, {0, 0, 0}), 2).at, {3, 1, 0});
  const std::vector<Vector> one_place = {{1, 1, 0}, {1, 1, 0}};
  expect_close(follow_path({one_place}, 1, 1, 1, {9, 9, 0}, {1, 0, 0}, 2), {});
  expect_close(follow_path({}, 1, 1, 1, {9, 9, 0}, {1, 0, 0}, 2), {});
  expect_close(follow_wall({}, 1, 1, 1, 1, {9, 9, 0}, {1, 0, 0}, 2), {});
}

// Against 20000 samples of the line in double.
RC_GTEST_PROP(PolylinePlaces, NearestIsNotFartherThanAnySample, ()) {
  std::vector<Vector> corners;
  for (int i = *rc::gen::inRange(2, 7); i > 0; --i) corners.push_back(any_vector(3, 10));
  const Vector place = any_vector(3, 20);
  const OnPolyline found = nearest_on({corners}, place);
  double least = 1e9;
  for (std::size_t piece = 0; piece + 1 < corners.size(); ++piece) {
    for (int k = 0; k <= 2000; ++k) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = double{corners[piece][axis]}, b = double{corners[piece + 1][axis]};
        sum += std::pow(a + (b - a) * k / 2000 - double{place[axis]}, 2);
      }
      least = std::min(least, std::sqrt(sum));
    }
  }
  RC_ASSERT(double{found.distance} <= least + 1e-4);
  RC_ASSERT(double{found.distance} >= least - 0.02);
}

TEST(PathFollowing, IsZeroOnThePathAndSeeksAheadOffIt) {
  const Polyline path{square};
  expect_close(follow_path(path, 1, 3, 1, {2, 0.5f, 0}, {1, 0, 0}, 2), {});
  expect_close(follow_path(path, 1, 3, 1, {2, 0.5f, 0}, {1, 0.5f, 0}, 2), {});  // exactly on the edge
  // Will be at (3, 4): nearest (3, 0), sought (6, 0), from (2, 3): 2 (4, -3)/5 - (1, 1).
  expect_close(follow_path(path, 1, 3, 1, {2, 3, 0}, {1, 1, 0}, 2), {0.6f, -2.2f, 0});
}

template <class Steer, class Check>
void walk_along(Vector at, Vector v, Steer&& steer, Check&& check) {
  const float dt = 0.05f;
  for (int step = 0; step < 6000; ++step) {
    const Vector a = steer(at, v);
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] += a[i] * dt;
      at[i] += v[i] * dt;
    }
    if (step > 1000) check(at, v);
  }
}

TEST(PathFollowing, BringsAnAgentToTheLoopAndRoundIt) {
  std::array<int, 4> pieces{};
  walk_along(
      {-8, 3, 0}, {1, 0, 0},
      [](const Vector& at, const Vector& v) {
        return follow_path({square, true}, 0.5f, 1.5f, 0.8f, at, v, 1);
      },
      [&](const Vector& at, const Vector& v) {
        const OnPolyline place = nearest_on({square, true}, at);
        EXPECT_LT(place.distance, 1.0f);
        EXPECT_GT(size_of(v), 0.3);
        ++pieces[place.piece];
      });
  for (const int steps : pieces) EXPECT_GT(steps, 500);
}

TEST(WallFollowing, SeeksTheLineBesideTheWallOnTheOwnSide) {
  const Polyline wall{square};
  // Will be at (3, 5), 5 from the wall (nearest (3, 0)); sought (6, 2) from (2, 5).
  expect_close(follow_wall(wall, 2, 0.5f, 3, 1, {2, 5, 0}, {1, 0, 0}, 5), {3, -3, 0});
  expect_close(follow_wall(wall, 2, 0.5f, 3, 1, {2, -5, 0}, {1, 0, 0}, 5), {3, 3, 0});
  expect_close(follow_wall(wall, 2, 0.5f, 3, 1, {2, 2.4f, 0}, {1, 0, 0}, 5), {});
  // Would be through the wall: back, to the own side.
  EXPECT_GT(follow_wall(wall, 2, 0.5f, 3, 1, {2, 1, 0}, {1, -3, 0}, 5)[1], 0);
  EXPECT_LT(follow_wall(wall, 2, 0.5f, 3, 1, {2, -1, 0}, {1, 3, 0}, 5)[1], 0);
  EXPECT_EQ(follow_wall(wall, 2, 0.5f, 3, 1, {2, 5, 7}, {1, 0, 2}, 5)[2], -2);
}

TEST(WallFollowing, GoesRoundAConvexWallOnTheOutsideAtItsDistance) {
  std::array<int, 4> pieces{};
  walk_along(
      {-8, 3, 0}, {1, 0, 0},
      [](const Vector& at, const Vector& v) {
        return follow_wall({square, true}, 2, 0.2f, 1, 0.8f, at, v, 1);
      },
      [&](const Vector& at, const Vector&) {
        const OnPolyline place = nearest_on({square, true}, at);
        EXPECT_FALSE(at[0] > 0 && at[0] < 10 && at[1] > 0 && at[1] < 10);
        EXPECT_NEAR(double{place.distance}, 2, 1.2);
        ++pieces[place.piece];
      });
  for (const int steps : pieces) EXPECT_GT(steps, 500);
}

// Beyond the tip the side is that of both pieces together, whichever of them is found to be nearest.
TEST(WallFollowing, TellsTheSidesOfASharpCorner) {
  const std::vector<Vector> wedge = {{-10, 1, 0}, {0, 0, 0}, {-10, -1, 0}};
  const std::vector<Vector> backwards = {wedge.rbegin(), wedge.rend()};
  for (const float y : {-0.3f, -0.1f, 0.1f, 0.3f}) {
    EXPECT_LT(follow_wall({wedge}, 2, 0.1f, 0, 0, {5, y, 0}, {}, 1)[0], 0);
    // Its line runs under the wedge on the way back: the outer side is down.
    EXPECT_LT(follow_wall({wedge}, 2, 0.1f, 3, 0, {0.1f, y, 0}, {}, 1)[1], 0) << y;
    EXPECT_GT(follow_wall({backwards}, 2, 0.1f, 3, 0, {0.1f, y, 0}, {}, 1)[1], 0) << y;
  }
}

RC_GTEST_PROP(PathAndWallFollowing, TurnAndMirrorWithTheWorld, ()) {
  const Vector at = any_vector(2, 15), v = any_vector(2, 2);
  const double angle = *rc::gen::inRange(0, 628) / 100.0;
  const std::vector<Vector> line = {{-5, 2, 0}, {1, -3, 0}, {6, 4, 0}};
  std::vector<Vector> turned_line, mirrored_line;
  for (const Vector& corner : line) {
    turned_line.push_back(turned(corner, angle));
    mirrored_line.push_back(mirrored(corner));
  }
  const Vector path = follow_path({line}, 0.5f, 2, 1, at, v, 3);
  const Vector path_turned = follow_path({turned_line}, 0.5f, 2, 1, turned(at, angle), turned(v, angle), 3);
  const OnPolyline nearest = nearest_on({line}, {at[0] + v[0], at[1] + v[1], 0});
  RC_PRE(std::abs(nearest.distance - 0.5f) > 1e-3f);
  // The direction to a place that has all but been reached is rounding.
  const OnPolyline sought = further_on({line}, nearest, 2);
  RC_PRE(size_of({sought.at[0] - at[0], sought.at[1] - at[1], 0}) > 1.5);
  // Where two pieces are equally near, rounding chooses.
  RC_PRE(nearest_on({turned_line}, turned({at[0] + v[0], at[1] + v[1], 0}, angle)).piece == nearest.piece);
  expect_close(turned(path, angle), path_turned, 5e-3);
  expect_close(mirrored(path), follow_path({mirrored_line}, 0.5f, 2, 1, mirrored(at), mirrored(v), 3), 1e-4);
  const Vector wall = follow_wall({line}, 1, 0.0f, 2, 1, at, v, 3);
  RC_PRE(std::abs(nearest.distance - 1) > 1e-3f && nearest.distance > 1e-3f);
  RC_PRE(nearest_on({line}, at).distance > 1e-3f);
  expect_close(turned(wall, angle),
               follow_wall({turned_line}, 1, 0.0f, 2, 1, turned(at, angle), turned(v, angle), 3), 5e-3);
  expect_close(mirrored(wall), follow_wall({mirrored_line}, 1, 0.0f, 2, 1, mirrored(at), mirrored(v), 3),
               1e-4);
}

}  // namespace
}  // namespace sturnus::test
