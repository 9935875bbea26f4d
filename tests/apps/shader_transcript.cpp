// The Shadertoy flock in C++, function by function in the order of shadertoy/buffer_a.glsl.
#include "shader_transcript.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sturnus-shadertoy/noise.h"

namespace shader_transcript {
namespace {

using sturnus::BoundaryKind;
using sturnus::FlockDef;
using sturnus::ScenarioDef;
using sturnus::SteeringForm;

struct Vec2 {
  float x, y;
};

Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 operator*(Vec3 a, float f) {
  return {a.x * f, a.y * f, a.z * f};
}
Vec3 operator/(Vec3 a, float f) {
  return {a.x / f, a.y / f, a.z / f};
}
bool is_zero(Vec3 v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}
float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
float size_of(Vec3 v) {
  return std::sqrt(dot(v, v));
}
Vec3 unit(Vec3 v) {
  const float size = size_of(v);
  return size > 0 ? v / size : Vec3{};
}

enum Purpose {
  start_place,
  start_depth,
  start_speed,
  start_wander,
  noise_acceleration,
  noise_turn = 6,
  wander = 8
};

std::uint32_t mixed(std::uint32_t bits) {
  bits = (bits ^ (bits >> 16)) * 0x7feb352du;
  bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
  return bits ^ (bits >> 16);
}

float sine(float t) {
  const float x = t * 1.57079633f, x2 = x * x;
  const float high = -1.98412698e-4f + x2 * (2.75573192e-6f + x2 * -2.50521084e-8f);
  return x * (1.0f + x2 * (-0.166666667f + x2 * (8.33333333e-3f + x2 * high)));
}

Vec2 direction(float turns) {
  const float quarters = 4.0f * (turns - std::floor(turns));
  const float quarter = std::floor(quarters), t = quarters - quarter;
  Vec2 d{sine(1.0f - t), sine(t)};
  if (quarter >= 2) d = {-d.x, -d.y};
  return std::fmod(quarter, 2.0f) == 1 ? Vec2{-d.y, d.x} : d;
}

Vec3 vec_of(const sturnus::Coordinates& at) {
  Vec3 v;
  if (!at.empty()) v.x = static_cast<float>(at[0]);
  if (at.size() > 1) v.y = static_cast<float>(at[1]);
  if (at.size() > 2) v.z = static_cast<float>(at[2]);
  return v;
}

// One term of a flock as the shader has it.
struct Term {
  std::vector<bool> flocks;  // who is looked at
  float inner_squared, outer_squared, cos_half_view;
  enum { grows, constant, fades, velocity, heading } adds;
};

class Shader {
 public:
  Shader(const ScenarioDef& scenario, const Inputs& inputs, const std::vector<Boid>& flock, int frame)
      : scenario_(scenario), inputs_(inputs), boids_(flock), frame_(frame), dims_(scenario.space.dimensions) {
    const auto extent = extent_of(scenario);
    low_ = inputs.world_is_window ? Vec3{} : vec_of(extent.min);
    high_ = inputs.world_is_window ? Vec3{inputs.width, inputs.height, 0} : vec_of(extent.max);
  }

  Boid start_of(int boid, int flock) const {
    const auto& start = scenario_.flocks[static_cast<std::size_t>(flock)].start;
    Boid out;
    out.flock = flock;
    const Vec2 u = random2(boid, 0, start_speed);
    const auto slow = static_cast<float>(start.min_speed), fast = static_cast<float>(start.max_speed);
    const float speed = slow + (fast - slow) * u.x;
    const Vec2 depth = random2(boid, 0, start_depth);
    out.velocity = random_direction({u.y, depth.y}) * speed;
    const Vec2 place = random2(boid, 0, start_place);
    const Vec3 size = high_ - low_;
    out.position = low_ + Vec3{size.x * place.x, size.y * place.y, dims_ == 3 ? size.z * depth.x : 0.0f};
    if (uses_wander()) out.wander = random_direction(random2(boid, 0, start_wander));
    return out;
  }

  Boid next_of(int boid) const {
    const Boid& self = boids_[static_cast<std::size_t>(boid)];
    const FlockDef& own = own_of(self);
    const auto dt = static_cast<float>(scenario_.time.dt);
    Boid out = self;
    out.velocity = turned(limited(self.velocity + acceleration_of(boid, self) * dt, own), boid, own);
    const bool semi_implicit = scenario_.time.integrator == sturnus::Integrator::semi_implicit_euler;
    out.position = self.position + (semi_implicit ? out.velocity : self.velocity) * dt;
    keep_inside(out.position.x, low_.x, high_.x);
    keep_inside(out.position.y, low_.y, high_.y);
    if (dims_ == 3) keep_inside(out.position.z, low_.z, high_.z);
    if (uses_wander()) out.wander = wandered(boid);
    return out;
  }

 private:
  const FlockDef& own_of(const Boid& boid) const {
    return scenario_.flocks[static_cast<std::size_t>(boid.flock)];
  }

  bool uses_wander() const {
    return std::any_of(scenario_.flocks.begin(), scenario_.flocks.end(),
                       [](const FlockDef& flock) { return flock.wander.has_value(); });
  }

  Vec2 random2(int boid, int frame, int purpose) const {
    const auto seed = static_cast<std::uint32_t>(scenario_.seed);
    const std::uint32_t bits =
        mixed(mixed(mixed(seed + static_cast<std::uint32_t>(frame)) + static_cast<std::uint32_t>(boid)) +
              static_cast<std::uint32_t>(purpose));
    const std::uint32_t x = (bits & 0xffffu) % 256u, y = (bits >> 16) % 256u;
    const auto byte = [&](std::uint32_t channel) {
      return static_cast<float>(shadertoy::noise_byte(x, y, channel));
    };
    return {(byte(0) * 256.0f + byte(1)) / 65536.0f, (byte(2) * 256.0f + byte(3)) / 65536.0f};
  }

  Vec3 random_direction(Vec2 u) const {
    const Vec2 flat = direction(u.x);
    if (dims_ == 2) return {flat.x, flat.y, 0};
    const float z = 2.0f * u.y - 1.0f;
    const float r = std::sqrt(1.0f - z * z);
    return {flat.x * r, flat.y * r, z};
  }

  Vec3 random_in_cube(int boid, int purpose) const {
    const Vec2 xy = random2(boid, frame_, purpose);
    const float z = dims_ == 3 ? random2(boid, frame_, purpose + 1).x : 0.5f;
    return {2.0f * xy.x - 1.0f, 2.0f * xy.y - 1.0f, 2.0f * z - 1.0f};
  }

  float nearer(float o, float size) const {
    if (o > 0.5f * size) return o - size;
    return o < -0.5f * size ? o + size : o;
  }

  Vec3 offset(Vec3 from, Vec3 to) const {
    Vec3 o = to - from;
    if (scenario_.space.boundary.kind != BoundaryKind::wrap) return o;
    const Vec3 size = high_ - low_;
    return {nearer(o.x, size.x), nearer(o.y, size.y), nearer(o.z, size.z)};
  }

  static Vec3 contribution(const Term& term, Vec3 o, float distance_squared, Vec3 velocity) {
    if (term.adds == Term::velocity) return velocity;
    if (term.adds == Term::heading) return unit(velocity);
    if (term.adds == Term::grows) return o;
    if (distance_squared < 1.2e-38f) return {};
    return o / (term.adds == Term::fades ? distance_squared : std::sqrt(distance_squared));
  }

  struct Sum {
    Vec3 value;
    float count = 0;
  };

  Sum sum_over_neighbours(const Term& term, int boid, const Boid& self) const {
    Sum sum;
    const float speed = size_of(self.velocity);
    for (std::size_t i = 0; i < boids_.size(); ++i) {
      const Boid& other = boids_[i];
      if (!term.flocks[static_cast<std::size_t>(other.flock)]) continue;
      const Vec3 o = offset(self.position, other.position);
      const float d2 = dot(o, o);
      if (static_cast<int>(i) == boid || d2 < term.inner_squared || d2 >= term.outer_squared) continue;
      if (term.cos_half_view >= -1 && !(dot(self.velocity, o) >= term.cos_half_view * speed * std::sqrt(d2)))
        continue;
      sum.value = sum.value + contribution(term, o, d2, other.velocity);
      sum.count += 1;
    }
    return sum;
  }

  // The ring as squares: a closed edge is the next float after outer squared.
  Term looking(const FlockDef& own, double inner, double outer, sturnus::Edge edge,
               std::optional<double> view) const {
    Term term{};
    const auto in = static_cast<float>(inner), out = static_cast<float>(outer);
    term.inner_squared = in * in;
    term.outer_squared = out * out;
    if (edge == sturnus::Edge::closed && out > 0)
      term.outer_squared = std::nextafter(term.outer_squared, std::numeric_limits<float>::infinity());
    const double angle = view.value_or(own.field_of_view);
    term.cos_half_view =
        angle >= 360 ? -2.0f : static_cast<float>(std::cos(angle / 360 * 3.14159265358979324));
    term.flocks.assign(scenario_.flocks.size(), false);
    return term;
  }

  void look_at(Term& term, const sturnus::Whose& whose, const FlockDef& own) const {
    for (std::size_t i = 0; i < scenario_.flocks.size(); ++i) {
      const std::string& name = scenario_.flocks[i].name;
      term.flocks[i] = whose.kind == sturnus::Whose::Kind::all ||
                       (whose.kind == sturnus::Whose::Kind::own && name == own.name) ||
                       std::count(whose.names.begin(), whose.names.end(), name) > 0;
    }
  }

  static decltype(Term::adds) adds_of(sturnus::Strength strength) {
    if (strength == sturnus::Strength::grows) return Term::grows;
    return strength == sturnus::Strength::constant ? Term::constant : Term::fades;
  }

  Vec3 separation(const sturnus::Separation& def, const FlockDef& own, int boid, const Boid& self) const {
    Term term = looking(own, def.inner, def.radius, def.edge, def.field_of_view);
    look_at(term, def.of, own);
    term.adds = adds_of(def.strength);
    const Sum sum = sum_over_neighbours(term, boid, self);
    if (sum.count == 0) return {};
    return (def.combine == sturnus::Combine::mean ? sum.value / sum.count : sum.value) * -1.0f;
  }

  Vec3 alignment(const sturnus::Alignment& def, const FlockDef& own, int boid, const Boid& self) const {
    Term term = looking(own, def.inner, def.radius, def.edge, def.field_of_view);
    look_at(term, def.of, own);
    const bool by_velocity = def.match == sturnus::Match::velocity;
    term.adds = by_velocity ? Term::velocity : Term::heading;
    const Sum sum = sum_over_neighbours(term, boid, self);
    const Vec3 mine = by_velocity ? self.velocity : unit(self.velocity);
    if (sum.count == 0 && !(def.count_self && !def.relative)) return {};
    const float counted = def.count_self ? 1.0f : 0.0f;
    const Vec3 average = (sum.value + mine * counted) / (sum.count + counted);
    return def.relative ? average - mine : average;
  }

  Vec3 cohesion(const sturnus::Cohesion& def, const FlockDef& own, int boid, const Boid& self) const {
    Term term = looking(own, def.inner, def.radius, def.edge, def.field_of_view);
    look_at(term, def.of, own);
    term.adds = adds_of(def.strength);
    const Sum sum = sum_over_neighbours(term, boid, self);
    if (sum.count == 0) return {};
    if (def.combine == sturnus::Combine::sum) return sum.value;
    return sum.value / (sum.count + (def.count_self ? 1.0f : 0.0f));
  }

  Vec3 flee(const sturnus::Flee& def, const FlockDef& own, int boid, const Boid& self) const {
    Term term = looking(own, 0, def.radius, sturnus::Edge::open, def.field_of_view);
    look_at(term, {sturnus::Whose::Kind::named, def.from}, own);
    term.adds = def.form == SteeringForm::linear ? Term::grows : Term::constant;
    const Sum sum = sum_over_neighbours(term, boid, self);
    if (sum.count == 0) return {};
    const Vec3 mean = sum.value / sum.count;
    const auto max_speed = static_cast<float>(own.max_speed);
    if (def.form == SteeringForm::seek) return unit(mean * -1.0f) * max_speed - self.velocity;
    return def.form == SteeringForm::heading ? mean * -1.0f - unit(self.velocity) : mean * -1.0f;
  }

  Vec3 pull_of_mouse(const Boid& self) const {
    if (!inputs_.pressed) return {};
    const Vec3 o = offset(self.position, {inputs_.mouse[0], inputs_.mouse[1], 0});
    if (size_of(o) > static_cast<float>(scenario_.pointer.radius) || is_zero(o)) return {};
    return unit(o) - unit(self.velocity);
  }

  Vec3 wandered(int boid) const {
    const Boid& self = boids_[static_cast<std::size_t>(boid)];
    const FlockDef& own = own_of(self);
    const float rate = own.wander ? static_cast<float>(own.wander->rate) : 0.0f;
    const Vec3 next = unit(self.wander + random_in_cube(boid, wander) * rate);
    return is_zero(next) ? self.wander : next;
  }

  float turn_on(float at, float low, float high, double margin) const {
    const auto room = static_cast<float>(margin);
    float turn = at < low + room ? 1.0f : 0.0f;
    if (at > high - room) turn -= 1.0f;
    return static_cast<float>(scenario_.space.boundary.strength) * turn;
  }

  Vec3 turn_at_edge(Vec3 at) const {
    const auto& boundary = scenario_.space.boundary;
    if (boundary.kind != BoundaryKind::turn) return {};
    const auto margin = [&](std::size_t axis) {
      if (boundary.margin.empty()) return 0.0;
      return boundary.margin.size() == 1 ? boundary.margin[0] : boundary.margin[axis];
    };
    return {turn_on(at.x, low_.x, high_.x, margin(0)), turn_on(at.y, low_.y, high_.y, margin(1)),
            dims_ == 3 ? turn_on(at.z, low_.z, high_.z, margin(2)) : 0.0f};
  }

  Vec3 acceleration_of(int boid, const Boid& self) const {
    const FlockDef& own = own_of(self);
    Vec3 sum;
    const auto add = [&](Vec3 felt, double weight) { sum = sum + felt * static_cast<float>(weight); };
    for (const auto& term : own.separation) {
      if (term.on) add(separation(term, own, boid, self), term.weight);
    }
    for (const auto& term : own.alignment) {
      if (term.on) add(alignment(term, own, boid, self), term.weight);
    }
    for (const auto& term : own.cohesion) {
      if (term.on) add(cohesion(term, own, boid, self), term.weight);
    }
    for (const auto& term : own.flee) {
      if (term.on) add(flee(term, own, boid, self), term.weight);
    }
    if (own.cruise) {
      const Vec3 along =
          unit(self.velocity) * (static_cast<float>(own.cruise->speed) - size_of(self.velocity));
      add(along, own.cruise->weight);
    }
    if (own.noise && own.noise->acceleration > 0)
      add(random_in_cube(boid, noise_acceleration), own.noise->acceleration);
    if (own.wander) add(wandered(boid), own.wander->weight);
    add(pull_of_mouse(self), scenario_.pointer.weight);
    const float size = size_of(sum);
    const auto cap = static_cast<float>(own.max_acceleration);
    if (size > cap) sum = sum * (cap / size);
    return sum + turn_at_edge(self.position);
  }

  static Vec3 limited(Vec3 velocity, const FlockDef& own) {
    const float speed = size_of(velocity);
    const auto slow = static_cast<float>(own.min_speed), fast = static_cast<float>(own.max_speed);
    if (speed > fast) return velocity * (fast / speed);
    return speed > 0 && speed < slow ? velocity * (slow / speed) : velocity;
  }

  Vec3 turned(Vec3 velocity, int boid, const FlockDef& own) const {
    if (!own.noise || own.noise->turn == 0 || is_zero(velocity)) return velocity;
    const Vec2 u = random2(boid, frame_, noise_turn);
    const Vec2 angle = direction(static_cast<float>(own.noise->turn / 360) * (u.x - 0.5f));
    Vec3 axis{0, 0, 1};
    if (dims_ == 3)
      axis = unit(cross(unit(velocity), random_direction(random2(boid, frame_, noise_turn + 1))));
    return velocity * angle.x + cross(axis, velocity) * angle.y;
  }

  void keep_inside(float& at, float low, float high) const {
    if (scenario_.space.boundary.kind != BoundaryKind::wrap) return;
    const float size = high - low, far = at - low;
    at = low + (far - std::floor(far / size) * size);
    if (at >= high) at = low;
  }

  const ScenarioDef& scenario_;
  const Inputs& inputs_;
  const std::vector<Boid>& boids_;
  int frame_;
  std::int64_t dims_;
  Vec3 low_, high_;
};

}  // namespace

std::vector<Boid> start(const ScenarioDef& scenario, const Inputs& inputs) {
  std::vector<Boid> flock;
  const Shader shader(scenario, inputs, flock, 0);
  std::vector<Boid> out;
  for (std::size_t i = 0; i < scenario.flocks.size(); ++i) {
    for (std::int64_t k = 0; k < scenario.flocks[i].count; ++k)
      out.push_back(shader.start_of(static_cast<int>(out.size()), static_cast<int>(i)));
  }
  return out;
}

std::vector<Boid> next(const ScenarioDef& scenario, const Inputs& inputs, const std::vector<Boid>& flock,
                       int frame) {
  const Shader shader(scenario, inputs, flock, frame);
  std::vector<Boid> out;
  for (std::size_t i = 0; i < flock.size(); ++i) out.push_back(shader.next_of(static_cast<int>(i)));
  return out;
}

}  // namespace shader_transcript
