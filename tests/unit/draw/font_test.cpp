// Laws of text: it has ink, the ink is where the text is said to be, and odd bytes do no harm.
#include "draw/font.h"

#include <gtest/gtest.h>

#include <string>

namespace sturnus {
namespace {

class FontTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_font()) GTEST_SKIP() << "built without a font";
  }
};

int total(const TextInk& ink) {
  int sum = 0;
  for (const std::uint8_t cover : ink.cover) sum += cover;
  return sum;
}

TEST_F(FontTest, TextHasInkAndSpacesHaveNone) {
  EXPECT_GT(total(text_ink("flock", 16, 0)), 1000);
  EXPECT_EQ(total(text_ink("   ", 16, 0)), 0);
  EXPECT_EQ(total(text_ink("", 16, 0)), 0);
}

TEST_F(FontTest, TheInkStaysInsideItsBox) {
  for (const char* text : {"murmuration", "jÄgÅ|fWf_", "1.25 k"}) {
    for (const float size : {7.0f, 13.0f, 40.5f}) {
      const TextInk ink = text_ink(text, size, 0.7f);
      // The rim of the box stays empty: no letter was cut off.
      for (int x = 0; x < ink.width; ++x) {
        EXPECT_EQ(ink.cover[static_cast<std::size_t>(x)], 0) << text << ' ' << size;
        EXPECT_EQ(ink.cover[static_cast<std::size_t>((ink.height - 1) * ink.width + x)], 0)
            << text << ' ' << size;
      }
      for (int y = 0; y < ink.height; ++y) {
        EXPECT_EQ(ink.cover[static_cast<std::size_t>(y * ink.width)], 0) << text << ' ' << size;
        EXPECT_EQ(ink.cover[static_cast<std::size_t>(y * ink.width + ink.width - 1)], 0)
            << text << ' ' << size;
      }
      EXPECT_LE(ink.width, static_cast<int>(text_width(text, size)) + 6);
    }
  }
}

TEST_F(FontTest, WidthGrowsWithTheTextAndWithItsSize) {
  EXPECT_GT(text_width("flocks", 16), text_width("flock", 16));
  EXPECT_NEAR(text_width("flock", 32), 2 * text_width("flock", 16), 1e-3);
  EXPECT_EQ(text_width("", 16), 0);
}

TEST_F(FontTest, SeveralBytesMakeOneLetter) {
  EXPECT_EQ(text_width("ä", 16), text_width("a", 16));
  EXPECT_EQ(text_width("…", 16), text_width("\xe2\x80\xa6", 16));
}

TEST_F(FontTest, BytesThatAreNoTextDoNoHarm) {
  for (const std::string& text : {std::string("\xff\xfe"), std::string("a\xc3"), std::string("\xe2\x82"),
                                  std::string("\xf0\x9f\x90\xa6"), std::string("\0b", 2)}) {
    EXPECT_GT(text_width(text, 16), 0);
    EXPECT_GT(total(text_ink(text, 16, 0)), 0);
  }
}

TEST_F(FontTest, CapitalsReachTheirHeight) {
  const TextInk ink = text_ink("H", 100, 0);
  int first = 0;
  while (total({0,
                0,
                0,
                0,
                {ink.cover.begin() + first * ink.width, ink.cover.begin() + (first + 1) * ink.width}}) == 0) {
    ++first;
  }
  EXPECT_NEAR(-(ink.top + first), capital_height(100), 1.01);
}

}  // namespace
}  // namespace sturnus
