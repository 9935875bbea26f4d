// What each scenario of Reynolds' steering behaviours is there to show, stated as a law of its run.
#include <gtest/gtest.h>
#include <sturnus/steering.h>

#include <algorithm>

#include "support.h"

namespace sturnus::test {
namespace {

ScenarioDef shipped(const std::string& name) {
  for (const ShippedScenario& scenario : shipped_scenarios()) {
    if (name == scenario.name) return take(parse_scenario(scenario.text, name));
  }
  throw std::runtime_error("no scenario " + name);
}

std::vector<std::size_t> members(const Simulation& simulation, const std::string& flock) {
  std::vector<std::size_t> slots;
  const View view = simulation.view();
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (view.scenario().flocks[static_cast<std::size_t>(view.flock(i))].name == flock) slots.push_back(i);
  }
  return slots;
}

// By the nearest image where the space wraps.
Point offset_of(const Simulation& simulation, std::size_t from, std::size_t to) {
  const View view = simulation.view();
  Point o{};
  const Extent extent = extent_of(view.scenario());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double size = extent.max[axis] - extent.min[axis];
    double d = double{view.position(to)[axis]} - double{view.position(from)[axis]};
    if (view.scenario().space.boundary.kind == BoundaryKind::wrap) d -= size * std::round(d / size);
    o[axis] = static_cast<float>(d);
  }
  return o;
}

double gap_of(const Simulation& simulation, std::size_t a, std::size_t b) {
  return length_of(offset_of(simulation, a, b));
}

// Steps until a pursuer has been within 12 of the quarry; 10000 where it never is.
int steps_to_catch(const std::string& pursuer) {
  Simulation simulation = start(shipped("steer-pursuit"));
  for (int step = 0; step < 900; ++step) {
    if (gap_of(simulation, members(simulation, pursuer)[0], members(simulation, "quarry")[0]) < 12)
      return step;
    simulation.step();
  }
  return 10000;
}

TEST(SteeringScenarios, EveryPursuerCatchesAndInterceptionIsNotTheLast) {
  const int constant = steps_to_catch("constant"), distance = steps_to_catch("distance");
  const int intercept = steps_to_catch("intercept");
  EXPECT_LT(std::max({constant, distance, intercept}), 900);
  EXPECT_LE(intercept, std::max(constant, distance));
}

double nearest_hunter(bool evades) {
  ScenarioDef scenario = shipped("steer-evasion");
  scenario.flocks[0].evade->on = evades;
  Simulation simulation = start(scenario);
  double sum = 0;
  for (int step = 0; step < 600; ++step) {
    simulation.step();
    double least = 1e9;
    for (const std::size_t hunter : members(simulation, "hunters")) {
      for (const std::size_t prey : members(simulation, "crowd"))
        least = std::min(least, gap_of(simulation, hunter, prey));
    }
    sum += least;
  }
  return sum / 600;
}

TEST(SteeringScenarios, WhoEvadesKeepsItsHuntersFartherOff) {
  EXPECT_GT(nearest_hunter(true), 2 * nearest_hunter(false));
}

TEST(SteeringScenarios, EveryWingFliesInItsPlaceOfTheWedge) {
  Simulation simulation = start(shipped("steer-offset"));
  simulation.run(400);
  double sum = 0;
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    const std::size_t leader = members(simulation, "leader")[0];
    for (const FlockDef& flock : simulation.view().scenario().flocks) {
      if (flock.name == "leader") continue;
      const std::vector<double>& place = flock.pursue->offset;
      const Vector wanted = in_world({static_cast<float>(place[0]), static_cast<float>(place[1]), 0},
                                     simulation.view().velocity(leader));
      sum += distance(offset_of(simulation, leader, members(simulation, flock.name)[0]), wanted);
    }
  }
  EXPECT_LT(sum / (400 * 6), 12);  // where the places are 47 apart
}

// How far boids are from a closed line on average, and the farthest, over steps 400 to 800.
std::pair<double, double> off_line(const ScenarioDef& scenario, const std::vector<Coordinates>& points) {
  std::vector<Vector> corners;
  for (const Coordinates& point : points)
    corners.push_back({static_cast<float>(point[0]), static_cast<float>(point[1]), 0});
  Simulation simulation = start(scenario);
  simulation.run(400);
  double sum = 0, most = 0;
  int count = 0;
  for (int step = 0; step < 400; ++step) {
    simulation.step();
    for (std::size_t i = 0; i < simulation.view().size(); ++i) {
      const double off = double{nearest_on({corners, true}, simulation.view().position(i)).distance};
      sum += off;
      most = std::max(most, off);
      ++count;
    }
  }
  return {sum / count, most};
}

TEST(SteeringScenarios, WalkersStayOnTheRoadOnceTheyAreThere) {
  const ScenarioDef scenario = shipped("steer-path");
  const FollowPath& path = *scenario.flocks[0].follow_path;
  const auto [mean, most] = off_line(scenario, path.points);
  EXPECT_LT(mean, path.radius);
  EXPECT_LT(most, 2.5 * path.radius);
}

TEST(SteeringScenarios, WallFollowersKeepTheirDistance) {
  const ScenarioDef scenario = shipped("steer-wall");
  const FollowWall& wall = *scenario.flocks[0].follow_wall;
  const auto [mean, most] = off_line(scenario, wall.points);
  EXPECT_NEAR(mean, wall.distance, 8);
  EXPECT_LT(most, 2.5 * wall.distance);
}

TEST(SteeringScenarios, LeavesTakeTheVelocityOfTheWhirl) {
  const ScenarioDef scenario = shipped("steer-flow");
  const FollowFlow& flow = *scenario.flocks[0].flow;
  Simulation simulation = start(scenario);
  simulation.run(300);
  double difference = 0, speed = 0;
  for (std::size_t i = 0; i < simulation.view().size(); ++i) {
    const Point at = simulation.view().position(i);
    const Vector field =
        vortex({at[0] - 480, at[1] - 270, 0}, static_cast<float>(flow.speed), static_cast<float>(flow.core));
    difference += distance(field, simulation.view().velocity(i));
    speed += length_of(field);
  }
  EXPECT_LT(difference, 0.3 * speed);
}

TEST(SteeringScenarios, FollowersAreBehindTheLeaderAndOutOfItsWay) {
  const ScenarioDef scenario = shipped("steer-leader");
  const FollowLeader& rule = *scenario.flocks[1].follow_leader;
  Simulation simulation = start(scenario);
  simulation.run(500);
  double behind = 0, in_the_way = 0, gap = 0;
  int count = 0;
  for (int step = 0; step < 900; ++step) {
    simulation.step();
    const std::size_t leader = members(simulation, "leader")[0];
    const Vector ahead = heading(simulation.view().velocity(leader));
    for (const std::size_t follower : members(simulation, "followers")) {
      const Point o = offset_of(simulation, leader, follower);
      const double lead = double{o[0]} * double{ahead[0]} + double{o[1]} * double{ahead[1]};
      const double across = std::abs(double{o[0]} * double{ahead[1]} - double{o[1]} * double{ahead[0]});
      behind += lead < 0;
      in_the_way += lead > 0 && lead < rule.distance && across < rule.clearance;
      gap += length_of(o);
      ++count;
    }
  }
  EXPECT_GT(behind / count, 0.8);
  EXPECT_LT(in_the_way / count, 0.02);
  EXPECT_LT(gap / count, 100);
}

// Pairs of different flocks nearer than 8, summed over the steps.
int near_misses(bool avoids) {
  ScenarioDef scenario = shipped("steer-avoidance");
  for (FlockDef& flock : scenario.flocks) flock.avoid_collisions->on = avoids;
  Simulation simulation = start(scenario);
  int count = 0;
  for (int step = 0; step < 900; ++step) {
    simulation.step();
    if (step < 100) continue;  // they begin anywhere
    for (const std::size_t a : members(simulation, "east")) {
      for (const std::size_t b : members(simulation, "north")) count += gap_of(simulation, a, b) < 8;
    }
  }
  return count;
}

TEST(SteeringScenarios, AvoidanceHalvesTheNearMissesAtLeast) {
  const int without = near_misses(false), with = near_misses(true);
  EXPECT_GT(without, 100);
  EXPECT_LT(2 * with, without) << with << " of " << without;
}

// Whether the straight way between two boids meets an obstacle; a box counts as the ball around it.
bool is_hidden(const Simulation& simulation, std::size_t from, std::size_t to) {
  const View view = simulation.view();
  const Point o = offset_of(simulation, from, to);
  for (const Obstacle& obstacle : view.state().obstacles) {
    const double x = double{obstacle.at[0]} - double{view.position(from)[0]};
    const double y = double{obstacle.at[1]} - double{view.position(from)[1]};
    const double radius = obstacle.kind == ObstacleKind::sphere
                              ? double{obstacle.radius}
                              : std::hypot(double{obstacle.half[0]}, double{obstacle.half[1]});
    const double all = double{o[0]} * double{o[0]} + double{o[1]} * double{o[1]};
    const double part = std::clamp((x * double{o[0]} + y * double{o[1]}) / all, 0.0, 1.0);
    if (std::hypot(x - part * double{o[0]}, y - part * double{o[1]}) < radius) return true;
  }
  return false;
}

// How much of the crowd the hunter can't see, once they had time to hide.
double share_out_of_sight(bool hides) {
  ScenarioDef scenario = shipped("steer-hide");
  scenario.flocks[0].hide->on = hides;
  Simulation simulation = start(scenario);
  simulation.run(200);
  double hidden = 0, all = 0;
  for (int step = 0; step < 600; ++step) {
    simulation.step();
    const std::size_t hunter = members(simulation, "hunter")[0];
    for (const std::size_t boid : members(simulation, "crowd")) {
      hidden += is_hidden(simulation, hunter, boid) ? 1 : 0;
      ++all;
    }
  }
  return hidden / all;
}

TEST(SteeringScenarios, MostOfThoseWhoHideAreOutOfSight) {
  EXPECT_GT(share_out_of_sight(true), 0.8);
  EXPECT_LT(share_out_of_sight(false), 0.4);
}

TEST(SteeringScenarios, WhoArrivesComesToRestWhereWhoSeeksOvershoots) {
  Simulation simulation = start(shipped("steer-arrival"));
  simulation.run(300);
  double arriving = 0, seeking = 0;  // the fastest of each over the next steps
  for (int step = 0; step < 90; ++step) {
    simulation.step();
    for (const std::size_t boid : members(simulation, "arriving")) {
      arriving = std::max(arriving, length_of(simulation.view().velocity(boid)));
      EXPECT_LT(distance(simulation.view().position(boid), {300, 270, 0}), 20);
    }
    for (const std::size_t boid : members(simulation, "seeking"))
      seeking = std::max(seeking, length_of(simulation.view().velocity(boid)));
  }
  EXPECT_LT(arriving, 0.8);
  EXPECT_GT(seeking, 1.6);
}

TEST(SteeringScenarios, WhoWandersNervouslyTurnsMore) {
  Simulation simulation = start(shipped("steer-wander"));
  double turned[2] = {};
  for (int step = 0; step < 300; ++step) {
    simulation.step();
    for (std::size_t i = 0; i < simulation.view().size(); ++i) {
      const Vector before = heading(simulation.view().previous_velocity(i));
      const Vector now = heading(simulation.view().velocity(i));
      turned[simulation.view().flock(i)] += distance(before, now);
    }
  }
  EXPECT_GT(turned[0], 0);
  EXPECT_GT(turned[1], 2 * turned[0]);
}

// The least distance of any two cars after step 500, and how many are in a queue: with somebody within 40.
std::pair<double, int> queued(bool waits) {
  ScenarioDef scenario = shipped("steer-queue");
  scenario.flocks[1].queue->on = waits;
  Simulation simulation = start(scenario);
  simulation.run(600);
  double least = 1e9;
  int queued = 0;
  for (int step = 0; step < 600; ++step) {
    simulation.step();
    queued = 0;
    for (std::size_t a = 0; a < simulation.view().size(); ++a) {
      double nearest = 1e9;
      for (std::size_t b = 0; b < simulation.view().size(); ++b) {
        if (a != b) nearest = std::min(nearest, gap_of(simulation, a, b));
      }
      least = std::min(least, nearest);
      queued += nearest < 44;
    }
  }
  return {least, queued};
}

TEST(SteeringScenarios, CarsThatQueueDoNotOverlap) {
  const auto [least, count] = queued(true);
  EXPECT_GT(least, 10);
  EXPECT_GT(count, 12);
  EXPECT_LT(queued(false).first, 5);
}

}  // namespace
}  // namespace sturnus::test
