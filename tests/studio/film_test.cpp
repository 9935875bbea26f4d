// Films and scripted visits: sizes and numbers of frames, what a script does, and how it is refused.
#include "script/play.h"
#include "studio_support.h"
#include "ui.h"

namespace studio {
namespace {

std::string probe(const std::string& file) {
  return output_of(
      "ffprobe -v error -count_frames -select_streams v -show_entries "
      "stream=width,height,nb_read_frames -of csv=p=0 " +
      file);
}

Script script_of(const std::string& text) {
  auto script = parse_script(text, "visit.txt");
  EXPECT_TRUE(script) << script.error();
  return script ? *script : Script();
}

class StudioFilm : public StudioTest {};

TEST_F(StudioFilm, HasTheWindowsSizeAndAFrameForEveryThirtiethWhileStepsGoOn) {
  open("ucsd");
  const std::uint64_t step = desk().frame->step;
  desk().film.waits = true;
  press(SDLK_r);
  ASSERT_TRUE(desk().recorder.is_recording()) << said();
  frames(58);  // two more were shown with the key
  press(SDLK_r);
  EXPECT_FALSE(desk().recorder.is_recording());
  const Film film = desk().recorder.finish();
  ASSERT_TRUE(film.status) << film.status.error();
  EXPECT_EQ(film.missing, 0u);
  EXPECT_EQ(probe(film.path), "640,400,30\n");
  EXPECT_GE(desk().frame->step, step + 28);
}

TEST_F(StudioFilm, FramesOfAnotherSizeAreCroppedOrPadded) {
  Recorder recorder;
  FilmOptions options;
  options.waits = true;
  ASSERT_TRUE(recorder.start("film.mp4", {65, 41}, options));
  for (const sturnus::Size size : {sturnus::Size{65, 41}, {30, 20}, {100, 90}}) {
    ASSERT_TRUE(recorder.is_due(1.0 / 30));
    recorder.add(sturnus::Image(size, sturnus::rgb(0x336699)));
  }
  const Film film = recorder.finish();
  ASSERT_TRUE(film.status) << film.status.error();
  EXPECT_EQ(probe("film.mp4"), "64,40,3\n");
}

TEST_F(StudioFilm, AWindowThatIsSlowShowsFramesAgainSoThatTimeIsRight) {
  Recorder recorder;
  FilmOptions options;
  options.waits = true;
  ASSERT_TRUE(recorder.start("film.mp4", {64, 40}, options));
  for (int i = 0; i < 5; ++i) {
    if (recorder.is_due(0.2)) recorder.add(sturnus::Image({64, 40}, sturnus::rgb(0x336699)));
  }
  const Film film = recorder.finish();
  EXPECT_NEAR(static_cast<double>(film.frames), 25, 1);
  EXPECT_EQ(film.missing, film.frames - 5);
}

TEST_F(StudioFilm, AScriptClicksPressesAndShoots) {
  open("ucsd");
  const Script script = script_of(
      "say \"hello\"\nclick top.play\nwait 3\nshot paused.png\nclick \"tool.add units\"\nclick 15% 50%\n"
      "key ctrl+z # takes it back\nmaybe click no.such.item\nopen cs184\nwait 5\n");
  const auto status = play(studio(), script, {"visit.mp4"});
  ASSERT_TRUE(status) << status.error();
  EXPECT_FALSE(desk().playback.is_playing());
  EXPECT_TRUE(std::filesystem::exists("paused.png"));
  EXPECT_EQ(desk().tools.tool, Tool::add);
  EXPECT_EQ(scenario().name, "cs184");
  EXPECT_EQ(probe("visit.mp4").substr(0, 8), "640,400,");
}

TEST_F(StudioFilm, AnItemThatIsNotThereEndsAScriptWithItsLine) {
  open("ucsd");
  const auto status = play(studio(), script_of("wait 2\nclick top.plya\n"), {});
  EXPECT_SAYS(status.error(),
              "visit.txt:2: there is no \"top.plya\" in the window; did you mean \"top.play\"?");
}

// The menu of the red dot, and the films that it makes.
class StudioRecording : public test::Ui {
 protected:
  void choose(const std::string& item) {
    press_right("top.record");
    frames(3);
    press(item);
    key(SDLK_ESCAPE);
    frames(3);
  }
  void press_right(const std::string& item) {
    const Box box = desk().items.at(item);
    click(box.x + box.width / 2, box.y + box.height / 2, SDL_BUTTON_RIGHT);
  }
  // Begins and ends a film with the button, with so many frames of the window between.
  Film film_of(int count) {
    desk().film.waits = true;
    press("top.record");
    EXPECT_TRUE(desk().recorder.is_recording());
    frames(count);
    press("top.record");
    EXPECT_FALSE(desk().recorder.is_recording());
    return desk().recorder.finish();
  }
  // The first picture of a film, red, green and blue.
  static std::string pixels_of(const std::string& file) {
    return output_of("ffmpeg -v error -i " + file + " -frames:v 1 -f rawvideo -pix_fmt rgb24 -");
  }
  sturnus::Size window_size() const override { return {640, 480}; }
};

TEST_F(StudioRecording, TheButtonBeginsAndEndsAGifWhileStepsGoOn) {
  open("ucsd");
  choose("film.gif");
  ASSERT_TRUE(desk().film.is_gif);
  const std::uint64_t step = world().step;
  const Film film = film_of(30);
  ASSERT_TRUE(film.status) << film.status.error();
  EXPECT_TRUE(film.path.ends_with(".gif")) << film.path;
  const auto bytes = sturnus::read_text(film.path);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->substr(0, 6), "GIF89a");
  EXPECT_EQ(probe(film.path).substr(0, 8), "640,480,");
  EXPECT_GE(film.frames, 15u);
  EXPECT_GT(world().step, step);
}

TEST_F(StudioRecording, FilmsAreWithPanelsOrOfTheWorldAlone) {
  open("ucsd");
  pause();
  const auto pixel = [](const std::string& rgb, int x, int y) {
    const auto at = static_cast<std::size_t>(3 * (640 * y + x));
    return static_cast<int>(static_cast<unsigned char>(rgb.at(at)));
  };
  const std::string with = pixels_of(film_of(10).path);
  choose("film.panels");
  ASSERT_FALSE(desk().film.with_panels);
  const std::string without = pixels_of(film_of(10).path);
  ASSERT_EQ(with.size(), std::size_t{640} * 480 * 3);
  ASSERT_EQ(without.size(), with.size());
  // The settings' panel is there or it is not; behind it lies the world, which fills the picture.
  const Box panel = desk().layout.inspector;
  int differing = 0;
  for (int y = static_cast<int>(panel.y); y < static_cast<int>(panel.y + panel.height); y += 3) {
    const int x = static_cast<int>(panel.x + panel.width / 2);
    differing += std::abs(pixel(with, x, y) - pixel(without, x, y)) > 12;
  }
  EXPECT_GT(differing, 10);
  // Left and right of the world the ground is equally wide.
  const auto margin = [&](bool from_right) {
    for (int i = 0; i < 320; ++i) {
      const int x = from_right ? 639 - i : i;
      if (pixel(without, x, 240) > 150) return i;
    }
    return 320;
  };
  EXPECT_NEAR(margin(false), margin(true), 4);
}

TEST(StudioScript, FaultsAreSentencesWithTheirLines) {
  const auto script =
      parse_script("wait\n\n# fine\nclik top.play\nkey nokey\nsay \"open\nwait 5\n", "visit.txt");
  ASSERT_FALSE(script);
  const std::string text = script.error();
  EXPECT_SAYS(text, "visit.txt:1: wait is written wait FRAMES");
  EXPECT_SAYS(text, "visit.txt:4: \"clik\" is no verb of scripts; did you mean \"click\"?");
  EXPECT_SAYS(text, "visit.txt:5: there is no key \"nokey\"");
  EXPECT_SAYS(text, "visit.txt:6: a quote is not closed");
  EXPECT_EQ(script.problems().size(), 4u);
}

TEST(StudioScript, KeysHaveNamesAndModifiers) {
  EXPECT_EQ(key_of("space").sym, SDLK_SPACE);
  EXPECT_EQ(key_of("ctrl+z").sym, SDLK_z);
  EXPECT_EQ(key_of("ctrl+z").mod, KMOD_LCTRL);
  EXPECT_EQ(key_of("ctrl+shift+z").mod, KMOD_LCTRL | KMOD_LSHIFT);
  EXPECT_EQ(key_of("hyper+z").sym, 0);
}

class StudioProgram : public InFolder {};

TEST_F(StudioProgram, AScriptsFirstClickFindsItsPlace) {
  write("visit.txt", "click legend.fold\nwait 3\nclick legend.eraser\n");
  EXPECT_SAYS(output_of(STURNUS_STUDIO " ucsd --threads 1 --script visit.txt 2>&1"),
              "visit.txt:3: there is no \"legend.eraser\"");
}

TEST_F(StudioProgram, BadInputIsRefusedInSentences) {
  EXPECT_SAYS(output_of(STURNUS_STUDIO " murmurration 2>&1; echo $?"), "did you mean \"murmuration\"?\n2");
  EXPECT_SAYS(output_of(STURNUS_STUDIO " --video a.mp4 2>&1; echo $?"), "--script FILE");
  EXPECT_SAYS(output_of("SDL_VIDEODRIVER=x11 DISPLAY= " STURNUS_STUDIO " ucsd 2>&1; echo $?"),
              "sturnus render");
}

TEST_F(StudioProgram, TellsWhatFramesTook) {
  write("visit.txt", "wait 6\n");  // and one frame in which the panels come to rest, and the last
  EXPECT_SAYS(
      output_of(STURNUS_STUDIO " ucsd --size 320x240 --threads 1 --script visit.txt --frame-times 2>&1"),
      "1000 boids, 8 frames, 3 steps: upload ");
}

#ifdef STURNUS_PROGRAM
TEST_F(StudioProgram, IsWhatSturnusStudioBecomes) {
  EXPECT_SAYS(output_of(STURNUS_PROGRAM " studio --size nonsense 2>&1; echo $?"), "--size");
}
#endif

}  // namespace
}  // namespace studio
