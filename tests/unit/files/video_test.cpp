// Laws of videos: every frame arrives, and no half-written file is ever seen.
#include "files/video.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "files/process.h"
#include "temporary_folder.h"

namespace sturnus {
namespace {

class VideoTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!ffmpeg_available()) GTEST_SKIP() << "no ffmpeg here";
  }
  TemporaryFolder folder_;
};

// Sets the PATH for one test.
class OtherPath {
 public:
  explicit OtherPath(const std::string& path) : before_(std::getenv("PATH")) {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~OtherPath() { ::setenv("PATH", before_.c_str(), 1); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  std::string before_;
};

// A program named ffmpeg that does what the script says.
void fake_ffmpeg(const TemporaryFolder& folder, const std::string& script) {
  const std::string path = folder / "ffmpeg";
  std::FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs(("#!/bin/sh\n" + script + "\n").c_str(), file);
  std::fclose(file);
  ASSERT_EQ(::chmod(path.c_str(), 0755), 0);
}

std::string probe(const std::string& path) {
  const std::string line =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=width,height,nb_read_frames -of csv=p=0 '" +
      path + "'";
  std::FILE* pipe = ::popen(line.c_str(), "r");
  char text[128] = "";
  if (pipe == nullptr || std::fgets(text, sizeof text, pipe) == nullptr) text[0] = '\0';
  if (pipe != nullptr) ::pclose(pipe);
  std::string answer = text;
  while (!answer.empty() && answer.back() == '\n') answer.pop_back();
  return answer;
}

Status write_video(const std::string& path, Size size, int frames) {
  Result<VideoWriter> video = VideoWriter::open(path, size, 25);
  if (!video) return video.problems();
  for (int i = 0; i < frames; ++i) {
    Image frame(size, {static_cast<std::uint8_t>(i * 20), 80, 160, 255});
    frame.rgb[static_cast<std::size_t>(i) * 3] = 255;
    if (const Status added = video->add(frame); !added) return added;
  }
  return video->finish();
}

TEST_F(VideoTest, TenFramesAreTenFramesOfTheRightSize) {
  const Status mp4 = write_video(folder_ / "a.mp4", {64, 48}, 10);
  ASSERT_TRUE(mp4) << mp4.error();
  EXPECT_EQ(probe(folder_ / "a.mp4"), "64,48,10");
  const Status gif = write_video(folder_ / "a.gif", {64, 48}, 10);
  ASSERT_TRUE(gif) << gif.error();
  EXPECT_EQ(probe(folder_ / "a.gif"), "64,48,10");
  EXPECT_EQ(folder_.names().size(), 2u);
}

TEST_F(VideoTest, OddSizesLoseTheirLastRowAndColumn) {
  const Status status = write_video(folder_ / "odd.MP4", {65, 49}, 3);
  ASSERT_TRUE(status) << status.error();
  EXPECT_EQ(probe(folder_ / "odd.MP4"), "64,48,3");
}

TEST_F(VideoTest, OddNamesAreSafe) {
  for (const char* name : {"a b;c$(d).mp4", "-y.mp4", "http:x.mp4", "%d.mp4", "\"q\".gif"}) {
    const Status status = write_video(folder_ / name, {32, 32}, 2);
    ASSERT_TRUE(status) << status.error();
    EXPECT_FALSE(read_all(folder_ / name).empty()) << name;
  }
  // Without a folder in front, a colon looks like a protocol.
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "");
  EXPECT_TRUE(write_video("tcp:b.mp4", {32, 32}, 2));
  EXPECT_TRUE(write_video("-n", {32, 32}, 2).error().find("has to end") != std::string::npos);
  std::filesystem::current_path(before);
  EXPECT_FALSE(read_all(folder_ / "tcp:b.mp4").empty());
}

TEST_F(VideoTest, WithoutFinishNothingIsLeft) {
  {
    Result<VideoWriter> video = VideoWriter::open(folder_ / "a.mp4", {64, 48}, 25);
    ASSERT_TRUE(video);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(video->add(Image({64, 48}, rgb(0x446688))));
  }
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(VideoTest, NoFramesAndWrongFramesAreProblems) {
  EXPECT_FALSE(write_video(folder_ / "a.mp4", {64, 48}, 0));
  Result<VideoWriter> video = VideoWriter::open(folder_ / "a.mp4", {64, 48}, 25);
  ASSERT_TRUE(video);
  EXPECT_FALSE(video->add(Image({32, 48}, rgb(0))));
  EXPECT_FALSE(VideoWriter::open(folder_ / "b.mp4", {1, 1}, 25));
  EXPECT_FALSE(VideoWriter::open(folder_ / "b.mp4", {64, 48}, 0));
  EXPECT_FALSE(VideoWriter::open(folder_ / "b.avi", {64, 48}, 25));
  EXPECT_FALSE(VideoWriter::open(folder_ / "none/b.mp4", {64, 48}, 25));
}

TEST(Video, WithoutFfmpegTheSentenceNamesTheOtherWay) {
  const TemporaryFolder folder;
  const OtherPath nowhere(folder / "empty");
  EXPECT_FALSE(ffmpeg_available());
  const std::string error = check_video(folder / "a.mp4").error();
  EXPECT_NE(error.find("ffmpeg"), std::string::npos);
  EXPECT_NE(error.find("-o frames/%05d.png"), std::string::npos);
}

TEST(Video, FfmpegsLastWordIsPartOfTheSentence) {
  const TemporaryFolder programs;
  const TemporaryFolder folder;
  fake_ffmpeg(programs, "exec >&2; echo first line; echo 'Unknown encoder libx264'; echo; exit 3");
  const OtherPath path((programs / "") + ":/bin:/usr/bin");
  const Status status = write_video(folder / "a.mp4", {640, 480}, 50);
  EXPECT_EQ(status.error(), (folder / "a.mp4") + ": ffmpeg failed: Unknown encoder libx264\n");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Video, AnFfmpegThatFailsInTheEndLeavesNoFile) {
  const TemporaryFolder programs;
  const TemporaryFolder folder;
  // It writes its output, then fails: the worst case for a name that must stay free.
  fake_ffmpeg(programs, "cat >/dev/null; for last; do :; done; echo half >\"${last#file:}\"; exit 1");
  const OtherPath path((programs / "") + ":/bin:/usr/bin");
  EXPECT_EQ(write_video(folder / "a.gif", {64, 48}, 5).error(),
            (folder / "a.gif") + ": ffmpeg failed with exit status 1\n");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Process, ABrokenPipeIsAnErrorAndNoSignal) {
  Process process;
  ASSERT_EQ(process.start({"sh", "-c", "exec <&-; echo gone >&2"}), 0);
  const std::vector<unsigned char> bytes(1 << 20);
  EXPECT_EQ(process.write(bytes), EPIPE);
  EXPECT_EQ(process.wait(), 0);
  EXPECT_EQ(process.last_complaint(), "gone");
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

TEST(Process, AMissingProgramIsAnError) {
  EXPECT_EQ(Process().start({"no-such-program-here"}), ENOENT);
}

}  // namespace
}  // namespace sturnus
