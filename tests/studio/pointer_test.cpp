// The hand and the tools that follow the mouse: what motion may do and when, and one stroke as one deed.
#include "ui.h"

namespace studio::test {
namespace {

class StudioPointer : public Ui {
 protected:
  static constexpr float x = 560, y = 330;

  // In the past of a world that flew for a while, paused there.
  void scrub_to(std::uint64_t step) {
    desk().playback.play(false);
    desk().session.go_to(step);
    frames(3);
    ASSERT_EQ(world().step, step);
  }
};

TEST_F(StudioPointer, MotionInThePastChangesNothingUntilAClick) {
  open("ucsd");
  frames(100);
  scrub_to(20);
  const std::uint64_t last = world().reach.last, before = hash();
  for (const SDL_Keycode tool : {SDLK_5, SDLK_6}) {
    key(tool);
    for (int i = 0; i < 5; ++i) move(x + static_cast<float>(10 * i), y);
    move(20, 20);  // over the top bar
    frames(2);
  }
  EXPECT_EQ(world().reach.last, last) << "the future was cut";
  EXPECT_EQ(hash(), before);
  click(x, y);
  EXPECT_EQ(world().reach.last, 20u);
  EXPECT_TRUE(world().pointer.pressed);
  EXPECT_EQ(world().pointer.mode, sturnus::PointerMode::repel);
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(world().reach.last, last);
  EXPECT_EQ(hash(), before);
}

TEST_F(StudioPointer, ToolsOfTheCursorLetGoAsSoonAsAnotherIsChosen) {
  open("ucsd");
  key(SDLK_5);
  move(x, y);
  frames(2);
  ASSERT_TRUE(world().pointer.pressed);
  key(SDLK_6);
  EXPECT_TRUE(world().pointer.pressed);
  EXPECT_EQ(world().pointer.mode, sturnus::PointerMode::repel);
  key(SDLK_1);
  EXPECT_FALSE(world().pointer.pressed);
  key(SDLK_5);
  EXPECT_TRUE(world().pointer.pressed) << "the mouse is over the world";
  EXPECT_NEAR(world().pointer.at[0], desk().camera.place(x, y, {})[0], 0.5);
}

TEST_F(StudioPointer, AHandOfThePastLetsGoWhenTheUserGoesOn) {
  open("ucsd");
  move(x, y);
  button(true);
  move(x + 40, y);
  frames(60);
  button(false);
  frames(30);
  scrub_to(15);
  ASSERT_TRUE(world().pointer.pressed);
  key(SDLK_1);
  click(x, y);
  EXPECT_FALSE(world().pointer.pressed);
}

TEST_F(StudioPointer, AStrokeIsOneDeed) {
  open("ucsd");
  pause();
  const std::uint64_t before = hash();
  drag(x, y, x + 100, y);
  frames(2);
  EXPECT_EQ(world().reach.undo, "drag");
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(hash(), before);
  EXPECT_TRUE(world().reach.undo.empty());
  key(SDLK_5);
  move(x + 5, y);
  frames(2);
  EXPECT_EQ(world().reach.undo, "follow cursor");
  EXPECT_TRUE(world().pointer.pressed);
  key(SDLK_SPACE);
  frames(30);
  key(SDLK_z, KMOD_CTRL);
  move(x + 9, y);
  frames(2);
  EXPECT_FALSE(world().pointer.pressed) << "motion begins no stroke after an undo";
  EXPECT_EQ(world().reach.redo, "follow cursor");
  move(20, 20);
  move(x, y);
  frames(2);
  EXPECT_TRUE(world().pointer.pressed) << "entering the world does";
}

}  // namespace
}  // namespace studio::test
