// The shaders of boids: one pulls an Instance, moves it between its places and gives it its colour.
#include "view/shader_parts.h"
#include "view/shaders.h"

namespace studio::shaders {

const std::string boid = R"(
uniform usamplerBuffer boids;
uniform vec4 flock_colour[64];   // red, green, blue, length of a boid
uniform vec4 flock_form[64];     // mesh, lowest and highest speed, 1 where it jumps
uniform float part;              // of the way between two steps
uniform int colour_by;           // as ColourBy
uniform int tracked;             // -1: nobody
uniform vec3 full_colour, starved_colour, ready_tail, tired_tail, quarantined_colour, tracked_colour;
uniform float lightness;         // of colours by heading and speed

struct Boid {
  vec3 at, from, velocity;
  int flock;
  uint flags;
  float starving, crowd;
  vec4 drifting;
  uint id;
};

Boid pull(int index) {
  uvec4 a = texelFetch(boids, 3 * index), b = texelFetch(boids, 3 * index + 1), c = texelFetch(boids, 3 * index + 2);
  Boid boid;
  boid.from = uintBitsToFloat(uvec3(a.w, b.x, b.y));
  boid.at = mix(boid.from, uintBitsToFloat(a.xyz), part);
  boid.velocity = uintBitsToFloat(uvec3(b.z, b.w, c.x));
  boid.flock = min(int(c.y & 255u), 63);
  boid.flags = c.y >> 8 & 255u;
  boid.starving = float(c.y >> 16 & 255u) / 255.0;
  boid.crowd = float(c.y >> 24);
  boid.drifting = bytes_of(c.z);
  boid.id = c.w;
  return boid;
}

// Lightness, chroma and hue (in turns) of Oklab, in which equal steps look equal.
vec3 even_colour(float light, float chroma, float turn) {
  float a = chroma * cos(6.2831853 * turn), b = chroma * sin(6.2831853 * turn);
  vec3 cone = vec3(light + 0.3963378 * a + 0.2158038 * b, light - 0.1055613 * a - 0.0638542 * b,
                   light - 0.0894842 * a - 1.2914855 * b);
  cone = cone * cone * cone;
  vec3 linear = vec3(4.0767417 * cone.x - 3.3077116 * cone.y + 0.2309699 * cone.z,
                     -1.2684380 * cone.x + 2.6097574 * cone.y - 0.3413194 * cone.z,
                     -0.0041961 * cone.x - 0.7034186 * cone.y + 1.7076147 * cone.z);
  return pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2));
}

// From violet over green to yellow, darker to lighter.
vec3 ramp(float part_) {
  float t = clamp(part_, 0.0, 1.0);
  return even_colour(lightness - 0.22 + 0.38 * t, 0.15, mix(0.80, 0.29, t));
}

vec3 by_heading(vec3 velocity) {
  float turn = atan(velocity.y, velocity.x) / 6.2831853;
  if (!in_space) return even_colour(lightness, 0.14, turn);
  turn = atan(velocity.z, velocity.x) / 6.2831853;
  float climb = velocity.y / max(length(velocity), 1e-20);
  return even_colour(lightness + 0.14 * climb, 0.14, turn);
}

vec3 hunter_colour(Boid boid, vec3 own) {
  if ((boid.flags & 2u) != 0u) return full_colour;
  return mix(own, starved_colour, boid.starving);
}

vec3 untracked_colour(Boid boid) {
  vec3 own = flock_colour[boid.flock].rgb;
  if ((boid.flags & 16u) != 0u) return quarantined_colour;
  if ((boid.flags & 1u) != 0u) return hunter_colour(boid, own);
  if (colour_by == 2) return by_heading(boid.velocity);
  if (colour_by == 3) {
    vec4 form = flock_form[boid.flock];
    return ramp((length(boid.velocity) - form.y) / max(form.z - form.y, 1e-20));
  }
  if (colour_by == 4) return ramp(sqrt(boid.crowd / 40.0));
  if (colour_by != 1 && boid.drifting.a > 0.0) return boid.drifting.rgb;
  return own;
}

// In space whoever is followed stands among others, who are paler then.
vec3 colour_of(Boid boid, int index) {
  if (index == tracked) return tracked_colour;
  vec3 own = untracked_colour(boid);
  return tracked >= 0 && in_space ? mix(own, background, 0.5) : own;
}

vec4 tail_of(Boid boid) {
  if (flock_form[boid.flock].w == 0.0) return vec4(0);
  return vec4((boid.flags & 4u) != 0u ? ready_tail : tired_tail, 1);
}

uniform float size;  // times the flock's
float length_of(Boid boid, int index) { return flock_colour[boid.flock].a * size * (index == tracked ? 1.35 : 1.0); }
)";

std::string figure_vertex() {
  return version + lens + boid + figure_outputs + R"(
uniform int shape;  // kind of what is drawn now
uniform int mesh;   // of the flocks that are drawn now
void main() {
  int index = gl_VertexID / 6, corner = gl_VertexID % 6;
  Boid boid = pull(index);
  float unit_pixel = pixel_at(boid.at);
  centre_depth = depth_of(boid.at);
  if (int(flock_form[boid.flock].x) != mesh || centre_depth < nearest) { gl_Position = nowhere; return; }
  bool is_tracked = index == tracked;
  colour = vec4(sunk(colour_of(boid, index), is_tracked ? 0.0 : centre_depth), 1);
  tail = tail_of(boid);
  ring = 0.0;
  kind = shape;
  float long_ = max(length_of(boid, index) / unit_pixel, (kind == 2 ? 2.0 : 3.5) * scale);
  bool is_dart = kind == 1 || kind == 2;
  radius = is_dart ? long_ : 0.5 * long_;
  deep = radius * unit_pixel;
  bool ahead = corner == 1 || corner == 2 || corner == 4, left = corner == 2 || corner == 4 || corner == 5;
  local = is_dart ? vec2(ahead ? 0.56 : -0.44, left ? 0.34 : -0.34) * long_ : vec2(ahead ? 1 : -1, left ? 1 : -1) * radius;
  local += vec2(ahead ? 1 : -1, left ? 1 : -1);
  vec2 heading = dot(boid.velocity.xy, boid.velocity.xy) > 0.0 && is_dart ? normalize(boid.velocity.xy) : vec2(1, 0);
  vec2 aside = heading * local.x + vec2(-heading.y, heading.x) * local.y;
  gl_Position = to_clip * vec4(boid.at + (right * aside.x + up * aside.y) * unit_pixel, 1);
  if (is_tracked) gl_Position = in_front(gl_Position), centre_depth = nearest + deep;
}
)";
}

std::string point_vertex() {
  return version + lens + boid + R"(
flat out vec3 colour;
uniform float smallest;  // pixels
void main() {
  Boid boid = pull(gl_VertexID);
  float depth = depth_of(boid.at);
  bool is_tracked = gl_VertexID == tracked;
  colour = sunk(colour_of(boid, gl_VertexID), is_tracked ? 0.0 : depth);
  gl_PointSize = clamp(0.5 * length_of(boid, gl_VertexID) / pixel_at(boid.at), (is_tracked ? 6.0 : smallest) * scale, 24.0 * scale);
  gl_Position = depth < nearest ? nowhere : to_clip * vec4(boid.at, 1);
  if (is_tracked && depth >= nearest) gl_Position = in_front(gl_Position);
}
)";
}

std::string point_fragment() {
  return version + "flat in vec3 colour;\nout vec4 shown;\nvoid main() { shown = vec4(colour, 1); }\n";
}

std::string trail_vertex() {
  return version + lens + boid + wide_line + R"(
uniform vec2 ages;    // opacity at the start and the end of the step's way
uniform float width;  // pixels
void main() {
  int index = gl_VertexID / 6, corner = gl_VertexID % 6;
  Boid boid = pull(index);
  if ((boid.flags & 16u) != 0u) { gl_Position = nowhere; return; }
  colour = vec4(sunk(colour_of(boid, index), depth_of(boid.at)), 1);
  strength = corner == 1 || corner == 2 || corner == 4 ? ages.y : ages.x;
  widen(boid.from, boid.at, width * scale, corner);
}
)";
}

std::string body_vertex() {
  return version + lens + boid + R"(
uniform samplerBuffer meshes;
uniform int mesh, first, corners;  // which mesh is drawn now, and where it is in the buffer
uniform float seconds;
flat out vec3 colour;
flat out vec4 tail;
flat out float depth_;
out vec3 model;       // where on the body at rest, in lengths of it
out vec3 normal;
out float what;       // the part of the body, as meshes.h counts
flat out float detail;  // 0 where a body is too small on the screen to show a texture, 1 where it is large

const float turn = 6.2831853;

// Two waves of fixed speed, so that a change of speed makes no leap: `lively` goes from the one to the other.
float wave(float slow, float fast, float phase, float lively) {
  return mix(sin(slow * seconds + phase), sin(fast * seconds + phase), lively);
}

vec3 swim(vec3 at, float phase, float lively) {
  float behind = 0.5 - at.x;
  at.y += (0.02 + 0.10 * behind * behind) * (0.6 + 0.4 * lively) * wave(5.0, 11.0, phase - 4.5 * behind, lively);
  return at;
}

vec3 flap(vec3 at, int piece, float phase, float lively) {
  if (piece != 2) return at;
  float reach = max(0.0, abs(at.y) - 0.05);
  float beating = mix(0.35, 1.0, smoothstep(-0.6, 0.4, sin(0.7 * seconds + 3.0 * phase) + lively));
  float angle = 0.12 + beating * 0.75 * wave(8.0, 14.0, phase - 2.2 * reach, lively);
  return vec3(at.x - 0.10 * reach * sin(angle), sign(at.y) * (0.05 + reach * cos(angle)), at.z + reach * sin(angle));
}

// Jaws apart: up and down in space; to the sides in the plane, which is seen from above.
vec3 bite(vec3 at, int piece, float open) {
  if (piece < 3 || piece > 6) return at;
  float by = open * max(0.0, at.x - 0.30) * (in_space ? 0.6 : 0.35);
  bool upper = piece == 3 || piece == 4, lefthand = piece == 3 || piece == 5;
  return at + (in_space ? vec3(0, 0, upper ? by : -by) : vec3(0, lefthand ? by : -by, 0));
}

// Small bodies are plumper, and a fish's tail is seen from all sides.
vec3 plump(vec3 at, int piece, float small) {
  if (mesh == 5 && piece == 1 && at.x < -0.35) at.y += sign(at.y) * abs(at.z) * 0.9 * max(small, 0.4);
  if (mesh == 5 && piece != 1) at.y *= 1.0 + small;
  if (mesh == 6 && piece == 0) at.yz *= 1.0 + 0.6 * small;
  return at;
}

void main() {
  int index = gl_VertexID / corners, corner = first + gl_VertexID % corners;
  Boid boid = pull(index);
  depth_ = depth_of(boid.at);
  if (int(flock_form[boid.flock].x) != mesh || depth_ < nearest) { gl_Position = nowhere; return; }
  vec4 a = texelFetch(meshes, 2 * corner);
  vec3 direction = texelFetch(meshes, 2 * corner + 1).xyz;
  float phase = float(boid.id * 2654435761u >> 16 & 1023u) / 1023.0 * turn;
  float speed = length(boid.velocity);
  float lively = clamp(speed / max(flock_form[boid.flock].z, 1e-20), 0.0, 1.0);
  int piece = int(a.w);
  float open = (boid.flags & 8u) != 0u ? 0.65 + 0.35 * sin(9.0 * seconds + phase) : 0.0;
  float unit_pixel = pixel_at(boid.at) * scale, least = mesh == 5 || mesh == 6 ? 10.0 : 4.0;
  float long_ = max(length_of(boid, index), least * unit_pixel);
  detail = smoothstep(14.0, 44.0, long_ / unit_pixel);
  vec3 moved = plump(bite(a.xyz, piece, open), piece, 1.0 - detail);
  if (mesh == 5) moved = swim(moved, phase, lively);
  if (mesh == 6) moved = flap(moved, piece, phase, lively);
  vec3 ahead = speed > 0.0 ? boid.velocity / speed : vec3(1, 0, 0);
  vec3 upright = in_space ? vec3(0, 1, 0) : vec3(0, 0, 1);
  if (abs(dot(ahead, upright)) > 0.999) upright = vec3(1, 0, 0);
  vec3 left = normalize(cross(upright, ahead)), top = cross(ahead, left);
  colour = colour_of(boid, index);
  tail = tail_of(boid);
  model = a.xyz;
  what = a.w;
  normal = ahead * direction.x + left * direction.y + top * direction.z;
  gl_Position = to_clip * vec4(boid.at + (ahead * moved.x + left * moved.y + top * moved.z) * long_, 1);
  // The plane has no depth of its own: each body has a thin layer, by its id.
  if (!in_space) gl_Position.z = -0.9 * phase / turn - 0.0008 * moved.z;
  if (index == tracked) gl_Position = in_front(gl_Position), depth_ = 0.0;
}
)";
}

std::string body_fragment() {
  return version + lens + R"(
uniform int mesh;
flat in vec3 colour;
flat in vec4 tail;
flat in float depth_;
in vec3 model;
in vec3 normal;
in float what;
flat in float detail;
out vec4 shown;

float band(float at, float width) { return smoothstep(width, 0.6 * width, abs(at)); }

vec3 fish(vec3 base) {
  int piece = int(what + 0.5);
  if (piece == 7) return vec3(0.25, 0.05, 0.06);
  if (piece == 1) return mix(base * 1.15, base * 0.55, 0.5 + 0.5 * sin(80.0 * (model.y + model.z) + 20.0 * model.x));
  float belly = smoothstep(0.02, -0.07, model.z);
  vec3 skin = base * (0.82 + 0.18 * smoothstep(-0.5, 0.4, model.x));
  float stripe = band(fract(model.x * 5.2 + 0.1) - 0.5, 0.24) * smoothstep(0.33, 0.24, model.x);
  skin = mix(skin, base * 0.42, 0.8 * stripe);
  skin = mix(skin, mix(base, vec3(1), 0.72), belly);
  skin = mix(skin, base * 0.5, band(model.x - 0.27, 0.012));
  float from_eye = length((vec3(model.x, abs(model.y), model.z) - vec3(0.37, 0.052, 0.034)) * vec3(1, 0.8, 1));
  skin = mix(skin, vec3(0.96), smoothstep(0.034, 0.028, from_eye));
  return mix(skin, vec3(0.04), smoothstep(0.022, 0.017, from_eye));
}

vec3 bird(vec3 base) {
  int piece = int(what + 0.5);
  if (piece >= 3) return vec3(0.95, 0.66, 0.18);
  if (piece == 1) return mix(base, base * 0.35, smoothstep(-0.30, -0.46, model.x));
  if (piece == 2) {
    float reach = abs(model.y);
    vec3 feathers = base * (0.88 + 0.12 * sin(110.0 * reach));
    feathers = mix(feathers, vec3(0.97), 0.85 * band(model.x + 0.015 + 0.22 * (reach - 0.2), 0.022));
    return mix(feathers, base * 0.28, smoothstep(0.34, 0.50, reach - 0.5 * (model.x + 0.02)));
  }
  vec3 skin = mix(base, mix(base, vec3(1), 0.7), smoothstep(0.01, -0.05, model.z));
  skin = mix(skin, base * 0.6, smoothstep(0.16, 0.24, model.x));
  float from_eye = length(vec3(model.x, abs(model.y), model.z) - vec3(0.285, 0.034, 0.018));
  return mix(skin, vec3(0.03), smoothstep(0.020, 0.014, from_eye));
}

void main() {
  int piece = int(what + 0.5);
  vec3 facing = normalize(normal);
  if ((piece == 1 || piece == 2) && dot(facing, forward) > 0.0) facing = -facing;  // thin: seen from both sides
  vec3 base = mesh == 5 ? fish(colour) : mesh == 6 ? bird(colour) : colour;
  base = mix(colour, base, detail);
  float end = mesh == 5 || mesh == 6 ? -0.30 : -0.08;
  if (tail.a > 0.0 && model.x < end) base = tail.rgb;
  float light = max(0.0, dot(facing, towards_light()));
  float gloss = light * light * light * light;
  // On a light ground bodies would be black in their own shade.
  float ground = dot(background, vec3(0.3, 0.6, 0.1));
  vec3 lit = base * mix(0.5 + 0.55 * light, 0.78 + 0.3 * light, ground) + 0.10 * gloss * gloss * gloss;
  shown = vec4(sunk(lit, depth_), 1);
}
)";
}

}  // namespace studio::shaders
