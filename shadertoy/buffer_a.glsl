// Tab "Buffer A": one step of the flock a frame. Each texel at the lower left computes what one boid does next
// from what all boids did last.
//   iChannel0 = Buffer A, filter nearest, wrap clamp
//   iChannel1 = RGBA Noise Medium (Textures), filter linear, wrap repeat
//
// F is the weighted sum of the terms; then velocity += F, the speed is limited, and the new velocity moves the
// boid. All boids see the same old state.

// What random numbers are drawn for.
const int START_PLACE = 0, START_DEPTH = 1, START_SPEED = 2, START_WANDER = 3;
const int NOISE_ACCELERATION = 4, NOISE_TURN = 6, WANDER = 8;

uint mixed(uint bits) {
  bits = (bits ^ (bits >> 16)) * 0x7feb352du;
  bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
  return bits ^ (bits >> 16);
}

// Two numbers in [0, 1), of 16 bits each, from a texel of the noise. Drivers differ in the last bit of a texel, so
// that it is rounded to the byte that it was.
vec2 random2(int boid, int frame, int purpose) {
  uint bits = mixed(mixed(mixed(SEED + uint(frame)) + uint(boid)) + uint(purpose));
  ivec2 size = textureSize(iChannel1, 0);
  ivec2 at = ivec2(int(bits & 0xffffu) % size.x, int(bits >> 16) % size.y);
  vec4 bytes = floor(texelFetch(iChannel1, at, 0) * 255.0 + 0.5);
  return (bytes.xz * 256.0 + bytes.yw) / 65536.0;
}

// sin of t quarter turns, t in [0, 1], by its Taylor series: the same on every driver. (Some turn a division by a constant
// into a multiplication, so there is none.)
float sine(float t) {
  float x = t * 1.57079633, x2 = x * x;
  float high = -1.98412698e-4 + x2 * (2.75573192e-6 + x2 * -2.50521084e-8);
  return x * (1.0 + x2 * (-0.166666667 + x2 * (8.33333333e-3 + x2 * high)));
}

// The direction after `turns` whole turns from x to y.
vec2 direction(float turns) {
  float quarters = 4.0 * (turns - floor(turns));
  float quarter = floor(quarters), t = quarters - quarter;
  vec2 d = vec2(sine(1.0 - t), sine(t));
  if (quarter >= 2.0) d = -d;
  return mod(quarter, 2.0) == 1.0 ? vec2(-d.y, d.x) : d;
}

// A direction from two numbers in [0, 1); in the plane from the first alone.
vec3 random_direction(vec2 u) {
  if (DIMENSIONS == 2) return vec3(direction(u.x), 0.0);
  float z = 2.0 * u.y - 1.0;
  return vec3(direction(u.x) * sqrt(1.0 - z * z), z);
}

// Every component in [-1, 1).
vec3 random_in_cube(int boid, int purpose) {
  vec2 xy = random2(boid, iFrame, purpose);
  float z = DIMENSIONS == 3 ? random2(boid, iFrame, purpose + 1).x : 0.5;
  return 2.0 * vec3(xy, z) - 1.0;
}

// Whether a number is one, and not too large to reckon with.
bool is_sound(vec3 v) { return abs(v.x) <= 1e15 && abs(v.y) <= 1e15 && abs(v.z) <= 1e15; }

// ---- the start ----

vec3 start_place(int boid, Start start) {
  vec3 u = vec3(random2(boid, 0, START_PLACE), random2(boid, 0, START_DEPTH).x);
  if (start.outer > 0.0) {  // a ball, or a ring
    float power = float(DIMENSIONS);
    float r = pow(mix(pow(start.inner, power), pow(start.outer, power), u.x), 1.0 / power);
    vec3 centre = start.in_space ? 0.5 * (world_min() + world_max(iResolution.xy)) : start.low;
    return centre + r * random_direction(u.yz);
  }
  vec3 low = start.in_space ? world_min() : start.low;
  vec3 high = start.in_space ? world_max(iResolution.xy) : start.high;
  vec3 place = low + (high - low) * u;
  return DIMENSIONS == 3 ? place : vec3(place.xy, 0.0);
}

Boid start_of(int boid) {
  Start start = STARTS[flock_of(boid)];
  vec2 u = random2(boid, 0, START_SPEED);
  float speed = start.min_speed + (start.max_speed - start.min_speed) * u.x;
  vec3 heading = start.heading;
  if (heading == vec3(0.0)) heading = random_direction(vec2(u.y, random2(boid, 0, START_DEPTH).y));
  Boid first = Boid(start_place(boid, start), heading * speed);
  if (!is_sound(first.position) || !is_sound(first.velocity)) first = Boid(world_min(), vec3(0.0));
  return first;
}

// ---- neighbours ----

// From one place to another; in a wrapped world to the nearest image.
vec3 offset(vec3 from, vec3 to) {
  vec3 o = to - from;
  if (BOUNDARY == WRAP) {
    vec3 size = world_max(iResolution.xy) - world_min();
    if (o.x > 0.5 * size.x) o.x -= size.x; else if (o.x < -0.5 * size.x) o.x += size.x;
    if (o.y > 0.5 * size.y) o.y -= size.y; else if (o.y < -0.5 * size.y) o.y += size.y;
    if (o.z > 0.5 * size.z) o.z -= size.z; else if (o.z < -0.5 * size.z) o.z += size.z;
  }
  return o;
}

// What one neighbour adds to the sum of a term. Two boids at one place feel no direction.
vec3 contribution(int adds, vec3 o, float distance_squared, vec3 velocity) {
  if (adds == VELOCITY) return velocity;
  if (adds == HEADING) return unit(velocity);
  if (adds == GROWS) return o;
  if (distance_squared < 1.2e-38) return vec3(0.0);
  return o / (adds == FADES ? distance_squared : sqrt(distance_squared));
}

// The sum over the neighbours that a term lets in, and in .w how many they are.
vec4 sum_over_neighbours(Term term, int boid, Boid self) {
  vec4 sum = vec4(0.0);
  float speed = size_of(self.velocity);
  for (int flock = 0; flock < FLOCK_COUNT; ++flock) {
    if ((term.flocks >> flock & 1) == 0) continue;
    int first = FLOCKS[flock].first, last = first + count_of(flock);
    for (int i = first; i < last; ++i) {
      Boid other = boid_in(iChannel0, i);
      vec3 o = offset(self.position, other.position);
      float distance_squared = product(o, o);
      if (i == boid || distance_squared < term.inner_squared || distance_squared >= term.outer_squared) continue;
      bool is_seen = term.cos_half_view < -1.0 ||
                     product(self.velocity, o) >= term.cos_half_view * speed * sqrt(distance_squared);
      if (!is_seen) continue;
      sum += vec4(contribution(term.adds, o, distance_squared, other.velocity), 1.0);
    }
  }
  return sum;
}

// ---- steering ----

// Toward an offset: face it, seek it at full speed, or go there in proportion to how far it is.
vec3 steered(int form, vec3 o, vec3 velocity, float max_speed) {
  if (form == LINEAR) return o;
  if (form == SEEK) return unit(o) * max_speed - velocity;
  return o == vec3(0.0) ? vec3(0.0) : unit(o) - unit(velocity);
}

// A term before its weight. With no neighbour it is zero.
vec3 felt(Term term, int boid, Boid self, float max_speed) {
  vec4 sum = sum_over_neighbours(term, boid, self);
  float divisor = sum.w + term.count_self;
  if (term.kind == ALIGNMENT) {
    vec3 own = term.adds == VELOCITY ? self.velocity : unit(self.velocity);
    if (sum.w == 0.0 && !(term.count_self == 1.0 && !term.relative)) return vec3(0.0);
    vec3 average = (sum.xyz + term.count_self * own) / divisor;
    return term.relative ? average - own : average;
  }
  if (sum.w == 0.0) return vec3(0.0);
  vec3 mean = sum.xyz / divisor;
  if (term.kind == FLEE) {
    if (term.form == SEEK) return steered(SEEK, -mean, self.velocity, max_speed);
    return term.form == FACE ? -mean - unit(self.velocity) : -mean;
  }
  vec3 combined = term.is_mean ? mean : sum.xyz;
  return term.kind == SEPARATION ? -combined : combined;
}

// The pressed mouse attracts.
vec3 pull_of_mouse(Boid self, float max_speed) {
  if (iMouse.z <= 0.0) return vec3(0.0);
  vec3 o = offset(self.position, behind(view_at(iTime, iResolution.xy), iMouse.xy, iResolution.xy));
  return size_of(o) > MOUSE_RADIUS ? vec3(0.0) : steered(MOUSE_FORM, o, self.velocity, max_speed);
}

// The direction in which a boid wanders next.
vec3 wandered(int boid) {
  vec3 old = texelFetch(iChannel0, texel_at(FIRST_WANDER_TEXEL + boid), 0).xyz;
  vec3 next = unit(old + FLOCKS[flock_of(boid)].wander_rate * random_in_cube(boid, WANDER));
  return next == vec3(0.0) ? old : next;
}

// Inward, for each margin that the place is in.
vec3 turn_at_edge(vec3 position) {
  if (BOUNDARY != TURN) return vec3(0.0);
  vec3 low = world_min() + MARGIN, high = world_max(iResolution.xy) - MARGIN;
  vec3 turn = vec3(lessThan(position, low)) - vec3(greaterThan(position, high));
  return TURN_STRENGTH * (DIMENSIONS == 3 ? turn : vec3(turn.xy, 0.0));
}

vec3 acceleration_of(int boid, Boid self) {
  int flock = flock_of(boid);
  Flock own = FLOCKS[flock];
  vec3 sum = vec3(0.0);
  for (int t = 0; t < TERM_COUNT; ++t) {
    if (TERMS[t].flock == flock) sum += felt(TERMS[t], boid, self, own.max_speed) * TERMS[t].weight;
  }
  sum += unit(self.velocity) * (own.cruise_speed - size_of(self.velocity)) * own.cruise_weight;
  if (own.noise_acceleration > 0.0) sum += random_in_cube(boid, NOISE_ACCELERATION) * own.noise_acceleration;
  if (own.wander_weight != 0.0) sum += wandered(boid) * own.wander_weight;
  sum += pull_of_mouse(self, own.max_speed) * MOUSE_WEIGHT;
  float size = size_of(sum);
  if (size > own.max_acceleration) sum *= own.max_acceleration / size;
  return sum + turn_at_edge(self.position);
}

// ---- the step ----

// A boid at rest stays at rest.
vec3 limited(vec3 velocity, Flock own) {
  float speed = size_of(velocity);
  if (speed > own.max_speed) return velocity * (own.max_speed / speed);
  if (speed > 0.0 && speed < own.min_speed) return velocity * (own.min_speed / speed);
  return velocity;
}

// Noise turns the heading: in the plane at once, in space about a random perpendicular.
vec3 turned(vec3 velocity, int boid, Flock own) {
  if (own.noise_turn == 0.0 || velocity == vec3(0.0)) return velocity;
  vec2 u = random2(boid, iFrame, NOISE_TURN);
  vec2 angle = direction(own.noise_turn * (u.x - 0.5));
  vec3 axis = DIMENSIONS == 2 ? vec3(0.0, 0.0, 1.0)
                              : unit(cross(unit(velocity), random_direction(random2(boid, iFrame, NOISE_TURN + 1))));
  return velocity * angle.x + cross(axis, velocity) * angle.y;
}

// Brings one coordinate back into the world; a bounce mirrors the velocity too.
void keep_inside(inout float at, inout float velocity, float low, float high) {
  float size = high - low, far = at - low;
  if (BOUNDARY == WRAP) {
    at = low + (far - floor(far / size) * size);
    if (at >= high) at = low;
  }
  if (BOUNDARY == BOUNCE && (at < low || at > high)) {
    float folds = floor(far / size);
    bool is_mirrored = mod(folds, 2.0) == 1.0;
    far -= folds * size;
    at = clamp(low + (is_mirrored ? size - far : far), low, high);
    if (is_mirrored) velocity = -velocity;
  }
}

Boid next_of(int boid) {
  Boid self = boid_in(iChannel0, boid);
  Flock own = FLOCKS[flock_of(boid)];
  vec3 velocity = turned(limited(self.velocity + acceleration_of(boid, self) * DT, own), boid, own);
  vec3 position = self.position + (SEMI_IMPLICIT ? velocity : self.velocity) * DT;
  vec3 low = world_min(), high = world_max(iResolution.xy);
  keep_inside(position.x, velocity.x, low.x, high.x);
  keep_inside(position.y, velocity.y, low.y, high.y);
  if (DIMENSIONS == 3) keep_inside(position.z, velocity.z, low.z, high.z);
  if (!is_sound(position) || !is_sound(velocity)) return Boid(self.position, vec3(0.0));
  return Boid(position, velocity);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  fragColor = vec4(0.0);
  ivec2 at = ivec2(fragCoord);
  int texel = at.y * ROW + at.x;
  if (at.x >= ROW || texel > STAMP_TEXEL) return;

  // The flock starts in the first frame, as soon as the site has loaded the noise, or when another one was there.
  bool starts = iFrame == 0 || texelFetch(iChannel0, texel_at(STAMP_TEXEL), 0) != STAMP;
  if (starts && textureSize(iChannel1, 0).x < 2) return;

  if (texel == STAMP_TEXEL) {
    fragColor = STAMP;
  } else if (texel >= FIRST_WANDER_TEXEL) {
    int boid = texel - FIRST_WANDER_TEXEL;
    fragColor.xyz = starts ? random_direction(random2(boid, 0, START_WANDER)) : wandered(boid);
  } else {
    int boid = texel / TEXELS_PER_BOID;
    Boid next;
    if (starts) next = start_of(boid);
    else next = next_of(boid);
    if (DIMENSIONS == 2) fragColor = vec4(next.position.xy, next.velocity.xy);
    else fragColor.xyz = texel % 2 == 0 ? next.position : next.velocity;
  }
}
