// The runner of Shadertoy shaders keeps Shadertoy's contract: uniforms, channels, feedback, pictures; and
// reads boids where the Common tab says they are.
#include <sturnus/files.h>

#include <csignal>

#include "program.h"
#include "sturnus-shadertoy/noise.h"

namespace program_test {
namespace {

using sturnus::State;

// A boid in each texel: the first of them, in rows of 16.
std::string common_of(int count, const std::string& more = "") {
  return "const int COUNT = " + std::to_string(count) +
         ";\n"
         "const int DIMENSIONS = 2;\n"
         "int flock_of(int boid) { return boid % 3; }\n"
         "ivec2 texel_of(int boid) { return ivec2(boid % 16, boid / 16); }\n" +
         more;
}

std::string main_image(const std::string& body) {
  return "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n" + body + "\n}\n";
}

const std::string black = main_image("fragColor = vec4(0.0);");

class ShadertoyRunner : public ProgramTest {
 protected:
  void write_shaders(const std::string& common, const std::string& buffer_a,
                     const std::string& image = black) const {
    write("s/common.glsl", common);
    write("s/buffer_a.glsl", buffer_a);
    write("s/image.glsl", image);
  }

  Ended play(const Words& arguments, std::vector<std::string> variables = {}) const {
    StartOptions options = here();
    options.variables = std::move(variables);
    Words words = {STURNUS_SHADERTOY, "s"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return Running(words, options).wait();
  }

  Ended play_well(const Words& arguments) const {
    Ended ended = play(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }

  State state_in(const std::string& name) const {
    auto state = sturnus::parse_state_csv(read(name), name);
    EXPECT_TRUE(state) << state.error();
    return state ? *state : State{};
  }

  // The state after the last frame of a picture of 48x32.
  State state_after(int frames, const Words& more = {}) const {
    Words words = {"--frames", std::to_string(frames), "--size", "48x32", "--state", "out.csv"};
    words.insert(words.end(), more.begin(), more.end());
    play_well(words);
    return state_in("out.csv");
  }

  // A texel's four numbers, as a boid has them.
  static std::array<float, 4> texel(const State& state, std::size_t boid) {
    return {state.position[0].at(boid), state.position[1].at(boid), state.velocity[0].at(boid),
            state.velocity[1].at(boid)};
  }

  // The pixels of a PPM file, three bytes each.
  std::string pixels(const std::string& name, int width, int height) const {
    const std::string bytes = read(name);
    const auto size = 3 * static_cast<std::size_t>(width * height);
    EXPECT_TRUE(bytes.starts_with("P6"));
    return bytes.size() < size ? std::string(size, '?') : bytes.substr(bytes.size() - size);
  }

  void expect_refusal(const Words& arguments, const std::string& sentence, int code = 2) const {
    const std::set<std::string> before = files();
    const Ended ended = play(arguments);
    EXPECT_EQ(ended.code, code) << sentence;
    EXPECT_EQ(ended.out, "");
    EXPECT_SAYS(ended.err, sentence);
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    EXPECT_EQ(files(), before);
  }
};

using Four = std::array<float, 4>;

TEST_F(ShadertoyRunner, ABufferSeesItsFrameBeforeAndBeginsAtZero) {
  write_shaders(common_of(2), main_image("vec4 before = texelFetch(iChannel0, ivec2(fragCoord), 0);\n"
                                         "fragColor = vec4(before.x + 1.0, iFrame, iTime, before.y);"));
  const State state = state_after(7);
  EXPECT_EQ(state.id, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(texel(state, 0), (Four{8, 7, 7.0f / 60, 6}));
  EXPECT_EQ(texel(state_after(0), 1), (Four{1, 0, 0, 0}));
  write_shaders(common_of(1), main_image("fragColor = texelFetch(iChannel0, ivec2(fragCoord), 0) + 1.0;"));
  EXPECT_EQ(texel(state_after(0), 0), (Four{1, 1, 1, 1}));
}

TEST_F(ShadertoyRunner, FeedbackDoesNotReachTheFrameThatIsDrawn) {
  // Each texel copies its left neighbour: a mark moves by one texel a frame, and by no more.
  write_shaders(common_of(16),
                main_image("ivec2 at = ivec2(fragCoord);\n"
                           "fragColor = iFrame == 0 ? vec4(at.x == 0 ? 5.0 : 0.0)\n"
                           "  : texelFetch(iChannel0, at - ivec2(1, 0), 0) * float(at.x > 0);"));
  const State state = state_after(9);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(state.position[0].at(i), i == 9 ? 5.0f : 0.0f) << i;
}

TEST_F(ShadertoyRunner, UniformsAreThoseOfShadertoy) {
  write_shaders(common_of(6), main_image("vec4 rows[6] = vec4[6](\n"
                                         "  vec4(iResolution, iFrameRate),\n"
                                         "  vec4(iChannelResolution[0], iTimeDelta),\n"
                                         "  vec4(iChannelResolution[1], iChannelTime[0]),\n"
                                         "  vec4(iChannelResolution[2], iChannelTime[3]),\n"
                                         "  iMouse, iDate);\n"
                                         "fragColor = rows[min(int(fragCoord.x), 5)];"));
  const State state = state_after(30);
  EXPECT_EQ(texel(state, 0), (Four{48, 32, 1, 60}));
  EXPECT_EQ(texel(state, 1), (Four{48, 32, 1, 1.0f / 60}));
  EXPECT_EQ(texel(state, 2), (Four{256, 256, 1, 0}));
  EXPECT_EQ(texel(state, 3), (Four{0, 0, 0, 0}));
  EXPECT_EQ(texel(state, 4), (Four{0, 0, 0, 0}));
  EXPECT_EQ(texel(state, 5), (Four{2000, 0, 1, 0.5f}));
}

TEST_F(ShadertoyRunner, AHeldMouseIsClickedInFrameZeroOnly) {
  write_shaders(common_of(1), main_image("fragColor = iMouse;"));
  EXPECT_EQ(texel(state_after(0, {"--mouse", "20,9"}), 0), (Four{20, 9, 20, 9}));
  EXPECT_EQ(texel(state_after(1, {"--mouse", "20,9"}), 0), (Four{20, 9, 20, -9}));
}

TEST_F(ShadertoyRunner, TheNoiseIsExact) {
  write_shaders(
      "const int COUNT = 65536;\nconst int DIMENSIONS = 2;\n"
      "int flock_of(int boid) { return 0; }\n"
      "ivec2 texel_of(int boid) { return ivec2(boid % 256, boid / 256); }\n",
      main_image("fragColor = floor(texelFetch(iChannel1, ivec2(fragCoord), 0) * 255. + .5);"));
  play_well({"--frames", "0", "--size", "256x256", "--state", "out.csv"});
  const State state = state_in("out.csv");
  ASSERT_EQ(state.size(), 65536u);
  int wrong = 0;
  for (std::uint32_t i = 0; i < 65536; ++i) {
    for (std::uint32_t channel = 0; channel < 4; ++channel)
      wrong += texel(state, i)[channel] != shadertoy::noise_byte(i % 256, i / 256, channel);
  }
  EXPECT_EQ(wrong, 0);
  // From the definition, worked out apart: key 0, and the last key.
  EXPECT_EQ(shadertoy::noise_byte(0, 0, 0), 7);
  EXPECT_EQ(shadertoy::noise_byte(255, 255, 3), 17);
}

TEST_F(ShadertoyRunner, TheNoiseIsLinearAndRepeats) {
  write_shaders(common_of(3), main_image("vec2 corner = vec2(3.0, 5.0) / 256.0;\n"
                                         "int x = int(fragCoord.x);\n"
                                         "if (x == 1) corner += vec2(2.0, -1.0);\n"
                                         "if (x == 2) corner = vec2(0.0);\n"
                                         "fragColor = texture(iChannel1, corner) * 255.0;"));
  const State state = state_after(0);
  const auto mean = [](std::uint32_t left, std::uint32_t right, std::uint32_t low, std::uint32_t high,
                       std::uint32_t channel) {
    return 0.25f * static_cast<float>(shadertoy::noise_byte(left, low, channel) +
                                      shadertoy::noise_byte(right, low, channel) +
                                      shadertoy::noise_byte(left, high, channel) +
                                      shadertoy::noise_byte(right, high, channel));
  };
  for (std::uint32_t channel = 0; channel < 4; ++channel) {
    EXPECT_NEAR(texel(state, 0)[channel], mean(2, 3, 4, 5, channel), 1.1f);  // drivers keep eight bits
    EXPECT_NEAR(texel(state, 1)[channel], mean(2, 3, 4, 5, channel), 1.1f);
    EXPECT_NEAR(texel(state, 2)[channel], mean(255, 0, 255, 0, channel), 1.1f);
  }
}

TEST_F(ShadertoyRunner, ABufferIsReadToTheNearestTexelAndClamped) {
  write_shaders(common_of(3),
                main_image("vec2 at[3] = vec2[3](vec2(-0.3, 1.7), vec2(3.9, 2.1) / iResolution.xy,\n"
                           "                     vec2(9.0, -9.0));\n"
                           "fragColor = vec4(fragCoord, 0.0, 0.0);\n"
                           "if (iFrame > 0) fragColor = texture(iChannel0, at[min(int(fragCoord.x), 2)]);"));
  const State state = state_after(1);
  EXPECT_EQ(texel(state, 0), (Four{0.5f, 31.5f, 0, 0}));
  EXPECT_EQ(texel(state, 1), (Four{3.5f, 2.5f, 0, 0}));
  EXPECT_EQ(texel(state, 2), (Four{47.5f, 0.5f, 0, 0}));
}

TEST_F(ShadertoyRunner, ThePictureStandsUpright) {
  write_shaders("", black,
                main_image("fragColor = vec4(0.0, 0.0, 1.0, 0.0);\n"
                           "if (fragCoord.x < 1.0 && fragCoord.y > iResolution.y - 1.0) fragColor = "
                           "vec4(1.0, 0.0, 0.0, 0.0);"));
  play_well({"--frames", "0", "--size", "20x16", "--image", "a.ppm"});
  const std::string seen = pixels("a.ppm", 20, 16);
  EXPECT_EQ(seen.substr(0, 6), std::string("\xff\0\0\0\0\xff", 6));
  EXPECT_EQ(std::count(seen.begin(), seen.end(), '\xff'), 320);
  EXPECT_EQ(seen.substr(20 * 16 * 3 - 3), std::string("\0\0\xff", 3));
}

TEST_F(ShadertoyRunner, TheImageSeesBufferAOfItsOwnFrameAndNothingElse) {
  // Buffer A says frame and place; a quarter of a texel to the side is still the same texel, and beyond the
  // edge is the edge. What has no input is black.
  write_shaders(
      "", main_image("fragColor = vec4(float(iFrame) * 10.0, fragCoord, 0.0);"),
      main_image(
          "vec4 a = texture(iChannel0, (fragCoord + vec2(0.4, 0.0)) / iResolution.xy);\n"
          "vec4 edge = texture(iChannel0, vec2(1.5, 0.5));\n"
          "vec3 none = texture(iChannel1, fragCoord / 256.0).rgb + texture(iChannel2, vec2(0.3)).rgb;\n"
          "float good = float(a.yz == fragCoord && edge.y == iResolution.x - 0.5);\n"
          "float alone = float(none == vec3(0.0) && iChannelResolution[1] == vec3(0.0));\n"
          "fragColor = vec4(a.x / 255.0, good, alone, 1.0);"));
  play_well({"--frames", "3", "--size", "20x16", "--image", "a.ppm"});
  const std::string seen = pixels("a.ppm", 20, 16);
  for (std::size_t i = 0; i < seen.size(); i += 3) ASSERT_EQ(seen.substr(i, 3), "\x1e\xff\xff") << i / 3;
}

TEST_F(ShadertoyRunner, MovieFramesAreZeroToN) {
  write_shaders("", black, main_image("fragColor = vec4(float(iFrame) / 255.0);"));
  play_well({"--frames", "3", "--size", "16x16", "--movie", "f/%02d.ppm", "--image", "last.ppm"});
  for (int frame = 0; frame <= 3; ++frame) {
    const std::string name = "f/0" + std::to_string(frame) + ".ppm";
    EXPECT_EQ(pixels(name, 16, 16), std::string(768, static_cast<char>(frame)));
  }
  EXPECT_FALSE(exists("f/04.ppm"));
  EXPECT_EQ(read("last.ppm"), read("f/03.ppm"));
  play_well({"--frames", "3", "--size", "32x18", "--movie", "a.mp4", "--image", "a.png"});
  EXPECT_EQ(read("a.mp4").substr(4, 4), "ftyp");
  EXPECT_TRUE(is_png(read("a.png")));
}

TEST_F(ShadertoyRunner, TwoDimensionsLieInOneTexel) {
  write_shaders(common_of(40), main_image("fragColor = vec4(fragCoord, -fragCoord);"));
  const State state = state_after(2);
  EXPECT_TRUE(read("out.csv").starts_with("id,flock,x,y,vx,vy\n0,0,0.5,0.5,-0.5,-0.5\n1,1,1.5,"));
  ASSERT_EQ(state.size(), 40u);
  EXPECT_EQ(texel(state, 37), (Four{5.5f, 2.5f, -5.5f, -2.5f}));
  EXPECT_EQ(state.flock[38], 2);
}

TEST_F(ShadertoyRunner, ThreeDimensionsLieInTwoTexels) {
  write_shaders(
      "const int COUNT = 5;\nconst int DIMENSIONS = 3;\n"
      "int flock_of(int boid) { return boid == 4 ? 7 : 0; }\n"
      "ivec2 texel_of(int boid) { return ivec2(2 * boid, 3); }\n",
      main_image("fragColor = vec4(fragCoord, 100.0 + fragCoord.x, 999.0);"));
  state_after(0);
  EXPECT_TRUE(read("out.csv").starts_with("id,flock,x,y,z,vx,vy,vz\n0,0,0.5,3.5,100.5,1.5,3.5,101.5\n"));
  EXPECT_SAYS(read("out.csv"), "\n4,7,8.5,3.5,108.5,9.5,3.5,109.5\n");
}

TEST_F(ShadertoyRunner, StatesOfEveryFrame) {
  write_shaders(common_of(2), main_image("fragColor = vec4(float(iFrame));"));
  play_well({"--frames", "3", "--size", "16x16", "--state", "states/%05d.csv"});
  EXPECT_EQ(files().size(), 9u);  // two folders, three shaders, four states
  for (int frame = 0; frame <= 3; ++frame) {
    const State state = state_in("states/0000" + std::to_string(frame) + ".csv");
    EXPECT_EQ(state.position[0].at(1), static_cast<float>(frame));
  }
  play_well({"--frames", "3", "--size", "16x16", "--state", "last.csv"});
  EXPECT_EQ(read("last.csv"), read("states/00003.csv"));
}

TEST_F(ShadertoyRunner, NobodyIsAStateToo) {
  write_shaders(common_of(0), black);
  EXPECT_EQ(state_after(1).size(), 0u);
  EXPECT_EQ(read("out.csv"), "id,flock,x,y,vx,vy\n");
}

TEST_F(ShadertoyRunner, SaysWhatItDid) {
  write_shaders(common_of(1), black);
  const Ended ended = play_well({"--frames", "2", "--size", "32x16", "--state", "a.csv", "--image", "a.png"});
  EXPECT_TRUE(ended.out.starts_with("wrote a.csv, a.png: frames 0 to 2, 32x16, ")) << ended.out;
  EXPECT_SAYS(ended.out, " s CPU\n");
  EXPECT_SAYS(play_well({"--image", "a.png", "--size", "16x16"}).out, "frames 0 to 100, 16x16");
  EXPECT_SAYS(play_well({"--image", "a.png", "--frames", "0"}).out, "1280x720");
  EXPECT_EQ(play_well({"--image", "a.png", "--size", "16x16", "--quiet"}).out, "");
}

TEST_F(ShadertoyRunner, LeavesNothingButWhatWasAskedFor) {
  write("s/buffer_a.glsl", black);
  write("s/image.glsl", main_image("fragColor = vec4(0.125);"));
  std::set<std::string> expected = files();
  expected.insert("a.png");
  const Ended ended =
      play({"--frames", "1", "--image", "a.png"}, {"HOME=" + folder(), "XDG_CACHE_HOME=" + path("cache")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(files(), expected);
}

TEST_F(ShadertoyRunner, CtrlCWritesTheFrameThatIsThere) {
  write_shaders(common_of(1), main_image("fragColor = vec4(float(iFrame));"));
  Running running({STURNUS_SHADERTOY, "s", "--frames", "1000000000", "--size", "16x16", "--state", "a.csv"},
                  here());
  ASSERT_TRUE(running.wait_until_it_works());
  ::kill(running.id(), SIGINT);
  const Ended ended = running.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  const auto frame = static_cast<int>(state_in("a.csv").position[0].at(0));
  EXPECT_SAYS(ended.out, "wrote a.csv: frames 0 to " + std::to_string(frame) + ", ");
}

TEST_F(ShadertoyRunner, AnyPairOfShadersHasAPictureButOnlyBoidsHaveAState) {
  write("s/buffer_a.glsl", black);
  write("s/image.glsl", black);
  play_well({"--frames", "0", "--image", "a.png"});
  expect_refusal({"--state", "a.csv"},
                 "common.glsl: does not say where the boids are; --state needs const int COUNT");
  struct Case {
    std::string common, sentence;
  };
  const std::string flock = "int flock_of(int boid) { return 0; }\n";
  const std::string texels = "ivec2 texel_of(int boid) { return ivec2(boid, 0); }\n";
  const std::vector<Case> cases = {
      {"const int COUNT = 2;\n" + flock + texels, "does not say where the boids are"},
      {"const int COUNT = 2;\nconst int DIMENSIONS = 4;\n" + flock + texels,
       "DIMENSIONS must be 2 or 3, but is 4"},
      {"const int COUNT = -2;\nconst int DIMENSIONS = 2;\n" + flock + texels, "COUNT is -2, but"},
      {"const int COUNT = 2000;\nconst int DIMENSIONS = 2;\n" + flock + texels,
       "COUNT is 2000, but a picture of 48x32 has room for 0 to 1536 boids"},
      {"const int COUNT = 49;\nconst int DIMENSIONS = 2;\n" + flock + texels,
       "texel_of(48) is 48,0, outside a picture of 48x32"},
      {"const int COUNT = 48;\nconst int DIMENSIONS = 3;\n" + flock + texels,
       "texel_of(47) is 47,0, outside a picture of 48x32"},
      {"const int COUNT = 1;\nconst int DIMENSIONS = 2;\nint flock_of(int boid) { return 256; }\n" + texels,
       "flock_of(0) must be 0 to 255, but is 256"},
  };
  for (const Case& bad : cases) {
    write_shaders(bad.common, black);
    expect_refusal({"--size", "48x32", "--state", "a.csv"}, bad.sentence);
  }
}

TEST_F(ShadertoyRunner, CompileErrorsNameFileAndLine) {
  const std::string wrong = "\n\nint wrong = 1.5;\n";
  write_shaders(wrong, black);
  expect_refusal({"--image", "a.png"}, "s/common.glsl:3: ");
  write_shaders(common_of(1), wrong + black);
  expect_refusal({"--image", "a.png"}, "s/buffer_a.glsl:3: ");
  write_shaders(common_of(1) + "// no line end", black, black + "#error no");
  expect_refusal({"--image", "a.png"}, "s/image.glsl:4: ");
  write_shaders("", black, "void main_image() {}\n");
  expect_refusal({"--image", "a.png"}, "s/image.glsl: ");
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(ShadertoyRunner, WrongOptionsAreRefusedInASentence) {
  write_shaders(common_of(1), black);
  struct Case {
    Words words;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{}, "sturnus-shadertoy: nothing is asked for; say what to write"},
      {{"--imag", "a.png"}, "sturnus-shadertoy: unknown option \"--imag\"; did you mean --image?"},
      {{"t", "--image", "a.png"}, "sturnus-shadertoy: \"t\" is one word too many"},
      {{"--image", "a.jpg"}, "--image: \"a.jpg\" must end in .png or .ppm"},
      {{"--image", "a%d.png"}, "--image: \"a%d.png\" must end in .png or .ppm, and is one picture"},
      {{"--movie", "a.png"}, "--movie: \"a.png\" must end in .mp4 or .gif"},
      {{"--state", "%d/%d.csv"}, "%d/%d.csv: the name of a frame has one place for its number"},
      {{"--image", "a.png", "--size", "wide"}, "--size: write width x height in pixels"},
      {{"--image", "a.png", "--size", "8x8"}, "--size: each side must be 16 to 16384 pixels"},
      {{"--image", "a.png", "--frames", "-1"}, "--frames"},
      {{"--image", "a.png", "--frames", "1.5"}, "must be a whole number"},
      {{"--image", "a.png", "--mouse", "5x5"}, "--mouse: write X,Y in pixels"},
      {{"--image", "a.png", "--mouse", "1280,0"}, "--mouse: \"1280,0\" lies outside the picture of 1280x720"},
  };
  for (const Case& bad : cases) expect_refusal(bad.words, bad.sentence);
  EXPECT_SAYS(Running({STURNUS_SHADERTOY}, here()).wait().err, "sturnus-shadertoy needs DIR; for example: ");
}

TEST_F(ShadertoyRunner, FilesThatAreNotThereOrCannotBeWritten) {
  expect_refusal({"--image", "a.png"}, "s/buffer_a.glsl: cannot be read: No such file or directory");
  write("s/buffer_a.glsl", black);
  expect_refusal({"--image", "a.png"}, "s/image.glsl: cannot be read: No such file or directory");
  write_shaders(common_of(1), "this is not looked at");
  expect_refusal({"--image", "no/a.png"}, "no/a.png: cannot be written", 1);
  expect_refusal({"--state", "no/a.csv"}, "no/a.csv: cannot be written", 1);
  expect_refusal({"--movie", "no/a.mp4"}, "no/a.mp4: cannot be written", 1);
  expect_refusal({"--sources", "s/image.glsl/src"}, "s/image.glsl", 1);
}

TEST_F(ShadertoyRunner, WithoutADriverItNamesThePackages) {
  write_shaders(common_of(1), black);
  for (const char* variable : {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent", "LIBGL_DRIVERS_PATH=/nonexistent"}) {
    const Ended ended = play({"--image", "a.png"}, {variable});
    EXPECT_EQ(ended.code, 1) << variable;
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    EXPECT_SAYS(ended.err, "shaders can't run here: ");
    EXPECT_SAYS(ended.err, "libegl1, libegl-mesa0, libgl1-mesa-dri and libgles2");
    EXPECT_FALSE(exists("a.png"));
  }
}

TEST_F(ShadertoyRunner, SourcesAreCompleteShaders) {
  write_shaders(common_of(1), main_image("fragColor = texture(iChannel1, iMouse.xy) * float(COUNT);"));
  // Without a driver too: there is nothing to run.
  const Ended ended = play({"--sources", "a/b"}, {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "wrote a/b/buffer_a.frag, a/b/image.frag\n");
  for (const char* name : {"a/b/buffer_a.frag", "a/b/image.frag"}) {
    EXPECT_TRUE(read(name).starts_with("#version 300 es\n"));
    const Ended lint = Running({"/bin/sh", "-c",
                                std::string("command -v glslangValidator >/dev/null || exit 77; "
                                            "glslangValidator ") +
                                    name},
                               here())
                           .wait();
    if (lint.code == 77) GTEST_SKIP() << "the package glslang-tools is missing";
    EXPECT_EQ(lint.code, 0) << lint.out;
  }
}

}  // namespace
}  // namespace program_test
