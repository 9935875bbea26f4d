// Composition of fragment shaders, and the way back from a line of the whole to a line of a tab. `#line` is
// not used for that, because Mesa forgets its second number.
#include "shader_text.h"

#include <sturnus/files.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

namespace shadertoy {
namespace {

constexpr const char* head =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "uniform vec3 iResolution;\n"
    "uniform float iTime;\n"
    "uniform float iTimeDelta;\n"
    "uniform float iFrameRate;\n"
    "uniform int iFrame;\n"
    "uniform vec4 iMouse;\n"
    "uniform vec4 iDate;\n"
    "uniform vec3 iChannelResolution[4];\n"
    "uniform float iChannelTime[4];\n"
    "uniform sampler2D iChannel0;\n"
    "uniform sampler2D iChannel1;\n"
    "uniform sampler2D iChannel2;\n"
    "uniform sampler2D iChannel3;\n";

std::string before_main(const Tab& common, const std::string& tab) {
  return head + common.text + "\n" + tab;
}

std::string pass_shader(const Shaders& shaders, const Tab& tab, const char* alpha) {
  return before_main(shaders.common, tab.text + "\n") +
         "out vec4 shadertoy_out;\n"
         "void main() {\n"
         "  vec4 colour = vec4(0.0, 0.0, 0.0, 1.0);\n"
         "  mainImage(colour, gl_FragCoord.xy);\n"
         "  shadertoy_out = vec4(colour.rgb, " +
         alpha + ");\n}\n";
}

int lines_in(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// A problem in a line of the complete shader, by the tab's own count. What the runner adds has no line.
sturnus::Problem problem_at(int line, std::string text, const Shaders& shaders, const Tab& tab) {
  line -= lines_in(head);
  const int common_lines = lines_in(shaders.common.text) + 1;
  if (line > 0 && line <= common_lines) return {shaders.common.file, line, "", std::move(text), false};
  line -= common_lines;
  const bool in_tab = line > 0 && line <= lines_in(tab.text) + 1;
  return {tab.file, in_tab ? line : 0, "", std::move(text), false};
}

sturnus::Result<Tab> read_tab(const std::string& folder, const std::string& name) {
  Tab tab;
  tab.file = (std::filesystem::path(folder) / name).string();
  auto text = sturnus::read_text(tab.file);
  if (!text) return text.problems();
  tab.text = std::move(*text);
  return tab;
}

}  // namespace

sturnus::Result<Shaders> read_shaders(const std::string& folder) {
  Shaders shaders;
  const bool has_common = std::filesystem::exists(std::filesystem::path(folder) / "common.glsl");
  for (const auto& [name, tab] :
       {std::pair("common.glsl", &shaders.common), std::pair("buffer_a.glsl", &shaders.buffer_a),
        std::pair("image.glsl", &shaders.image)}) {
    if (tab == &shaders.common && !has_common) continue;
    auto read = read_tab(folder, name);
    if (!read) return read.problems();
    *tab = std::move(*read);
  }
  return shaders;
}

std::string buffer_a_shader(const Shaders& shaders) {
  return pass_shader(shaders, shaders.buffer_a, "colour.a");
}

std::string image_shader(const Shaders& shaders) {
  return pass_shader(shaders, shaders.image, "1.0");
}

std::string probe_shader(const Shaders& shaders) {
  return before_main(shaders.common, "") +
         "uniform int probe_width;\n"
         "out ivec4 probe_out;\n"
         "void main() {\n"
         "  int boid = int(gl_FragCoord.y) * probe_width + int(gl_FragCoord.x) - 1;\n"
         "  probe_out = boid < 0 ? ivec4(COUNT, DIMENSIONS, 0, 0) : ivec4(flock_of(boid), texel_of(boid), "
         "0);\n"
         "}\n";
}

sturnus::Problems problems_in(const std::string& log, const Shaders& shaders, const Tab& tab) {
  // Mesa: "0:5(3): error: ..."; ANGLE: "ERROR: 0:5: ...".
  static const std::regex numbered_line(R"((?:ERROR: )?\d+:(\d+)(?:\(\d+\))?: (?:error: )?(.*))");
  sturnus::Problems problems;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.empty() || line.find("warning: ") != std::string::npos) continue;
    if (std::regex_match(line, match, numbered_line)) {
      problems.push_back(problem_at(std::atoi(match[1].str().c_str()), match[2].str(), shaders, tab));
    } else {
      problems.push_back({tab.file, 0, "", line, false});
    }
  }
  if (problems.empty())
    problems.push_back({tab.file, 0, "", "the driver refuses it without a reason", false});
  return problems;
}

}  // namespace shadertoy
