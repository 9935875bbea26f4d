// Two thousand uses of everything, at random, where sanitizers watch, and some without: nothing breaks, and
// what was done is a scenario that ends alike.
#include <algorithm>
#include <random>

#include "studio_support.h"
#include "ui.h"

namespace studio::test {
namespace {

#if defined(__clang__)
constexpr bool is_watched = __has_feature(address_sanitizer);
#else
constexpr bool is_watched = false;
#endif
constexpr int uses = is_watched ? 2000 : 600;

class StudioRandomUse : public Ui {
 protected:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  float x() { return static_cast<float>(number(0, window_size().width - 1)); }
  float y() { return static_cast<float>(number(0, window_size().height - 1)); }

  sturnus::Size window_size() const override { return {560, 360}; }

  void use_once() {
    constexpr SDL_Keycode keys[] = {SDLK_0, SDLK_1,      SDLK_2,     SDLK_3,    SDLK_4,        SDLK_5,
                                    SDLK_6, SDLK_7,      SDLK_8,     SDLK_s,    SDLK_SPACE,    SDLK_a,
                                    SDLK_t, SDLK_UP,     SDLK_DOWN,  SDLK_LEFT, SDLK_f,        SDLK_g,
                                    SDLK_w, SDLK_PERIOD, SDLK_RIGHT, SDLK_r,    SDLK_QUESTION, SDLK_ESCAPE};
    constexpr Uint8 buttons[] = {SDL_BUTTON_LEFT, SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE};
    const Uint8 which = buttons[number(0, 3)];
    switch (number(0, 10)) {
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
      case 9:
        return use_files();
      default:
        return frames(number(1, 4));
    }
  }

  void use_files() {
    constexpr SDL_Keycode commands[] = {SDLK_c, SDLK_v, SDLK_y};
    const char* files[] = {"pond.toml", "state.csv", "bad.toml"};
    const int which = number(0, 9);
    if (which < 3) return drop(files[which]);
    key(commands[which % 3], KMOD_CTRL);
  }

  void drop(const char* file) {
    SDL_Event event{};
    event.type = SDL_DROPFILE;
    event.drop.file = SDL_strdup(file);
    SDL_PushEvent(&event);
    frames(2);
  }

  // The events file of a world that was left, or of the last one: its replay, and what the program says.
  void expect_replay(const Timeline& left) {
    const std::string file = "left-" + std::to_string(left.number) + ".toml";
    std::filesystem::remove(file);
    ASSERT_TRUE(write_session(left, file));
    const auto saved = sturnus::load_scenario(file);
    ASSERT_TRUE(saved) << saved.error();
    auto replay = sturnus::open_simulation(*saved, 1);
    ASSERT_TRUE(replay) << replay.error();
    replay->run(left.simulation.step_number() - replay->step_number());
    EXPECT_EQ(replay->hash(), left.simulation.hash())
        << file << ": " << saved->run.events.size() << " events, " << saved->run.steps << " steps";
    ++replayed_;
    events_ += saved->run.events.size();
#ifdef STURNUS_PROGRAM
    char expected[32];
    std::snprintf(expected, sizeof expected, "%016llx",
                  static_cast<unsigned long long>(left.simulation.hash()));
    const std::string steps = std::to_string(saved->run.steps);
    EXPECT_SAYS(output_of(STURNUS_PROGRAM " run " + file + " --steps " + steps + " 2>&1"), expected);
#endif
  }

  // A world that is left is replayed as it was left.
  void notice_leaving() {
    const std::uint64_t now = ask([](World& asked) { return asked.number(); });
    if (now == number_) return;
    const auto others = ask([](World& asked) { return asked.others(); });
    const auto left = std::find_if(others.begin(), others.end(),
                                   [&](const auto& other) { return other->number == number_; });
    ASSERT_NE(left, others.end()) << "a world that was left is forgotten";
    expect_replay(**left);
    number_ = now;
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
           item.find("csv") != item.npos || item.find("gallery.try") != item.npos;
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
  std::uint64_t number_ = 0;
  std::size_t replayed_ = 0, events_ = 0;
};

TEST_F(StudioRandomUse, EveryWorldOfItEndsAsItsSavedEventsEnd) {
  open("sharks-and-fish", 80);
  sturnus::ScenarioDef pond = *world().scenario;
  pond.run.events = {{3, sturnus::AddFood{"plankton", 3, {400, 300}, 20}}};
  ASSERT_TRUE(sturnus::write_text("pond.toml", to_toml(pond)));
  ASSERT_TRUE(sturnus::write_text("bad.toml", "boids = many\n"));
  const std::string state = ask([](World& asked) { return state_csv(asked.simulation().view().state()); });
  ASSERT_TRUE(sturnus::write_text("state.csv", state));
  for (int i = 0; i < uses; ++i) {
    use_once();
    keep_small();
    notice_leaving();
    ASSERT_FALSE(desk().wants_quit) << "after " << i << " uses";
    ASSERT_FALSE(HasFailure()) << "after " << i << " uses";
  }
  ask([this](World& asked) {
    expect_replay(asked.timeline());
    return 0;
  });
  EXPECT_GT(replayed_, uses / 100u);
  EXPECT_GT(events_, uses / 100u);
}

}  // namespace
}  // namespace studio::test
