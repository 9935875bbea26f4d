// Whom the camera follows: by keys, on to another when it dies, and no longer in another world.
#include <algorithm>
#include <optional>

#include "ui.h"

namespace studio::test {
namespace {

class StudioFollowing : public Ui {};

TEST_F(StudioFollowing, TrackingFollowsAUnitAndGoesOnToTheNext) {
  open("ucsd");
  key(SDLK_t);
  frames(2);
  ASSERT_TRUE(world().explained);
  const std::uint64_t id = world().explained->id;
  key(SDLK_RIGHT);
  frames(2);
  EXPECT_EQ(world().explained->id, (id + 1) % 200);
  key(SDLK_LEFT);
  key(SDLK_LEFT);
  frames(2);
  EXPECT_EQ(world().explained->id, (id + 199) % 200);
  key(SDLK_t);
  frames(2);
  EXPECT_FALSE(world().explained);
}

TEST_F(StudioFollowing, EveryPressOfTheKeyTakesAnotherUnitAlsoInPause) {
  open("ucsd", 3);
  pause();
  std::optional<std::uint64_t> before;
  for (int i = 0; i < 8; ++i) {
    key(SDLK_t);
    ASSERT_TRUE(desk().is_tracking && world().explained);
    EXPECT_NE(before, world().explained->id);
    before = world().explained->id;
    key(SDLK_t);
    ASSERT_FALSE(desk().is_tracking);
  }
}

TEST_F(StudioFollowing, GoesOnToAnotherWhenTheUnitIsErased) {
  open("ucsd");
  pause();
  key(SDLK_t);
  frames(2);
  ASSERT_TRUE(world().tracked);
  const std::uint64_t id = world().explained->id;
  const Instance& boid = world().boids[*world().tracked];
  desk().session.act(sturnus::EraseBoids{{double{boid.position[0]}, double{boid.position[1]}}, 0.5},
                     "eraser");
  frames(3);
  ASSERT_EQ(world().ids.end(), std::find(world().ids.begin(), world().ids.end(), id));
  ASSERT_TRUE(world().explained);
  EXPECT_EQ(world().explained->id, (id + 1) % 200);
  EXPECT_TRUE(desk().is_tracking);
  desk().session.act(sturnus::EraseBoids{{0, 0}, 1e6}, "eraser");
  frames(3);
  EXPECT_FALSE(desk().is_tracking) << "nobody is left";
}

TEST_F(StudioFollowing, AnotherWorldIsNotTrackedAndUndoTracksAgain) {
  open("ucsd");
  key(SDLK_t);
  ASSERT_TRUE(world().explained);
  const std::uint64_t id = world().explained->id;
  desk().files.open(desk(), *sturnus::load_scenario("cs184"));
  frames(3);
  EXPECT_FALSE(desk().is_tracking);
  key(SDLK_t);
  EXPECT_TRUE(desk().is_tracking && world().explained) << "one press is enough";
  key(SDLK_z, KMOD_CTRL);
  frames(2);
  ASSERT_TRUE(world().explained);
  EXPECT_EQ(world().explained->id, id);
}

TEST_F(StudioFollowing, StartingAgainFollowsTheSameUnit) {
  open("ucsd");
  key(SDLK_t);
  const std::uint64_t id = world().explained->id;
  press("top.restart");
  frames(3);
  ASSERT_TRUE(world().explained);
  EXPECT_EQ(world().explained->id, id);
}

}  // namespace
}  // namespace studio::test
