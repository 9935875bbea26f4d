// What a run is: plain structs with their defaults in place and a unit on every field.
//
// A definition does no work. `check` finds what is wrong with one, `Simulation::create` makes a world of
// it. Lengths are in the scenario's own length unit, times in its time unit; a step lasts `time.dt`.
// The formulas behind the terms are in docs/model.md, the documents they come from in docs/sources.md.
#pragma once

#include <sturnus/behaviours.h>
#include <sturnus/events.h>
#include <sturnus/result.h>
#include <sturnus/vocabulary.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sturnus {

/// Steer away from neighbours: combine over them of -(o/d) s(d), o the offset to the neighbour, d = |o|.
struct Separation {
  double weight = 1.0;
  double radius = 8.0;  ///< length; neighbours farther than this do not count, 0 means nobody
  double inner = 0.0;   ///< length; nor do those nearer than this
  Edge edge = Edge::open;
  Strength strength = Strength::fades;
  Combine combine = Combine::sum;
  Whose of = {Whose::Kind::all, {}};
  std::optional<double> field_of_view = {};  ///< full angle in degrees; not given: the flock's
  double sample = 1.0;        ///< share of the neighbours that are looked at, by chance, 0 to 1
  std::int64_t priority = 0;  ///< lower comes first under arbitration "budget" and "first"
  bool on = true;             ///< a switch that keeps the weight
  int order = 0;              ///< place in the file, which breaks ties of priority
};

/// Steer toward the average velocity or heading of the neighbours.
struct Alignment {
  double weight = 0.15;
  double radius = 30.0;  ///< length; infinity means the whole population
  double inner = 0.0;    ///< length
  Edge edge = Edge::open;
  Match match = Match::velocity;
  bool relative = true;     ///< average minus own; false: the average itself
  bool count_self = false;  ///< the boid is part of its own average
  Whose of = {};
  std::optional<double> field_of_view = {};  ///< full angle in degrees; not given: the flock's
  double sample = 1.0;                       ///< share, 0 to 1
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// Steer toward the neighbours: mean over them of (o/d) s(d).
struct Cohesion {
  double weight = 0.004;
  double radius = 20.0;  ///< length; infinity means the whole population (not in a wrapped space)
  double inner = 0.0;    ///< length
  Edge edge = Edge::open;
  Strength strength = Strength::grows;
  Combine combine = Combine::mean;
  bool count_self = false;  ///< divide by n + 1 instead of n
  Whose of = {};
  std::optional<double> field_of_view = {};  ///< full angle in degrees; not given: the flock's
  double sample = 1.0;                       ///< share, 0 to 1
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// Flee from other flocks in sight. heading: mean unit vector away minus own heading; seek: full speed away
/// minus own velocity; linear: mean of -o.
struct Flee {
  std::vector<std::string> from = {};  ///< names of the flocks to flee from
  double radius = 45.0;                ///< length; how far they are seen
  double weight = 0.5;
  SteeringForm form = SteeringForm::heading;
  std::optional<double> field_of_view = {};  ///< full angle in degrees; not given: the flock's
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// Accelerate toward a cruising speed along the own heading: (speed - |v|) v/|v|.
struct Cruise {
  double speed = 2.0;   ///< length per time
  double weight = 0.1;  ///< per time
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// A bounded random walk of a direction w: w <- unit(w + rate u), force weight * w.
struct Wander {
  double rate = 0.3;     ///< how far the direction strays in one step, 0 never
  double weight = 0.05;  ///< length per time squared
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// Steer around obstacles. sweep: a cylinder of the boid's radius plus the clearance is swept along its
/// heading; of all obstacles in its way the first one pushes it sideways. heading: the mean over all
/// obstacles near of unit(away) minus own heading.
struct AvoidObstacles {
  double weight = 0.5;
  double look_ahead = 40.0;  ///< sweep: length; how far ahead obstacles are seen
  double clearance = 1.0;    ///< sweep: length; room that is kept between the boid and an obstacle
  ObstacleForm form = ObstacleForm::sweep;
  double radius = 30.0;  ///< heading: length; an obstacle whose surface is farther does not count
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// Random steering: an acceleration inside the weighted sum, and a turn after the velocity update.
struct Noise {
  double acceleration = 0.0;  ///< length per time squared; each component uniform in [-this, this]
  double turn = 0.0;  ///< degrees; the heading turns by a uniform angle in [-turn/2, turn/2] each step
  std::int64_t priority = 0;  ///< of the acceleration
  bool on = true;
  int order = 0;
};

/// Hunt the boids of other flocks: steer toward those in view and eat whom the body touches. A flock that
/// hunts is one of predators.
struct Hunt {
  std::vector<std::string> prey = {};  ///< names of the flocks that are hunted
  double sight = 150.0;                ///< length; how far prey is seen
  HuntChoice choose = HuntChoice::average;
  HuntAim aim = HuntAim::heading;
  double time = 10.0;      ///< time; aim constant: how far ahead the prey is foreseen
  double factor = 0.2;     ///< time per length; aim distance: it is foreseen for this times its distance
  double confusion = 0.0;  ///< per prey in view and time; how often the focus slips to another one
  double weight = 0.1;
  std::optional<double> field_of_view = {};  ///< full angle in degrees; not given: the flock's
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// A burst of speed straight ahead when prey is near: starts at `speed` and slows down evenly to the cruising
/// speed, or to max_speed in a flock that has none. Steering, limits and noise rest meanwhile.
struct Jump {
  double speed = 9.0;           ///< length per time, above max_speed or not
  double duration = 30.0;       ///< time
  double cooldown = 180.0;      ///< time from the end of a jump until the next may begin
  double distance = 60.0;       ///< length; how near a prey must be
  double field_of_view = 50.0;  ///< full angle in degrees in which it must be
  bool on = true;
};

/// What eating does and what the lack of it does.
struct Hunger {
  double full_for = 120.0;          ///< time after a meal in which prey is ignored
  double starves_after = infinity;  ///< time without a meal after which a hunter dies; infinity: never
};

/// Be drawn to food within a radius and eat what the body touches; for every piece new boids of the own flock
/// appear beside it.
struct Feed {
  std::string on;        ///< name of the food
  double radius = 60.0;  ///< length; how far a piece is noticed
  double weight = 0.1;
  SteeringForm form = SteeringForm::heading;
  std::int64_t births = 1;          ///< boids for each piece
  std::int64_t population_cap = 0;  ///< boids of the flock beyond which none is born; 0: four times its count
  std::int64_t priority = 0;
  int order = 0;
};

/// Where boids begin, and how fast.
struct Start {
  StartRegion region = StartRegion::space;
  Coordinates min;         ///< box: its lower corner, length
  Coordinates max;         ///< box: its upper corner, length
  Coordinates centre;      ///< ball and ring: length; not given: the middle of the space
  double radius = 1.0;     ///< ball and ring: outer radius, length
  double inner = 0.0;      ///< ring: inner radius, length
  double min_speed = 1.5;  ///< length per time; speeds are uniform between the two
  double max_speed = 3.0;  ///< length per time
  Coordinates heading;     ///< direction of all; not given: every boid its own, at random
  std::string file;        ///< state CSV to take this flock's boids from instead, relative to the scenario
};

/// Three colour values that drift toward the neighbours' (ring: the first cohesion term's).
struct Colour {
  std::string start;       ///< "#rrggbb", "random", or empty for the next colour of the palette
  double averaging = 0.0;  ///< share of the way to the neighbours' mean in one step, 0 to 1
  double noise = 0.0;      ///< each value moves by a uniform amount in [-this, this] each step, 0 to 1
  Whose of = {};           ///< whose colours are averaged
};

/// A place that attracts or repels; o, the offset to it, is turned round by one that repels.
struct TargetDef {
  std::string name;  ///< what paths call it; not given: "target", "target-2", ...
  TargetKind kind = TargetKind::attract;
  SteeringForm form = SteeringForm::heading;
  Coordinates at;            ///< length; where it is at time 0, or the middle of its circle
  double weight = 0.1;       ///< of its pull in the sum over all targets
  double radius = infinity;  ///< length; who is farther feels nothing
  double slowing = 50.0;     ///< arrive: length; nearer than this the sought speed falls
  Whose felt_by = {Whose::Kind::all, {}};
  TargetMotion motion = TargetMotion::still;
  Coordinates velocity;   ///< line: length per time; it wraps or bounces with the space
  double circle = 100.0;  ///< circle: radius, length, in the plane of x and y
  double period = 600.0;  ///< circle: time for a turn; negative: clockwise
};

/// How a flock feels the targets: their sum, those of form "heading" averaged by kind.
struct TargetSense {
  double weight = 1.0;
  std::int64_t priority = 0;
  bool on = true;
  int order = 0;
};

/// A kind of boid: how many, how they start, what they feel, what limits them.
struct FlockDef {
  std::string name = "boids";
  std::int64_t count = 300;
  Start start;
  double min_speed = 1.5;          ///< length per time; a boid at rest stays at rest
  double max_speed = 3.0;          ///< length per time
  double max_acceleration = 0.25;  ///< length per time squared; the cap on the sum of all terms
  double field_of_view = 360.0;    ///< full angle in degrees; 360 sees all round
  Arbitration arbitration = Arbitration::weighted;
  std::vector<Separation> separation = {Separation{}};
  std::vector<Alignment> alignment = {Alignment{}};
  std::vector<Cohesion> cohesion = {Cohesion{}};
  std::vector<Flee> flee;
  std::optional<Cruise> cruise;
  std::optional<Wander> wander;
  std::optional<Noise> noise;
  TargetSense targets;
  std::optional<AvoidObstacles> avoid_obstacles;
  std::optional<Pursuit> pursue, evade;
  std::optional<Hide> hide;
  std::optional<FollowPath> follow_path;
  std::optional<FollowWall> follow_wall;
  std::optional<FollowFlow> flow;
  std::optional<FollowLeader> follow_leader;
  std::optional<AvoidCollisions> avoid_collisions;
  std::optional<Queue> queue;
  Colour colour;
  std::optional<GlyphStyle> glyph;  ///< how a boid is drawn; not given: dart in 2D, cone in 3D
  double size = 5.0;                ///< length of a drawn boid
  double body_radius = 0.0;         ///< length; how large a boid is to the touch
  std::optional<Hunt> hunt;
  std::optional<Jump> jump;
  std::optional<Hunger> hunger;
  std::optional<Feed> feed;
};

/// Food that appears periodically.
struct RandomFood {
  double every = 0.0;        ///< time between two appearances; 0: never
  std::int64_t count = 1;    ///< pieces each time
  std::int64_t most = 1000;  ///< pieces of the kind beyond which none appears by itself
};

/// A kind of food: pieces that lie still until somebody eats them.
struct FoodDef {
  std::string name = "food";
  std::int64_t count = 20;   ///< pieces at the start
  Coordinates at;            ///< length; where pieces appear; not given: anywhere in the space
  double radius = 0.0;       ///< length; around `at`, how far they are spread
  RandomFood random;         ///< new pieces on the way
  double body_radius = 2.0;  ///< length; how large a piece is to the touch
  double size = 4.0;         ///< length; how large it is drawn
  std::string colour;        ///< "#rrggbb", or empty for the theme's
};

/// What happens at the edge of the space.
struct Boundary {
  BoundaryKind kind = BoundaryKind::wrap;
  Coordinates margin;     ///< turn: length, one for each axis or one for all; not given: 0
  double strength = 0.0;  ///< turn: length per time squared, added for each margin a boid is in
};

struct Space {
  std::int64_t dimensions = 2;  ///< 2 or 3
  Coordinates min;              ///< length; lower corner
  Coordinates max;              ///< length; upper corner
  /// Area or volume for each boid where no corners are given: the space is a square or cube about the origin
  /// that grows with the count. Not given: a square or cube of side `usual_spacing` for each boid.
  std::optional<double> per_boid;
  static constexpr double usual_spacing = 10.0;  ///< length
  Boundary boundary;
  bool solid = false;  ///< no boid ends a step inside an obstacle
};

/// Spheres (in 2D circles) at random places wholly inside the space; where it wraps, anywhere.
struct RandomObstacles {
  std::int64_t count = 10;
  double min_radius = 5.0;   ///< length; radii are uniform between the two
  double max_radius = 20.0;  ///< length
  double keep_apart = 0.0;   ///< length; least room between a sphere and any earlier obstacle
};

/// Things in the way. Each list may hold any number; obstacles are numbered in order: spheres, boxes, planes,
/// then the random ones, table after table.
struct ObstacleDef {
  std::vector<Coordinates> spheres;  ///< centre and radius: [x, y, r] or [x, y, z, r], lengths
  std::vector<Coordinates> boxes;    ///< lower and upper corner: [x, y, X, Y] or [x, y, z, X, Y, Z], lengths
  std::vector<Coordinates> planes;   ///< a point of it, length, and a normal of any length; solid behind it
  std::optional<RandomObstacles> random;
};

enum class ObstacleKind : std::uint8_t { sphere, box, plane };

/// One obstacle as it stands in a run. In two dimensions a sphere is a circle, and a third number is 0.
struct Obstacle {
  ObstacleKind kind = ObstacleKind::sphere;
  std::array<float, 3> at{};      ///< length; sphere and box: the centre, plane: a point of it
  float radius = 0;               ///< sphere: length
  std::array<float, 3> half{};    ///< box: half of its sides, length
  std::array<float, 3> normal{};  ///< plane: unit vector out of the solid side

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

struct Time {
  double dt = 1.0;  ///< time units in a step
  Integrator integrator = Integrator::semi_implicit_euler;
};

/// How neighbours are found. Equal neighbour sets everywhere; another index may add in another order.
struct Index {
  IndexKind kind = IndexKind::grid;
  std::int64_t leaf_size = 16;    ///< tree: a node with more boids than this is divided
  std::int64_t depth_limit = 16;  ///< tree: but never deeper than this
  SumPath path = SumPath::automatic;
};

/// The mouse or any other point that a person moves: attracts or repels while pressed.
struct Pointer {
  double weight = 0.1;
  double radius = infinity;                 ///< length; who is farther feels nothing
  std::optional<double> repel_radius = {};  ///< length; the same where it repels; not given: radius
  SteeringForm form = SteeringForm::heading;
  double slowing = 50.0;  ///< arrive: length; nearer than this the sought speed falls
  std::int64_t priority = 0;
};

struct Run {
  std::int64_t steps = 1000;        ///< how long the run is when nobody says
  std::int64_t measure_every = 10;  ///< steps between two lines of measures
  double link = 0.0;    ///< length; neighbours this near are one cluster; 0: the largest finite radius
  std::string initial;  ///< state CSV with all boids, instead of every flock's start
  std::int64_t first_step = 0;  ///< number of the step that the start state stands at
  bool resumed = false;         ///< `initial` was saved at first_step with that step's events done
  std::vector<Event> events;    ///< in order of their steps
};

struct CameraDef {
  CameraFit fit = CameraFit::space;
  double room = 0.0;            ///< 2D: free room around what is shown, as a share of its size
  Coordinates eye;              ///< length; not given: a three-quarter view that fits
  Coordinates target;           ///< length; not given: the middle of what is fitted
  double field_of_view = 35.0;  ///< degrees, vertical
  bool outline = true;          ///< draw the edge of the space
  std::int64_t trail = 40;      ///< steps that a trail lasts
};

/// A whole run. `title`, `about`, `try_this` and `source` are for people.
struct ScenarioDef {
  std::string name;  ///< file name without ending; not a key of the file
  std::string file;  ///< where it was read, for messages and relative paths; not a key of the file
  std::int64_t format = 1;
  std::string title;
  std::string about;
  std::vector<std::string> try_this;
  std::string source;
  std::int64_t seed = 1;  ///< of all random streams
  Space space;
  Time time;
  Run run;
  Index index;
  Pointer pointer;
  CameraDef camera;
  std::vector<TargetDef> targets;
  std::vector<ObstacleDef> obstacles;
  std::vector<FlockDef> flocks = {FlockDef{}};
  std::vector<FoodDef> food;

  std::int64_t boid_count() const {
    std::int64_t sum = 0;
    for (const FlockDef& flock : flocks) sum += flock.count;
    return sum;
  }
};

/// Everything that is wrong with a scenario, each with its key; warnings are marked as such.
Problems check(const ScenarioDef& scenario);

/// Corners of the space after `per_boid` is worked out; `dimensions` components each.
struct Extent {
  Coordinates min, max;
};
Extent extent_of(const ScenarioDef& scenario);

/// One shipped scenario.
struct ShippedScenario {
  const char* name;   ///< unique, e.g. "ucsd"
  const char* group;  ///< "courses", "gallery", "bench"
  const char* text;   ///< the TOML file
};

/// All shipped scenarios in order of group and name.
const std::vector<ShippedScenario>& shipped_scenarios();

/// Reads TOML text; `file` is used in messages. The result has passed `check`. Warnings and problems found
/// are appended to `problems` when given.
Result<ScenarioDef> parse_scenario(const std::string& text, const std::string& file,
                                   Problems* problems = nullptr);

/// The effective scenario with all defaults, as TOML that loads again to the same definition.
std::string to_toml(const ScenarioDef& scenario);

}  // namespace sturnus
