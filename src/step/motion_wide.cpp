// Many boids at a time: the same operations as in motion.cpp and in the rules, lane by lane. What is rare (a
// bounce, a number that goes bad) or draws random numbers is done for one boid after the other.
#include "step/motion.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step/motion_wide.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "step/near_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// Boids from slot `first` on, in the lanes, of whom some belong to the flock.
template <int D>
struct Group {
  // Not an aggregate, all of which would be cleared first.
  HWY_INLINE Group(Motion<D>& its_motion, const FlockModel& its_flock, std::size_t slot, Lanes_mask lanes)
      : motion(its_motion),
        flock(its_flock),
        first(slot),
        counted(lanes),
        position(LoadVec<D>(motion.state.position, first)),
        velocity(LoadVec<D>(motion.state.velocity, first)) {}

  Motion<D>& motion;
  const FlockModel& flock;
  const std::size_t first;
  const Lanes_mask counted;  ///< those lanes
  const LaneVec<D> position, velocity;
  Box box;  ///< of their places, where somebody asks
};

// The sum of a row and its count, with the boid itself where it counts too.
template <int D>
struct RowSum {
  LaneVec<D> value;
  Lanes count;
  Lanes_mask is_lonely;
};

template <int D>
HWY_INLINE RowSum<D> LoadSum(const Group<D>& group, std::size_t row) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  RowSum<D> sum;
  SumBlock& sums = group.motion.part.sums;
  for (int axis = 0; axis < D; ++axis)
    sum.value.at[axis] = hn::LoadU(d, sums.value(row, static_cast<std::size_t>(axis), group.first));
  const auto* counts = reinterpret_cast<const std::int32_t*>(sums.count(row, group.first));
  sum.count = hn::ConvertTo(d, hn::LoadU(di, counts));
  sum.is_lonely = hn::Eq(sum.count, hn::Zero(d));
  return sum;
}

// 1 / n.
HWY_INLINE Lanes Share(const TermModel& term, Lanes count) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  return hn::Div(one, term.count_self ? hn::Add(count, one) : count);
}

template <int D>
HWY_INLINE LaneVec<D> Combined(const TermModel& term, const RowSum<D>& sum) {
  if (term.combine == Combine::sum) return sum.value;
  return Select(sum.is_lonely, sum.value, Scaled(sum.value, Share(term, sum.count)));
}

template <int D>
HWY_INLINE LaneVec<D> Alignment(const TermModel& term, const Group<D>& group, const RowSum<D>& sum) {
  const LaneVec<D> own = term.match == Match::velocity ? group.velocity : Heading(group.velocity);
  const LaneVec<D> total = term.count_self ? Sum(sum.value, own) : sum.value;
  const LaneVec<D> average = Scaled(total, Share(term, sum.count));
  const LaneVec<D> wish = term.relative ? Difference(average, own) : average;
  if (term.count_self && !term.relative) return wish;
  return Select(sum.is_lonely, Zeros<D>(), wish);
}

// A term that is asked boid by boid, for those lanes that have something to ask.
template <int D>
HWY_NOINLINE LaneVec<D> AskEach(const TermModel& term, const Group<D>& group, Lanes_mask asks) {
  const Floats d;
  if (hn::AllFalse(d, asks)) return Zeros<D>();
  HWY_ALIGN float is_asked[width];
  hn::Store(hn::IfThenElseZero(asks, hn::Set(d, 1.0f)), d, is_asked);
  HWY_ALIGN float felt[D][width] = {};
  for (std::size_t lane = 0; lane < width; ++lane) {
    if (is_asked[lane] == 0) continue;
    const std::size_t i = group.first + lane;
    Steering<D>& steering = group.motion.steering;
    const Vec<D> one = steering.feel(term, group.flock, steering.self(i), i);
    for (int axis = 0; axis < D; ++axis) felt[axis][lane] = one[axis];
  }
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::Load(Floats(), felt[axis]);
  return out;
}

// Who may feel an obstacle; and which, a bit for each lane.
template <int D>
HWY_INLINE Lanes_mask FindObstacles(const TermModel& term, const Group<D>& group,
                                    std::vector<std::uint32_t>& lanes) {
  const Floats d;
  const ObstacleColumns& near = group.motion.part.near_obstacles;
  lanes.resize(near.count);
  const bool sweeps = term.obstacle_form == ObstacleForm::sweep;
  const float thicker = 1.0001f * (sweeps ? group.flock.body_radius + term.clearance : 0.0f);
  const float reach = 1.0001f * term.look_ahead + thicker;
  auto may = hn::FirstN(d, 0);
  for (std::size_t k = 0; k < near.count; ++k) {
    const auto seen = LookAt<D>(near, k, group.motion.image, group.position, hn::Set(d, reach));
    auto one = seen.near;
    const bool is_sphere = seen.radius < FlockModel::infinity_f;
    if (sweeps && is_sphere && !IsAmbiguous(group.motion.image, D, seen.radius, reach))
      one = hn::And(one, MayMeet<D>(seen, group.velocity, thicker));
    lanes[k] = BitsOf(one);
    may = hn::Or(may, one);
  }
  return hn::And(may, group.counted);
}

// Those who may feel an obstacle are asked one by one, each about a few.
template <int D>
HWY_NOINLINE LaneVec<D> AvoidObstacles(const TermModel& term, const Group<D>& group) {
  const Floats d;
  const Motion<D>& motion = group.motion;
  if (motion.part.asks_obstacles) return AskEach(term, group, group.counted);
  std::vector<std::uint32_t>& lanes = motion.part.lanes_of_obstacles;
  std::vector<std::uint32_t>& felt = motion.part.felt_obstacles;
  const std::uint32_t asking = BitsOf(FindObstacles(term, group, lanes));
  if (asking == 0) return Zeros<D>();
  HWY_ALIGN float forces[D][width] = {};
  for (std::uint32_t left = asking; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    felt.clear();
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      if ((lanes[k] >> lane & 1) != 0)
        felt.push_back(std::bit_cast<std::uint32_t>(motion.part.near_obstacles.number[k]));
    }
    const Vec<D> force = avoid_listed<D>(term, group.flock, motion.model, motion.scratch.obstacles, felt,
                                         motion.steering.self(group.first + lane));
    for (int axis = 0; axis < D; ++axis) forces[axis][lane] = force[axis];
  }
  LaneVec<D> out;
  for (int axis = 0; axis < D; ++axis) out.at[axis] = hn::Load(d, forces[axis]);
  return out;
}

// What lanes smell of food.
template <int D>
struct Smelt {
  LaneVec<D> sum;
  Lanes count;
};

// The pieces in the runs, one after the other, for the lanes of a mask.
template <int D>
HWY_INLINE void Smell(const Group<D>& group, Lanes_mask who, Smelt<D>& smelt) {
  const Floats d;
  const FeedModel& feed = *group.flock.feed;
  const Pieces& pieces = group.motion.scratch.pieces;
  for (const Pieces::Run run : group.motion.part.food_runs) {
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      if (pieces.kind_at(i) != feed.kind) continue;
      std::array<float, 3> place{};
      for (std::size_t axis = 0; axis < D; ++axis) place[axis] = pieces.coordinate_at(axis, i);
      const LaneVec<D> o = Offset(group.position, Everywhere<D>(place), group.motion.image);
      const auto smells = hn::And(who, hn::Le(Squared<D>(o.at), hn::Set(d, feed.radius * feed.radius)));
      if (hn::AllFalse(d, smells)) continue;
      const LaneVec<D> toward = feed.form == SteeringForm::linear ? o : Heading(o);
      smelt.sum = Select(smells, Sum(smelt.sum, toward), smelt.sum);
      smelt.count = hn::IfThenElse(smells, hn::Add(smelt.count, hn::Set(d, 1.0f)), smelt.count);
    }
  }
}

// Toward food, as in rules/feed.cpp.
template <int D>
HWY_INLINE LaneVec<D> TowardFood(const TermModel& term, const Group<D>& group, const Smelt<D>& smelt) {
  const Floats d;
  const auto smells = hn::Gt(smelt.count, hn::Zero(d));
  if (hn::AllFalse(d, smells)) return Zeros<D>();
  if (group.flock.feed->form != SteeringForm::heading) return AskEach(term, group, smells);
  const LaneVec<D> toward = Scaled(smelt.sum, hn::Div(hn::Set(d, 1.0f), smelt.count));
  return Select(smells, Difference(toward, Heading(group.velocity)), Zeros<D>());
}

// Where the order of storage jumps from one end of the world to the other, a group stands in two places: it
// is quartered, and only the boids of the part with the jump are asked one by one.
template <int D>
HWY_NOINLINE LaneVec<D> Feed(const TermModel& term, const Group<D>& group) {
  const Floats d;
  const Pieces& pieces = group.motion.scratch.pieces;
  auto& runs = group.motion.part.food_runs;
  const float radius = group.flock.feed->radius;
  Smelt<D> smelt{Zeros<D>(), hn::Zero(d)};
  if (pieces.find_runs(group.box.low, group.box.high, radius, runs)) {
    Smell(group, group.counted, smelt);
    return TowardFood(term, group, smelt);
  }
  auto torn = hn::FirstN(d, 0);
  constexpr std::size_t size = std::max<std::size_t>(width / 4, 1);
  for (std::size_t first = 0; first < width; first += size) {
    const auto stretch = hn::AndNot(hn::FirstN(d, first), hn::FirstN(d, std::min(first + size, width)));
    const auto part = hn::And(stretch, group.counted);
    if (hn::AllFalse(d, part)) continue;
    const Box box = BoxOf(BoundsOf(group.position, part));
    if (pieces.find_runs(box.low, box.high, radius, runs)) {
      Smell(group, part, smelt);
    } else {
      torn = hn::Or(torn, part);
    }
  }
  return Select(torn, AskEach(term, group, torn), TowardFood(term, group, smelt));
}

template <int D>
HWY_INLINE LaneVec<D> Feel(const TermModel& term, const Group<D>& group) {
  const Floats d;
  const auto row = static_cast<std::size_t>(term.row);
  switch (term.kind) {
    case TermKind::separation:
      return Scaled(Combined(term, LoadSum(group, row)), hn::Set(d, -1.0f));
    case TermKind::cohesion:
      return Combined(term, LoadSum(group, row));
    case TermKind::alignment:
      return Alignment(term, group, LoadSum(group, row));
    case TermKind::cruise:
      return Scaled(Heading(group.velocity), hn::Sub(hn::Set(d, term.amount), Length(group.velocity)));
    case TermKind::flee:
      return AskEach(term, group, hn::AndNot(LoadSum(group, row).is_lonely, group.counted));
    case TermKind::avoid_obstacles:
      return AvoidObstacles(term, group);
    case TermKind::feed:
      return Feed(term, group);
    default:
      return AskEach(term, group, group.counted);
  }
}

// Whether a term can be left out: it asks nothing of anybody, and adding +0 or -0 to a sum that began at +0
// changes no bit of it.
template <int D>
bool IsSilent(const Motion<D>& motion, const TermModel& term) {
  if (term.kind == TermKind::pointer) return !motion.state.pointer.pressed;
  if (term.kind == TermKind::avoid_obstacles) return motion.scratch.obstacles.empty();
  return term.kind == TermKind::custom &&
         motion.scratch.custom[static_cast<std::size_t>(term.row)][0].empty();
}

HWY_INLINE bool AllWithin(Lanes_mask counted, Lanes value, float most) {
  const Floats d;
  return hn::AllTrue(d, hn::Or(hn::Not(counted), hn::Le(hn::Abs(value), hn::Set(d, most))));
}

// At most `longest` long; the caller has seen that the length is finite.
template <int D>
HWY_INLINE LaneVec<D> Capped(const LaneVec<D>& v, Lanes size, float longest) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const auto is_longer = hn::Gt(size, hn::Set(d, longest));
  return Scaled(
      v, hn::Div(hn::IfThenElse(is_longer, hn::Set(d, longest), one), hn::IfThenElse(is_longer, size, one)));
}

template <int D>
HWY_INLINE LaneVec<D> Limited(const LaneVec<D>& v, Lanes speed, const FlockModel& flock) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f);
  const auto is_faster = hn::Gt(speed, hn::Set(d, flock.max_speed));
  const auto is_slower = hn::Lt(speed, hn::Set(d, flock.min_speed));
  const Lanes wanted = hn::IfThenElse(is_faster, hn::Set(d, flock.max_speed), hn::Set(d, flock.min_speed));
  const auto moves = hn::Gt(speed, hn::Zero(d));
  const auto is_limited = hn::And(moves, hn::Or(is_faster, is_slower));
  const Lanes factor =
      hn::Div(hn::IfThenElse(is_limited, wanted, one), hn::IfThenElse(is_limited, speed, one));
  return Scaled(v, factor);
}

template <int D>
HWY_INLINE LaneVec<D> BoundaryTurn(const Model& model, const LaneVec<D>& position) {
  const Floats d;
  LaneVec<D> push = Zeros<D>();
  const Lanes strength = hn::Set(d, model.turn_strength);
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const auto is_low = hn::Lt(position.at[axis], hn::Set(d, model.min[i] + model.margin[i]));
    const auto is_high = hn::Gt(position.at[axis], hn::Set(d, model.max[i] - model.margin[i]));
    push.at[axis] = hn::IfThenElse(is_low, hn::Add(push.at[axis], strength), push.at[axis]);
    push.at[axis] = hn::IfThenElse(is_high, hn::Sub(push.at[axis], strength), push.at[axis]);
  }
  return push;
}

// Where a boid leaves a space that wraps or bounces, it is brought back alone.
template <int D>
HWY_INLINE void KeepInside(const Group<D>& group, Lanes_mask counted, LaneVec<D>& position,
                           LaneVec<D>& velocity) {
  const Floats d;
  const Model& model = group.motion.model;
  if (model.boundary != BoundaryKind::wrap && model.boundary != BoundaryKind::bounce) return;
  auto inside = counted;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    inside = hn::And(inside, hn::Ge(position.at[axis], hn::Set(d, model.min[i])));
    inside = hn::And(inside, hn::Lt(position.at[axis], hn::Set(d, model.max[i])));
  }
  if (hn::AllTrue(d, hn::Or(inside, hn::Not(counted)))) return;
  HWY_ALIGN float p[D][width];
  HWY_ALIGN float v[D][width];
  for (int axis = 0; axis < D; ++axis) {
    hn::Store(position.at[axis], d, p[axis]);
    hn::Store(velocity.at[axis], d, v[axis]);
  }
  for (std::size_t lane = 0; lane < width; ++lane) {
    Vec<D> one_position, one_velocity;
    for (int axis = 0; axis < D; ++axis) {
      one_position[axis] = p[axis][lane];
      one_velocity[axis] = v[axis][lane];
    }
    keep_inside(model, one_position, one_velocity);
    for (int axis = 0; axis < D; ++axis) {
      p[axis][lane] = one_position[axis];
      v[axis][lane] = one_velocity[axis];
    }
  }
  for (int axis = 0; axis < D; ++axis) {
    position.at[axis] = hn::Load(d, p[axis]);
    velocity.at[axis] = hn::Load(d, v[axis]);
  }
}

template <int D>
HWY_INLINE bool AreSound(Lanes_mask counted, const LaneVec<D>& v) {
  for (int axis = 0; axis < D; ++axis) {
    if (!AllWithin(counted, v.at[axis], 1e15f)) return false;
  }
  return true;
}

// Moves the counted lanes; false where a number needs the care of the plain motion, and nothing is written.
template <int D>
HWY_INLINE bool MoveGroup(const Group<D>& group) {
  const Floats d;
  const Lanes_mask counted = group.counted;
  const Model& model = group.motion.model;
  constexpr float most = std::numeric_limits<float>::max();
  LaneVec<D> felt = Zeros<D>();
  for (const TermModel& term : group.flock.terms) {
    if (!IsSilent(group.motion, term)) felt = Sum(felt, Scaled(Feel(term, group), hn::Set(d, term.weight)));
  }
  const Lanes size = Length(felt);
  if (!AllWithin(counted, size, most)) return false;
  LaneVec<D> acceleration = Capped(felt, size, group.flock.max_acceleration);
  acceleration = Sum(acceleration,
                     model.boundary == BoundaryKind::turn ? BoundaryTurn(model, group.position) : Zeros<D>());
  const Lanes dt = hn::Set(d, model.dt);
  LaneVec<D> velocity = Sum(group.velocity, Scaled(acceleration, dt));
  const Lanes speed = Length(velocity);
  if (!AllWithin(counted, speed, most)) return false;
  velocity = Limited(velocity, speed, group.flock);
  const bool semi_implicit = model.integrator == Integrator::semi_implicit_euler;
  LaneVec<D> position = Sum(group.position, Scaled(semi_implicit ? velocity : group.velocity, dt));
  if (!AreSound(counted, position) || !AreSound(counted, velocity)) return false;
  KeepInside(group, counted, position, velocity);
  if (!AreSound(counted, position)) return false;
  for (int axis = 0; axis < D; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    hn::BlendedStore(position.at[axis], counted, d,
                     group.motion.scratch.previous_position[i].data() + group.first);
    hn::BlendedStore(velocity.at[axis], counted, d,
                     group.motion.scratch.previous_velocity[i].data() + group.first);
  }
  return true;
}

// Whether lanes can do what a flock does; a random turn, a jump and a shared budget are done boid by boid.
inline bool HasLanes(const FlockModel& flock) {
  return flock.arbitration == Arbitration::weighted && flock.noise_turn == 0 && !flock.jump;
}

template <int D>
HWY_INLINE Lanes_mask MembersOf(const Motion<D>& motion, std::size_t first, std::size_t flock) {
  const Floats d;
  const std::uint64_t present = motion.boids.flocks_in(first, first + width);
  if ((present >> flock & 1) == 0) return hn::FirstN(d, 0);
  if (motion.boids.hidden == nullptr && std::has_single_bit(present)) return hn::FirstN(d, width);
  HWY_ALIGN float is_member[width] = {};
  for (std::size_t i = 0; i < width; ++i) {
    const std::size_t slot = first + i;
    is_member[i] = motion.state.flock[slot] == flock && motion.state.quarantined[slot] == 0 ? 1.0f : 0.0f;
  }
  return hn::Gt(hn::Load(d, is_member), hn::Zero(d));
}

// What is near the boids of a group.
template <int D>
HWY_INLINE void LookAround(Group<D>& group) {
  Motion<D>& motion = group.motion;
  PartScratch& part = motion.part;
  part.near_obstacles.count = 0;
  part.asks_obstacles = part.has_many_obstacles;
  if (part.block_obstacles.count == 0 && !group.flock.feed) return;
  group.box = BoxOf(BoundsOf(group.position, group.counted));
  Select<D>(part.block_obstacles, motion.image, group.box, motion.model.obstacle_reach, part.near_obstacles);
  part.asks_obstacles = part.asks_obstacles || part.near_obstacles.count > many_for_group;
}

template <int D>
HWY_INLINE void MoveLanes(Motion<D>& motion, std::size_t first) {
  const Floats d;
  for (std::size_t f = 0; f < motion.model.flocks.size(); ++f) {
    const auto counted = MembersOf(motion, first, f);
    if (hn::AllFalse(d, counted)) continue;
    Group<D> group(motion, motion.model.flocks[f], first, counted);
    LookAround(group);
    if (!HasLanes(group.flock) || !MoveGroup(group)) move_plain(motion, first, first + width);
  }
}

inline bool LooksForObstacles(const FlockModel& flock) {
  return std::any_of(flock.terms.begin(), flock.terms.end(),
                     [](const TermModel& term) { return term.kind == TermKind::avoid_obstacles; });
}

// The obstacles that somebody of the stretch may feel.
template <int D>
HWY_INLINE void LookFar(Motion<D>& motion, std::size_t begin, std::size_t end) {
  const auto& flocks = motion.model.flocks;
  PartScratch& part = motion.part;
  part.block_obstacles.count = 0;
  part.has_many_obstacles = false;
  if (motion.scratch.obstacles.empty() || std::none_of(flocks.begin(), flocks.end(), LooksForObstacles))
    return;
  const ObstacleColumns& all = motion.scratch.obstacles.columns();
  part.has_many_obstacles = AreTooMany(all, end - begin);
  if (part.has_many_obstacles) return;
  Bounds<D> bounds = NoBounds<D>();
  for (std::size_t first = begin; first < end; first += width) {
    const LaneVec<D> places = LoadVec<D>(motion.state.position, std::min(first, end - width));
    Widen(bounds, places, AreSoundPlaces(places));
  }
  part.block_obstacles.fit(all.count);
  part.near_obstacles.fit(all.count);
  part.lanes_of_obstacles.reserve(all.count);
  part.felt_obstacles.reserve(all.count);
  Select<D>(all, motion.image, BoxOf(bounds), motion.model.obstacle_reach, part.block_obstacles);
  part.has_many_obstacles = part.block_obstacles.count > many_for_block;
  if (part.has_many_obstacles) part.block_obstacles.count = 0;
}

// The last lanes go back over boids that have moved: that changes nothing, since all is read from the state
// and written elsewhere. Only a wandering boid's walk is not.
template <int D>
HWY_INLINE void MoveAll(Motion<D>& motion, std::size_t begin, std::size_t end) {
  if (end - begin < width || motion.model.uses_wander) return move_plain(motion, begin, end);
  LookFar(motion, begin, end);
  for (std::size_t first = begin; first < end; first += width)
    MoveLanes(motion, std::min(first, end - width));
}

void MoveWide2(Motion<2>& motion, std::size_t begin, std::size_t end) {
  MoveAll(motion, begin, end);
}
void MoveWide3(Motion<3>& motion, std::size_t begin, std::size_t end) {
  MoveAll(motion, begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sturnus {

HWY_EXPORT(MoveWide2);
HWY_EXPORT(MoveWide3);

template <>
void move_wide<2>(Motion<2>& motion, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(MoveWide2)(motion, begin, end);
}
template <>
void move_wide<3>(Motion<3>& motion, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(MoveWide3)(motion, begin, end);
}

}  // namespace sturnus
#endif
