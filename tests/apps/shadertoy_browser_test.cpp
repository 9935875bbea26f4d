// Chromium and the runner agree about a pair of Shadertoy shaders: two drivers, two programs, one flock.
#include <sturnus/files.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "program.h"
#include "shadertoy_page.h"

namespace program_test {
namespace {

using nlohmann::json;
using sturnus::State;

constexpr int width = 1280, height = 720, frames = 100;
constexpr double most_pixels_apart = 1e-3;  // drivers round sums differently
constexpr double most_levels_apart = 8;     // of 255, in the mean of a square of 16 pixels

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

class FullShadertoyInChromium : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const Ended found = Running({"/bin/sh", "-c", "command -v chromium"}, here()).wait();
    if (found.code != 0) GTEST_SKIP() << "the package chromium is missing";
  }

  static std::string text_of(const std::string& path) {
    const auto text = sturnus::read_text(path);
    EXPECT_TRUE(text) << text.error();
    return text ? *text : "";
  }

  // What the page says about the shaders of a folder.
  json browser_plays(const std::string& shaders) const {
    const json tabs = {{"common", text_of(shaders + "/common.glsl")},
                       {"buffer_a", text_of(shaders + "/buffer_a.glsl")},
                       {"image", text_of(shaders + "/image.glsl")}};
    std::string given = "const tabs = " + tabs.dump() + ", frames = " + std::to_string(frames) +
                        ", width = " + std::to_string(width) + ", height = " + std::to_string(height) + ";\n";
    replace_all(given, "</", "<\\/");
    write("page.html", "<!doctype html><meta charset=\"utf-8\"><pre id=\"out\"></pre>\n<script>\n" + given +
                           shadertoy_page + "</script>\n");
    StartOptions options = here();
    options.variables = {"HOME=" + folder()};
    const Ended ended =
        Running({"chromium", "--headless", "--no-sandbox", "--disable-quic", "--no-first-run",
                 "--disable-background-networking", "--disable-component-update", "--disable-sync",
                 "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                 "--user-data-dir=" + path("chromium"), "--dump-dom", "file://" + path("page.html")},
                options)
            .wait(std::chrono::minutes(10));
    const std::string opening = "<pre id=\"out\">";
    const auto begin = ended.out.find(opening), end = ended.out.find("</pre>");
    if (ended.code != 0 || begin == std::string::npos || end == std::string::npos)
      return {{"error", "Chromium ended with " + std::to_string(ended.code) + ": " + ended.err}};
    std::string said = ended.out.substr(begin + opening.size(), end - begin - opening.size());
    for (const auto& [from, to] : {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&amp;", "&")})
      replace_all(said, from, to);
    const json answer = json::parse(said, nullptr, false);
    if (answer.is_discarded()) return {{"error", "the page's script did not run: " + ended.err}};
    return answer;
  }

  State runner_plays(const std::string& shaders) const {
    const Ended ended = Running({STURNUS_SHADERTOY, shaders, "--frames", std::to_string(frames), "--state",
                                 "out.csv", "--image", "out.ppm"},
                                here())
                            .wait(std::chrono::minutes(10));
    EXPECT_EQ(ended.code, 0) << ended.err;
    auto state = sturnus::parse_state_csv(read("out.csv"), "out.csv");
    EXPECT_TRUE(state) << state.error();
    return state ? *state : State{};
  }

  static void compare_states(const State& state, const json& page) {
    ASSERT_EQ(page["count"], state.size());
    ASSERT_EQ(page["dimensions"], state.dimensions);
    const auto axes = static_cast<std::size_t>(state.dimensions);
    const std::vector<std::int32_t> bits = page["bits"];
    ASSERT_EQ(bits.size(), 2 * axes * state.size());
    double apart = 0, moved = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      EXPECT_EQ(page["flocks"][i], state.flock[i]) << i;
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const double theirs = std::bit_cast<float>(bits[2 * axes * i + axis]);
        const double difference = std::abs(theirs - state.position[axis][i]);
        ASSERT_TRUE(std::isfinite(difference)) << "boid " << i;
        apart = std::max(apart, difference);
        moved = std::max(moved, std::abs(double{state.velocity[axis][i]}));
      }
    }
    std::cout << state.size() << " boids, frame " << frames << ": largest difference of positions " << apart
              << " px\n";
    EXPECT_LE(apart, most_pixels_apart);
    EXPECT_GT(moved, 0) << "nobody moves, which proves nothing";
  }

  void compare_pictures(const json& page) const {
    const std::string bytes = read("out.ppm");
    ASSERT_GE(bytes.size(), std::size_t{width * height * 3});
    const std::string picture = bytes.substr(bytes.size() - std::size_t{width * height * 3});
    std::vector<double> apart = page["blocks"];
    ASSERT_EQ(apart.size(), std::size_t{3 * (width / 16) * (height / 16)});
    for (std::size_t i = 0; i < picture.size(); ++i) {
      const std::size_t x = i / 3 % width, y = i / 3 / width;
      apart[3 * (y / 16 * (width / 16) + x / 16) + i % 3] -= static_cast<unsigned char>(picture[i]);
    }
    double most = 0;
    for (const double sum : apart) most = std::max(most, std::abs(sum) / 256);
    std::cout << "largest difference of mean levels in squares of 16 pixels " << most << "\n";
    EXPECT_LE(most, most_levels_apart);
    EXPECT_NE(std::count(picture.begin(), picture.end(), picture[0]), std::ptrdiff_t{width * height * 3});
  }

  void expect_agreement(const std::string& shaders) const {
    const json page = browser_plays(shaders);
    ASSERT_FALSE(page.contains("error")) << page["error"].get<std::string>();
    compare_states(runner_plays(shaders), page);
    compare_pictures(page);
  }
};

constexpr const char* flock_common = R"glsl(
const int COUNT = 300;
const int DIMENSIONS = 2;
int flock_of(int boid) { return boid % 2; }
ivec2 texel_of(int boid) { return ivec2(boid % 64, boid / 64); }
)glsl";

constexpr const char* flock_buffer_a = R"glsl(
float noise(int k) { return floor(texelFetch(iChannel1, ivec2(k % 256, k / 256), 0).x * 255.0 + 0.5) / 256.0; }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  ivec2 at = ivec2(fragCoord);
  int self = at.y * 64 + at.x;
  fragColor = vec4(0.0);
  if (at.x >= 64 || self >= COUNT) return;
  if (iFrame == 0) {
    fragColor = vec4(noise(4 * self) * iResolution.x, noise(4 * self + 1) * iResolution.y,
                     4.0 * noise(4 * self + 2) - 2.0, 4.0 * noise(4 * self + 3) - 2.0);
    return;
  }
  vec4 me = texelFetch(iChannel0, at, 0);
  vec2 separation = vec2(0.0), alignment = vec2(0.0), cohesion = vec2(0.0);
  float near = 0.0;
  for (int i = 0; i < COUNT; ++i) {
    vec4 other = texelFetch(iChannel0, texel_of(i), 0);
    vec2 offset = other.xy - me.xy;
    float d2 = dot(offset, offset);
    if (i == self || d2 > 2500.0 || flock_of(i) != flock_of(self)) continue;
    near += 1.0;
    alignment += other.zw;
    cohesion += offset;
    if (d2 > 0.0 && d2 < 225.0) separation -= offset / d2;
  }
  vec2 v = me.zw;
  if (near > 0.0) v += 0.05 * (alignment / near - v) + 0.001 * cohesion / near + 0.3 * separation;
  float speed = sqrt(dot(v, v));
  if (speed > 3.0) v *= 3.0 / speed;
  vec2 p = me.xy + v;
  fragColor = vec4(p - floor(p / iResolution.xy) * iResolution.xy, v);
}
)glsl";

constexpr const char* flock_image = R"glsl(
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  vec3 colour = vec3(0.05, 0.06, fragCoord.y / iResolution.y);
  for (int i = 0; i < COUNT; ++i) {
    vec2 offset = fragCoord - texelFetch(iChannel0, texel_of(i), 0).xy;
    if (dot(offset, offset) < 12.0) colour = flock_of(i) == 0 ? vec3(1.0, 0.7, 0.3) : vec3(0.4, 0.8, 1.0);
  }
  fragColor = vec4(colour, 1.0);
}
)glsl";

TEST_F(FullShadertoyInChromium, TheShippedShadersFlyAsInTheRunner) {
  expect_agreement(STURNUS_SOURCE "/shadertoy");
}

TEST_F(FullShadertoyInChromium, TheShippedShadersInSpaceFlyAsInTheRunner) {
  const std::string shipped = STURNUS_SOURCE "/shadertoy/";
  for (const char* tab : {"buffer_a.glsl", "image.glsl"})
    write(std::string("s/") + tab, *sturnus::read_text(shipped + tab));
  write("s/common.glsl", *sturnus::read_text(shipped + "common_3d.glsl"));
  expect_agreement(path("s"));
}

TEST_F(FullShadertoyInChromium, AFlockOfTheTestsOwnFliesAsInTheRunner) {
  write("s/common.glsl", flock_common);
  write("s/buffer_a.glsl", flock_buffer_a);
  write("s/image.glsl", flock_image);
  expect_agreement(path("s"));
}

// Places in even columns, velocities to their right; everybody turns about an axis through the middle.
constexpr const char* spatial_common = R"glsl(
const int COUNT = 40;
const int DIMENSIONS = 3;
int flock_of(int boid) { return boid / 20; }
ivec2 texel_of(int boid) { return ivec2(2 * (boid % 10), 3 + boid / 10); }
)glsl";

constexpr const char* spatial_buffer_a = R"glsl(
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  ivec2 at = ivec2(fragCoord), place = ivec2(at.x / 2 * 2, at.y);
  vec3 p = texelFetch(iChannel0, place, 0).xyz, v = texelFetch(iChannel0, place + ivec2(1, 0), 0).xyz;
  if (iFrame == 0) {
    p = vec3(400.0 + 40.0 * float(at.x / 2), 200.0 + 30.0 * float(at.y), 10.0 * float(at.y));
    v = floor(texelFetch(iChannel1, place, 0).xyz * 255.0 + 0.5) / 64.0 - 2.0;
  }
  v += 1e-3 * cross(vec3(0.6, 0.0, 0.8), p - vec3(640.0, 360.0, 50.0));
  v /= max(1.0, sqrt(dot(v, v)) / 3.0);
  fragColor = vec4(at.x % 2 == 0 ? p + v : v, 0.0);
}
)glsl";

TEST_F(FullShadertoyInChromium, AFlockInSpaceFliesAsInTheRunner) {
  write("s/common.glsl", spatial_common);
  write("s/buffer_a.glsl", spatial_buffer_a);
  write("s/image.glsl", flock_image);
  expect_agreement(path("s"));
}

TEST_F(FullShadertoyInChromium, WhatThePageRefusesIsAnError) {
  write("s/common.glsl", flock_common);
  write("s/buffer_a.glsl", flock_buffer_a);
  write("s/image.glsl", "void mainImage(out vec4 c, in vec2 at) { c = vec3(\"</pre>\"); }\n");
  const json page = browser_plays(path("s"));
  ASSERT_TRUE(page.contains("error"));
  EXPECT_SAYS(page["error"].get<std::string>(), "image: ERROR: ");
}

}  // namespace
}  // namespace program_test
