// Scenarios with everything switched on: what has to keep its bits when rules meet.
#pragma once

#include "support.h"

namespace sturnus::test {

inline constexpr const char* everything = R"toml(
format = 1
title = "Everything at once"
seed = 99

[space]
dimensions = 2
min = [0, 0]
max = [400, 300]
boundary = "wrap"
solid = true

[time]
dt = 0.8

[run]
steps = 100
events = [
  [2, "pointer", "attract", [100, 100]],
  [3, "set", "flock.fish.cohesion.0.weight", 1.5],
  [4, "add", "fish", 10, [200, 150], 20],
  [5, "food", "plankton", 5, [100, 200], 30],
  [5, "target", "repel", [350, 250], "heading", 0.2, 80],
  [6, "scatter", [120, 150], 40],
  [6, "pointer", "repel", [300, 100]],
  [7, "move", 3, [50, 50], [1, 0]],
  [8, "obstacle", [250, 60], 8],
  [8, "erase", [380, 20], 15],
  [9, "pointer", "off", [0, 0]],
]

[pointer]
weight = 0.3
radius = 120

[[obstacle]]
spheres = [[80, 80, 14], [300, 220, 20]]
boxes = [[180, 40, 220, 60]]
random = { count = 3, radius = [4, 8], keep_apart = 6 }

[[target]]
name = "lamp"
at = [200, 150]
form = "seek"
weight = 0.05
radius = 90
motion = "circle"
circle = 60
period = 200

[[target]]
name = "harbour"
at = [60, 240]
form = "arrive"
weight = 0.05
radius = 100
felt_by = ["fish"]

[[food]]
name = "plankton"
count = 12
random = { every = 4, count = 2 }

[[flock]]
name = "fish"
count = 160
body_radius = 2
start = { region = "space", speed = [1, 2] }
min_speed = 0.3
max_speed = 3
max_acceleration = 0.4
field_of_view = 300
separation = [{ weight = 1.5, ring = [0, 12], strength = "1/d", combine = "mean" }, { weight = 0.5, radius = 20, of = ["sharks"] }]
alignment = { weight = 0.1, ring = [4, 28], match = "heading", relative = false, count_self = true }
cohesion = [{ weight = 1, ring = [12, 50], strength = "1/d" }, { weight = 0.001, radius = 70, sample = 0.5 }]
cruise = { speed = 2, weight = 0.1 }
wander = { rate = 0.3, weight = 0.05 }
noise = { acceleration = 0.03, turn = 4 }
flee = [{ from = ["sharks"], radius = 40, weight = 0.3, form = "heading" }, { from = ["hawks"], radius = 30, weight = 0.2 }]
feed = { on = "plankton", radius = 50, weight = 0.1, form = "heading", births = 1, population_cap = 200 }
flow = { kind = "vortex", centre = [200, 150], speed = 2, core = 60, weight = 0.02 }
avoid_collisions = { radius = 30, gap = 5, time = 12, weight = 0.05 }
avoid_obstacles = { form = "heading", radius = 20, weight = 0.3 }
colour = { start = "random", averaging = 0.05, noise = 0.03 }

[[flock]]
name = "sharks"
count = 6
body_radius = 6
start = { region = "space", speed = [1, 2] }
min_speed = 0
max_speed = 6
max_acceleration = 0.3
arbitration = "budget"
separation = { weight = 2, radius = 40, strength = "1/d", combine = "sum", of = "own" }
alignment = { on = false }
cohesion = { on = false }
noise = { acceleration = 0.04 }
cruise = { speed = 1.2, weight = 0.1 }
hunt = { prey = ["fish", "followers"], sight = 90, choose = "average", aim = "heading", weight = 0.2 }
jump = { speed = 7, duration = 8, cooldown = 20, distance = 40, field_of_view = 60 }
hunger = { full_for = 6, starves_after = 30 }
avoid_obstacles = { look_ahead = 30, clearance = 2, weight = 0.4, priority = -1 }

[[flock]]
name = "hawks"
count = 3
body_radius = 4
start = { region = "ball", centre = [300, 80], radius = 30, speed = [1, 2] }
min_speed = 0.5
max_speed = 3.5
max_acceleration = 0.3
arbitration = "first"
separation = { weight = 1, radius = 20, priority = 1 }
hunt = { prey = ["fish"], sight = 120, choose = "nearest", aim = "intercept", confusion = 0.004, field_of_view = 300, weight = 0.3 }
wander = { rate = 0.5, weight = 0.1, priority = 2 }

[[flock]]
name = "leader"
count = 1
start = { region = "ball", centre = [100, 150], radius = 1, speed = [1.5, 1.5] }
min_speed = 1
max_speed = 2
max_acceleration = 0.2
separation = { on = false }
alignment = { on = false }
cohesion = { on = false }
follow_path = { points = [[60, 60], [340, 80], [300, 240], [80, 220]], loop = true, radius = 5, weight = 0.2 }

[[flock]]
name = "followers"
count = 24
body_radius = 1.5
start = { region = "space", speed = [0.5, 1] }
min_speed = 0
max_speed = 2.5
max_acceleration = 0.3
separation = { weight = 2, radius = 14 }
follow_leader = { leader = "leader", distance = 25, clearance = 15, weight = 0.1 }
queue = { distance = 12, weight = 0.2 }
hide = { from = ["sharks", "hawks"], radius = 60, reach = 70, margin = 6, weight = 0.2 }
evade = { of = ["hawks"], radius = 50, weight = 0.2 }

[[flock]]
name = "wings"
like = "leader"
count = 8
follow_path = { on = false, points = [[60, 60], [340, 80]] }
follow_wall = { points = [[20, 20], [380, 40], [360, 280], [40, 260]], loop = true, distance = 15, weight = 0.1 }
pursue = { of = ["leader"], prediction = "distance", radius = 150, offset = [-20, 12], weight = 0.1 }
)toml";

/// The same in space, with hunters and targets of the other kinds.
inline constexpr const char* everything_in_space = R"toml(
format = 1
title = "Everything at once, in space"
seed = 98

[space]
dimensions = 3
min = [0, 0, 0]
max = [150, 150, 150]
boundary = "wrap"
solid = true

[run]
steps = 100
events = [
  [2, "pointer", "attract", [100, 100, 20]],
  [4, "add", "fish", 10, [75, 75, 75], 20],
  [5, "food", "plankton", 5, [40, 90, 60], 20],
  [6, "scatter", [75, 75, 75], 30],
  [7, "move", 3, [50, 50, 50], [1, 0, 0]],
  [8, "obstacle", [20, 120, 30], 8],
]

[pointer]
weight = 0.3
radius = 60

[[obstacle]]
spheres = [[40, 40, 40, 12], [100, 110, 90, 15]]
boxes = [[80, 10, 20, 100, 30, 60]]
random = { count = 40, radius = [2, 5], keep_apart = 2 }

[[target]]
name = "lamp"
at = [75, 75, 75]
form = "orbit"
weight = 0.05
radius = 60
motion = "circle"
circle = 30
period = 100

[[target]]
name = "buoy"
at = [20, 20, 100]
form = "linear"
weight = 0.002
radius = 50
motion = "line"
velocity = [1, 0.5, -0.3]

[[food]]
name = "plankton"
count = 40
body_radius = 4
random = { every = 2, count = 3 }

[[flock]]
name = "fish"
count = 150
body_radius = 2
start = { region = "space", speed = [1, 2] }
min_speed = 0.3
max_speed = 3
max_acceleration = 0.4
field_of_view = 300
separation = { weight = 1.5, ring = [0, 12], strength = "1/d", combine = "mean" }
alignment = { weight = 0.1, ring = [4, 24], match = "heading", relative = false, count_self = true }
cohesion = [{ weight = 1, ring = [10, 30], strength = "1/d" }, { weight = 0.001, radius = 35, sample = 0.5 }]
cruise = { speed = 2, weight = 0.1 }
wander = { rate = 0.3, weight = 0.05 }
noise = { acceleration = 0.03 }
flee = { from = ["sharks"], radius = 30, weight = 0.3 }
feed = { on = "plankton", radius = 30, weight = 0.1, births = 1, population_cap = 200 }
avoid_collisions = { radius = 20, gap = 5, time = 12, weight = 0.05 }
avoid_obstacles = { form = "heading", radius = 15, weight = 0.3 }
colour = { start = "random", averaging = 0.05, noise = 0.03 }

[[flock]]
name = "sharks"
count = 8
body_radius = 6
start = { region = "space", speed = [1, 2] }
min_speed = 0
max_speed = 6
max_acceleration = 0.3
arbitration = "budget"
separation = { weight = 2, radius = 30, strength = "1/d", combine = "sum", of = "own" }
alignment = { on = false }
cohesion = { on = false }
cruise = { speed = 1.2, weight = 0.1 }
hunt = { prey = ["fish", "followers"], sight = 45, choose = "nearest", aim = "distance", factor = 0.1, confusion = 0.01, weight = 0.2 }
jump = { speed = 7, duration = 8, cooldown = 20, distance = 30, field_of_view = 60 }
hunger = { full_for = 6, starves_after = 40 }
avoid_obstacles = { look_ahead = 30, clearance = 2, weight = 0.4, priority = -1 }

[[flock]]
name = "hawks"
count = 3
body_radius = 4
start = { region = "space", speed = [1, 2] }
min_speed = 0.5
max_speed = 3.5
max_acceleration = 0.3
arbitration = "first"
separation = { weight = 1, radius = 20, priority = 1 }
hunt = { prey = ["fish"], sight = 45, aim = "constant", time = 5, weight = 0.3 }

[[flock]]
name = "leader"
count = 1
start = { region = "space", speed = [1.5, 1.5] }
min_speed = 1
max_speed = 2
max_acceleration = 0.2
separation = { on = false }
alignment = { on = false }
cohesion = { on = false }
follow_path = { points = [[20, 20, 20], [130, 30, 40], [110, 120, 100]], loop = true, radius = 5, weight = 0.2 }

[[flock]]
name = "followers"
count = 24
body_radius = 1.5
start = { region = "space", speed = [0.5, 1] }
min_speed = 0
max_speed = 2.5
max_acceleration = 0.3
separation = { weight = 2, radius = 14 }
cohesion = { weight = 0.01, ring = [10, 45], strength = "d" }
follow_leader = { leader = "leader", distance = 25, clearance = 15, weight = 0.1 }
queue = { distance = 12, weight = 0.2 }
hide = { from = ["sharks", "hawks"], radius = 40, reach = 45, margin = 6, weight = 0.2 }
evade = { of = ["hawks"], radius = 40, weight = 0.2 }
)toml";

/// Everything in the plane with another edge, a plane, and hunters and targets of other kinds.
inline ScenarioDef everything_between(BoundaryKind boundary, HuntAim sharks, HuntAim hawks) {
  ScenarioDef scenario = take(parse_scenario(everything, "everything"));
  scenario.space.boundary = {boundary, {40}, 0.5};
  scenario.obstacles.front().planes = {{0, 12, 0.1, 1}};
  scenario.flocks[1].hunt->aim = sharks;
  scenario.flocks[2].hunt->aim = hawks;
  scenario.targets[0].form = SteeringForm::linear;
  scenario.targets[0].weight = 0.002;
  scenario.targets[0].motion = TargetMotion::line;
  scenario.targets[0].velocity = {1.5, -0.7};
  scenario.targets[1].form = SteeringForm::orbit;
  return scenario;
}

/// All of them, with their names.
inline std::vector<std::pair<const char*, ScenarioDef>> everything_everywhere() {
  return {{"wrap", take(parse_scenario(everything, "everything"))},
          {"turn", everything_between(BoundaryKind::turn, HuntAim::seek, HuntAim::constant)},
          {"bounce", everything_between(BoundaryKind::bounce, HuntAim::constant, HuntAim::distance)},
          {"open", everything_between(BoundaryKind::open, HuntAim::distance, HuntAim::seek)},
          {"space", take(parse_scenario(everything_in_space, "everything in space"))}};
}

}  // namespace sturnus::test
