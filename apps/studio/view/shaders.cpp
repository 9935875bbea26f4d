// Pieces of GLSL that shaders share, and the shaders of the scenery.
#include "view/shaders.h"

#include "view/shader_parts.h"

namespace studio::shaders {

const std::string version = "#version 330 core\n";

const std::string lens = R"(
uniform mat4 to_clip;
uniform vec3 eye, right, up, forward;
uniform bool in_space;
uniform float pixel;      // length of a pixel: in the plane everywhere, in space at distance 1
uniform vec2 window;      // pixels
uniform float scale;      // pixels of the display for one of the design
uniform float nearest;    // length: what is nearer is not drawn
uniform vec2 fade_between;
uniform vec3 background;

float depth_of(vec3 at) { return in_space ? dot(at - eye, forward) : 1.0; }
float pixel_at(vec3 at) { return pixel * max(depth_of(at), nearest); }
vec3 sunk(vec3 colour, float depth) {
  if (!in_space) return colour;
  float far = clamp((depth - fade_between.x) / (fade_between.y - fade_between.x), 0.0, 1.0);
  return mix(colour, background, 0.72 * far);
}
vec3 towards_light() { return normalize(up * 0.7 - right * 0.3 - forward * 0.8); }
vec4 bytes_of(uint word) {
  return vec4(word & 255u, word >> 8 & 255u, word >> 16 & 255u, word >> 24) / 255.0;
}
// Above all that looks at depth.
vec4 in_front(vec4 place) { return vec4(place.xy, mix(place.z, -place.w, 0.98), place.w); }
const vec4 nowhere = vec4(0, 0, -2, 1);
)";

const std::string wide_line = R"(
flat out vec4 colour;
out float across;
out float strength;
flat out float half_width;

// The corner of a line so many pixels wide; two triangles from `from` to `to`.
void widen(vec3 from, vec3 to, float width, int corner) {
  float a = depth_of(from), b = depth_of(to);
  if (in_space && a < nearest && b < nearest) { gl_Position = nowhere; return; }
  if (in_space && a < nearest) from = mix(to, from, (b - nearest) / (b - a));
  if (in_space && b < nearest) to = mix(from, to, (a - nearest) / (a - b));
  vec4 start = to_clip * vec4(from, 1), end = to_clip * vec4(to, 1);
  vec2 along = (end.xy / end.w - start.xy / start.w) * window;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1, 0);
  bool at_end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
  half_width = 0.5 * max(width, 1.0);
  across = side * (half_width + 0.5);
  vec4 at = at_end ? end : start;
  at.xy += vec2(-along.y, along.x) * (across * 2.0) / window * at.w;
  gl_Position = at;
}
)";

std::string line_vertex() {
  return version + "uniform usamplerBuffer lines;\n" + lens + wide_line + R"(
void main() {
  int line = gl_VertexID / 6, corner = gl_VertexID % 6;
  uvec4 a = texelFetch(lines, 2 * line), b = texelFetch(lines, 2 * line + 1);
  vec3 from = uintBitsToFloat(a.xyz), to = uintBitsToFloat(b.xyz);
  float width = uintBitsToFloat(a.w) * scale;
  colour = bytes_of(b.w);
  colour.rgb = sunk(colour.rgb, depth_of(0.5 * (from + to)));
  strength = min(width, 1.0);
  widen(from, to, width, corner);
}
)";
}

std::string line_fragment() {
  return version + R"(
flat in vec4 colour;
in float across;
in float strength;
flat in float half_width;
out vec4 shown;
void main() {
  shown = vec4(colour.rgb, colour.a * strength * clamp(half_width + 0.5 - abs(across), 0.0, 1.0));
}
)";
}

std::string sprite_vertex() {
  return version + "uniform usamplerBuffer sprites;\n" + lens + figure_outputs + R"(
void main() {
  int sprite = gl_VertexID / 6, corner = gl_VertexID % 6;
  uvec4 a = texelFetch(sprites, 2 * sprite), b = texelFetch(sprites, 2 * sprite + 1);
  vec3 at = uintBitsToFloat(a.xyz);
  float unit_pixel = pixel_at(at);
  colour = bytes_of(b.x);
  tail = vec4(0);
  ring = uintBitsToFloat(b.y) * scale;
  bool is_ball = (b.w & 1u) != 0u && in_space;
  kind = is_ball ? 3 : 0;
  radius = max(uintBitsToFloat(a.w) / unit_pixel, uintBitsToFloat(b.z) * scale);
  centre_depth = depth_of(at);
  deep = radius * unit_pixel;
  if ((b.w & 2u) == 0u) colour.rgb = sunk(colour.rgb, centre_depth);
  vec2 aside = vec2(corner == 1 || corner == 2 || corner == 4 ? 1 : -1,
                    corner == 2 || corner == 4 || corner == 5 ? 1 : -1);
  local = aside * (radius + ring + 1.0);
  vec3 place = at + (right * local.x + up * local.y) * unit_pixel;
  gl_Position = centre_depth < nearest ? nowhere : to_clip * vec4(place, 1);
}
)";
}

const std::string figure_outputs = R"(
flat out vec4 colour;
flat out vec4 tail;          // its colour, opaque where there is one
flat out int kind;           // 0 disc or ring, 1 dart, 2 triangle, 3 ball
flat out float radius;       // pixels; of a dart: its length
flat out float ring;         // pixels: width of a ring, 0: filled
flat out float centre_depth, deep;
out vec2 local;              // pixels, a dart's along its heading
)";

std::string figure_fragment() {
  return version + R"(
flat in vec4 colour;
flat in vec4 tail;
flat in int kind;
flat in float radius, ring, centre_depth, deep;
in vec2 local;
uniform bool in_space;
uniform float nearest;
out vec4 shown;

// Distance from the dart's edge in pixels; folded along its axis, two straight edges bound it.
float outside_dart() {
  float half_width = (kind == 2 ? 0.28 : 0.34) * radius;
  float nose = 0.56 * radius, end = 0.44 * radius, notch = (kind == 2 ? 0.44 : 0.22) * radius;
  float v = abs(local.y), front = nose + end, back = end - notch;
  return max(((local.x - nose) * half_width + v * front) * inversesqrt(half_width * half_width + front * front),
             -((local.x + notch) * half_width + v * back) * inversesqrt(half_width * half_width + back * back));
}

void main() {
  gl_FragDepth = gl_FragCoord.z;
  shown = colour;
  float outside;
  if (kind == 1 || kind == 2) {
    outside = outside_dart();
    if (tail.a > 0.0) shown.rgb = mix(shown.rgb, tail.rgb, clamp(-0.14 * radius - local.x + 0.5, 0.0, 1.0));
  } else {
    float from_centre = length(local);
    outside = from_centre - radius - 0.5 * ring;
    if (ring > 0.0) outside = max(outside, radius - 0.5 * ring - from_centre);
    if (tail.a > 0.0) shown.rgb = mix(tail.rgb, shown.rgb, clamp(from_centre - 0.4 * radius, 0.0, 1.0));
  }
  float cover = clamp(0.5 - outside, 0.0, 1.0);
  if (cover <= 0.0) discard;
  if (kind == 3) {
    vec2 out_ = local / radius;
    float towards = sqrt(max(0.0, 1.0 - dot(out_, out_)));
    float light = clamp(-0.28 * out_.x + 0.63 * out_.y + 0.72 * towards, 0.0, 1.0);
    shown.rgb = shown.rgb * (0.42 + 0.6 * light) + 0.16 * pow(light, 24.0);
    float depth = max(nearest, centre_depth - deep * towards);
    gl_FragDepth = 0.5 + 0.5 * (depth - 2.0 * nearest) / depth;
  }
  shown.a *= cover;
}
)";
}

std::string solid_vertex() {
  return version + "uniform usamplerBuffer corners;\n" + lens + R"(
out vec3 place;
out vec4 colour;
void main() {
  uvec4 corner = texelFetch(corners, gl_VertexID);
  place = uintBitsToFloat(corner.xyz);
  colour = bytes_of(corner.w);
  gl_Position = to_clip * vec4(place, 1);
}
)";
}

std::string solid_fragment() {
  return version + lens + R"(
in vec3 place;
in vec4 colour;
uniform bool lit;
out vec4 shown;
void main() {
  shown = colour;
  if (!lit) return;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, eye - place) < 0.0) normal = -normal;
  shown.rgb = sunk(colour.rgb * (0.5 + 0.5 * max(0.0, dot(normal, towards_light()))), depth_of(place));
}
)";
}

}  // namespace studio::shaders
