// Laws of drawing a draw list: places, sizes, layers and depth.
#include "draw/draw.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw/glyphs.h"

namespace sturnus {
namespace {

constexpr Size size{200, 200};
const Theme& dark = theme(ThemeName::dark);
constexpr Rgba red = rgb(0xff0000);
constexpr Rgba green = rgb(0x00ff00);

Viewpoint plane() {
  return flat_view({{0, 0, 0}}, {{200, 200, 0}}, 0);
}  // one pixel is one world length
Viewpoint space() {
  return look_at({{0, 0, 100}}, {{0, 0, 0}}, {{0, 1, 0}}, 60);
}

Image draw_glyphs(const std::vector<Glyph>& glyphs, const Viewpoint& view) {
  DrawList list;
  list.glyphs = glyphs;
  return draw(list, view, dark, size, Workers(1));
}

// The pixels that differ from the background.
struct Ink {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1, count = 0;
};

Ink ink(const Image& image, Rgba ground = dark.background) {
  Ink found;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y) == ground) continue;
      found.left = std::min(found.left, x);
      found.right = std::max(found.right, x);
      found.top = std::min(found.top, y);
      found.bottom = std::max(found.bottom, y);
      ++found.count;
    }
  }
  return found;
}

TEST(Draw, ADartIsAsLongAsItsSizeAndPointsAlongItsHeading) {
  const Ink right = ink(draw_glyphs({{{{100, 100, 0}}, {{5, 0, 0}}, 50, red, GlyphKind::dart}}, plane()));
  EXPECT_NEAR(right.right - right.left + 1, 50, 2);
  EXPECT_LT(right.bottom - right.top, 40);
  const Image up = draw_glyphs({{{{100, 100, 0}}, {{0, 1, 0}}, 50, red, GlyphKind::dart}}, plane());
  EXPECT_NEAR(ink(up).bottom - ink(up).top + 1, 50, 2);
  EXPECT_EQ(up.at(100, 80), red);               // towards the nose, above the middle
  EXPECT_EQ(up.at(100, 120), dark.background);  // in the notch
}

TEST(Draw, TurningTheWorldTurnsThePicture) {
  // By a right angle: (x, y) -> (-y, x) about the middle. Pixel (x, y) goes to (y, 199 - x).
  const Image image = draw_glyphs({{{{130, 70, 0}}, {{2, 1, 0}}, 40, red, GlyphKind::dart}}, plane());
  const Image turned = draw_glyphs({{{{130, 130, 0}}, {{-1, 2, 0}}, 40, red, GlyphKind::dart}}, plane());
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) ASSERT_NEAR(image.at(x, y).r, turned.at(y, 199 - x).r, 2) << x << ' ' << y;
  }
}

TEST(Draw, AGlyphWithoutAHeadingIsRound) {
  for (const GlyphKind kind : {GlyphKind::dart, GlyphKind::cone, GlyphKind::triangle}) {
    const Ink round = ink(draw_glyphs({{{{100, 100, 0}}, {{0, 0, 0}}, 40, red, kind}}, plane()));
    EXPECT_NEAR(round.right - round.left + 1, 40, 2);
    EXPECT_NEAR(round.bottom - round.top + 1, 40, 2);
    EXPECT_GT(ink(draw_glyphs({{{{0, 0, 0}}, {{0, 0, 0}}, 40, red, kind}}, space())).count, 100);
  }
}

TEST(Draw, TheConeIsTheFourTrianglesOfItsModel) {
  const Cone cone = cone_along({{0, 0, 2}});
  EXPECT_EQ(cone.nose, (Vec<3>{{0, 0, 0.5f}}));
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(length(cone.base[i]), 0.2f, 1e-6);
    EXPECT_NEAR(dot(cone.base[i], cone.nose), 0, 1e-6);
    EXPECT_NEAR(dot(cone.base[i], cone.base[i + 1]), 0, 1e-6);
  }
  EXPECT_EQ(cone.base[0], cone.base[4]);
}

TEST(Draw, InSpaceTheNearerGlyphHidesTheFartherWhateverTheOrder) {
  const Glyph near{{{0, 0, 20}}, {{0, 0, 0}}, 20, red, GlyphKind::ball};
  const Glyph far{{{0, 0, -20}}, {{0, 0, 0}}, 20, green, GlyphKind::ball};
  const Image first = draw_glyphs({near, far}, space());
  EXPECT_EQ(first, draw_glyphs({far, near}, space()));
  EXPECT_EQ(first.at(100, 100).g, 0);
}

TEST(Draw, TheFartherTheCloserToTheBackground) {
  Viewpoint view = space();
  view.fade_from = 50;
  view.fade_to = 150;
  const auto red_at = [&](float z) {
    return draw_glyphs({{{{0, 0, z}}, {{0, 0, 0}}, 20, rgb(0xff0000), GlyphKind::circle}}, view)
        .at(100, 100)
        .r;
  };
  EXPECT_EQ(red_at(50), 255);
  EXPECT_LT(red_at(0), 200);
  EXPECT_LT(red_at(-50), red_at(0));
}

TEST(Draw, SmallGlyphsStayVisible) {
  EXPECT_GT(ink(draw_glyphs({{{{100, 100, 0}}, {{1, 0, 0}}, 0.001f, red, GlyphKind::dart}}, plane())).count,
            2);
  EXPECT_GT(ink(draw_glyphs({{{{0, 0, 0}}, {{1, 0, 0}}, 0.001f, red, GlyphKind::cone}}, space())).count, 2);
}

TEST(Draw, LayersCoverEachOtherInTheirOrder) {
  DrawList list;
  list.boxes.push_back({{{50, 50, 0}}, {{150, 150, 0}}, green, 0, green});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)).at(100, 100), green);
  list.rings.push_back({{{100, 100, 0}}, 30, dark.text, 0, Layer::below});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)).at(100, 100), dark.text);
  list.glyphs.push_back({{{100, 100, 0}}, {{0, 0, 0}}, 30, red, GlyphKind::circle});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)).at(100, 100), red);
  list.rings.push_back({{{100, 100, 0}}, 30, dark.food, 0, Layer::above});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)).at(100, 100), dark.food);
  list.arrows.push_back({{{80, 99.5f, 0}}, {{150, 99.5f, 0}}, red, 4});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)).at(100, 100), red);
}

TEST(Draw, ARingIsAsWideAsItsRadiusSays) {
  DrawList list;
  list.rings.push_back({{{100, 100, 0}}, 60, red, 2, Layer::above});
  const Image image = draw(list, plane(), dark, size, Workers(1));
  EXPECT_NEAR(ink(image).right - ink(image).left + 1, 122, 1);
  EXPECT_EQ(image.at(100, 100), dark.background);
}

TEST(Draw, AWorldFarLargerThanThePictureFillsIt) {
  DrawList list;
  list.boxes.push_back({{{-1e7f, -1e7f, 0}}, {{1e7f, 1e7f, 0}}, red, 2, green});
  EXPECT_EQ(draw(list, plane(), dark, size, Workers(1)), Image(size, green));
}

TEST(Draw, AnArrowEndsAtItsTip) {
  DrawList list;
  list.arrows.push_back({{{20, 100, 0}}, {{160, 100, 0}}, red, 3});
  const Ink found = ink(draw(list, plane(), dark, size, Workers(1)));
  EXPECT_NEAR(found.right, 160, 1);
  EXPECT_NEAR(found.left, 19, 2);
}

TEST(Draw, ABoxInSpaceHasItsEdgesEvenAroundTheViewer) {
  DrawList list;
  list.boxes.push_back({{{-200, -30, -200}}, {{200, 30, 200}}, red, 2});
  EXPECT_GT(ink(draw(list, space(), dark, size, Workers(1))).count, 200);
}

TEST(Draw, LabelsStandAtTheirPlace) {
  if (!has_font()) GTEST_SKIP() << "built without a font";
  DrawList list;
  list.labels.push_back({"step 12", {{0.5f, 0.25f, 0}}, true, 0, 0, 20, red, Align::centre, false});
  const Ink text = ink(draw(list, plane(), dark, size, Workers(1)));
  EXPECT_NEAR(0.5 * (text.left + text.right), 100, 2);
  EXPECT_NEAR(0.5 * (text.top + text.bottom), 50, 4);
  list.labels[0].on_screen = false;
  list.labels[0].position = {{100, 20, 0}};
  EXPECT_NEAR(ink(draw(list, plane(), dark, size, Workers(1))).top, 174, 4);
}

TEST(Draw, ThePictureIsTheSameForAnyNumberOfWorkers) {
  DrawList list;
  for (int i = 0; i < 500; ++i) {
    const auto t = static_cast<float>(i);
    list.glyphs.push_back({{{60 * std::sin(t), 60 * std::cos(1.7f * t), 60 * std::sin(2.3f * t)}},
                           {{std::cos(t), std::sin(t), 0.3f}},
                           9,
                           dark.flock(static_cast<std::size_t>(i)),
                           GlyphKind::cone});
  }
  list.boxes.push_back({{{-60, -60, -60}}, {{60, 60, 60}}, dark.outline});
  for (const Viewpoint& view : {three_quarter_view({{-60, -60, -60}}, {{60, 60, 60}}, 1), plane()}) {
    const Image one = draw(list, view, dark, size, Workers(1));
    for (const int count : {2, 3, 8}) EXPECT_EQ(one, draw(list, view, dark, size, Workers(count))) << count;
  }
}

}  // namespace
}  // namespace sturnus
