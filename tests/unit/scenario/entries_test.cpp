// Files of plain settings: order, lines, and what they may not hold.
#include <gtest/gtest.h>
#include <sturnus/parameters.h>

namespace sturnus {
namespace {

TEST(Entries, ComeInTheOrderOfTheFileWithTheirLines) {
  const auto entries = parse_entries("zebra = 1\n\napple = [2, \"x\"]  # why\nmango = true\n", "f.toml");
  ASSERT_TRUE(entries) << entries.error();
  ASSERT_EQ(entries->size(), 3u);
  EXPECT_EQ((*entries)[0].key, "zebra");
  EXPECT_EQ((*entries)[1].key, "apple");
  EXPECT_EQ(to_text((*entries)[1].value), "[2, \"x\"]");
  EXPECT_EQ((*entries)[1].line, 3);
  EXPECT_EQ((*entries)[2].line, 4);
}

TEST(Entries, ATableOrASlipIsNamedWithFileAndLine) {
  const auto table = parse_entries("a = 1\nb = { c = 2 }\n", "f.toml");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error(), "f.toml:2: b: must be a number, a text, true, false or a list of them\n");
  const auto slip = parse_entries("a = 1\nb = = 2\n", "f.toml");
  ASSERT_FALSE(slip);
  EXPECT_EQ(slip.error().find("f.toml:2: "), 0u) << slip.error();
}

}  // namespace
}  // namespace sturnus
