// Small windows and large text: panels stand still, nothing runs out of them, and all tools can be reached.
#include "panels/layout.h"

#include <algorithm>
#include <sstream>

#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"
#include "ui.h"
#include "view/colours.h"

namespace studio {
namespace {

struct Case {
  sturnus::Size size;
  int presses = 0;  // of Ctrl and plus: each makes text a tenth larger
};

class StudioLayout : public test::Ui, public testing::WithParamInterface<Case> {
 protected:
  sturnus::Size window_size() const override { return GetParam().size; }
  void SetUp() override {
    Ui::SetUp();
    open("sharks-and-fish");
    for (int i = 0; i < GetParam().presses; ++i) key(SDLK_EQUALS, KMOD_CTRL);
    desk().playback.play(false);
    frames(5);
  }
  static bool holds(const Box& outer, const Box& inner) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
  }
  static bool overlap(const Box& a, const Box& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
  }
  // What stands in one panel, by the beginning of its names.
  std::map<std::string, Box> of(const std::string& beginning) {
    std::map<std::string, Box> found;
    for (const auto& [name, box] : desk().items) {
      if (name.starts_with(beginning)) found[name] = box;
    }
    return found;
  }
  void expect_apart(const std::map<std::string, Box>& items, const Box& panel) {
    for (auto one = items.begin(); one != items.end(); ++one) {
      EXPECT_TRUE(holds(panel, one->second)) << one->first << " runs out of its panel";
      for (auto other = std::next(one); other != items.end(); ++other)
        EXPECT_FALSE(overlap(one->second, other->second)) << one->first << " lies over " << other->first;
    }
  }
};

TEST_P(StudioLayout, StandsStillFromFrameToFrame) {
  const auto before = desk().items;
  for (int i = 0; i < 4; ++i) {
    frames();
    ASSERT_EQ(desk().items.size(), before.size());
    for (const auto& [name, box] : desk().items) {
      const Box& was = before.at(name);
      EXPECT_TRUE(box.x == was.x && box.y == was.y && box.width == was.width && box.height == was.height)
          << name << " in frame " << i;
    }
  }
}

TEST_P(StudioLayout, EveryToolIsInTheColumnAndWorks) {
  const auto tools = of("tool.");
  EXPECT_EQ(tools.size(), tool_list().size() + 2) << "tracking and the legend";
  expect_apart(tools, desk().layout.tools);
  for (const ToolInfo& info : tool_list()) {
    press(std::string("tool.") + info.name);
    EXPECT_EQ(desk().tools.tool, info.tool) << info.name;
  }
}

TEST_P(StudioLayout, TheBarHoldsItsButtons) {
  expect_apart(of("top."), desk().layout.top);
  press("top.theme");
  EXPECT_EQ(desk().view.theme, sturnus::ThemeName::light);
  press("top.view");
  ASSERT_TRUE(desk().items.contains("view.trails"));
  for (const auto& [name, box] : of("view."))
    EXPECT_TRUE(holds(desk().layout.world, box)) << name << " runs out of the window";
}

TEST_P(StudioLayout, PlotsHaveRoomAndTheTimelineIsBesideThem) {
  const Box panel = desk().layout.bottom;
  for (const auto& [name, box] : of("plot.")) {
    EXPECT_GE(box.width, 7 * 15 * desk().text_scale) << name;
    EXPECT_GE(box.height, 30) << name;
    EXPECT_LE(box.y + box.height, panel.y + panel.height) << name;
  }
  EXPECT_GE(desk().items.at("timeline").width, 100);
  std::map<std::string, Box> row = of("timeline");
  for (const auto& [name, box] : of("plots.")) row[name] = box;
  row["bottom.fold"] = desk().items.at("bottom.fold");
  expect_apart(row, panel);
}

TEST_P(StudioLayout, TheLegendNeverHidesHalfOfTheWorldUnasked) {
  const Box free = free_area(desk());
  EXPECT_GT(free.width, 100);
  EXPECT_GT(free.height, 100);
  if (desk().items.contains("legend")) {
    const Box legend = desk().items.at("legend");
    EXPECT_LE(legend.width, 0.5f * free.width + 1);
    EXPECT_TRUE(holds(free, legend));
  } else {
    press("tool.legend");
    frames(3);
    ASSERT_TRUE(desk().items.contains("legend")) << "who asks for it sees it";
    EXPECT_LE(desk().items.at("legend").height, free.height + 1);
  }
}

TEST_P(StudioLayout, TermsOfTheTrackedUnitAreWhole) {
  press("tool.track");
  frames(5);
  ASSERT_TRUE(desk().is_tracking);
  const Box panel = desk().layout.inspector;
  const auto names = of("tracking.name.");
  EXPECT_GT(names.size(), 5u);
  for (const auto& [name, box] : names) {
    // Each word is whole; several stand below each other where there is little room.
    std::string words = name.substr(std::string("tracking.name.").size());
    std::replace(words.begin(), words.end(), '_', ' ');
    std::istringstream stream(words);
    for (std::string word; stream >> word;)
      EXPECT_GE(box.width, ImGui::CalcTextSize(word.c_str()).x - 1) << name;
    EXPECT_LE(box.x + box.width, panel.x + panel.width) << name;
  }
  press("tool.track");
  frames(3);
  EXPECT_FALSE(desk().is_tracking);
}

INSTANTIATE_TEST_SUITE_P(Sizes, StudioLayout,
                         testing::Values(Case{{1280, 800}, 0}, Case{{800, 600}, 0}, Case{{800, 600}, 5},
                                         Case{{1280, 800}, 5}, Case{{640, 480}, 0}),
                         [](const auto& tried) {
                           const Case& at = tried.param;
                           return "Size" + std::to_string(at.size.width) + "x" +
                                  std::to_string(at.size.height) + "Plus" + std::to_string(at.presses);
                         });

class StudioLooks : public test::Ui {};

TEST_F(StudioLooks, TheLegendHasTrackingToo) {
  open("ucsd");
  press("legend.track");
  frames(3);
  EXPECT_TRUE(desk().is_tracking);
  EXPECT_TRUE(world().tracked.has_value());
  press("tool.track");
  frames(3);
  EXPECT_FALSE(desk().is_tracking);
}

TEST_F(StudioLooks, ASecondVisitKnowsWhatTheFirstFoldedAwayAndThatTheHintWasSeen) {
  memory_ = "state/sturnus/studio.txt";
  open("ucsd");
  EXPECT_TRUE(desk().open.legend && desk().open.hint) << "a first visit";
  press("legend.fold");
  desk().seconds += 13;
  frames(2);
  EXPECT_FALSE(desk().open.hint) << "it faded";
  studio_.reset();
  open("ucsd");
  EXPECT_FALSE(desk().open.legend);
  EXPECT_FALSE(desk().open.hint);
  press("tool.legend");
  frames(2);
  studio_.reset();
  open("ucsd");
  EXPECT_TRUE(desk().open.legend) << "unfolded again";
}

TEST_F(StudioLooks, PopupsHaveAnEdge) {
  open("ucsd");
  EXPECT_GE(ImGui::GetStyle().PopupBorderSize, 1);
}

// Contrast as the Web Content Accessibility Guidelines count it.
double contrast(sturnus::Rgba a, sturnus::Rgba b) {
  const auto light = [](sturnus::Rgba colour) {
    const auto part = [](std::uint8_t byte) {
      const double c = byte / 255.0;
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(colour.r) + 0.7152 * part(colour.g) + 0.0722 * part(colour.b);
  };
  const double one = light(a) + 0.05, other = light(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

TEST(StudioColours, EveryToolIsSeenOnBothGrounds) {
  for (const sturnus::ThemeName theme : {sturnus::ThemeName::dark, sturnus::ThemeName::light}) {
    for (const ToolInfo& info : tool_list())
      EXPECT_GE(contrast(colour_on(theme, info.colour), palette(theme).surface), 2) << info.name;
  }
}

TEST(StudioColours, TheEdgeOfTheWorldIsWhiteOnDarkAndDarkOnLight) {
  EXPECT_EQ(colours(sturnus::ThemeName::dark).edge, sturnus::rgb(0xffffff));
  const Colours& light = colours(sturnus::ThemeName::light);
  EXPECT_GE(contrast(light.edge, light.background), 10);
}

TEST(StudioWords, AreShortenedToTheirRoom) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  load_font(1, 1);
  ImGui::GetIO().Fonts->Build();
  ImGui::GetIO().DisplaySize = {100, 100};
  ImGui::NewFrame();
  for (const float room : {20.0f, 50.0f, 80.0f}) {
    const std::string text = shortened("Nearest neighbour \u00e4\u00f6\u00fc", room);
    EXPECT_LE(ImGui::CalcTextSize(text.c_str()).x, room);
    EXPECT_TRUE(text.ends_with("\u2026"));
  }
  EXPECT_EQ(shortened("short", 100), "short");
  ImGui::EndFrame();
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace studio
