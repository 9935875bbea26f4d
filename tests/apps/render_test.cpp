// sturnus render: pictures, sheets and videos, and what it refuses.
#include <signal.h>

#include <regex>

#include "apps/program.h"

namespace program_test {
namespace {

class Render : public ProgramTest {
 protected:
  std::string pixels(Words options) const {
    options.insert(options.begin(),
                   {"render", "ucsd", "-o", "p.ppm", "--steps", "5", "--size", "320x180", "--count", "60"});
    run_well(options);
    return read("p.ppm");
  }
  // "320x180 11" for a video of that size with so many frames.
  std::string probe(const std::string& name) const {
    StartOptions options = here();
    const Ended ended =
        Running({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                 "stream=width,height,nb_read_frames,r_frame_rate", "-of", "csv=p=0", name},
                options)
            .wait();
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find_first_of("\r\n"));
  }
};

TEST_F(Render, APictureHasTheFormatAndSizeOfItsName) {
  const Ended ended = run_well({"render", "ucsd", "-o", "p.png", "--steps", "5"});
  EXPECT_TRUE(std::regex_match(ended.out,
                               std::regex("wrote p.png: 1280x720, step 5, 1000 boids, hash [0-9a-f]{16}\n")))
      << ended.out;
  EXPECT_TRUE(is_png(read("p.png")));
  EXPECT_EQ(hash_in(ended.out), hash_in(run_well({"run", "ucsd", "--steps", "5"}).out));
  EXPECT_TRUE(pixels({}).starts_with("P6\n320 180\n255\n"));
  EXPECT_EQ(pixels({}).size(), 15u + 320 * 180 * 3);
}

TEST_F(Render, APictureShowsStep300WhenNobodySaysOtherwise) {
  EXPECT_SAYS(run_well({"render", "ucsd", "-o", "p.png", "--count", "50"}).out, "step 300, 50 boids");
}

TEST_F(Render, EveryOptionChangesThePicture) {
  const std::string plain = pixels({});
  EXPECT_EQ(pixels({}), plain);
  const std::vector<Words> changes = {{"--trails"},
                                      {"--show", "index"},
                                      {"--show", "velocities"},
                                      {"--show", "vectors"},
                                      {"--theme", "light"},
                                      {"--no-caption"},
                                      {"--seed", "5"},
                                      {"--set", "flock.birds.size=40"},
                                      {"--steps", "6"},
                                      {"--show", "index", "--index", "tree"}};
  for (const Words& change : changes) EXPECT_NE(pixels(change), plain) << change.front();
  EXPECT_NE(pixels({"--show", "index", "--show", "velocities"}), pixels({"--show", "index"}));
  EXPECT_EQ(pixels({"--theme", "dark"}), plain);
}

TEST_F(Render, VectorsAreOfTheBoidThatWasAskedFor) {
  const std::string middle = pixels({"--show", "vectors"});
  EXPECT_NE(pixels({"--show", "vectors", "--boid", "7"}), pixels({"--show", "vectors", "--boid", "8"}));
  EXPECT_NE(pixels({"--show", "vectors", "--zoom"}), middle);
  EXPECT_NE(pixels({"--show", "vectors", "--theme", "light"}), middle);
  EXPECT_NE(pixels({"--show", "vectors", "--no-caption"}), middle);
  const std::string hash = hash_in(run_well({"run", "vuw-core", "--steps", "9"}).out);
  for (const Words& more : {Words{}, Words{"--zoom"}, Words{"--theme", "light"}}) {
    Words words = {"render", "vuw-core", "-o",      "v.ppm",  "--steps",
                   "9",      "--size",   "320x180", "--show", "vectors"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(hash_in(run_well(words).out), hash);
  }
}

TEST_F(Render, ThreadsChangeNoPixel) {
  const std::string plain = pixels({"--threads", "1"});
  for (const char* threads : {"2", "3"}) EXPECT_EQ(pixels({"--threads", threads}), plain);
}

TEST_F(Render, ContinuesFromAState) {
  run_well({"run", "ucsd", "--count", "60", "--steps", "3", "--final", "s.csv"});
  const std::string whole = pixels({});
  EXPECT_EQ(pixels({"--initial", "s.csv", "--first-step", "3", "--steps", "2"}), whole);
}

TEST_F(Render, ASheetShowsMomentsOverTheSteps) {
  const Ended ended =
      run_well({"render", "ucsd", "-o", "s.png", "--sheet", "4x3", "--steps", "22", "--size", "160x90"});
  EXPECT_SAYS(ended.out, ", 12 pictures, step 22, ");
  EXPECT_TRUE(is_png(read("s.png")));
  std::smatch size;
  ASSERT_TRUE(std::regex_search(ended.out, size, std::regex("s.png: ([0-9]+)x([0-9]+),")));
  EXPECT_GE(std::stoi(size[1]), 4 * 160);
  EXPECT_LT(std::stoi(size[1]), 5 * 160);
  EXPECT_GE(std::stoi(size[2]), 3 * 90);
}

TEST_F(Render, FramesAreNumberedFromTheStart) {
  const Ended ended = run_well({"render", "ucsd", "-o", "f/%03d.ppm", "--steps", "5", "--every", "2",
                                "--size", "320x180", "--count", "60"});
  EXPECT_SAYS(ended.out, "3 frames");
  EXPECT_EQ(files(), (std::set<std::string>{"f", "f/000.ppm", "f/001.ppm", "f/002.ppm"}));
  EXPECT_EQ(read("f/002.ppm"), pixels({"--steps", "4"}));
}

TEST_F(Render, VideosHaveAFrameForEachStep) {
  run_well({"render", "ucsd", "-o", "v.mp4", "--steps", "10", "--size", "320x180", "--fps", "25"});
  EXPECT_EQ(probe("v.mp4"), "320,180,25/1,11");
  run_well({"render", "ucsd", "-o", "w.mp4", "--steps", "10", "--size", "320x180", "--every", "5"});
  EXPECT_EQ(probe("w.mp4"), "320,180,30/1,3");
  run_well({"render", "ucsd", "-o", "v.gif", "--steps", "4", "--size", "160x90", "--fps", "10"});
  EXPECT_EQ(probe("v.gif"), "160,90,10/1,5");
}

TEST_F(Render, WithoutFfmpegFramesAreOfferedAndNothingIsLeft) {
  StartOptions options;
  options.path = "/nonexistent";
  for (const char* name : {"v.mp4", "v.gif"}) {
    const Ended ended = run({"render", "ucsd", "-o", name, "--steps", "1e12"}, options);
    EXPECT_EQ(ended.code, 1);
    EXPECT_SAYS(ended.err, std::string(name) + ": ");
    EXPECT_SAYS(ended.err, "ffmpeg");
    EXPECT_SAYS(ended.err, "-o frames/%05d.png");
    EXPECT_EQ(line_count(ended.err), 1u);
  }
  EXPECT_EQ(run({"render", "ucsd", "-o", "p.png", "--steps", "1"}, options).code, 0);
  EXPECT_EQ(files(), std::set<std::string>{"p.png"});
}

TEST_F(Render, CtrlCFinishesTheVideo) {
  Running running(sturnus_words({"render", "ucsd", "-o", "v.mp4", "--steps", "1e12", "--size", "320x180",
                                 "--count", "60"}),
                  here());
  ASSERT_TRUE(running.wait_until_it_works());
  ::kill(running.id(), SIGINT);
  const Ended ended = running.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_EQ(files(), std::set<std::string>{"v.mp4"});
  EXPECT_SAYS(probe("v.mp4"), "320,180,30/1,");
}

TEST_F(Render, CtrlCLeavesThePictureOfWhereItWas) {
  Running running(sturnus_words({"render", "ucsd", "-o", "p.png", "--steps", "1e12", "--count", "60"}),
                  here());
  ASSERT_TRUE(running.wait_until_it_works());
  ::kill(running.id(), SIGINT);
  EXPECT_EQ(running.wait().code, 130);
  EXPECT_TRUE(is_png(read("p.png")));
}

TEST_F(Render, BadOptionsGetOneSentence) {
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"-o", "a.jpg"},
       "\"a.jpg\" must end in .png, .ppm, .mp4 or .gif, or be a pattern such as frames/%05d.png"},
      {{"-o", "a.png", "--fps", "30"}, "--fps: \"a.png\" is one picture"},
      {{"-o", "a.png", "--every", "2"}, "--every: \"a.png\" is one picture"},
      {{"-o", "a.mp4", "--fps", "0"}, "--fps: must be a number from 1 to 1000, but is \"0\""},
      {{"-o", "a.mp4", "--fps", "fast"}, "--fps: must be a number"},
      {{"-o", "a.mp4", "--sheet", "4x3"}, "--sheet: \"a.mp4\" is a video"},
      {{"-o", "a.mp4", "--every", "0"}, "--every: must be at least 1, but is 0"},
      {{"-o", "a.png", "--size", "12"}, "--size: write width x height"},
      {{"-o", "a.png", "--size", "8x8"}, "--size: each side must be 16 to 16384 pixels"},
      {{"-o", "a.png", "--size", "99999x99"}, "--size: each side must be"},
      {{"-o", "a.png", "--sheet", "4"}, "--sheet: write columns x rows"},
      {{"-o", "a.png", "--sheet", "0x3"}, "--sheet: write columns x rows"},
      {{"-o", "a.png", "--sheet", "90x1"}, "--sheet: the sheet would be wider"},
      {{"-o", "a.png", "--sheet", "4x3", "--steps", "5"},
       "--sheet: 12 moments need at least 11 steps, but there are 5"},
      {{"-o", "a.png", "--show", "indx"},
       "--show: must be one of index, velocities, vectors, but is \"indx\"; did you mean index?"},
      {{"-o", "a.png", "--boid", "3"}, "--boid: goes with --show vectors"},
      {{"-o", "a.png", "--zoom", "--show", "index"}, "--zoom: goes with --show vectors"},
      {{"-o", "a.png", "--show", "vectors", "--boid", "1000"}, "--boid: there is no boid with id 1000"},
      {{"-o", "a.png", "--theme", "drak"},
       "--theme: must be one of dark, light, but is \"drak\"; did you mean dark?"},
  };
  for (const auto& [end, sentence] : cases) {
    Words words = {"render", "ucsd"};
    words.insert(words.end(), end.begin(), end.end());
    expect_refusal(words, sentence);
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Render, WhatCannotBeWrittenIsFoundBeforeTheFirstStep) {
  for (const char* name : {"no/p.png", "no/v.mp4"}) {
    const Ended ended = run({"render", "ucsd", "-o", name, "--steps", "1e12"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_SAYS(ended.err, std::string(name) + ": cannot be written");
  }
  write("file", "");
  EXPECT_EQ(run({"render", "ucsd", "-o", "file/%d.png", "--steps", "1e12"}).code, 1);
  EXPECT_EQ(files(), std::set<std::string>{"file"});
}

}  // namespace
}  // namespace program_test
