// The settings: what a slider, a switch or a button does to the world, and that one undo takes it back.
#include <cmath>

#include "desktop.h"
#include "panels/values.h"

namespace studio {
namespace {

TEST(StudioInspector, ADragOfASliderIsOneUndo) {
  Desktop desktop(opened("ucsd"));
  const std::string name = desktop.desk.scenario().flocks[0].name;
  const std::string path = "flock." + name + ".cohesion.radius", before = desktop.value(path);
  desktop.drag("inspector." + path, 0.2f, 0.9f);
  const double after = desktop.number(path);
  EXPECT_GT(after, std::stod(before));
  EXPECT_EQ(desktop.desk.frame->reach.undo, path);
  desktop.undo();
  EXPECT_EQ(desktop.value(path), before);
  EXPECT_TRUE(desktop.desk.frame->reach.undo.empty());
}

TEST(StudioInspector, ASwitchedOffTermIsNotFelt) {
  Desktop desktop(opened("ucsd"));
  const std::string path = "flock." + desktop.desk.scenario().flocks[0].name + ".separation.on";
  desktop.click("inspector." + path);
  EXPECT_EQ(desktop.value(path), "false");
  sturnus::Simulation reference = opened("ucsd");
  ASSERT_TRUE(reference.push(sturnus::SetParameter{path, "false"}));
  reference.run(20);
  desktop.run(20);
  std::uint64_t hash = 0;
  desktop.session.order([&](World& world) {
    hash = world.simulation().hash();
    return sturnus::Status();
  });
  desktop.session.settle();
  EXPECT_EQ(hash, reference.hash());
}

TEST(StudioInspector, LinkedRadiiKeepTheirProportionsInOneUndo) {
  Desktop desktop(opened("ucsd"));
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  const double separation = desktop.number(base + "separation.radius"),
               alignment = desktop.number(base + "alignment.radius");
  const double cohesion = desktop.number(base + "cohesion.radius");
  desktop.click("inspector." + base + "link");
  desktop.drag("inspector." + base + "cohesion.radius", 0.3f, 0.6f);
  const double factor = desktop.number(base + "cohesion.radius") / cohesion;
  EXPECT_GT(std::abs(factor - 1), 0.1);
  EXPECT_NEAR(desktop.number(base + "separation.radius"), separation * factor, 1e-6 * separation);
  EXPECT_NEAR(desktop.number(base + "alignment.radius"), alignment * factor, 1e-6 * alignment);
  desktop.undo();
  EXPECT_EQ(desktop.number(base + "separation.radius"), separation);
  EXPECT_EQ(desktop.number(base + "alignment.radius"), alignment);
  EXPECT_EQ(desktop.number(base + "cohesion.radius"), cohesion);
}

TEST(StudioInspector, ADotResetsOneValueAndTheButtonAll) {
  Desktop desktop(opened("ucsd"));
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  const auto scenario = values_of(desktop.desk.scenario());
  desktop.drag("inspector." + base + "cohesion.radius", 0.2f, 0.9f);
  desktop.drag("inspector." + base + "alignment.radius", 0.2f, 0.9f);
  ASSERT_NE(values_of(desktop.desk.scenario()), scenario);
  desktop.click("inspector." + base + "cohesion.radius.reset");
  EXPECT_EQ(desktop.value(base + "cohesion.radius"), scenario.at(base + "cohesion.radius"));
  EXPECT_NE(desktop.value(base + "alignment.radius"), scenario.at(base + "alignment.radius"));
  EXPECT_FALSE(desktop.desk.items.contains("inspector." + base + "cohesion.radius.reset"));
  desktop.click("inspector." + base + "preset.tight");
  desktop.click("inspector.reset");
  EXPECT_EQ(values_of(desktop.desk.scenario()), scenario);
  desktop.undo();
  EXPECT_NE(values_of(desktop.desk.scenario()), scenario);
}

TEST(StudioInspector, APresetIsOneUndo) {
  Desktop desktop(opened("ucsd"));
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  const auto scenario = values_of(desktop.desk.scenario());
  desktop.click("inspector." + base + "preset.swarm");
  EXPECT_DOUBLE_EQ(desktop.number(base + "cohesion.weight"),
                   2.5 * std::stod(scenario.at(base + "cohesion.weight")));
  desktop.undo();
  EXPECT_EQ(values_of(desktop.desk.scenario()), scenario);
}

// A flock with two rows of alignment and a ring of cohesion.
sturnus::Simulation with_several_rows() {
  sturnus::ScenarioDef scenario = *sturnus::load_scenario("ucsd");
  sturnus::FlockDef& flock = scenario.flocks[0];
  flock.alignment.push_back(flock.alignment[0]);
  flock.alignment[1].weight *= 3;
  flock.cohesion[0].inner = flock.cohesion[0].radius / 4;
  return std::move(*sturnus::open_simulation(scenario, 1));
}

TEST(StudioInspector, PresetsAndLinkedRadiiReachEveryRowAndRing) {
  Desktop desktop(with_several_rows());
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  const auto weight = [&](std::size_t row) {
    return desktop.desk.scenario().flocks[0].alignment[row].weight;
  };
  const double first = weight(0), second = weight(1);
  desktop.click("inspector." + base + "preset.school");
  EXPECT_DOUBLE_EQ(weight(0), 2.5 * first);
  EXPECT_DOUBLE_EQ(weight(1), 2.5 * second);
  const sturnus::FlockDef before = desktop.desk.scenario().flocks[0];
  desktop.click("inspector." + base + "link");
  desktop.drag("inspector." + base + "separation.radius", 0.3f, 0.6f);
  const sturnus::FlockDef& after = desktop.desk.scenario().flocks[0];
  const double factor = after.separation[0].radius / before.separation[0].radius;
  EXPECT_GT(std::abs(factor - 1), 0.1);
  const auto is_scaled = [factor](double is, double was) { EXPECT_NEAR(is, was * factor, 1e-5 * is); };
  is_scaled(after.alignment[0].radius, before.alignment[0].radius);
  is_scaled(after.alignment[1].radius, before.alignment[1].radius);
  is_scaled(after.cohesion[0].inner, before.cohesion[0].inner);
  is_scaled(after.cohesion[0].radius, before.cohesion[0].radius);
}

TEST(StudioInspector, AnAbsentTermIsAddedAndUndone) {
  Desktop desktop(opened("ucsd"));
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  ASSERT_FALSE(desktop.desk.scenario().flocks[0].wander);
  desktop.run(5);
  desktop.click("inspector." + base + "wander.add");
  EXPECT_TRUE(desktop.desk.scenario().flocks[0].wander);
  EXPECT_TRUE(desktop.desk.items.contains("inspector." + base + "wander.weight"));
  desktop.undo();
  EXPECT_FALSE(desktop.desk.scenario().flocks[0].wander);
}

TEST(StudioInspector, EveryParameterIsThereOnceAllIsUnfolded) {
  Desktop desktop(opened("ucsd"));
  const std::string base = "flock." + desktop.desk.scenario().flocks[0].name + ".";
  ImGui::GetIO().DisplaySize.y = 4000;
  for (const std::string fold : {"inspector.more.fold", "inspector.pointer.fold", "inspector.time.fold",
                                 "inspector.space.boundary.fold"})
    desktop.click(fold);
  desktop.click("inspector." + base + "more.fold");
  desktop.click("inspector." + base + "limits.fold");
  for (const std::string term : {"separation", "alignment", "cohesion"})
    desktop.click("inspector." + base + term + ".all");
  for (const auto& [path, text] : values_of(desktop.desk.scenario())) {
    const bool is_there = desktop.desk.items.contains("inspector." + path);
    EXPECT_TRUE(is_there || sturnus::is_fixed_while_running(path)) << path;
  }
}

TEST(StudioValues, TextReadsBackToTheSameScenario) {
  for (const auto& shipped : sturnus::shipped_scenarios()) {
    const auto scenario = sturnus::load_scenario(shipped.name);
    ASSERT_TRUE(scenario) << shipped.name;
    for (const auto& [path, text] : values_of(*scenario)) {
      const auto known = sturnus::get_parameter(*scenario, path);
      ASSERT_TRUE(known) << path;
      EXPECT_EQ(sturnus::to_text(sturnus::parse_value(text)), sturnus::to_text(sturnus::parse_value(*known)))
          << path;
    }
  }
}

TEST(StudioValues, SpansHoldTheValueAndKnownRanges) {
  const sturnus::About angle{"degrees", "", 0, 360};
  EXPECT_EQ(span_of("field_of_view", angle, 90, 90, 100).high, 360);
  const sturnus::About weight{"", "", -1e9, 1e9};
  const Span span = span_of("weight", weight, 0.004, 0.004, 100);
  EXPECT_TRUE(span.low == 0 && span.high >= 0.016 && span.high <= 0.1 && span.is_logarithmic);
  EXPECT_GE(span_of("weight", weight, 0.1, 77, 100).high, 77);
  EXPECT_LE(span_of("weight", weight, 0.1, -3, 100).low, -3);
}

TEST(StudioTracking, TheTableShowsTheUnitAndArrowsReachTheWorld) {
  Desktop desktop(opened("ucsd"));
  desktop.desk.is_tracking = true;
  desktop.session.order([](World& world) {
    world.track(3);
    return sturnus::Status();
  });
  desktop.run(5);
  ASSERT_TRUE(desktop.desk.items.contains("inspector.tracking.cohesion"));
  Shapes shapes(desktop.desk.camera, 1);
  for (const auto& add : desktop.desk.shapes) add(shapes);
  const std::size_t all = shapes.triangles().size();
  EXPECT_GT(all, 0u);
  for (const std::string term : {"separation", "alignment", "cohesion"})
    desktop.click("inspector.tracking." + term);
  desktop.click("tracking.neighbours");
  Shapes fewer(desktop.desk.camera, 1);
  for (const auto& add : desktop.desk.shapes) add(fewer);
  EXPECT_LT(fewer.triangles().size(), all);
  const auto& boid = desktop.desk.frame->boids[*desktop.desk.frame->tracked];
  const float part = desktop.desk.playback.part(*desktop.desk.frame);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const float shown = boid.previous[axis] * (1 - part) + boid.position[axis] * part;
    EXPECT_NEAR(desktop.desk.camera.middle()[axis], shown, 1e-3f);
  }
  desktop.click("tracking.next");
  EXPECT_EQ(desktop.desk.frame->explained->id, 4u);
}

}  // namespace
}  // namespace studio
