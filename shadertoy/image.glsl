// Tab "Image": draws every boid as a circle, light at its front, and the edge at which the flock turns.
//   iChannel0 = Buffer A, filter nearest, wrap clamp
//
// Every pixel looks at every boid, once and briefly: fit for some hundreds.

const vec3 BACKGROUND = vec3(15.0, 20.0, 25.0) / 255.0;
const vec3 LINES = vec3(58.0, 72.0, 82.0) / 255.0;
const vec3 POINTER = vec3(0.34, 0.71, 0.91);

// How much of a pixel something covers whose edge is so many pixels away, inside positive.
float cover(float inside) { return clamp(inside + 0.5, 0.0, 1.0); }

float distance_to_line(vec2 pixel, vec2 a, vec2 b) {
  vec2 along = b - a, o = pixel - a;
  return length(o - along * clamp(dot(o, along) / max(dot(along, along), 1e-6), 0.0, 1.0));
}

// The rectangle or box, `margin` inside the world's edge; in space all twelve edges.
float outline(View view, vec2 pixel, vec3 margin) {
  vec3 low = world_min() + margin, high = world_max(iResolution.xy) - margin;
  float line = 0.0;
  int edges = DIMENSIONS == 2 ? 4 : 12;
  for (int edge = 0; edge < edges; ++edge) {
    // Edges 0 to 3 lie in the front face along x and y, 4 to 7 in the back face, 8 to 11 join the two.
    int corner = edge & 3;
    vec3 a = vec3(float((corner + 1) >> 1 & 1), float(corner >> 1), edge < 4 ? 0.0 : 1.0);
    vec3 b = vec3(float((corner + 2) >> 1 & 1), float(((corner + 1) & 3) >> 1), a.z);
    if (edge >= 8) a.z = 0.0, b = vec3(a.xy, 1.0);
    vec4 from = seen(view, mix(low, high, a)), to = seen(view, mix(low, high, b));
    line = max(line, cover(0.4 - distance_to_line(pixel, from.xy, to.xy)));
  }
  return line;
}

// One boid over what was there: a disc, dark behind, light in front, with a bright spot where it is going.
vec3 disc(vec3 under, vec2 at, float radius, vec2 heading, vec3 colour, float fade) {
  vec2 q = at / radius;
  float front = 0.5 + 0.5 * dot(q, heading);
  vec3 body = mix(0.35 * colour, min(1.15 * colour, 1.0), front);
  float spot = cover(radius * (0.34 - length(q - 0.48 * heading)));
  body = mix(body, mix(colour, vec3(1.0), 0.8), heading == vec2(0.0) ? 0.0 : spot);
  return mix(under, mix(BACKGROUND, body, fade), cover(radius - length(at)));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  View view = view_at(iTime, iResolution.xy);
  vec3 colour = BACKGROUND;
  colour = mix(colour, LINES, (BOUNDARY == TURN ? 0.5 : 1.0) * outline(view, fragCoord, vec3(0.0)));
  if (BOUNDARY == TURN) colour = mix(colour, LINES, outline(view, fragCoord, MARGIN));

  // The line of sight through this pixel: in the plane all run along z, in space all come from the eye.
  vec3 there = behind(view, fragCoord, iResolution.xy);
  vec3 ray = DIMENSIONS == 2 ? view.forward : normalize(there - view.eye);
  vec3 from = DIMENSIONS == 2 ? there : view.eye;
  float far = size_of(world_max(iResolution.xy) - world_min());
  float nearest = ENDLESS;

  for (int flock = 0; flock < FLOCK_COUNT; ++flock) {
    Flock own = FLOCKS[flock];
    int last = own.first + count_of(flock);
    for (int i = own.first; i < last; ++i) {
      vec3 position = texelFetch(iChannel0, texel_of(i), 0).xyz;
      if (DIMENSIONS == 2) position.z = 0.0;
      vec3 o = position - from;
      float along = dot(o, ray);
      float reach = 0.5 * own.size + 2.0 * (DIMENSIONS == 2 ? 1.0 : max(along, 0.0)) / view.scale;
      if (dot(o, o) - along * along > reach * reach) continue;

      vec4 place = seen(view, position);
      if (place.z <= 0.0 || (DIMENSIONS == 3 && place.z > nearest)) continue;
      vec3 velocity = boid_in(iChannel0, i).velocity;
      vec2 heading = vec2(dot(velocity, view.right), dot(velocity, view.up));
      heading = velocity == vec3(0.0) ? vec2(0.0) : heading / size_of(velocity);
      float radius = max(0.5 * own.size * place.w, 1.5);
      float depth = dot(position - 0.5 * (world_min() + world_max(iResolution.xy)), view.forward);
      float fade = DIMENSIONS == 2 ? 1.0 : clamp(0.75 - depth / far, 0.25, 1.0);
      colour = disc(colour, fragCoord - place.xy, radius, heading, own.colour, fade);
      if (length(fragCoord - place.xy) < radius) nearest = place.z;
    }
  }

  if (iMouse.z > 0.0) {
    float r = length(fragCoord - iMouse.xy);
    colour = mix(colour, POINTER, cover(1.0 - abs(r - 14.0)));
  }
  fragColor = vec4(colour, 1.0);
}
