// Laws of the contact sheet: every picture is there, whole, in its place.
#include "draw/sheet.h"

#include "draw/font.h"

#include <gtest/gtest.h>

namespace sturnus {
namespace {

const Theme& dark = theme(ThemeName::dark);

bool contains_at(const Image& sheet, int left, int top, const Image& picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!(sheet.at(left + x, top + y) == picture.at(x, y))) return false;
    }
  }
  return true;
}

TEST(Sheet, PicturesStandInRowsAndColumns) {
  std::vector<Image> pictures;
  for (std::uint8_t i = 0; i < 5; ++i) pictures.emplace_back(Size{40, 30}, Rgba{i, 99, 200, 255});
  const Image sheet = contact_sheet(pictures, {}, 3, dark, Workers(1));
  EXPECT_EQ(sheet.size(), (Size{12 + 3 * 52, 12 + 2 * 42}));
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(contains_at(sheet, 12 + i % 3 * 52, 12 + i / 3 * 42, pictures[static_cast<std::size_t>(i)]))
        << i;
  }
}

TEST(Sheet, SmallerPicturesStandInTheMiddleOfTheirCell) {
  const Image large({40, 30}, dark.text);
  const Image small({20, 10}, dark.food);
  EXPECT_TRUE(
      contains_at(contact_sheet({large, small}, {}, 2, dark, Workers(1)), 12 + 52 + 10, 12 + 10, small));
}

TEST(Sheet, CaptionsHaveRoomAndInkBelowTheirPicture) {
  const Image picture({120, 30}, dark.background);
  const Image sheet = contact_sheet({picture}, {"step 30"}, 1, dark, Workers(1));
  EXPECT_EQ(sheet.height, 12 + 30 + 26 + 12);
  bool has_ink = !has_font();
  for (int x = 0; x < sheet.width; ++x) has_ink = has_ink || !(sheet.at(x, 12 + 30 + 13) == dark.background);
  EXPECT_TRUE(has_ink);
}

TEST(Sheet, NoPicturesMakeAnEmptySheet) {
  EXPECT_EQ(contact_sheet({}, {"nothing"}, 4, dark, Workers(1)).rgb.size() % 3, 0u);
}

}  // namespace
}  // namespace sturnus
