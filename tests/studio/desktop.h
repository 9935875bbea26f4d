// Panels without a window: ImGui in memory, a mouse moved by hand, and a session that is waited for.
#pragma once

#include <gtest/gtest.h>
#include <sturnus/files.h>
#include <sturnus/parameters.h>

#include "desk.h"
#include "panels/layout.h"
#include "panels/panels.h"
#include "panels/style.h"

namespace studio {

inline sturnus::Simulation opened(const char* name, std::int64_t count = 60) {
  auto scenario = sturnus::load_scenario(name);
  if (count > 0) scenario->flocks[0].count = count;
  return std::move(*sturnus::open_simulation(*scenario, 1));
}

class Desktop {
 public:
  explicit Desktop(sturnus::Simulation simulation)
      : session(std::move(simulation), {std::size_t{64} << 20, true}), desk(session) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {1280, 4000};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    load_font(1, 1);
    ImGui::GetIO().Fonts->Build();
    desk.playback.play(false);
    frame();
    frame();
  }
  ~Desktop() { ImGui::DestroyContext(); }

  void frame() {
    session.settle();
    desk.frame = session.frame();
    apply_style(desk.view.theme, 1);
    ImGui::NewFrame();
    desk.items.clear();
    desk.shapes.clear();
    desk.layout = lay_out(desk, {1280, 4000});
    show_inspector(desk);
    show_bottom(desk);
    ImGui::Render();
    session.settle();
    desk.frame = session.frame();
  }

  /// The mouse at a share of a widget's width.
  void move(const std::string& name, float part) {
    ASSERT_TRUE(desk.items.contains(name)) << name;
    const Box box = desk.items.at(name);
    ImGui::GetIO().MousePos = {box.x + part * box.width, box.y + box.height / 2};
    frame();
  }
  void hold(bool down) {
    ImGui::GetIO().MouseDown[0] = down;
    frame();
  }
  void click(const std::string& name) {
    move(name, 0.5f);
    hold(true);
    hold(false);
    frame();
  }
  /// Presses at one share of a widget and lets go at another, by way of the middle between them.
  void drag(const std::string& name, float from, float to) {
    move(name, from);
    hold(true);
    move(name, (from + to) / 2);
    move(name, to);
    hold(false);
    frame();
  }
  void run(std::uint64_t steps) {
    session.run_to(desk.frame->step + steps, desk.frame->generation);
    frame();
    frame();
  }
  void undo() {
    session.order([](World& world) {
      world.undo();
      return sturnus::Status();
    });
    frame();
    frame();
  }
  std::string value(const std::string& path) const {
    const auto text = sturnus::get_parameter(desk.scenario(), path);
    return text ? *text : "none";
  }
  double number(const std::string& path) const { return std::stod(value(path)); }

  Session session;
  Desk desk;
};

}  // namespace studio
