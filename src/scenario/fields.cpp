// The one list of parameters: a visiting function for each definition struct. Defaults stand in the structs.
#include "scenario/behaviours.h"
#include "scenario/field_parts.h"

namespace sturnus {
namespace {

// The keys that every term over neighbours has.
template <class Term>
void visit_reach(Term& term, const char* formula, const char* source, FieldVisitor& visitor) {
  visitor.field(
      "weight", &term.weight,
      {weight_about.unit, weight_about.text, weight_about.low, weight_about.high, false, formula, source});
  visitor.field("radius", RingRef{&term.inner, &term.radius},
                {"length", "how near a neighbour must be; or ring = [inner, outer], inner <= d < outer", 0,
                 infinity, true, "inner <= d < outer", "CS 184 (S4-4)"});
  visitor.field("edge", edge_choice(term.edge),
                {"", "whether a neighbour exactly on the outer radius counts", 0, 0, false,
                 "open: d < outer, closed: d <= outer", "prog06 (S1-6)"});
}

template <class Term>
void visit_filters(Term& term, FieldVisitor& visitor) {
  visitor.field("of", &term.of,
                {"", "whose members are looked at: \"own\", \"all\" or a list of flocks", 0, 0, false, "",
                 "VUW CGRA 354 (S2-18)"});
  visitor.field("field_of_view", &term.field_of_view, field_of_view_about);
  visitor.field("sample", &term.sample,
                {"", "share of the neighbours that are looked at, by chance", 0, 1, false, "",
                 "quadtree project (S3-6)"});
  visitor.field("priority", &term.priority, priority_about);
  visitor.field("on", &term.on, on_about);
}

void visit_separation(Separation& term, FieldVisitor& visitor) {
  visit_reach(term, "sum or mean of -(o/d)·s(d)", "UCSD (S0-5), prog06 (S1-6)", visitor);
  visitor.field("strength", strength_choice(term.strength),
                {"", "one neighbour's push over its distance: \"d\" grows, \"1\" constant, \"1/d\" fades", 0,
                 0, false, "s(d)", "UCSD (S0-5), VUW CGRA 354 (S2-12)"});
  visitor.field(
      "combine", combine_choice(term.combine),
      {"", "sum over the neighbours or their mean", 0, 0, false, "", "UCSD (S0-5), VUW CGRA 354 (S2-12)"});
  visit_filters(term, visitor);
}

void visit_alignment(Alignment& term, FieldVisitor& visitor) {
  visit_reach(term, "mean of v - own v", "UCSD (S0-7)", visitor);
  visitor.field(
      "match", choice(term.match, {"velocity", "heading"}),
      {"", "what is averaged: velocities, or headings (unit velocities)", 0, 0, false, "", "CS 184 (S4-1)"});
  visitor.field("relative", &term.relative,
                {"", "average minus own (true), or the average itself", 0, 1, false, "", "CS 184 (S4-1)"});
  visitor.field(
      "count_self", &term.count_self,
      {"", "the boid is part of its own average", 0, 1, false, "(q + sum)/(n + 1)", "VUW CGRA 354 (S2-14)"});
  visit_filters(term, visitor);
}

void visit_cohesion(Cohesion& term, FieldVisitor& visitor) {
  visit_reach(term, "mean of (o/d)·s(d)", "UCSD (S0-6)", visitor);
  visitor.field("strength", strength_choice(term.strength),
                {"", "one neighbour's pull over its distance: \"d\" grows, \"1\" constant, \"1/d\" fades", 0,
                 0, false, "s(d)", "CS 184 (S4-2)"});
  visitor.field("combine", combine_choice(term.combine), {"", "sum over the neighbours or their mean"});
  visitor.field("count_self", &term.count_self,
                {"", "divide by n + 1 instead of n", 0, 1, false, "", "VUW CGRA 354 (S2-14)"});
  visit_filters(term, visitor);
}

void visit_flee(Flee& term, FieldVisitor& visitor) {
  visitor.field("from", &term.from,
                {"", "names of the flocks that are fled", 0, 0, false, "", "CS 184 (S4-17)"});
  visitor.field("radius", &term.radius,
                {"length", "how far they are seen", 0, infinity, false, "", "CS 184 (S4-17)"});
  visitor.field("weight", &term.weight,
                {weight_about.unit, weight_about.text, weight_about.low, weight_about.high, false,
                 "m - v/|v|, unit(m)·max_speed - v and so on, by form; m the mean of -(o/d), linear: of -o",
                 "CS 184 (S4-17)"});
  visitor.field(
      "form", form_choice(term.form),
      {"",
       "heading: unit(away) - heading; seek: full speed away - v; linear: the offset itself; orbit: full "
       "speed away, v not taken off",
       0, 0, false, "", "CS 184 (S4-11), VUW CGRA 354 (S2-19), quadtree project (S3-10)"});
  visitor.field("field_of_view", &term.field_of_view, field_of_view_about);
  visitor.field("priority", &term.priority, priority_about);
  visitor.field("on", &term.on, on_about);
}

void visit_cruise(Cruise& cruise, FieldVisitor& visitor) {
  visitor.field("speed", &cruise.speed,
                {"length per time", "the speed that is sought", 0, infinity, false, "", "CS 184 (S4-5)"});
  visitor.field("weight", &cruise.weight,
                {"per time", weight_about.text, -1e9, 1e9, false, "(speed - |v|)·v/|v|", "CS 184 (S4-5)"});
  visitor.field("priority", &cruise.priority, priority_about);
  visitor.field("on", &cruise.on, on_about);
}

void visit_wander(Wander& wander, FieldVisitor& visitor) {
  visitor.field("rate", &wander.rate,
                {"", "how far the sought direction strays in one step", 0, 1000, false,
                 "w <- unit(w + rate·u)", "Reynolds 1999"});
  visitor.field(
      "weight", &wander.weight,
      {"length per time squared", weight_about.text, -1e9, 1e9, false, "weight·w", "Reynolds 1999"});
  visitor.field("priority", &wander.priority, priority_about);
  visitor.field("on", &wander.on, on_about);
}

void visit_avoid_obstacles(AvoidObstacles& avoid, FieldVisitor& visitor) {
  visitor.field("weight", &avoid.weight, weight_about);
  visitor.field(
      "form", choice(avoid.form, {"sweep", "heading"}),
      {"",
       "sweep: sideways, out of the way of the first obstacle ahead; heading: away from all that are near", 0,
       0, false, "unit(E - C), or the mean of unit(p - C) - heading",
       "VUW CGRA 354 (S2-25 to S2-28), CS 184 (S4-10, S4-11)"});
  visitor.field("look_ahead", &avoid.look_ahead,
                {"length", "sweep: how far along the heading obstacles are seen", 0, 1e15, false, "",
                 "VUW CGRA 354 (S2-25)"});
  visitor.field("clearance", &avoid.clearance,
                {"length", "sweep: room that is kept between body and obstacle", 0, 1e15, false,
                 "R = body_radius + clearance + r", "VUW CGRA 354 (S2-25)"});
  visitor.field(
      "radius", &avoid.radius,
      {"length", "heading: how near an obstacle's surface must be", 0, 1e15, false, "", "CS 184 (S4-10)"});
  visitor.field("priority", &avoid.priority, priority_about);
  visitor.field("on", &avoid.on, on_about);
}

void visit_noise(Noise& noise, FieldVisitor& visitor) {
  visitor.field("acceleration", &noise.acceleration,
                {"length per time squared", "each component of a random acceleration lies in [-this, this]",
                 0, 1e9, false, "A·u, u uniform in [-1, 1]", "quadtree project (S3-7)"});
  visitor.field(
      "turn", &noise.turn,
      {"degrees", "the heading turns by a random angle in [-turn/2, turn/2] after the velocity update", 0,
       360, false, "", "Vicsek 1995"});
  visitor.field("priority", &noise.priority, priority_about);
  visitor.field("on", &noise.on, on_about);
}

void visit_start(Start& start, FieldVisitor& visitor) {
  visitor.field("region", choice(start.region, {"space", "box", "ball", "ring"}),
                {"", "where boids begin: anywhere in the space, a box, a ball, a ring"});
  visitor.field("min", CoordinatesRef{&start.min}, {"length", "box: lower corner"});
  visitor.field("max", CoordinatesRef{&start.max}, {"length", "box: upper corner"});
  visitor.field("centre", CoordinatesRef{&start.centre},
                {"length", "ball, ring: centre; default: the middle of the space"});
  visitor.field("radius", &start.radius, {"length", "ball, ring: outer radius", 0, infinity});
  visitor.field("inner", &start.inner, {"length", "ring: inner radius", 0, infinity});
  visitor.field("speed", Range{&start.min_speed, &start.max_speed},
                {"length per time", "speeds at the start, uniform between the two", 0, infinity, false, "",
                 "prog06 (S1-5)"});
  visitor.field("heading", CoordinatesRef{&start.heading},
                {"", "direction of all; default: each its own, at random"});
  visitor.field("file", &start.file, {"", "state CSV that this flock's boids are taken from instead"});
}

void visit_colour(Colour& colour, FieldVisitor& visitor) {
  visitor.field("start", &colour.start,
                {"", "\"#rrggbb\", \"random\", or empty for the next colour of the palette", 0, 0, false, "",
                 "CS 184 (S4-9)"});
  visitor.field("averaging", &colour.averaging,
                {"", "share of the way to the neighbours' mean colour in one step", 0, 1, false,
                 "c <- clamp(c + averaging·(mean - c) + noise·u)", "CS 184 (S4-9)"});
  visitor.field("noise", &colour.noise,
                {"", "each value moves by up to this much in one step", 0, 1, false, "", "CS 184 (S4-9)"});
  visitor.field("of", &colour.of, {"", "whose colours are averaged: \"own\", \"all\" or a list of flocks"});
}

void visit_target_sense(TargetSense& sense, FieldVisitor& visitor) {
  visitor.field("weight", &sense.weight,
                {"", weight_about.text, -1e9, 1e9, false, "sum of w·pull; of form heading their mean",
                 "CS 184 (S4-11)"});
  visitor.field("priority", &sense.priority, priority_about);
  visitor.field("on", &sense.on, on_about);
}

void visit_flock(FlockDef& flock, FieldVisitor& visitor) {
  visitor.field("name", &flock.name, {"", "what paths, messages and other flocks call it"});
  visitor.field("count", &flock.count,
                {"boids", "how many there are at the start", 0, 1e9, false, "", "prog06 (S1-5)"});
  visitor.table(
      "start", {"", "where boids begin and how fast"},
      [&](FieldVisitor& inner) { visit_start(flock.start, inner); }, "region");
  visitor.field(
      "min_speed", &flock.min_speed,
      {"length per time", "least speed; a boid at rest stays at rest", 0, 1e15, false, "", "UCSD (S0-10)"});
  visitor.field("max_speed", &flock.max_speed,
                {"length per time", "largest speed", 0, 1e15, true, "", "UCSD (S0-10)"});
  visitor.field("max_acceleration", &flock.max_acceleration,
                {"length per time squared", "cap on the length of the sum of all terms", 0, infinity, true,
                 "a·min(1, max/|a|)", "prog06 (S1-12)"});
  visitor.field("field_of_view", &flock.field_of_view,
                {"degrees", "full angle of sight around the heading; 360 sees all round", 0, 360, false,
                 "v·o >= cos(half)·|v|·d", "quadtree project (S3-5)"});
  visitor.field(
      "arbitration", choice(flock.arbitration, {"weighted", "budget", "first"}),
      {"",
       "how terms share the acceleration: weighted sum, budget by priority, or the first that is not zero", 0,
       0, false, "", "VUW CGRA 354 (S2-30), Couzin 2002"});
  visitor.items("separation", {"", "steer away from near neighbours"},
                list_of(flock.separation, visit_separation));
  visitor.items("alignment", {"", "steer toward the neighbours' average velocity or heading"},
                list_of(flock.alignment, visit_alignment));
  visitor.items("cohesion", {"", "steer toward the neighbours"}, list_of(flock.cohesion, visit_cohesion));
  visitor.items("flee", {"", "steer away from other flocks in sight"}, list_of(flock.flee, visit_flee));
  visitor.items("cruise", {"", "keep a cruising speed"}, maybe(flock.cruise, visit_cruise));
  visitor.items("wander", {"", "a bounded random walk of a sought direction"},
                maybe(flock.wander, visit_wander));
  visit_behaviours(flock, visitor);
  visitor.items("noise", {"", "random acceleration and turning"}, maybe(flock.noise, visit_noise));
  visitor.items("avoid_obstacles", {"", "steer around obstacles"},
                maybe(flock.avoid_obstacles, visit_avoid_obstacles));
  visitor.table(
      "targets", {"", "how the flock feels the targets"},
      [&](FieldVisitor& inner) { visit_target_sense(flock.targets, inner); }, "weight");
  visitor.table(
      "colour", {"", "colours that drift toward the neighbours'"},
      [&](FieldVisitor& inner) { visit_colour(flock.colour, inner); }, "start");
  visitor.field("glyph",
                Choice{{"auto", "dart", "cone", "circle"},
                       [&flock] { return flock.glyph ? static_cast<int>(*flock.glyph) + 1 : 0; },
                       [&flock](int index) {
                         flock.glyph.reset();
                         if (index > 0) flock.glyph = static_cast<GlyphStyle>(index - 1);
                       }},
                {"", "how a boid is drawn; auto: a dart in 2D, a cone in 3D", 0, 0, false, "",
                 "CS 184 (S4-32), prog06 (S1-16)"});
  visitor.field("size", &flock.size,
                {"length", "length of a drawn boid", 0, infinity, false, "", "quadtree project (S3-8)"});
  visitor.field("body_radius", &flock.body_radius,
                {"length", "how large a boid is to the touch, and for obstacles", 0, 1e15, false,
                 "touch: d <= sum of the body radii", "CS 184 (S4-14), VUW CGRA 354 (S2-25)"});
  visitor.items("hunt", {"", "hunt other flocks and eat whom the body touches"},
                maybe(flock.hunt, visit_hunt));
  visitor.items("jump", {"", "a burst of speed straight ahead when prey is near"},
                maybe(flock.jump, visit_jump));
  visitor.items("hunger", {"", "how long a meal lasts"}, maybe(flock.hunger, visit_hunger));
  visitor.items("feed", {"", "eat food, of which new boids are born"}, maybe(flock.feed, visit_feed));
}

void visit_boundary(Boundary& boundary, FieldVisitor& visitor) {
  visitor.field("kind", choice(boundary.kind, {"open", "wrap", "turn", "bounce"}),
                {"", "nothing, come out at the other side, be turned back, or bounce", 0, 0, false, "",
                 "VUW CGRA 354 (S2-17), UCSD (S0-9)"});
  visitor.field(
      "margin", CoordinatesRef{&boundary.margin, true},
      {"length", "turn: width of the strip along the edge, one for all axes or one for each; default 0", 0,
       infinity, false, "p < min + margin, p > max - margin", "UCSD (S0-9)"});
  visitor.field("strength", &boundary.strength,
                {"length per time squared", "turn: acceleration inward while in the strip, after the cap",
                 -infinity, infinity, false, "", "UCSD (S0-9), prog06 (S1-13)"});
}

void visit_space(Space& space, FieldVisitor& visitor) {
  visitor.field("dimensions", &space.dimensions, {"", "2 or 3", 2, 3});
  visitor.field("min", CoordinatesRef{&space.min},
                {"length", "lower corner; with max, or per_boid in place of both"});
  visitor.field("max", CoordinatesRef{&space.max}, {"length", "upper corner"});
  visitor.field("per_boid", &space.per_boid,
                {"area or volume",
                 "the space is a square or cube about the origin that grows with the number of boids; "
                 "default: 10 by 10 (by 10) for each",
                 0, infinity});
  visitor.table(
      "boundary", {"", "what happens at the edge"},
      [&](FieldVisitor& inner) { visit_boundary(space.boundary, inner); }, "kind");
  visitor.field("solid", &space.solid, {"", "no boid ends a step inside an obstacle"});
}

void visit_random_obstacles(RandomObstacles& random, FieldVisitor& visitor) {
  visitor.field("count", &random.count, {"obstacles", "how many spheres", 0, 1e6});
  visitor.field("radius", Range{&random.min_radius, &random.max_radius},
                {"length", "their radii, uniform between the two", 0, 1e15});
  visitor.field("keep_apart", &random.keep_apart,
                {"length", "least room between a sphere and any earlier obstacle", 0, 1e15});
}

void visit_obstacle(ObstacleDef& obstacle, FieldVisitor& visitor) {
  visitor.field("spheres", &obstacle.spheres,
                {"length", "centre and radius of each: [x, y, z, r]; in 2D circles [x, y, r]", -1e15, 1e15,
                 false, "|p - C| < r", "VUW CGRA 354 (S2-25)"});
  visitor.field(
      "boxes", &obstacle.boxes,
      {"length", "lower and upper corner of each: [x, y, z, X, Y, Z]; in 2D [x, y, X, Y]", -1e15, 1e15});
  visitor.field(
      "planes", &obstacle.planes,
      {"length", "a point and a normal of each: [x, y, z, nx, ny, nz]; solid is the side behind the normal",
       -1e15, 1e15});
  visitor.items("random", {"", "spheres at random places in the space"},
                maybe(obstacle.random, visit_random_obstacles));
}

void visit_time(Time& time, FieldVisitor& visitor) {
  visitor.field("dt", &time.dt,
                {"time", "time units in a step", 0, infinity, false, "", "VUW CGRA 354 (S2-1)"});
  visitor.field("integrator", choice(time.integrator, {"semi-implicit-euler", "explicit-euler"}),
                {"", "whether the new or the old velocity moves the boid", 0, 0, false,
                 "v' = v + dt·a; p' = p + dt·v' or p + dt·v", "UCSD (S0-2), VUW CGRA 354 (S2-1)"});
}

void visit_run(Run& run, FieldVisitor& visitor) {
  visitor.field("steps", &run.steps, {"steps", "length of the run when nobody says otherwise", 0, 1e15});
  visitor.table(
      "measure", {"", "when measures are taken"},
      [&](FieldVisitor& inner) {
        inner.field("every", &run.measure_every, {"steps", "steps between two lines of measures", 1, 1e15});
        inner.field(
            "link", &run.link,
            {"length", "boids this near belong to one cluster; 0: the largest finite radius", 0, infinity});
      },
      "every");
  visitor.field("initial", &run.initial, {"", "state CSV with all boids, in place of every flock's start"});
  visitor.field("first_step", &run.first_step,
                {"steps", "number of the step at which the start state stands", 0, 1e15});
  visitor.field("resumed", &run.resumed,
                {"", "the state in initial was saved with the events of first_step already done"});
}

void visit_index(Index& index, FieldVisitor& visitor) {
  visitor.field(
      "kind", choice(index.kind, {"grid", "tree", "all-pairs"}),
      {"", "how neighbours are found; all find the same", 0, 0, false, "", "quadtree project (S3-12)"});
  visitor.field(
      "leaf_size", &index.leaf_size,
      {"boids", "tree: a node with more boids is divided", 1, 1e6, false, "", "quadtree project (S3-12)"});
  visitor.field("depth_limit", &index.depth_limit, {"", "tree: but never deeper than this", 0, 40});
  visitor.field("path", choice(index.path, {"auto", "sparse", "dense"}),
                {"", "how neighbours are summed: one by one, or those well inside a radius together"});
}

void visit_pointer(Pointer& pointer, FieldVisitor& visitor) {
  visitor.field("weight", &pointer.weight,
                {weight_about.unit, weight_about.text, weight_about.low, weight_about.high, false,
                 "unit(o) - v/|v|, unit(o)·max_speed - v and so on, by form; o the offset to it",
                 "CS 184 (S4-12), quadtree project (S3-9)"});
  visitor.field("radius", &pointer.radius,
                {"length", "who is farther from the pointer feels nothing", 0, infinity, true, "",
                 "quadtree project (S3-9)"});
  visitor.field(
      "repel_radius", &pointer.repel_radius,
      {"length", "the same while it repels; default: radius", 0, infinity, false, "", "CS 184 (S4-12)"});
  visitor.field(
      "form", form_choice(pointer.form),
      {"",
       "heading: unit(o) - heading; seek: full speed toward it - v; linear: the offset o itself; arrive: "
       "seek, slower near it; orbit: full speed toward it, v not taken off",
       0, 0, false, "", "CS 184 (S4-12), VUW CGRA 354 (S2-19, S2-20), quadtree project (S3-9)"});
  visitor.field("slowing", &pointer.slowing,
                {"length", "arrive: nearer than this the sought speed falls", 0, 1e15, false,
                 "max_speed·min(1, |o|/slowing)", "VUW CGRA 354 (S2-20)"});
  visitor.field("priority", &pointer.priority, priority_about);
}

void visit_target(TargetDef& target, FieldVisitor& visitor) {
  visitor.field("name", &target.name, {"", "what paths and messages call it"});
  visitor.field("kind", choice(target.kind, {"attract", "repel"}),
                {"", "whether boids are drawn to it or driven away", 0, 0, false, "", "CS 184 (S4-10)"});
  visitor.field(
      "form", form_choice(target.form),
      {"",
       "heading: unit(o) - heading; seek: full speed toward it - v; linear: the offset o itself; arrive: "
       "seek, slower near it; orbit: full speed toward it, v not taken off",
       0, 0, false, "", "CS 184 (S4-11), VUW CGRA 354 (S2-19, S2-20), quadtree project (S3-9)"});
  visitor.field("at", CoordinatesRef{&target.at},
                {"length", "where it is at time 0; the middle of its circle"});
  visitor.field("weight", &target.weight, {"", "how much it counts among the targets", -1e9, 1e9});
  visitor.field("radius", &target.radius,
                {"length", "who is farther feels nothing", 0, infinity, true, "", "VUW CGRA 354 (S2-20)"});
  visitor.field("slowing", &target.slowing,
                {"length", "arrive: nearer than this the sought speed falls", 0, 1e15, false,
                 "max_speed·min(1, |o|/slowing)", "VUW CGRA 354 (S2-20)"});
  visitor.field("felt_by", &target.felt_by, {"", "whose members feel it: \"all\" or a list of flocks"});
  visitor.field("motion", choice(target.motion, {"still", "line", "circle"}), {"", "how it moves"});
  visitor.field("velocity", CoordinatesRef{&target.velocity},
                {"length per time", "line: its velocity; it wraps, or bounces where the space has an edge"});
  visitor.field("circle", &target.circle, {"length", "circle: radius, in the plane of x and y", 0, 1e15});
  visitor.field("period", &target.period, {"time", "circle: for one turn; negative: clockwise", -1e15, 1e15});
}

void visit_camera(CameraDef& camera, FieldVisitor& visitor) {
  visitor.field("fit", choice(camera.fit, {"space", "flock"}),
                {"", "what the picture shows: the space, or where the boids are"});
  visitor.field("room", &camera.room,
                {"", "2D: free room around what is shown, as a share of its size", 0, 100});
  visitor.field("eye", CoordinatesRef{&camera.eye},
                {"length", "3D: where the camera stands; default: a three-quarter view"});
  visitor.field("target", CoordinatesRef{&camera.target},
                {"length", "3D: what it looks at; default: the middle"});
  visitor.field("field_of_view", &camera.field_of_view,
                {"degrees", "3D: vertical angle of the picture", 1, 170});
  visitor.field("outline", &camera.outline,
                {"", "draw the edge of the space", 0, 1, false, "", "CS 184 (S4-19)"});
  visitor.field("trail", &camera.trail, {"steps", "how long a trail lasts", 1, 100000});
}

}  // namespace

void visit(ScenarioDef& scenario, FieldVisitor& visitor) {
  visitor.field("format", &scenario.format, {"", "version of the file format", 1, 1});
  visitor.field("title", &scenario.title, {"", "a name for people"});
  visitor.field("about", &scenario.about, {"", "one sentence on what there is to see"});
  visitor.field("try", &scenario.try_this, {"", "things worth trying"});
  visitor.field("source", &scenario.source, {"", "where the rules and numbers come from"});
  visitor.field("seed", &scenario.seed, {"", "of all random streams", 0, 9007199254740992.0});
  visitor.table("space", {"", "the world"}, [&](FieldVisitor& inner) { visit_space(scenario.space, inner); });
  visitor.table("time", {"", "the time step"},
                [&](FieldVisitor& inner) { visit_time(scenario.time, inner); });
  visitor.table("run", {"", "length, measures, events"},
                [&](FieldVisitor& inner) { visit_run(scenario.run, inner); });
  visitor.table(
      "index", {"", "the neighbour index"}, [&](FieldVisitor& inner) { visit_index(scenario.index, inner); },
      "kind");
  visitor.table("pointer", {"", "the mouse, or any point moved by hand"},
                [&](FieldVisitor& inner) { visit_pointer(scenario.pointer, inner); });
  visitor.table("camera", {"", "what pictures show"},
                [&](FieldVisitor& inner) { visit_camera(scenario.camera, inner); });
  Items targets = list_of(scenario.targets, visit_target);
  targets.name = [&scenario](std::size_t i) { return scenario.targets[i].name; };
  targets.rename = [&scenario](std::size_t i, std::string name) {
    scenario.targets[i].name = std::move(name);
  };
  visitor.items("target", {"", "a place that attracts or repels"}, targets);
  Items obstacles = list_of(scenario.obstacles, visit_obstacle);
  obstacles.has_header = true;
  visitor.items("obstacle", {"", "things in the way"}, obstacles);
  Items flocks = list_of(scenario.flocks, visit_flock);
  flocks.name = [&scenario](std::size_t i) { return scenario.flocks[i].name; };
  visitor.items("flock", {"", "a kind of boid"}, flocks);
  Items food = list_of(scenario.food, visit_food);
  food.name = [&scenario](std::size_t i) { return scenario.food[i].name; };
  food.rename = [&scenario](std::size_t i, std::string name) { scenario.food[i].name = std::move(name); };
  visitor.items("food", {"", "a kind of food"}, food);
}

}  // namespace sturnus
