// Tab "Common". Every number of the flock, and what both passes need. It has no channels.
// Paste this file into the tab Common, buffer_a.glsl into Buffer A and image.glsl into Image.

// The kinds of terms, what one neighbour adds to a sum, the forms of steering, and the edges of a world.
const int SEPARATION = 0, ALIGNMENT = 1, COHESION = 2, FLEE = 3;
const int GROWS = 0, CONSTANT = 1, FADES = 2, VELOCITY = 3, HEADING = 4;
const int FACE = 0, SEEK = 1, LINEAR = 2;
const int OPEN = 0, WRAP = 1, TURN = 2, BOUNCE = 3;

// Where the boids of a flock begin: in the box from low to high, or, with outer > 0, in the ring or ball about low;
// in_space takes the whole world for the box, or its middle for the ring. A heading of zero is every boid's own.
struct Start {
  bool in_space;
  vec3 low, high;
  float inner, outer;
  float min_speed, max_speed;
  vec3 heading;
};

// Lengths in the world's units, a frame lasts DT time units. The boids of a flock are those from `first` up to the
// next flock's; noise_turn is a part of a whole turn.
struct Flock {
  int first;
  float min_speed, max_speed, max_acceleration;
  float cruise_speed, cruise_weight;
  float noise_acceleration, noise_turn;
  float wander_rate, wander_weight;
  vec3 colour;
  float size;
};

// A term of a flock: what it looks at (a bit for each flock, a ring of squared distances, a field of view by the
// cosine of its half), what each neighbour adds to the sum, and what becomes of the sum.
struct Term {
  int flock, kind, flocks;
  float inner_squared, outer_squared, cos_half_view;
  int adds;
  bool is_mean;
  float count_self;
  bool relative;
  int form;
  float weight;
};
const float ALL_ROUND = -2.0;  // a field of view without an edge
const float ENDLESS = 3e38;

// ---- numbers ----
// UCSD boids in 3D, after UCSD CSE 167 Assignment 5: Animation: Boids, bonus: 3D boids
// Written by: sturnus shadertoy ucsd-3d
const int COUNT = 300;  // boids
const bool WANDERS = false;
const int DIMENSIONS = 3;
const bool WORLD_IS_WINDOW = false;  // one unit a pixel; otherwise from MIN to MAX
const vec3 MIN = vec3(0.0, 0.0, 0.0);
const vec3 MAX = vec3(1280.0, 720.0, 720.0);
const int BOUNDARY = TURN;
const vec3 MARGIN = vec3(200.0, 160.0, 160.0);
const float TURN_STRENGTH = 0.5;
const float DT = 1.0;
const bool SEMI_IMPLICIT = true;  // the new velocity moves the boid
const uint SEED = 167u;
const float MOUSE_WEIGHT = 0.6;
const float MOUSE_RADIUS = ENDLESS;
const int MOUSE_FORM = FACE;
const int FLOCK_COUNT = 1;
const Flock FLOCKS[1] = Flock[](
  Flock(0, 5.0, 10.0, ENDLESS, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, vec3(0.3372549, 0.7058824, 0.9137255), 26.0)  // birds
);
const Start STARTS[1] = Start[](
  Start(true, vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, 0.0), 0.0, 0.0, 5.0, 10.0, vec3(0.0, 0.0, 0.0))  // birds
);
const int TERM_COUNT = 3;
const Term TERMS[3] = Term[](
  Term(0, SEPARATION, 1, 0.0, 900.0, ALL_ROUND, GROWS, true, 0.0, true, FACE, 0.02),  // birds: separation
  Term(0, ALIGNMENT, 1, 0.0, 22500.0, ALL_ROUND, VELOCITY, true, 0.0, true, FACE, 0.03),  // birds: alignment
  Term(0, COHESION, 1, 0.0, 22500.0, ALL_ROUND, GROWS, true, 0.0, true, FACE, 0.001)  // birds: cohesion
);
// ---- end of numbers ----

// The texels of Buffer A, row by row in a block at the lower left that is ROW texels wide, so that it outlives a
// change of the window's size. In the plane boid i has texel i: position.xy, velocity.xy. In space it has the
// even texel 2i for its position and the odd one after it for its velocity. Behind them lie the directions of
// boids that wander, and one texel with a stamp: another flock than the one there was begins anew.
const int ROW = 64;
const int TEXELS_PER_BOID = DIMENSIONS == 3 ? 2 : 1;
const int FIRST_WANDER_TEXEL = COUNT * TEXELS_PER_BOID;
const int STAMP_TEXEL = FIRST_WANDER_TEXEL + (WANDERS ? COUNT : 0);
const vec4 STAMP = vec4(COUNT, DIMENSIONS, WANDERS ? FLOCK_COUNT : -FLOCK_COUNT, 1u + (SEED & 0xffffu));

ivec2 texel_at(int number) { return ivec2(number % ROW, number / ROW); }
ivec2 texel_of(int boid) { return texel_at(boid * TEXELS_PER_BOID); }

int flock_of(int boid) {
  int flock = 0;
  while (flock + 1 < FLOCK_COUNT && boid >= FLOCKS[flock + 1].first) ++flock;
  return flock;
}
int count_of(int flock) { return (flock + 1 < FLOCK_COUNT ? FLOCKS[flock + 1].first : COUNT) - FLOCKS[flock].first; }

struct Boid {
  vec3 position;  // z = 0 in the plane
  vec3 velocity;
};

Boid boid_in(sampler2D buffer_a, int boid) {
  vec4 texel = texelFetch(buffer_a, texel_of(boid), 0);
  if (DIMENSIONS == 2) return Boid(vec3(texel.xy, 0.0), vec3(texel.zw, 0.0));
  return Boid(texel.xyz, texelFetch(buffer_a, texel_of(boid) + ivec2(1, 0), 0).xyz);
}

// The corners of the world: the scenario's own, or in the plane the window's, one unit a pixel.
vec3 world_min() { return WORLD_IS_WINDOW ? vec3(0.0) : MIN; }
vec3 world_max(vec2 resolution) { return WORLD_IS_WINDOW ? vec3(resolution, 0.0) : MAX; }

// Drivers add the products of dot() in orders of their own, and length() and normalize() may be rough; these are the same
// everywhere.
float product(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
float size_of(vec3 v) { return sqrt(product(v, v)); }
vec3 unit(vec3 v) {
  float size = size_of(v);
  return size > 0.0 ? v / size : vec3(0.0);
}

// The view: in the plane flat and fitted to the window; in space a slow flight round the middle of the world.
struct View {
  vec3 eye, right, up, forward;
  float scale;  // pixels for one unit: everywhere in the plane, at distance 1 in space
  vec2 middle;  // of the window, pixels
};

View view_at(float time, vec2 resolution) {
  vec3 size = world_max(resolution) - world_min();
  vec3 centre = world_min() + 0.5 * size;
  View view;
  view.middle = 0.5 * resolution;
  if (DIMENSIONS == 2) {
    float room = WORLD_IS_WINDOW ? 1.0 : 0.94;
    view.scale = room * min(resolution.x / size.x, resolution.y / size.y);
    view.eye = centre + vec3(0.0, 0.0, 1.0);
    view.right = vec3(1.0, 0.0, 0.0);
    view.up = vec3(0.0, 1.0, 0.0);
    view.forward = vec3(0.0, 0.0, -1.0);
    return view;
  }
  float angle = 0.5 + 0.08 * time;
  vec3 towards_eye = normalize(vec3(sin(angle), 0.35, cos(angle)));
  float slope = 0.3;  // of the upper edge of what is seen
  view.scale = 0.5 * min(resolution.y, resolution.x) / slope;
  view.eye = centre + towards_eye * (0.5 * size_of(size) / slope);
  view.forward = -towards_eye;
  view.right = normalize(cross(view.forward, vec3(0.0, 1.0, 0.0)));
  view.up = cross(view.right, view.forward);
  return view;
}

// A place in the window: x and y in pixels, how far away, and how many pixels one unit has there.
vec4 seen(View view, vec3 position) {
  vec3 o = position - view.eye;
  float depth = dot(o, view.forward);
  float scale = DIMENSIONS == 2 ? view.scale : view.scale / max(depth, 1e-6);
  return vec4(view.middle + scale * vec2(dot(o, view.right), dot(o, view.up)), depth, scale);
}

// The place in the world behind a pixel: in space that on the plane through its middle that faces the viewer.
vec3 behind(View view, vec2 pixel, vec2 resolution) {
  vec3 centre = 0.5 * (world_min() + world_max(resolution));
  float depth = dot(centre - view.eye, view.forward);
  vec2 o = (pixel - view.middle) * (DIMENSIONS == 2 ? 1.0 : depth) / view.scale;
  return view.eye + depth * view.forward + o.x * view.right + o.y * view.up;
}
