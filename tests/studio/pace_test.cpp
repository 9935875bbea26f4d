// Speed, and that the window keeps its pace.
#include <atomic>
#include <memory>
#include <thread>

#include "ui.h"

namespace studio::test {
namespace {

class StudioPace : public Ui {};

TEST_F(StudioPace, TheSliderSetsTheSpeed) {
  open("ucsd");
  const auto steps_in_a_second = [&] {
    const std::uint64_t before = world().step;
    frames(60);
    return world().step - before;
  };
  EXPECT_NEAR(static_cast<double>(steps_in_a_second()), 30, 1);
  drag_item("top.speed", 400, 0.5f);
  EXPECT_EQ(desk().playback.speed(), Playback::fastest);
  EXPECT_NEAR(static_cast<double>(steps_in_a_second()), 3000, 60);
  drag_item("top.speed", -400, 0.5f);
  EXPECT_NEAR(desk().playback.speed(), Playback::slowest, 1e-6);
  EXPECT_NEAR(static_cast<double>(steps_in_a_second()), 3, 1);
  const Box box = desk().items["top.speed"];
  click(box.x + box.width / 2, box.y + box.height / 2, SDL_BUTTON_RIGHT);
  EXPECT_EQ(desk().playback.speed(), 1);
}

// A rule that lasts until it is let go stands for a huge world.
struct SlowRule {
  std::atomic<int> begun = 0;
  std::atomic<bool> may_end = false, gave_up = false;

  void run() {
    ++begun;
    for (int tenths = 0; !may_end; ++tenths) {
      gave_up = gave_up || tenths > 300;
      if (gave_up) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
};

TEST_F(StudioPace, ASlowStepDoesNotHoldTheWindowUp) {
  auto scenario = *sturnus::load_scenario("ucsd");
  scenario.flocks[0].count = 50;
  auto simulation = sturnus::open_simulation(scenario, 1);
  ASSERT_TRUE(simulation);
  const auto slow = std::make_shared<SlowRule>();
  simulation->add_rule("slow", 0, [slow](const sturnus::View&, sturnus::Accelerations&) { slow->run(); });
  StudioOptions options;
  options.points = {400, 300};
  options.threads = 1;
  auto opened = Studio::open(std::move(*simulation), options);
  ASSERT_TRUE(opened) << opened.error();
  studio_ = std::move(*opened);
  while (slow->begun == 0) frames();
  const std::uint64_t step = world().step;
  frames(120);
  EXPECT_EQ(slow->begun, 1) << "two seconds of frames, and still the same step";
  EXPECT_FALSE(slow->gave_up) << "the window waited for the step";
  EXPECT_EQ(world().step, step);
  slow->may_end = true;
  while (world().step == step) frames();
  EXPECT_LE(world().step, step + 5) << "what was missed is not made up for";
}

TEST_F(StudioPace, AMouseOverTheWorldLooksAtNoBoid) {
  Frame frame;
  frame.dimensions = 3;
  frame.extent = {{0, 0, 0}, {100, 100, 100}};
  frame.centre = {20, 30, 40};
  frame.boids.resize(3);  // at the origin, where their mean would be
  Camera camera;
  camera.resize({800, 600});
  camera.fit(frame.extent, 3);
  for (const Tool tool : {Tool::add, Tool::eraser, Tool::scatter}) {
    Tools tools;
    tools.tool = tool;
    const Point at = tools.place({300, 200, true}, frame, camera);
    EXPECT_NEAR(dot(at - Point{20, 30, 40}, camera.forward()), 0, 1e-3);
    Shapes shown(camera, 1), shown_without(camera, 1);
    tools.show({300, 200, true}, frame, camera, sturnus::ThemeName::dark, shown);
    Frame empty = frame;
    empty.boids.clear();
    tools.show({300, 200, true}, empty, camera, sturnus::ThemeName::dark, shown_without);
    ASSERT_EQ(shown.triangles().size(), shown_without.triangles().size());
    for (std::size_t i = 0; i < shown.triangles().size(); ++i)
      EXPECT_EQ(shown.triangles()[i].position, shown_without.triangles()[i].position);
  }
}

}  // namespace
}  // namespace studio::test
