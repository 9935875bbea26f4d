// The timeline winds the world back; the plots hold what was measured and forget futures that are gone.
#include <algorithm>
#include <filesystem>

#include "desktop.h"
#include "panels/plots.h"

namespace studio {
namespace {

TEST(StudioTimeline, DraggingItGoesToTheStep) {
  Desktop desktop(opened("ucsd"));
  desktop.run(100);
  ASSERT_EQ(desktop.desk.frame->step, 100u);
  desktop.drag("timeline", 1, 0.25f);
  EXPECT_NEAR(static_cast<double>(desktop.desk.frame->step), 25, 1);
  EXPECT_EQ(desktop.desk.frame->reach.last, 100u);
  EXPECT_FALSE(desktop.desk.playback.is_playing());
}

TEST(StudioTimeline, ItsButtonsUndoAndRedo) {
  Desktop desktop(opened("ucsd"));
  desktop.session.act(sturnus::EraseBoids{{0, 0}, 1e6}, "erase");
  desktop.frame();
  desktop.frame();
  ASSERT_EQ(desktop.desk.frame->boids.size(), 0u);
  desktop.click("timeline.undo");
  EXPECT_EQ(desktop.desk.frame->boids.size(), 60u);
  desktop.click("timeline.redo");
  EXPECT_EQ(desktop.desk.frame->boids.size(), 0u);
}

TEST(StudioPlots, HoldOneLineForEveryMeasuredStepInOrder) {
  Desktop desktop(opened("ucsd"));
  desktop.run(100);
  const auto every = static_cast<std::uint64_t>(desktop.desk.scenario().run.measure_every);
  const auto& lines = desktop.desk.plots.lines;
  ASSERT_EQ(lines.size(), 100 / every + 1);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].sample.measures.step, i * every);
  sturnus::Simulation reference = opened("ucsd");
  reference.run(100);
  EXPECT_EQ(lines.back().sample.measures.polarisation, sturnus::measure(reference.view()).polarisation);
}

TEST(StudioPlots, ADeedInThePastCutsThemAndScrubbingDoesNot) {
  Desktop desktop(opened("ucsd"));
  desktop.run(100);
  desktop.session.go_to(40);
  desktop.frame();
  desktop.frame();
  EXPECT_EQ(desktop.desk.plots.lines.back().sample.measures.step, 100u);
  desktop.session.act(sturnus::ScatterBoids{{0, 0}, 50}, "scatter");
  desktop.frame();
  desktop.frame();
  EXPECT_EQ(desktop.desk.plots.lines.back().sample.measures.step, 40u);
}

TEST(StudioPlots, WhatIsChangedWhileTheWorldRestsIsPlottedAtOnce) {
  Desktop desktop(opened("two-flocks"));
  desktop.run(23);
  const auto& lines = desktop.desk.plots.lines;
  const std::size_t before = lines.back().sample.population[0];
  const std::string flock = desktop.desk.scenario().flocks[0].name;
  desktop.session.act(sturnus::AddBoids{flock, 16, {100, 100}, 5}, "add units");
  desktop.frame();
  desktop.frame();
  EXPECT_EQ(lines.back().sample.measures.step, desktop.desk.frame->step);
  EXPECT_EQ(lines.back().sample.population[0], before + 16);
  desktop.undo();
  desktop.frame();
  EXPECT_EQ(lines.back().sample.population[0], before);
}

TEST(StudioPlots, AnotherScenarioBeginsAnew) {
  Desktop desktop(opened("ucsd"));
  desktop.run(100);
  desktop.session.order([](World& world) {
    world.replace(opened("ucsd", 20), "open");
    return sturnus::Status();
  });
  desktop.frame();
  desktop.frame();
  desktop.run(10);
  for (const PlotLine& line : desktop.desk.plots.lines) EXPECT_EQ(line.sample.population[0], 20u);
}

TEST(StudioPlots, TheTableHasALineForEachAndAColumnForEachFlock) {
  Desktop desktop(opened("two-flocks"));
  desktop.run(50);
  const std::string text = plots_csv(desktop.desk.plots, desktop.desk.scenario());
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(lines, desktop.desk.plots.lines.size() + 1);
  EXPECT_NE(text.find("polarisation"), std::string::npos);
  const std::string head = text.substr(0, text.find('\n')),
                    last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(last.begin(), last.end(), ','));
  for (const sturnus::FlockDef& flock : desktop.desk.scenario().flocks)
    EXPECT_NE(head.find(",population." + flock.name + ","), std::string::npos) << head;
  EXPECT_NE(last.find(",60,"), std::string::npos) << last;
}

// The words of the bottom and of its tooltip, as ImGui logs them.
std::string hovered(Desktop& desktop, const std::string& plot, float part) {
  desktop.move(plot, part);
  desktop.frame();
  ImGui::SetClipboardText("");
  ImGui::NewFrame();
  desktop.desk.items.clear();
  ImGui::LogToClipboard();
  show_bottom(desktop.desk);
  ImGui::LogFinish();
  ImGui::Render();
  return ImGui::GetClipboardText();
}

TEST(StudioPlots, TellTheValuesOfTheMomentUnderTheMouse) {
  Desktop desktop(opened("two-flocks"));
  desktop.run(100);
  const std::string middle = hovered(desktop, "plot.population", 0.5f);
  EXPECT_NE(middle.find("step 50"), std::string::npos) << middle;
  for (const sturnus::FlockDef& flock : desktop.desk.scenario().flocks) {
    const std::string line = flock.name + "  " + std::to_string(flock.count);
    EXPECT_NE(middle.find(line), std::string::npos) << middle;
  }
  const std::string end = hovered(desktop, "plot.polarisation", 0.99f);
  EXPECT_NE(end.find("step 100"), std::string::npos) << end;
  EXPECT_NE(end.find("Polarisation  0."), std::string::npos) << end;
}

TEST(StudioPlots, AreSavedAsATableAndAPictureUnderNamesThatAreFree) {
  const std::filesystem::path old = std::filesystem::current_path();
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "studio-measures";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);
  Desktop desktop(opened("ucsd"));
  desktop.run(50);
  for (const char* name : {"plots.csv", "plots.csv", "plots.png"}) desktop.click(name);
  std::filesystem::current_path(old);
  const auto text = sturnus::read_text((folder / "ucsd-50-measures.csv").string());
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, plots_csv(desktop.desk.plots, desktop.desk.scenario()));
  EXPECT_TRUE(std::filesystem::exists(folder / "ucsd-50-measures-2.csv"));
  const auto picture = sturnus::read_text((folder / "ucsd-50-measures.png").string());
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->substr(1, 3), "PNG");
}

TEST(StudioBottom, FoldsToOneLine) {
  Desktop desktop(opened("ucsd"));
  ASSERT_TRUE(desktop.desk.items.contains("plot.polarisation"));
  desktop.click("bottom.fold");
  EXPECT_FALSE(desktop.desk.items.contains("plot.polarisation"));
  EXPECT_TRUE(desktop.desk.items.contains("timeline"));
}

}  // namespace
}  // namespace studio
