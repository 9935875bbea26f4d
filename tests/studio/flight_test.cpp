// The camera under a person's hands: what each button and key does to it, and that the world knows nothing of
// it.
#include "ui.h"

namespace studio::test {
namespace {

class StudioFlight : public Ui {
 protected:
  static constexpr float x = 560, y = 330;

  void hold(SDL_Keycode code, bool down, int mod) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.sym = code;
    event.key.keysym.scancode = SDL_GetScancodeFromKey(code);
    event.key.keysym.mod = static_cast<Uint16>(mod);
    SDL_SetModState(static_cast<SDL_Keymod>(mod));
    SDL_PushEvent(&event);
    frames();
  }
  void expect_near(const Point& one, const Point& other, float within) {
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(one[axis], other[axis], within) << axis;
  }
};

TEST_F(StudioFlight, TheWheelZoomsToWhatIsUnderTheMouse) {
  open("ucsd");
  pause();
  move(x, y);
  const Point held = desk().camera.place(x, y, {});
  const float before = desk().camera.pixel_length(held);
  wheel(3);
  EXPECT_LT(desk().camera.pixel_length(held), before * 0.8f);
  const auto pixel = seen(held);
  EXPECT_NEAR(pixel[0], x, 0.1);
  EXPECT_NEAR(pixel[1], y, 0.1);
}

TEST_F(StudioFlight, InThePlaneTheMiddleButtonAndAltWithTheLeftOnePan) {
  open("ucsd");
  pause();
  for (const bool with_alt : {false, true}) {
    const Point held = desk().camera.place(x, y, {});
    SDL_SetModState(with_alt ? KMOD_LALT : KMOD_NONE);
    drag(x, y, x + 90, y + 30, with_alt ? SDL_BUTTON_LEFT : SDL_BUTTON_MIDDLE);
    SDL_SetModState(KMOD_NONE);
    const auto pixel = seen(held);
    EXPECT_NEAR(pixel[0], x + 90, 1);
    EXPECT_NEAR(pixel[1], y + 30, 1);
  }
  EXPECT_TRUE(world().reach.undo.empty()) << "looking changes nothing";
  EXPECT_FALSE(world().pointer.pressed);
}

TEST_F(StudioFlight, InSpaceTheyOrbitAroundTheMiddle) {
  open("murmuration");
  pause();
  for (const bool with_alt : {false, true}) {
    const Point middle = desk().camera.middle(), facing = desk().camera.forward();
    SDL_SetModState(with_alt ? KMOD_LALT : KMOD_NONE);
    drag(x, y, x + 90, y + 30, with_alt ? SDL_BUTTON_LEFT : SDL_BUTTON_MIDDLE);
    SDL_SetModState(KMOD_NONE);
    expect_near(desk().camera.middle(), middle, 0);
    EXPECT_LT(dot(desk().camera.forward(), facing), 0.99f) << "it did not turn";
  }
  EXPECT_TRUE(world().reach.undo.empty());
  EXPECT_FALSE(world().pointer.pressed);
}

TEST_F(StudioFlight, ShiftAndTheRightButtonLookAndLettersFlyUntilOneOfThemIsLetGo) {
  open("murmuration");
  pause();
  move(x, y);
  SDL_SetModState(KMOD_LSHIFT);
  button(true, SDL_BUTTON_RIGHT);
  const Point eye = desk().camera.eye(), facing = desk().camera.forward();
  move(x + 70, y + 20);
  expect_near(desk().camera.eye(), eye, 0.05f);
  EXPECT_LT(dot(desk().camera.forward(), facing), 0.999f);
  for (const auto& [code, way] :
       {std::pair{SDLK_w, desk().camera.forward()}, std::pair{SDLK_s, desk().camera.forward() * -1.0f},
        std::pair{SDLK_d, desk().camera.right()}, std::pair{SDLK_a, desk().camera.right() * -1.0f}}) {
    const Point before = desk().camera.eye();
    hold(code, true, KMOD_LSHIFT);
    frames(10);
    hold(code, false, KMOD_LSHIFT);
    const Point flown = desk().camera.eye() - before;
    ASSERT_GT(length(flown), 0) << SDL_GetKeyName(code);
    EXPECT_NEAR(dot(flown, way) / length(flown), 1, 1e-3) << SDL_GetKeyName(code);
  }
  hold(SDLK_w, true, KMOD_LSHIFT);
  SDL_SetModState(KMOD_NONE);  // Shift is let go, the letter and the button are not
  frames();
  const Point there = desk().camera.eye();
  frames(10);
  EXPECT_EQ(desk().camera.eye(), there) << "it flies on without Shift";
  hold(SDLK_w, false, KMOD_NONE);
  for (const SDL_Keycode code : {SDLK_w, SDLK_a, SDLK_s}) key(code);
  EXPECT_TRUE(std::filesystem::is_empty(std::filesystem::current_path())) << "a picture was saved";
  EXPECT_FALSE(desk().playback.is_playing());
  EXPECT_EQ(desk().tools.tool, Tool::hand);
  EXPECT_TRUE(world().reach.undo.empty());
  button(false, SDL_BUTTON_RIGHT);
  key(SDLK_a);
  EXPECT_TRUE(desk().playback.is_playing()) << "letters are shortcuts again";
}

TEST_F(StudioFlight, TheKeyFShowsTheWholeAgain) {
  open("murmuration");
  pause();
  key(SDLK_f);
  const Point eye = desk().camera.eye();
  move(x, y);
  wheel(5);
  drag(x, y, x + 90, y + 30, SDL_BUTTON_MIDDLE);
  EXPECT_GT(length(desk().camera.eye() - eye), 1);
  key(SDLK_f);
  expect_near(desk().camera.eye(), eye, 1e-3f);
}

}  // namespace
}  // namespace studio::test
