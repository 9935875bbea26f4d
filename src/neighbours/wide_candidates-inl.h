// Whom the lanes see: one candidate after the other, and who of them passes a filter. Included once for every
// instruction set.
#if defined(STURNUS_WIDE_CANDIDATES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef STURNUS_WIDE_CANDIDATES_INL_H
#undef STURNUS_WIDE_CANDIDATES_INL_H
#else
#define STURNUS_WIDE_CANDIDATES_INL_H
#endif

#include <algorithm>
#include <bit>
#include <limits>

#include "neighbours/lanes-inl.h"
#include "neighbours/wide.h"

HWY_BEFORE_NAMESPACE();
namespace sturnus {
namespace HWY_NAMESPACE {

// What lies in the lanes: the boids that are steered.
template <int D>
struct Targets {
  Lanes position[3], velocity[3];
  Lanes speed;
  Counts slots;
};

// `with_speed`: where somebody looks only ahead.
template <int D>
HWY_INLINE Targets<D> Load(const WideBatch& batch, std::size_t first, bool with_speed) {
  const hn::RebindToSigned<Floats> di;
  Targets<D> targets;
  targets.slots = hn::Add(hn::Iota(di, 0), hn::Set(di, static_cast<std::int32_t>(first)));
  const std::size_t count = std::min<std::size_t>(width, batch.targets.end - first);
  for (std::size_t axis = 0; axis < D; ++axis) {
    targets.position[axis] = LoadSome(batch.boids->position[axis] + first, count);
    if (with_speed) targets.velocity[axis] = LoadSome(batch.boids->velocity[axis] + first, count);
  }
  if (with_speed) targets.speed = hn::Sqrt(Squared<D>(targets.velocity));
  return targets;
}

// One candidate as all lanes see it: the way from it to each of them, which is minus its offset, bit by bit.
// Taken so, what is read of the candidate is the last operand, and is spread over the lanes on the way.
template <int D>
struct Seen {
  Lanes away[3];
  Lanes distance_squared;
};

// Where the space wraps: the nearest image by comparison, as the plain kernel finds it; or by one
// subtraction, where the span says over which end its boids are seen. For all who are near both give the same
// bits.
enum class Wraps { no, by_span, by_comparison };

template <int D, Wraps wraps>
HWY_INLINE Seen<D> Look(const Targets<D>& targets, const Boids& boids, const Wrapping* image,
                        const Lanes* shift, std::size_t candidate) {
  const Floats d;
  Seen<D> seen;
  for (std::size_t axis = 0; axis < D; ++axis) {
    Lanes o = hn::Sub(targets.position[axis], hn::Set(d, boids.position[axis][candidate]));
    if (wraps == Wraps::by_span) o = hn::Add(o, shift[axis]);
    if (wraps == Wraps::by_comparison) {
      const Lanes half = hn::Set(d, image->half[axis]);
      const Lanes size = hn::Set(d, image->size[axis]);
      const auto above = hn::Gt(o, half);
      const auto below = hn::Lt(o, hn::Neg(half));
      o = hn::IfThenElse(above, hn::Sub(o, size), hn::IfThenElse(below, hn::Add(o, size), o));
    }
    seen.away[axis] = o;
  }
  seen.distance_squared = hn::Mul(seen.away[0], seen.away[0]);
  for (std::size_t axis = 1; axis < D; ++axis)
    seen.distance_squared = hn::Add(seen.distance_squared, hn::Mul(seen.away[axis], seen.away[axis]));
  return seen;
}

// The filters of a batch, lane by lane where flocks stand mixed.
struct Filters {
  bool has_rings = false, has_views = false, asks_flocks = false;
  HWY_ALIGN float outer[WideProgram::most][width];
  HWY_ALIGN float inner[WideProgram::most][width];
  HWY_ALIGN float cosine[WideProgram::most][width];  ///< -infinity: sees all round
  /// 1 where the lane looks at a flock; the last is for the hidden.
  HWY_ALIGN float looks[WideProgram::most][65][width];
};

HWY_INLINE void FillFilter(const WideBatch& batch, std::size_t first, std::size_t f, Filters& filters) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (std::size_t lane = 0; lane < width; ++lane) {
    const std::size_t slot = std::min<std::size_t>(first + lane, batch.targets.end - 1);
    const WideProgram& program = batch.is_mixed ? batch.programs[batch.boids->flock[slot]] : *batch.program;
    const WideFilter& filter = program.filters[batch.filter + f];
    filters.outer[f][lane] = filter.outer_squared;
    filters.inner[f][lane] = filter.inner_squared;
    filters.cosine[f][lane] = filter.sees_all ? -infinity : filter.cos_half_view;
    filters.has_rings |= filter.inner_squared > 0;
    filters.has_views |= !filter.sees_all;
    const bool steered = (batch.boids->flock_bit(slot) & batch.steered) != 0;
    filters.asks_flocks |= batch.boids->hidden != nullptr || (steered && (batch.near & ~filter.flocks) != 0);
    for (std::uint64_t left = batch.boids->flocks; left != 0; left &= left - 1) {
      const auto flock = static_cast<std::size_t>(std::countr_zero(left));
      filters.looks[f][flock][lane] = (filter.flocks >> flock & 1) != 0 ? 1.0f : 0.0f;
    }
    filters.looks[f][64][lane] = 0;
  }
}

// So many filters of the program, from the batch's own on.
HWY_INLINE void FillFilters(const WideBatch& batch, std::size_t first, std::size_t count, Filters& filters) {
  filters.has_rings = filters.has_views = filters.asks_flocks = false;
  for (std::size_t f = 0; f < count; ++f) FillFilter(batch, first, f, filters);
}

template <int D>
HWY_INLINE Lanes_mask PassesFilter(const Filters& filters, std::size_t f, const Targets<D>& targets,
                                   const Seen<D>& seen, const Boids& boids, std::size_t candidate) {
  const Floats d;
  auto mask = hn::Lt(seen.distance_squared, hn::Load(d, filters.outer[f]));
  if (filters.has_rings) mask = hn::And(mask, hn::Ge(seen.distance_squared, hn::Load(d, filters.inner[f])));
  if (filters.has_views) {
    Lanes along = hn::Mul(targets.velocity[0], seen.away[0]);
    for (std::size_t axis = 1; axis < D; ++axis)
      along = hn::Add(along, hn::Mul(targets.velocity[axis], seen.away[axis]));
    const Lanes cosine = hn::Load(d, filters.cosine[f]);
    const Lanes least = hn::Mul(hn::Mul(cosine, targets.speed), hn::Sqrt(seen.distance_squared));
    const auto sees_all = hn::Lt(cosine, hn::Set(d, -2.0f));
    mask = hn::And(mask, hn::Or(hn::Le(along, hn::Neg(least)), sees_all));
  }
  if (filters.asks_flocks) {
    const std::size_t flock = boids.is_hidden(candidate) ? 64 : boids.flock[candidate];
    mask = hn::And(mask, hn::Gt(hn::Load(d, filters.looks[f][flock]), hn::Zero(d)));
  }
  return mask;
}

// Whoever is the candidate himself is left out; `slots` are those of the lanes.
HWY_INLINE Lanes_mask NotSelf(Lanes_mask mask, const std::uint32_t& candidate, Counts slots) {
  const hn::RebindToSigned<Floats> d;
  const auto others = hn::Ne(slots, hn::Set(d, static_cast<std::int32_t>(candidate)));
  return hn::And(mask, hn::RebindMask(Floats(), others));
}

}  // namespace HWY_NAMESPACE
}  // namespace sturnus
HWY_AFTER_NAMESPACE();

#endif
