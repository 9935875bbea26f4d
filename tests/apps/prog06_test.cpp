// prog06 without a display: keys that press themselves, pictures against a simulation of one's own, and wrong
// input.
#include <png.h>
#include <signal.h>
#include <sturnus/files.h>
#include <sturnus/triangles.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "cones.h"
#include "prog06_support.h"

namespace program_test {
namespace {

using sturnus::Image;
using sturnus::Point3;

class Prog06 : public ProgramTest {
 protected:
  Ended start(const Words& arguments) const { return Running(prog06_words(arguments), here()).wait(); }
  /// `line` and the keys, which must end well.
  Image picture(const std::string& line, const std::string& keys) const {
    Words words = split(line + " out.ppm --size 160x120");
    words.insert(words.end(), {"--keys", keys});
    const Ended ended = start(words);
    EXPECT_EQ(ended.code, 0) << line << "\n" << ended.err;
    return ppm_picture(read("out.ppm"));
  }

 private:
  Variable driver_{"SDL_VIDEODRIVER", "offscreen"};
};

struct Numbers {
  std::int64_t count;
  double radius, separation, alignment, cohesion;
};

// p + f * direction
Point3 aside(const Point3& p, const Point3& direction, float f) {
  return {p[0] + direction[0] * f, p[1] + direction[1] * f, p[2] + direction[2] * f};
}

// The picture after some steps, by the words of the assignment and by nothing of the program but its colours.
Image expected(const Numbers& numbers, std::uint64_t steps, float size = 0.06f) {
  auto scenario = sturnus::load_scenario("prog06");
  auto& boids = scenario->flocks[0];
  boids.count = numbers.count;
  boids.separation[0].radius = numbers.radius;
  boids.separation[0].weight = numbers.separation;
  boids.alignment[0].weight = numbers.alignment;
  boids.cohesion[0].weight = numbers.cohesion;
  auto flock = sturnus::open_simulation(*scenario);
  EXPECT_TRUE(flock) << flock.error();
  flock->run(steps);
  const sturnus::View view = flock->view();
  std::vector<sturnus::Triangle> triangles;
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    const Point3 p = view.position(slot);
    const auto [u, v, w] = sturnus::frame_along(view.velocity(slot)).value();
    const sturnus::Rgba colour = prog06::heading_colour(w);
    const Point3 tip = aside(p, w, 0.5f * size);
    triangles.push_back({{tip, aside(p, u, 0.2f * size), aside(p, v, 0.2f * size)}, colour});
    triangles.push_back({{tip, aside(p, v, 0.2f * size), aside(p, u, -0.2f * size)}, colour});
    triangles.push_back({{tip, aside(p, u, -0.2f * size), aside(p, v, -0.2f * size)}, colour});
    triangles.push_back({{tip, aside(p, v, -0.2f * size), aside(p, u, 0.2f * size)}, colour});
  }
  const sturnus::Rgba edge = sturnus::rgb(0x2f3b46);
  const Point3 a = {-0.5f, -0.5f, 0}, b = {0.5f, -0.5f, 0}, c = {-0.5f, 0.5f, 0}, d = {0.5f, 0.5f, 0};
  sturnus::SpaceCamera camera;
  camera.eye = {0, 0, 2};
  camera.field_of_view = 40;
  sturnus::PictureOptions options;
  options.size = {160, 120};
  return draw_triangles(triangles, {{a, b, edge}, {a, c, edge}, {b, d, edge}, {c, d, edge}}, camera, options);
}

constexpr Numbers tested{300, 0.4, 0.1, 0.3, 1.0};
const char* const tested_line = "300 0.4 0.1 0.3 1.0";

TEST_F(Prog06, StartsPausedAtTheFirstPicture) {
  EXPECT_EQ(picture(tested_line, "wq"), expected(tested, 0));
  EXPECT_EQ(picture(tested_line, "      wq"), expected(tested, 0));
}

TEST_F(Prog06, EveryStepKeyIsOneStep) {
  EXPECT_EQ(picture(tested_line, "sw q"), expected(tested, 1));
  EXPECT_EQ(picture(tested_line, "sssw\x1b"), expected(tested, 3));
}

TEST_F(Prog06, TheAnimationKeyTogglesAStepAFrame) {
  EXPECT_EQ(picture(tested_line, "a    a   wq"), expected(tested, 5));
  EXPECT_EQ(picture(tested_line, "a  a sa awq"), expected(tested, 3 + 1 + 2));
}

TEST_F(Prog06, TheArgumentsAreTakenInTheirOrderAndVerbatim) {
  EXPECT_EQ(picture("50 0.3 0.002 0.05 0.2", "ssswq"), expected({50, 0.3, 0.002, 0.05, 0.2}, 3));
  EXPECT_EQ(picture("50 .3 -.1 -1e-3 -2.5", "ssswq"), expected({50, 0.3, -0.1, -1e-3, -2.5}, 3));
  EXPECT_EQ(picture("5e1 +3e-1 0 -0 1", "ssswq"), expected({50, 0.3, 0, 0, 1}, 3));
  EXPECT_EQ(picture("50 0.3 0.002 0.05 0.2 --boid-size 1", "wq"),
            expected({50, 0.3, 0.002, 0.05, 0.2}, 0, 1.0f));
}

TEST_F(Prog06, SmallFlocksAndEmptyRadii) {
  EXPECT_EQ(picture("0 0 0 0 0", "asawq"), expected({0, 0, 0, 0, 0}, 3));
  EXPECT_EQ(picture("1 0.4 0.1 0.3 1", "ssswq"), expected({1, 0.4, 0.1, 0.3, 1}, 3));
  EXPECT_EQ(picture("40 0 0.1 0.3 1", "ssswq"), expected({40, 0, 0.1, 0.3, 1}, 3));
  picture("3 1e9 1e9 -1e9 1e9 --boid-size 10 --eye 0,0,0.01", "aaaaa   q");
}

TEST_F(Prog06, OptionsChangeWhatTheySay) {
  const Image usual = picture(tested_line, "sswq");
  for (const char* option : {"--seed 7", "--3d", "--eye 1,1,2", "--target 0.2,0,0", "--field-of-view 20",
                             "--boid-size=0.1", "--set flock.boids.max_speed=0.001"}) {
    const Image other = picture(std::string(tested_line) + " " + option, "sswq");
    EXPECT_EQ(other.size(), usual.size());
    EXPECT_NE(other, usual) << option;
  }
  EXPECT_EQ(picture(std::string(tested_line) + " --seed 6 --eye 0,0,2 --dimensions 2", "sswq"), usual);
}

TEST_F(Prog06, PngByNameAndPpmUnderAnyOther) {
  for (const char* name : {"a.png", "b.ppm", "c", "d.mp4", "e%05d.ppm"}) {
    const Ended ended = start({"9", "0.4", "0.1", "0.3", "1", name, "--size", "32x16", "--keys", "wq"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_SAYS(ended.out, std::string(name) + ": step 0");
  }
  EXPECT_TRUE(is_png(read("a.png")));
  for (const char* name : {"b.ppm", "c", "d.mp4", "e%05d.ppm"}) {
    EXPECT_EQ(ppm_picture(read(name)).size(), (sturnus::Size{32, 16})) << name;
  }
  EXPECT_EQ(files().size(), 5u);
}

TEST_F(Prog06, APictureThatCannotBeWrittenIsToldAndTheProgramGoesOn) {
  const Ended ended =
      start({"9", "0.4", "0.1", "0.3", "1", "/dev/full", "--size", "32x16", "--keys", "wsswq"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(line_count(ended.err), 2u) << ended.err;
  EXPECT_SAYS(ended.err, "/dev/full: cannot be written");
}

TEST_F(Prog06, SettingsComeFromAFileAndTheCommandLineWins) {
  write("c.toml", "size = [48, 32]\nboid_size = 0.3\nset = [\" flock.boids.max_speed = 0.01\"]\n");
  const Words words = split("9 0.4 0.1 0.3 1 out.ppm --config c.toml --keys wq");
  EXPECT_EQ(start(words).code, 0);
  const Image from_file = ppm_picture(read("out.ppm"));
  EXPECT_EQ(from_file.size(), (sturnus::Size{48, 32}));
  Words more = words;
  more.insert(more.begin(), {"--boid-size", "0.01"});
  EXPECT_EQ(start(more).code, 0);
  EXPECT_EQ(ppm_picture(read("out.ppm")).size(), (sturnus::Size{48, 32}));
  EXPECT_NE(ppm_picture(read("out.ppm")), from_file);
  more.insert(more.end(), {"--size", "20x16"});
  EXPECT_EQ(start(more).code, 0);
  EXPECT_EQ(ppm_picture(read("out.ppm")).size(), (sturnus::Size{20, 16}));
}

TEST_F(Prog06, AWrongFileIsToldWithFileLineAndKey) {
  write("c.toml", "size = \"9x9\"\n\nboid_sise = 1\neye = [0, 0]\nset = [\"flock.boids.max_speed\"]\n");
  const Ended ended = start(split("9 0.4 0.1 0.3 1 out.ppm --config c.toml --keys q"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_SAYS(ended.err, "c.toml:1: size: must be two sides of 16 to 4096 pixels");
  EXPECT_SAYS(ended.err, "c.toml:3: boid_sise: there is no such setting; did you mean boid_size?");
  EXPECT_SAYS(ended.err, "c.toml:4: eye: must be three numbers");
  EXPECT_SAYS(ended.err, "c.toml:5: set: must be a text");
  write("c.toml", "size = = 3\n");
  EXPECT_SAYS(start(split("9 0.4 0.1 0.3 1 out.ppm --config c.toml --keys q")).err, "c.toml:1: ");
  EXPECT_SAYS(start(split("9 0.4 0.1 0.3 1 out.ppm --config no.toml --keys q")).err,
              "no.toml: cannot be read");
}

TEST_F(Prog06, AWrongParameterInAFileIsToldWithFileAndLine) {
  write("c.toml",
        "seed = 3\nset = [\"flock.boids.max_sped = 1\", \"flock.boids.count=3\",\n"
        "  \"flock.boids.max_speed = -1\"]\n");
  const Ended ended = start(split("9 0.4 0.1 0.3 1 out.ppm --config c.toml --set space.sise=1 --keys q"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_TRUE(ended.err.starts_with("usage: prog06 ")) << ended.err;
  EXPECT_SAYS(ended.err, "c.toml:2: set: flock.boids.max_sped: ");
  EXPECT_SAYS(ended.err, "c.toml:2: set: flock.boids.count: is chosen by N");
  EXPECT_SAYS(ended.err, "c.toml:2: set: flock.boids.max_speed: must not be negative");
  EXPECT_SAYS(ended.err, "prog06: --set space.sise: ");
  EXPECT_EQ(line_count(ended.err), 5u) << ended.err;
  // What is wrong only with the whole, too.
  write("c.toml", "\nset = [\"flock.boids.min_speed = 0.01\", \"flock.boids.max_speed=0.005\"]\n");
  const Ended whole = start(split("9 0.4 0.1 0.3 1 out.ppm --config c.toml --keys q"));
  EXPECT_EQ(whole.code, 2);
  EXPECT_SAYS(whole.err, "c.toml:2: set: flock.boids.m");
}

struct Wrong {
  const char* line;
  const char* sentence;
};

const Wrong wrong_lines[] = {
    {"", "missing: N R ws wa wc out.ppm"},
    {"300 0.4", "missing: ws wa wc out.ppm"},
    {"300 0.4 0.1 0.3 1.0", "missing: out.ppm"},
    {"300 0.4 0.1 0.3 1.0 out.ppm more", "\"more\" is one word too many"},
    {"3x 0.4 0.1 0.3 1 out.ppm", "N must be a number, but is \"3x\""},
    {"3.5 0.4 0.1 0.3 1 out.ppm", "N must be a whole number, but is \"3.5\""},
    {"-3 0.4 0.1 0.3 1 out.ppm", "N must be at least 0, but is -3"},
    {"1e12 0.4 0.1 0.3 1 out.ppm", "N must be at most 1e+09, but is 1e12"},
    {"3 -0.4 0.1 0.3 1 out.ppm", "R must be at least 0, but is -0.4"},
    {"3 0.4 nan 0.3 1 out.ppm", "ws must be a finite number, but is \"nan\""},
    {"3 0.4 0.1 -inf 1 out.ppm", "wa must be a finite number, but is \"-inf\""},
    {"3 0.4 0.1 0.3 1e999 out.ppm", "wc is out of range: 1e999"},
    {"3 0.4 0.1 0.3 1e10 out.ppm", "wc must be at most 1e+09"},
    {"3 0.4 0.1 0.3 --1 out.ppm", "unknown option \"--1\""},
    {"3 0,4 0.1 0.3 1 out.ppm", "R must be a number, but is \"0,4\""},
    {"3 0x1p3 0.1 0.3 1 out.ppm", "R must be a number"},
    {"3 +-1 0.1 0.3 1 out.ppm", "R must be a number"},
    {"3 0.4 0.1 0.3 1 missing/out.ppm",
     "prog06: out.ppm: missing/out.ppm: cannot be written: No such file or directory"},
    {"3 0.4 0.1 0.3 1 /", "prog06: out.ppm: /: cannot be written: Is a directory"},
    {"1000000000 0.4 0.1 0.3 1 out.ppm", "prog06: N: 1000000000 boids need about"},
    {"3 0.4 0.1 0.3 1 -- out.ppm --seed 3", "\"--seed\" is one word too many; options come before --"},
    {"-- 3 0.4 0.1 0.3 1 --3d out.ppm", "\"out.ppm\" is one word too many; options come before --"},
    {"3 0.4 0.1 0.3 1 out.ppm --config a.toml --config b.toml", "--config is given twice"},
    {"3 0.4 0.1 0.3 1 out.ppm --keys a --keys=a", "--keys is given twice"},
    {"3 0.4 0.1 0.3 1 out.ppm --size 32x32 --size 64x64", "--size is given twice"},
    {"3 0.4 0.1 0.3 1 out.ppm --3d --dimensions 2", "--dimensions is given twice (--3d is the same as"},
    {"3 0.4 0.1 0.3 1 out.ppm --sise 3", "unknown option \"--sise\"; did you mean --size?"},
    {"3 0.4 0.1 0.3 1 out.ppm --size 3x", "--size must be two sides of 16 to 4096 pixels"},
    {"3 0.4 0.1 0.3 1 out.ppm --size 100x99999", "--size must be two sides of 16 to 4096 pixels"},
    {"3 0.4 0.1 0.3 1 out.ppm --size", "--size needs a value"},
    {"3 0.4 0.1 0.3 1 out.ppm --eye 1,2", "--eye must be three numbers"},
    {"3 0.4 0.1 0.3 1 out.ppm --eye 1,2,nan", "--eye must be three numbers"},
    {"3 0.4 0.1 0.3 1 out.ppm --eye 0,0,0", "eye and target are the same place"},
    {"3 0.4 0.1 0.3 1 out.ppm --target 0,0,2", "eye and target are the same place"},
    {"3 0.4 0.1 0.3 1 out.ppm --3d=yes", "--3d takes no value"},
    {"3 0.4 0.1 0.3 1 out.ppm --field-of-view 0", "--field-of-view must be an angle from 1 to 170 degrees"},
    {"3 0.4 0.1 0.3 1 out.ppm --boid-size nan", "--boid-size must be a number from 0.0001 to 10"},
    {"3 0.4 0.1 0.3 1 out.ppm --dimensions 4", "--dimensions must be 2 or 3"},
    {"3 0.4 0.1 0.3 1 out.ppm --seed 1.5", "--seed must be a whole number of at least 0"},
    {"3 0.4 0.1 0.3 1 out.ppm --keys saz", "there is no \"z\""},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.cont=3",
     "prog06: --set flock.boids.cont: there is no key \"cont\"; did you mean \"count\"?"},
    {"3 0.4 0.1 0.3 1 out.ppm --set space.dimensions=3", "--set space.dimensions: is chosen by --dimensions"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.count=3", "--set flock.boids.count: is chosen by N"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.separation.radius=1", "is chosen by R"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.separation.ring=[0,1]", "is chosen by R"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.separation.0.weight=1", "is chosen by ws"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.alignment.weight=1", "is chosen by wa"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.cohesion.weight=1", "is chosen by wc"},
    {"3 0.4 0.1 0.3 1 out.ppm --set seed=6", "is chosen by --seed"},
    {"3 0.4 0.1 0.3 1 out.ppm --set flock.boids.size", "--set must be a text such as"},
};

TEST_F(Prog06, WrongInputEndsWithTwoAndSaysWhatIsWrong) {
  for (const Wrong& wrong : wrong_lines) {
    const Ended ended = start(split(wrong.line));
    EXPECT_EQ(ended.code, 2) << wrong.line;
    EXPECT_EQ(ended.out, "") << wrong.line;
    EXPECT_TRUE(ended.err.starts_with("usage: prog06 N R ws wa wc out.ppm [options]\nprog06: ")) << ended.err;
    EXPECT_SAYS(ended.err, wrong.sentence);
  }
  EXPECT_SAYS(start({"3", "0.4", "0.1", "0.3", "1", ""}).err, "out.ppm must not be empty");
  EXPECT_TRUE(files().empty());
}

TEST_F(Prog06, HelpNamesEverythingAndEndsWell) {
  for (const char* word : {"--help", "-h"}) {
    const Ended ended = start({word});
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
    for (const char* part :
         {"N R ws wa wc out.ppm", "--config", "--size", "--eye", "--target", "--field-of-view", "--boid-size",
          "--dimensions", "--seed", "--set", "--keys", "--3d", "ESC"}) {
      EXPECT_SAYS(ended.out, part);
    }
  }
}

TEST_F(Prog06, FramesAreASixtiethOfASecond) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(start({"3", "0.4", "0.1", "0.3", "1", "out.ppm", "--size", "32x16", "--keys",
                   std::string(180, ' ') + "q"})
                .code,
            0);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
}

TEST_F(Prog06, InterruptsEndItWith130) {
  for (const int signal : {SIGINT, SIGTERM}) {
    write("said", "");
    StartOptions options = here();
    options.output = path("said");
    Running running(prog06_words(split("3 0.4 0.1 0.3 1 out.ppm --size 32x16")), options);
    for (int i = 0; i < 3000 && !contains(read("said"), "q quits"); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(running.id(), signal);
    const Ended ended = running.wait();
    EXPECT_EQ(ended.code, 130) << signal;
    EXPECT_EQ(ended.err, "");
  }
}

TEST_F(Prog06, WithoutADisplayItSaysSo) {
  const Variable driver("SDL_VIDEODRIVER", "x11");
  const Variable display("DISPLAY", ":98765");
  const Ended ended = start(split("3 0.4 0.1 0.3 1 out.ppm"));
  EXPECT_EQ(ended.code, 1);
  EXPECT_SAYS(ended.err, "prog06: there is no display to open a window on");
  EXPECT_TRUE(files().empty());
}

std::string repository_file(const std::string& name) {
  std::ifstream file(STURNUS_SOURCE "/" + name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The pixels of a PNG or PPM file; PNG files of one picture may differ from one zlib to the next.
Image picture_in(const std::string& bytes) {
  if (!is_png(bytes)) return ppm_picture(bytes);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return {};
  png.format = PNG_FORMAT_RGB;
  Image image({static_cast<int>(png.width), static_cast<int>(png.height)}, {});
  png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr);
  return image;
}

// README's lines that begin with build/prog06 and press their own keys.
std::vector<std::string> recipes() {
  std::istringstream lines(repository_file("README.md"));
  std::vector<std::string> out;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("build/prog06 ") && contains(line, "--keys")) out.push_back(line);
  }
  return out;
}

TEST_F(Prog06, ReadmesRecipesMakeThePicturesOfTheRepository) {
  std::filesystem::create_directories(path("build"));
  std::filesystem::create_directories(path("docs/images"));
  std::filesystem::create_symlink(PROG06_PROGRAM, path("build/prog06"));
  std::filesystem::create_directory_symlink(STURNUS_SOURCE "/apps", path("apps"));
  ASSERT_GE(recipes().size(), 3u);
  for (const std::string& line : recipes()) {
    const Ended ended = Running({"/bin/sh", "-c", line}, here()).wait();
    EXPECT_EQ(ended.code, 0) << line << "\n" << ended.err;
  }
  for (const char* name : {"myboids.ppm", "docs/images/prog06.png", "docs/images/prog06-streams.png"}) {
    const std::string bytes = repository_file(name);
    ASSERT_TRUE(exists(name)) << "no recipe makes " << name;
    EXPECT_GT(picture_in(bytes).size().width, 0) << name;
    EXPECT_LE(bytes.size(), 250'000u) << name;
    EXPECT_TRUE(picture_in(read(name)) == picture_in(bytes)) << name << " is not what its recipe makes";
  }
}

}  // namespace
}  // namespace program_test
