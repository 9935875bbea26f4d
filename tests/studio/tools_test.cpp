// Every tool and every key, as hands use them: what they do to the world, and that undo takes it back.
#include <set>

#include "ui.h"

namespace studio::test {
namespace {

class StudioTools : public Ui {
 protected:
  // A place of the window where the world is, and nothing lies above it.
  static constexpr float x = 560, y = 330;

  Point place() { return desk().camera.place(x, y, world().centre); }
  std::size_t boids() { return world().boids.size(); }

  // Boids within a radius of the mouse's line.
  std::size_t near(float radius) {
    const Ray ray = desk().camera.ray(x, y);
    std::size_t count = 0;
    for (const Instance& boid : world().boids)
      count += distance(ray, {boid.position[0], boid.position[1], boid.position[2]}) <= radius ? 1u : 0u;
    return count;
  }
};

TEST_F(StudioTools, UnitsAreAddedInPowersOfTwoWhereTheClickIs) {
  open("ucsd");
  pause();
  key(SDLK_1);
  EXPECT_EQ(desk().tools.tool, Tool::add);
  key(SDLK_UP);
  EXPECT_EQ(desk().tools.units_per_click(), 16);
  const auto around = static_cast<float>(world().scenario->flocks[0].size) * 4.01f;
  const std::size_t before = near(around);
  click(x, y);
  EXPECT_EQ(boids(), 216u);
  EXPECT_GE(near(around), before + 16);
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(boids(), 200u);
  key(SDLK_z, KMOD_CTRL | KMOD_SHIFT);
  EXPECT_EQ(boids(), 216u);
}

TEST_F(StudioTools, APressThatComesWithTheMotionOntoAPanelIsThePanels) {
  open("ucsd");
  pause();
  key(SDLK_1);
  move(x, y);
  const Box& panel = desk().layout.inspector;
  push_motion(panel.x + panel.width / 2, panel.y + panel.height - 4);
  button(true);
  button(false);
  frames(3);
  EXPECT_EQ(boids(), 200u);
  push_motion(x, y);
  frames();
  button(true);
  button(false);
  frames(3);
  EXPECT_EQ(boids(), 208u);
}

TEST_F(StudioTools, AnObstacleIsPlacedAndEverybodyLearnsToAvoidIt) {
  open("ucsd");
  pause();
  ASSERT_FALSE(world().scenario->flocks[0].avoid_obstacles);
  key(SDLK_2);
  click(x, y);
  ASSERT_EQ(world().obstacles.size(), 1u);
  EXPECT_NEAR(world().obstacles[0].at[0], place()[0], 0.5);
  EXPECT_TRUE(world().scenario->flocks[0].avoid_obstacles);
  key(SDLK_z, KMOD_CTRL);
  EXPECT_TRUE(world().obstacles.empty());
  EXPECT_FALSE(world().scenario->flocks[0].avoid_obstacles);
}

TEST_F(StudioTools, AnAttractorIsPlacedAndErased) {
  open("ucsd");
  pause();
  key(SDLK_3);
  click(x, y);
  ASSERT_EQ(world().targets.size(), 1u);
  EXPECT_FALSE(world().targets[0].repels);
  key(SDLK_z, KMOD_CTRL);
  EXPECT_TRUE(world().targets.empty());
  key(SDLK_y, KMOD_CTRL);
  ASSERT_EQ(world().targets.size(), 1u);
  key(SDLK_4);
  click(x, y);
  EXPECT_TRUE(world().targets.empty());
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(world().targets.size(), 1u);
}

TEST_F(StudioTools, AnErasedObstacleComesBackByUndo) {
  open("ucsd");
  pause();
  key(SDLK_2);
  click(x, y);
  const std::vector<sturnus::Obstacle> placed = world().obstacles;
  ASSERT_EQ(placed.size(), 1u);
  key(SDLK_4);
  click(x, y);
  EXPECT_TRUE(world().obstacles.empty());
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(world().obstacles, placed);
}

TEST_F(StudioTools, TheEraserTakesWhatItIsDraggedOverInOneStroke) {
  open("ucsd", 600);
  pause();
  key(SDLK_4);
  move(x, y);
  const float radius = desk().tools.radius;
  wheel(2, KMOD_CTRL);
  EXPECT_GT(desk().tools.radius, radius);
  drag(300, y, 800, y);
  EXPECT_EQ(near(desk().tools.radius * 0.99f), 0u);
  EXPECT_LT(boids(), 600u);
  EXPECT_EQ(world().reach.undo, "eraser");
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(boids(), 600u);
}

TEST_F(StudioTools, TheCursorIsFollowedAndAvoidedWhileItIsOverTheWorld) {
  open("ucsd");
  key(SDLK_5);
  move(x, y);
  frames(2);
  EXPECT_TRUE(world().pointer.pressed);
  EXPECT_EQ(world().pointer.mode, sturnus::PointerMode::attract);
  EXPECT_NEAR(world().pointer.at[0], place()[0], 0.5);
  key(SDLK_6);
  move(x + 5, y);
  frames(2);
  EXPECT_EQ(world().pointer.mode, sturnus::PointerMode::repel);
  move(20, 20);  // over the top bar
  frames(2);
  EXPECT_FALSE(world().pointer.pressed);
  move(x, y);
  key(SDLK_0);
  move(x + 1, y);
  frames(2);
  EXPECT_FALSE(world().pointer.pressed);
}

TEST_F(StudioTools, TheHandAttractsWithTheLeftAndRepelsWithTheRightButton) {
  open("ucsd");
  for (const auto& [which, mode] : {std::pair{SDL_BUTTON_LEFT, sturnus::PointerMode::attract},
                                    std::pair{SDL_BUTTON_RIGHT, sturnus::PointerMode::repel}}) {
    move(x, y);
    button(true, static_cast<Uint8>(which));
    move(x + 30, y + 10);
    frames(2);
    EXPECT_TRUE(world().pointer.pressed);
    EXPECT_EQ(world().pointer.mode, mode);
    button(false, static_cast<Uint8>(which));
    frames(2);
    EXPECT_FALSE(world().pointer.pressed);
  }
}

TEST_F(StudioTools, FoodIsLaidOutWhereSomebodyEatsIt) {
  open("sharks-and-fish");
  pause();
  const std::size_t before = world().food.size();
  key(SDLK_7);
  click(x, y);
  EXPECT_EQ(world().food.size(), before + 1);
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(world().food.size(), before);
}

TEST_F(StudioTools, PredatorsComeOneByOne) {
  open("cs184-death");
  pause();
  std::size_t before = 0, after = 0;
  for (const Instance& boid : world().boids) before += (boid.flags & is_hunter) != 0 ? 1u : 0u;
  key(SDLK_8);
  click(x, y);
  for (const Instance& boid : world().boids) after += (boid.flags & is_hunter) != 0 ? 1u : 0u;
  EXPECT_EQ(after, before + 1);
  const std::size_t all = boids();
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(boids(), all - 1);
}

TEST_F(StudioTools, ScatterIsABurstAroundTheCursor) {
  open("ucsd", 600);
  pause();
  move(x, y);
  const std::uint64_t calm = hash();
  key(SDLK_s);
  EXPECT_EQ(desk().tools.tool, Tool::scatter);
  EXPECT_EQ(world().reach.undo, "scatter");
  key(SDLK_z, KMOD_CTRL);
  EXPECT_EQ(hash(), calm);
  key(SDLK_y, KMOD_CTRL);
  const Point centre = place();
  std::size_t checked = 0;
  for (const Instance& boid : world().boids) {
    const float ox = boid.position[0] - centre[0], oy = boid.position[1] - centre[1];
    const float away = std::hypot(ox, oy);
    if (away > desk().tools.radius * 0.95f || away < 1) continue;
    const float speed = std::hypot(boid.velocity[0], boid.velocity[1]);
    EXPECT_NEAR((boid.velocity[0] * ox + boid.velocity[1] * oy) / (speed * away), 1, 1e-3);
    ++checked;
  }
  EXPECT_GT(checked, 0u);
}

TEST_F(StudioTools, InSpaceTheEraserReachesAlongTheLineOfSight) {
  open("murmuration", 800);
  pause();
  ASSERT_EQ(world().dimensions, 3);
  auto middle = seen(world().centre);
  for (float& pixel : middle) pixel = std::floor(pixel);
  key(SDLK_4);
  move(middle[0], middle[1]);
  const float radius = desk().tools.radius;
  const Ray ray = desk().camera.ray(middle[0], middle[1]);
  click(middle[0], middle[1]);
  EXPECT_LT(boids(), 800u);
  for (const Instance& boid : world().boids)
    EXPECT_GT(distance(ray, {boid.position[0], boid.position[1], boid.position[2]}), radius * 0.99f);
}

TEST_F(StudioTools, InSpaceScatterDrivesAwayFromTheLineOfSight) {
  open("murmuration", 800);
  pause();
  const auto middle = seen(world().centre);
  const float mx = std::floor(middle[0]), my = std::floor(middle[1]);
  move(mx, my);
  const Ray ray = desk().camera.ray(mx, my);
  key(SDLK_s);
  std::size_t checked = 0;
  for (const Instance& boid : world().boids) {
    const Point at{boid.position[0], boid.position[1], boid.position[2]},
        way{boid.velocity[0], boid.velocity[1], boid.velocity[2]};
    const float away = distance(ray, at);
    if (away > desk().tools.radius * 0.95f || away < 1) continue;
    const Point offset = at - ray.from;
    const Point aside = offset - ray.along * dot(offset, ray.along);
    EXPECT_NEAR(dot(way, aside) / (length(way) * away), 1, 1e-3);
    ++checked;
  }
  EXPECT_GT(checked, 10u);
}

TEST_F(StudioTools, InSpaceTheCursorIsALineThatIsFollowedAndAvoided) {
  open("murmuration");
  pause();
  for (const auto& [tool, mode] :
       {std::pair{SDLK_5, sturnus::PointerMode::attract}, std::pair{SDLK_6, sturnus::PointerMode::repel}}) {
    key(tool);
    move(x, y);
    move(x + 20, y + 10);
    frames(2);
    const sturnus::PointerState& pointer = world().pointer;
    ASSERT_TRUE(pointer.pressed);
    EXPECT_EQ(pointer.mode, mode);
    const Ray ray = desk().camera.ray(x + 20, y + 10);
    EXPECT_NEAR(dot(ray.along, {pointer.along[0], pointer.along[1], pointer.along[2]}), 1, 1e-5);
    EXPECT_NEAR(distance(ray, {pointer.at[0], pointer.at[1], pointer.at[2]}), 0, 0.05);
  }
}

TEST_F(StudioTools, InSpaceNewThingsGoToThePlaneThroughTheFlocksMiddle) {
  open("murmuration");
  pause();
  drag(x, y, x + 60, y + 25, SDL_BUTTON_MIDDLE);  // a view of its own
  const Point centre = world().centre, facing = desk().camera.forward();
  const Ray ray = desk().camera.ray(x, y);
  const auto expect_there = [&](const Point& at) {
    EXPECT_NEAR(dot(at - centre, facing), 0, 0.05);
    EXPECT_NEAR(distance(ray, at), 0, 0.05);
  };
  key(SDLK_2);
  click(x, y);
  ASSERT_EQ(world().obstacles.size(), 1u);
  expect_there({world().obstacles[0].at[0], world().obstacles[0].at[1], world().obstacles[0].at[2]});
  key(SDLK_3);
  click(x, y);
  ASSERT_EQ(world().targets.size(), 1u);
  expect_there({world().targets[0].at[0], world().targets[0].at[1], world().targets[0].at[2]});
  key(SDLK_1);
  while (desk().tools.power > 0) key(SDLK_DOWN);
  const std::set<std::uint64_t> before(world().ids.begin(), world().ids.end());
  click(x, y);
  ASSERT_EQ(world().boids.size(), before.size() + 1);
  for (std::size_t i = 0; i < world().ids.size(); ++i) {
    const Instance& boid = world().boids[i];
    if (before.count(world().ids[i]) == 0)
      expect_there({boid.position[0], boid.position[1], boid.position[2]});
  }
}

TEST_F(StudioTools, SpacePlaysAndPausesAndAPointIsOneStep) {
  open("ucsd");
  key(SDLK_SPACE);
  frames(3);
  const std::uint64_t step = world().step;
  frames(10);
  EXPECT_EQ(world().step, step);
  key(SDLK_PERIOD);
  frames(3);
  EXPECT_EQ(world().step, step + 1);
  key(SDLK_a);
  frames(10);
  EXPECT_GT(world().step, step + 3);
}

TEST_F(StudioTools, TheTopBarPlaysStepsRestartsAndChangesTheTheme) {
  open("ucsd");
  frames(20);
  press("top.play");
  frames(3);
  const std::uint64_t step = world().step;
  press("top.step");
  EXPECT_EQ(world().step, step + 1);
  press("top.start");
  frames(2);
  EXPECT_EQ(world().step, 0u);
  const std::uint64_t before = hash();
  press("top.new_seed");
  frames(2);
  EXPECT_NE(hash(), before);
  key(SDLK_z, KMOD_CTRL);
  frames(2);
  EXPECT_EQ(hash(), before);
  press("top.theme");
  EXPECT_EQ(desk().view.theme, sturnus::ThemeName::light);
}

TEST_F(StudioTools, CtrlAndPlusMakeTheTextLarger) {
  open("ucsd");
  key(SDLK_EQUALS, KMOD_CTRL);
  EXPECT_GT(desk().text_scale, 1);
  key(SDLK_0, KMOD_CTRL);
  EXPECT_EQ(desk().text_scale, 1);
}

TEST_F(StudioTools, TheLegendChoosesToolsAndFoldsAway) {
  open("ucsd");
  press("legend.eraser");
  EXPECT_EQ(desk().tools.tool, Tool::eraser);
  press("tool.add units");
  EXPECT_EQ(desk().tools.tool, Tool::add);
  press("legend.fold");
  frames(2);
  EXPECT_FALSE(desk().items.count("legend.eraser"));
  key(SDLK_QUESTION);
  EXPECT_TRUE(desk().open.help);
}

TEST_F(StudioTools, TheViewMenuColoursDrawsTrailsAndCells) {
  open("ucsd", 600);
  frames(40);
  press("top.view");
  frames(2);
  press("view.trails");
  press("view.cells");
  press("view.grid");
  frames(2);
  EXPECT_TRUE(desk().view.trails && desk().view.grid);
  EXPECT_FALSE(world().index_boxes.empty());
  press("view.colour");
  frames(2);
  press("view.colour.neighbours");
  frames(3);
  std::size_t crowded = 0;
  for (const Instance& boid : world().boids) crowded += boid.crowd > 0 ? 1u : 0u;
  EXPECT_GT(crowded, 100u);
}

TEST_F(StudioTools, TheViewMenuMakesUnitsLargerAndAsTheyWere) {
  open("ucsd");
  press("top.view");
  frames(2);
  drag_item("view.size", 20);
  frames(2);
  EXPECT_GT(desk().view.size, 1.5f);
  const Box box = desk().items["view.size"];
  click(box.x + box.width / 2, box.y + box.height / 2, SDL_BUTTON_RIGHT);
  frames(2);
  EXPECT_EQ(desk().view.size, 1);
}

TEST_F(StudioTools, EscapeClosesTheViewMenu) {
  open("ucsd");
  press("top.view");
  frames(2);
  ASSERT_TRUE(desk().items.contains("view.trails"));
  key(SDLK_ESCAPE);
  frames(3);
  EXPECT_FALSE(desk().items.contains("view.trails"));
}

TEST_F(StudioTools, APictureShowsTheWorldAloneAndInItsMiddle) {
  open("ucsd");
  pause();
  frames(2);
  const sturnus::Image image = studio_->picture(false);
  const auto is_edge = [&](int px, int py) { return image.at(px, py).g > 200; };
  int left = 0, right = 0, above = 0, below = 0;
  const int middle = image.height / 2;
  while (left < image.width && !is_edge(left, middle)) ++left;
  while (right < image.width && !is_edge(image.width - 1 - right, middle)) ++right;
  while (above < image.height && !is_edge(image.width / 2 + 3, above)) ++above;
  while (below < image.height && !is_edge(image.width / 2 + 3, image.height - 1 - below)) ++below;
  EXPECT_NEAR(left, right, 2);
  EXPECT_NEAR(above, below, 2);
  EXPECT_LT(std::min(left, above), 0.1 * image.height) << "as large as it fits";
}

TEST_F(StudioTools, APictureOfTheWorldIsSaved) {
  open("ucsd");
  pause();
  key(SDLK_w);
  frames(2);
  const std::string name = "ucsd-" + std::to_string(world().step);
  EXPECT_TRUE(std::filesystem::exists(name + ".png"));
  EXPECT_FALSE(std::filesystem::exists(name + "-2.png"));
  key(SDLK_w);
  frames(2);
  EXPECT_TRUE(std::filesystem::exists(name + "-2.png"));
}

}  // namespace
}  // namespace studio::test
