// The parameters of hunters, their prey and their food.
#include "scenario/field_parts.h"

namespace sturnus {

void visit_hunt(Hunt& hunt, FieldVisitor& visitor) {
  visitor.field("prey", &hunt.prey,
                {"", "names of the flocks that are hunted", 0, 0, false, "", "CS 184 (S4-13)"});
  visitor.field("sight", &hunt.sight,
                {"length", "how far prey is seen", 0, infinity, false, "", "CS 184 (S4-13)"});
  visitor.field("choose", choice(hunt.choose, {"average", "nearest"}),
                {"",
                 "average: all prey in view together; nearest: one in focus, kept until another is less "
                 "than half as far",
                 0, 0, false, "", "CS 184 (S4-13), VUW CGRA 354 (S2-21)"});
  visitor.field("aim", choice(hunt.aim, {"heading", "seek", "constant", "distance", "intercept"}),
                {"",
                 "heading: turn toward it; seek: full speed toward it; the others: full speed toward where "
                 "it will be after a constant time, a time that grows with the distance, or the time that "
                 "catching it takes",
                 0, 0, false, "x + v·T: T constant, T = c·d, |x + vT - p| = s·T",
                 "CS 184 (S4-13), VUW CGRA 354 (S2-22, S2-23)"});
  visitor.field("time", &hunt.time,
                {"time", "aim constant: how far ahead prey is foreseen", 0, infinity, false, "x + v·T",
                 "VUW CGRA 354 (S2-22)"});
  visitor.field("factor", &hunt.factor,
                {"time per length",
                 "aim distance, and intercept where nothing can be caught: times the distance, how far ahead",
                 0, infinity, false, "T = c·d", "VUW CGRA 354 (S2-22)"});
  visitor.field("confusion", &hunt.confusion,
                {"per time", "choose nearest: how often, for each prey in view, the focus slips to another",
                 0, infinity, false, "probability min(1, confusion·n·dt) in a step", "VUW CGRA 354 (S2-21)"});
  visitor.field("weight", &hunt.weight, weight_about);
  visitor.field("field_of_view", &hunt.field_of_view, field_of_view_about);
  visitor.field("priority", &hunt.priority, priority_about);
  visitor.field("on", &hunt.on, on_about);
}

void visit_jump(Jump& jump, FieldVisitor& visitor) {
  visitor.field(
      "speed", &jump.speed,
      {"length per time", "speed at the start of a jump; slows evenly to the cruising or largest speed", 0,
       1e15, false, "end + (speed - end)·left/duration", "CS 184 (S4-16)"});
  visitor.field("duration", &jump.duration,
                {"time", "how long a jump lasts", 0, infinity, false, "", "CS 184 (S4-16)"});
  visitor.field(
      "cooldown", &jump.cooldown,
      {"time", "from the end of a jump until the next may begin", 0, infinity, false, "", "CS 184 (S4-16)"});
  visitor.field("distance", &jump.distance,
                {"length", "how near a prey must be", 0, infinity, false, "", "CS 184 (S4-16)"});
  visitor.field("field_of_view", &jump.field_of_view,
                {"degrees", "full angle around the heading in which it must be", 0, 360, false,
                 "v·o >= cos(half)·|v|·d", "CS 184 (S4-16)"});
  visitor.field("on", &jump.on, {"", "a switch that keeps the numbers", 0, 1, false, "", "CS 184 (S4-18)"});
}

void visit_hunger(Hunger& hunger, FieldVisitor& visitor) {
  visitor.field("full_for", &hunger.full_for,
                {"time", "how long after a meal prey is ignored", 0, infinity, false, "", "CS 184 (S4-14)"});
  visitor.field("starves_after", &hunger.starves_after,
                {"time", "without a meal for so long a hunter dies; inf: never", 0, infinity, true, "",
                 "CS 184 (S4-15)"});
}

void visit_feed(Feed& feed, FieldVisitor& visitor) {
  visitor.field("on", &feed.on, {"", "name of the food", 0, 0, false, "", "CS 184 (S4-23)"});
  visitor.field("radius", &feed.radius,
                {"length", "how far a piece is noticed", 0, infinity, false, "", "CS 184 (S4-23)"});
  visitor.field("weight", &feed.weight, weight_about);
  visitor.field("form", form_choice(feed.form),
                {"",
                 "heading: unit(toward) - heading; seek: full speed toward it - v; linear: the offset "
                 "itself; orbit: full speed toward it",
                 0, 0, false, "", "CS 184 (S4-11, S4-23)"});
  visitor.field("births", &feed.births,
                {"boids", "how many are born of one piece", 0, 1000, false, "", "CS 184 (S4-23)"});
  visitor.field("population_cap", &feed.population_cap,
                {"boids", "none is born beyond so many in the flock; 0: four times its count", 0, 1e9, false,
                 "", "CS 184 (S4-23)"});
  visitor.field("priority", &feed.priority, priority_about);
}

void visit_food(FoodDef& food, FieldVisitor& visitor) {
  visitor.field("name", &food.name, {"", "what feed, events and messages call it"});
  visitor.field("count", &food.count,
                {"pieces", "how many there are at the start", 0, 1e6, false, "", "CS 184 (S4-23)"});
  visitor.field("at", CoordinatesRef{&food.at},
                {"length", "around which place pieces appear; default: anywhere in the space"});
  visitor.field("radius", &food.radius, {"length", "how far they are spread around it", 0, 1e15});
  visitor.table("random", {"", "pieces that appear on the way"}, [&](FieldVisitor& inner) {
    inner.field("every", &food.random.every,
                {"time", "between two appearances; 0: never", 0, infinity, false, "", "CS 184 (S4-22)"});
    inner.field("count", &food.random.count,
                {"pieces", "how many each time", 0, 1e6, false, "", "CS 184 (S4-22)"});
    inner.field("most", &food.random.most,
                {"pieces", "none appears by itself where so many of the kind lie", 0, 1e6});
  });
  visitor.field("body_radius", &food.body_radius,
                {"length", "how large a piece is to the touch", 0, infinity, false, "", "CS 184 (S4-23)"});
  visitor.field("size", &food.size, {"length", "how large it is drawn", 0, infinity});
  visitor.field("colour", &food.colour, {"", "\"#rrggbb\", or empty for the theme's"});
}

}  // namespace sturnus
