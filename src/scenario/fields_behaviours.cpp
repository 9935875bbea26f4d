// The list of parameters: Reynolds' steering behaviours.
#include "scenario/behaviours.h"

namespace sturnus {
namespace {

constexpr const char* paper = "Reynolds 1999";
constexpr const char* vuw = "VUW CGRA 354 (S2-22, S2-23)";

void visit_behaviour(Behaviour& term, FieldVisitor& visitor) {
  visitor.field("weight", &term.weight, {"per time", weight_about.text, -1e9, 1e9, false, "", paper});
  visitor.field("priority", &term.priority, priority_about);
  visitor.field("on", &term.on, on_about);
}

void visit_prediction(Pursuit& term, const char* formula, FieldVisitor& visitor) {
  visitor.field("of", &term.of,
                {"", "names of the flocks whose nearest member is meant", 0, 0, false, "", paper});
  visitor.field("prediction", choice(term.prediction, {"constant", "distance", "intercept"}),
                {"", "how far ahead: a fixed time, one that grows with the distance, or until they can meet",
                 0, 0, false, formula, vuw});
  visitor.field("time", &term.time, {"time", "constant: so far ahead", 0, 1e15, false, "T", vuw});
  visitor.field("per_length", &term.per_length,
                {"time per length", "distance, and intercept where they can't meet: T over the distance", 0,
                 1e15, false, "T = c·|o|", vuw});
  visitor.field(
      "radius", &term.radius,
      {"length", "who is farther is not seen", 0, infinity, true, "d < radius", "VUW CGRA 354 (S2-20)"});
}

void visit_pursue(Pursuit& term, FieldVisitor& visitor) {
  visit_prediction(term, "unit(o + v·T)·max_speed - own v", visitor);
  visitor.field(
      "offset", CoordinatesRef{&term.offset},
      {"length", "arrive at this place: ahead, left and up of the quarry", -1e15, 1e15, false, "", paper});
  visitor.field("slowing", &term.slowing,
                {"length", "of an offset: the wished speed falls within this distance", 0, 1e15, false,
                 "max_speed·min(1, d/slowing)", paper});
  visit_behaviour(term, visitor);
}

void visit_evade(Pursuit& term, FieldVisitor& visitor) {
  visit_prediction(term, "-unit(o + v·T)·max_speed - own v", visitor);
  visit_behaviour(term, visitor);
}

void visit_hide(Hide& term, FieldVisitor& visitor) {
  visitor.field("from", &term.from,
                {"", "names of the flocks whose nearest member is hidden from", 0, 0, false, "", paper});
  visitor.field("radius", &term.radius,
                {"length", "who is farther is not seen", 0, infinity, true, "", paper});
  visitor.field("reach", &term.reach,
                {"length", "an obstacle whose surface is farther is not sought", 0, 1e15, false, "", paper});
  visitor.field("margin", &term.margin,
                {"length", "from the obstacle's surface to the place behind it", 0, 1e15, false,
                 "c + unit(c - o)·(r + margin)", paper});
  visitor.field("slowing", &term.slowing,
                {"length", "the wished speed falls within this distance of the place", 0, 1e15, false,
                 "max_speed·min(1, d/slowing)", paper});
  visitor.field("time", &term.time,
                {"time", "where nothing hides: the place that is fled lies so far ahead of the hunter", 0,
                 1e15, false, "-unit(o + v·time)·max_speed - own v", paper});
  visit_behaviour(term, visitor);
}

void visit_line(std::vector<Coordinates>& points, bool& loop, const char* which, FieldVisitor& visitor) {
  visitor.field("points", &points, {"length", which, -1e15, 1e15, false, "", paper});
  visitor.field("loop", &loop, {"", "the last corner is joined to the first"});
}

void visit_way(double& radius, double& ahead, double& time, const char* room, FieldVisitor& visitor) {
  visitor.field("radius", &radius, {"length", room, 0, 1e15, false, "", paper});
  visitor.field(
      "ahead", &ahead,
      {"length", "how far beyond the nearest point the one lies that is sought", 0, 1e15, false, "", paper});
  visitor.field("time", &time,
                {"time", "the place that must be right lies so far ahead", 0, 1e15, false, "p + v·T", paper});
}

void visit_path(FollowPath& term, FieldVisitor& visitor) {
  visit_line(term.points, term.loop, "corners of the path in order", visitor);
  visit_way(term.radius, term.ahead, term.time, "half of the path's width, within which nothing is done",
            visitor);
  visit_behaviour(term, visitor);
}

void visit_wall(FollowWall& term, FieldVisitor& visitor) {
  visit_line(term.points, term.loop, "corners of the wall in order, [x, y] each; in 3D it stands upright",
             visitor);
  visitor.field("distance", &term.distance, {"length", "how far from the wall", 0, 1e15, false, "", paper});
  visit_way(term.radius, term.ahead, term.time, "how far off that distance nothing is done", visitor);
  visit_behaviour(term, visitor);
}

void visit_flow(FollowFlow& term, FieldVisitor& visitor) {
  visitor.field("kind", choice(term.kind, {"vortex", "shear", "uniform"}),
                {"", "a whirl about an upright axis, layers that slide along x, or one velocity everywhere",
                 0, 0, false, "flow(p + v·T) - v", paper});
  visitor.field("centre", CoordinatesRef{&term.centre},
                {"length", "of the vortex, or where a shear stands still; default: the origin", -1e15, 1e15});
  visitor.field("speed", &term.speed,
                {"length per time", "vortex: at the edge of its core; less within and beyond", -1e9, 1e9,
                 false, "speed·r/core, speed·core/r", "Rankine"});
  visitor.field("core", &term.core, {"length", "vortex: radius of the fastest ring", 0, 1e15});
  visitor.field(
      "rate", &term.rate,
      {"per time", "shear: velocity along x for each length of y", -1e9, 1e9, false, "rate·(y - centre)"});
  visitor.field("velocity", CoordinatesRef{&term.velocity},
                {"length per time", "uniform: the velocity; default: 0", -1e9, 1e9});
  visitor.field("time", &term.time,
                {"time", "the field is looked up so far ahead", 0, 1e15, false, "p + v·T", paper});
  visit_behaviour(term, visitor);
}

void visit_leader(FollowLeader& term, FieldVisitor& visitor) {
  visitor.field("leader", &term.leader,
                {"", "name of the flock whose nearest member leads", 0, 0, false, "", paper});
  visitor.field("distance", &term.distance,
                {"length", "how far behind the leader, and how far ahead its way is kept free", 0, 1e15,
                 false, "", paper});
  visitor.field("clearance", &term.clearance,
                {"length", "half of the width of the leader's way", 0, 1e15, false, "", paper});
  visitor.field("slowing", &term.slowing,
                {"length", "the wished speed falls within this distance of the place", 0, 1e15, false,
                 "max_speed·min(1, d/slowing)", paper});
  visit_behaviour(term, visitor);
}

void visit_avoidance(AvoidCollisions& term, FieldVisitor& visitor) {
  visitor.field("radius", &term.radius,
                {"length", "who is farther now does not count", 0, 1e15, false, "d < radius", paper});
  visitor.field("gap", &term.gap,
                {"length", "nearer than this at the nearest approach is too near", 0, 1e15, false,
                 "|o + w·T| < gap", paper});
  visitor.field(
      "time", &term.time,
      {"time", "a nearest approach later than this does not count", 0, 1e15, false, "T = -o·w/w·w", paper});
  visit_behaviour(term, visitor);
}

void visit_queue(Queue& term, FieldVisitor& visitor) {
  visitor.field("distance", &term.distance,
                {"length", "who is farther is not waited for", 0, 1e15, false, "-v·(1 - d/distance)", paper});
  visitor.field("angle", &term.angle,
                {"degrees", "full angle of the cone ahead", 0, 360, false, "v·o >= cos(half)·|v|·d", paper});
  visit_behaviour(term, visitor);
}

}  // namespace

void visit_behaviours(FlockDef& flock, FieldVisitor& visitor) {
  visitor.items("pursue", {"", "seek where another will be"}, maybe(flock.pursue, visit_pursue));
  visitor.items("evade", {"", "flee where another will be"}, maybe(flock.evade, visit_evade));
  visitor.items("hide", {"", "go behind an obstacle, out of a hunter's sight"},
                maybe(flock.hide, visit_hide));
  visitor.items("follow_path", {"", "stay near a line and go along it"},
                maybe(flock.follow_path, visit_path));
  visitor.items("follow_wall", {"", "go along a wall at a distance"}, maybe(flock.follow_wall, visit_wall));
  visitor.items("flow", {"", "take the velocity of a field"}, maybe(flock.flow, visit_flow));
  visitor.items("follow_leader", {"", "arrive behind a leader and keep out of its way"},
                maybe(flock.follow_leader, visit_leader));
  visitor.items("avoid_collisions", {"", "step aside from whoever will come too near"},
                maybe(flock.avoid_collisions, visit_avoidance));
  visitor.items("queue", {"", "brake for whoever is ahead"}, maybe(flock.queue, visit_queue));
}

}  // namespace sturnus
