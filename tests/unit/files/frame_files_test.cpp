// Laws of frame sequences: one number in each name, and user text never reaches printf.
#include "files/frame_files.h"

#include <sturnus/files.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "temporary_folder.h"

namespace sturnus {
namespace {

TEST(FrameFiles, FramesAreNumberedAndTheirFolderIsMade) {
  const TemporaryFolder folder;
  Result<FrameWriter> writer = FrameWriter::open(folder / "frames/%05d.png");
  ASSERT_TRUE(writer) << writer.error();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(writer->add(Image({4, 4}, rgb(0x102030))));
  EXPECT_FALSE(read_all(folder / "frames/00000.png").empty());
  EXPECT_FALSE(read_all(folder / "frames/00002.png").empty());
  EXPECT_TRUE(read_all(folder / "frames/00003.png").empty());
}

TEST(FrameFiles, NamesFollowThePattern) {
  const TemporaryFolder folder;
  EXPECT_EQ(FrameWriter::open(folder / "a%d.ppm")->name(12), folder / "a12.ppm");
  EXPECT_EQ(FrameWriter::open(folder / "%03d.png")->name(7), folder / "007.png");
  EXPECT_EQ(FrameWriter::open(folder / "%03d.png")->name(12345), folder / "12345.png");
  EXPECT_EQ(FrameWriter::open(folder / "100%%_%d_%%.png")->name(1), folder / "100%_1_%.png");
}

TEST(FrameFiles, OtherPatternsAreRefused) {
  const TemporaryFolder folder;
  for (const char* bad : {"%s.png", "%d%d.png", "%05d_%n.png", "%5d.png", "%00d.png", "%0d.png", "%012d.png",
                          "%", "a.png", "%d.jpg", "%d", "%ld.png", "%d/a.png", "%"}) {
    EXPECT_FALSE(FrameWriter::open(folder / bad)) << bad;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(FrameFiles, APatternIsToldFromAName) {
  EXPECT_TRUE(is_numbered_name("frames/%05d.png"));
  EXPECT_FALSE(is_numbered_name("frames/flock.png"));
  EXPECT_FALSE(is_numbered_name("100%%.png"));
}

TEST(FrameFiles, AnyFileMayHaveANumberInItsName) {
  const auto name = numbered_name("states/%05d.csv", 7);
  ASSERT_TRUE(name) << name.error();
  EXPECT_EQ(*name, "states/00007.csv");
  EXPECT_FALSE(numbered_name("states/%d/a.csv", 7));
  EXPECT_FALSE(numbered_name("state.csv", 7));
}

TEST(FrameFiles, AFolderThatCannotBeMadeIsAProblemAtOnce) {
  EXPECT_FALSE(FrameWriter::open("/dev/null/%d.png"));
}

}  // namespace
}  // namespace sturnus
