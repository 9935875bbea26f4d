// Two thousand uses of everything, at random: nothing breaks, and what was done is a scenario that ends
// alike.
#include <random>

#include "ui.h"

namespace studio::test {
namespace {

constexpr int uses = 2000;

class StudioRandomUse : public Ui {
 protected:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  float x() { return static_cast<float>(number(0, window_size().width - 1)); }
  float y() { return static_cast<float>(number(0, window_size().height - 1)); }

  sturnus::Size window_size() const override { return {560, 360}; }

  void use_once() {
    constexpr SDL_Keycode keys[] = {SDLK_0, SDLK_1,        SDLK_2,     SDLK_3,    SDLK_4,     SDLK_5,
                                    SDLK_6, SDLK_7,        SDLK_8,     SDLK_s,    SDLK_SPACE, SDLK_PERIOD,
                                    SDLK_t, SDLK_UP,       SDLK_DOWN,  SDLK_LEFT, SDLK_RIGHT, SDLK_f,
                                    SDLK_g, SDLK_QUESTION, SDLK_ESCAPE};
    constexpr Uint8 buttons[] = {SDL_BUTTON_LEFT, SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE};
    const Uint8 which = buttons[number(0, 3)];
    switch (number(0, 9)) {
      case 0:
      case 1:
      case 2:
        return key(keys[number(0, static_cast<int>(std::size(keys)) - 1)]);
      case 3:
      case 4:
        return click(x(), y(), which);
      case 5:
        return drag(x(), y(), x(), y(), which, number(1, 5));
      case 6:
        return wheel(number(-2, 2), number(0, 1) == 0 ? KMOD_NONE : KMOD_CTRL);
      case 7:
        return key(SDLK_z, number(0, 2) == 0 ? KMOD_CTRL | KMOD_SHIFT : KMOD_CTRL);
      case 8:
        return use_widget();
      default:
        return frames(number(1, 4));
    }
  }

  void use_widget() {
    if (desk().items.empty()) return;
    auto item = desk().items.begin();
    std::advance(item, number(0, static_cast<int>(desk().items.size()) - 1));
    if (is_outside(item->first)) return;
    const Box box = item->second;
    drag(box.x + box.width / 2, box.y + box.height / 2,
         box.x + box.width * static_cast<float>(number(0, 10)) / 10, box.y + box.height / 2, SDL_BUTTON_LEFT,
         2);
  }

  // What leaves the world for another or writes files again and again.
  static bool is_outside(const std::string& item) {
    return item.find("record") != item.npos || item.find("save") != item.npos ||
           item.find("csv") != item.npos;
  }

  // More would only take longer.
  void keep_small() {
    if (world().boids.size() <= 1500) return;
    desk().session.act(
        sturnus::EraseBoids{sturnus::Coordinates(static_cast<std::size_t>(world().dimensions), 0.0), 400},
        "eraser");
    frames();
  }

  std::mt19937 random_{20241};
};

TEST_F(StudioRandomUse, EndsInAWorldThatItsRecordingEndsInToo) {
  open("sharks-and-fish", 80);
  for (int i = 0; i < uses; ++i) {
    use_once();
    keep_small();
    ASSERT_FALSE(desk().wants_quit) << "after " << i << " uses";
  }
  const auto [recording, step, last] = ask([](World& asked) {
    const sturnus::Simulation& simulation = asked.simulation();
    return std::tuple(simulation.recording(), simulation.step_number(), simulation.hash());
  });
  auto replay = sturnus::open_simulation(recording, 1);
  ASSERT_TRUE(replay) << replay.error();
  EXPECT_FALSE(recording.run.events.empty());
  replay->run(step - replay->step_number());
  EXPECT_EQ(replay->hash(), last) << recording.run.events.size() << " events, " << step << " steps";
}

}  // namespace
}  // namespace studio::test
