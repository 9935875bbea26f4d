// Measures of a flock, in double and in order of ids, so that neither threads nor storage can be seen in
// them.
#include <sturnus/measure.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "base/root.h"
#include "base/text.h"
#include "neighbours/query.h"
#include "scenario/model.h"

namespace sturnus {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

using Vec3d = Vec<3, double>;

Vec3d wide(const std::array<float, 3>& v) {
  return {{double{v[0]}, double{v[1]}, double{v[2]}}};
}

Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

// The visible boids of a view in order of their ids, with what every measure needs.
struct Flock {
  const View& view;
  Model model;
  std::vector<std::uint32_t> slots;

  explicit Flock(const View& of) : view(of), model(compile(of.scenario())) {
    for (const std::uint32_t slot : of.slots_by_id()) {
      if (!of.quarantined(slot)) slots.push_back(slot);
    }
  }

  Vec3d offset(const Vec3d& from, const Vec3d& to) const {
    Vec3d o = to - from;
    for (int axis = 0; axis < model.dimensions && model.wraps(); ++axis) {
      const double size = model.size[static_cast<std::size_t>(axis)];
      o[axis] -= size * std::floor(o[axis] / size + 0.5);
    }
    return o;
  }
};

double mean(double sum, std::size_t count) {
  return count == 0 ? not_known : sum / static_cast<double>(count);
}

double mean_speed(const Flock& flock) {
  double sum = 0;
  for (const std::uint32_t slot : flock.slots) sum += length(wide(flock.view.velocity(slot)));
  return mean(sum, flock.slots.size());
}

double mean_turning(const Flock& flock) {
  if (!flock.view.has_previous()) return not_known;
  double sum = 0;
  std::size_t moving = 0;
  for (const std::uint32_t slot : flock.slots) {
    const Vec3d now = unit(wide(flock.view.velocity(slot)));
    const Vec3d before = unit(wide(flock.view.previous_velocity(slot)));
    if (now == Vec3d{} || before == Vec3d{}) continue;
    sum += std::atan2(length(cross(before, now)), dot(before, now)) * (180 / pi);
    ++moving;
  }
  return mean(sum, moving);
}

// The middle of the flock; in a wrapped axis the mean direction on the circle that the axis is.
Vec3d centre_of_mass(const Flock& flock) {
  Vec3d centre;
  for (int axis = 0; axis < flock.model.dimensions; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    double sum = 0, sum_cos = 0, sum_sin = 0;
    for (const std::uint32_t slot : flock.slots) {
      const double x = flock.view.position(slot)[a];
      const double angle = 2 * pi * (x - double{flock.model.min[a]}) / double{flock.model.size[a]};
      sum += x;
      sum_cos += std::cos(angle);
      sum_sin += std::sin(angle);
    }
    const double turned = std::atan2(sum_sin, sum_cos) / (2 * pi);
    centre[axis] = flock.model.wraps() ? double{flock.model.min[a]} +
                                             double{flock.model.size[a]} * (turned < 0 ? turned + 1 : turned)
                                       : sum / static_cast<double>(flock.slots.size());
  }
  return centre;
}

double milling_of(const Flock& flock) {
  if (flock.slots.empty()) return not_known;
  const Vec3d centre = centre_of_mass(flock);
  Vec3d sum;
  std::size_t moving = 0;
  for (const std::uint32_t slot : flock.slots) {
    const Vec3d heading = unit(wide(flock.view.velocity(slot)));
    if (heading == Vec3d{}) continue;
    sum += cross(unit(flock.offset(centre, wide(flock.view.position(slot)))), heading);
    ++moving;
  }
  return mean(length(sum), moving);
}

// The flock sorted into an index of its own, so that measuring does not touch the simulation's.
class Sorted {
 public:
  Sorted(const Flock& flock, float reach) {
    const std::size_t count = flock.slots.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = flock.view.position(flock.slots[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) position_[axis].push_back(at[axis]);
    }
    hidden_.assign(count, 0);
    Cloud cloud;
    cloud.dimensions = flock.model.dimensions;
    cloud.count = count;
    cloud.hidden = hidden_.data();
    cloud.wraps = flock.model.wraps();
    cloud.min = flock.model.min;
    cloud.max = flock.model.max;
    for (std::size_t axis = 0; axis < 3; ++axis) cloud.position[axis] = position_[axis].data();
    std::vector<std::uint32_t> order;
    divided_ = may_divide(cloud, reach);
    index_ = divided_ ? make_grid() : make_all_pairs();
    index_->build(cloud, reach, Workers(1), order);
    if (order.empty()) {
      order.resize(count);
      std::iota(order.begin(), order.end(), 0u);
    }
    for (const std::uint32_t i : order) ids_.push_back(i);
    const Columns old = position_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < count; ++i) position_[axis][i] = old[axis][order[i]];
    }
    near_ = {index_.get(), cloud, {cloud.wraps, flock.model.size, {}}, ids_};
    for (std::size_t axis = 0; axis < 3; ++axis) near_.image.half[axis] = 0.5f * flock.model.size[axis];
  }
  Sorted(const Sorted&) = delete;
  Sorted& operator=(const Sorted&) = delete;

  /// In `near().ids`: the number of the boid in `Flock::slots`.
  const Neighbourhood& near() const { return near_; }
  bool divided() const { return divided_; }

 private:
  Columns position_;
  std::vector<std::uint8_t> hidden_;
  std::vector<std::uint64_t> ids_;
  std::unique_ptr<NeighbourIndex> index_;
  Neighbourhood near_;
  bool divided_ = false;
};

template <int D>
Vec<D> place(const Flock& flock, std::size_t i) {
  return narrow_to<D>(flock.view.position(flock.slots[i]));
}

// Mean distance to the nearest other: asks within a short reach, and again in twice the reach for those who
// found nobody.
template <int D>
double nearest_distance_of(const Flock& flock) {
  if (flock.slots.size() < 2) return not_known;
  double volume = 1;
  for (std::size_t axis = 0; axis < D; ++axis) volume *= double{flock.model.size[axis]};
  const double share = volume / static_cast<double>(flock.slots.size());
  auto reach = static_cast<float>(0.5 * (D == 3 ? cube_root(share) : square_root(share)));
  std::vector<double> found(flock.slots.size(), -1);
  reach = std::max(reach, std::numeric_limits<float>::min());
  std::size_t open = found.size();
  while (open > 0) {
    const Sorted sorted(flock, reach);
    const float radius = sorted.divided() ? reach : std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] >= 0) continue;
      for (const Found& other : nearest<D>(sorted.near(), place<D>(flock, i), 2, radius)) {
        if (other.id != i) found[i] = std::sqrt(double{other.distance_squared});
      }
      if (found[i] >= 0 || !sorted.divided()) --open;
    }
    reach *= 2;
    if (!(reach < 1e18f)) break;
  }
  double sum = 0;
  for (const double distance : found) sum += std::max(0.0, distance);
  return mean(sum, found.size());
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

bool in_view(const Flock& flock, std::size_t i, std::size_t other) {
  const FlockDef& def =
      flock.view.scenario().flocks[static_cast<std::size_t>(flock.view.flock(flock.slots[i]))];
  if (def.field_of_view >= 360) return true;
  const Vec3d velocity = wide(flock.view.velocity(flock.slots[i]));
  const Vec3d o =
      flock.offset(wide(flock.view.position(flock.slots[i])), wide(flock.view.position(flock.slots[other])));
  return dot(velocity, o) >= cosine_of_degrees(def.field_of_view / 2) * length(velocity) * length(o);
}

// Neighbours and clusters within `link`, both from one walk over near pairs.
template <int D>
void measure_links(const Flock& flock, double link, Measures& out) {
  const std::size_t count = flock.slots.size();
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  double seen = 0;
  if (link > 0 && count > 0) {
    const float radius = std::nextafter(static_cast<float>(link), std::numeric_limits<float>::max());
    const Sorted sorted(flock, radius);
    std::vector<Span> spans;
    for (std::size_t i = 0; i < count; ++i) {
      visit<D>(sorted.near(), place<D>(flock, i), radius, spans, [&](std::uint32_t slot, float) {
        const auto other = static_cast<std::size_t>(sorted.near().ids[slot]);
        if (other == i) return;
        if (in_view(flock, i, other)) seen += 1;
        parent[root_of(parent, other)] = root_of(parent, i);
      });
    }
  }
  std::vector<std::size_t> members(count, 0);
  for (std::size_t i = 0; i < count; ++i) ++members[root_of(parent, i)];
  out.clusters = static_cast<std::size_t>(
      std::count_if(members.begin(), members.end(), [](std::size_t n) { return n > 0; }));
  out.largest_cluster = count == 0 ? not_known
                                   : static_cast<double>(*std::max_element(members.begin(), members.end())) /
                                         static_cast<double>(count);
  out.neighbours = mean(seen, count);
}

double link_of(const Flock& flock, double link) {
  if (link > 0) return link;
  const double from_scenario = flock.view.scenario().run.link;
  return from_scenario > 0 ? from_scenario : double{flock.model.reach};
}

// Calls f(i, other) for every ordered pair of boids within `link` of which the first sees the second.
template <int D, class F>
void for_each_seen(const Flock& flock, double link, F&& f) {
  if (!(link > 0) || flock.slots.empty()) return;
  const float radius = std::nextafter(static_cast<float>(link), std::numeric_limits<float>::max());
  const Sorted sorted(flock, radius);
  std::vector<Span> spans;
  for (std::size_t i = 0; i < flock.slots.size(); ++i) {
    visit<D>(sorted.near(), place<D>(flock, i), radius, spans, [&](std::uint32_t slot, float) {
      const auto other = static_cast<std::size_t>(sorted.near().ids[slot]);
      if (other != i && in_view(flock, i, other)) f(i, other);
    });
  }
}

double polarisation_of(const Flock& flock) {
  Vec3d sum;
  std::size_t moving = 0;
  for (const std::uint32_t slot : flock.slots) {
    const Vec3d heading = unit(wide(flock.view.velocity(slot)));
    if (heading == Vec3d{}) continue;
    sum += heading;
    ++moving;
  }
  return mean(length(sum), moving);
}

}  // namespace

std::vector<std::uint32_t> neighbour_counts(const View& view, double link) {
  const Flock flock(view);
  std::vector<std::uint32_t> counts(view.size(), 0);
  const auto count = [&](std::size_t i, std::size_t) { ++counts[flock.slots[i]]; };
  if (view.dimensions() == 2) {
    for_each_seen<2>(flock, link_of(flock, link), count);
  } else {
    for_each_seen<3>(flock, link_of(flock, link), count);
  }
  return counts;
}

double polarisation(const View& view) {
  return polarisation_of(Flock(view));
}

Measures measure(const View& view, double link) {
  const Flock flock(view);
  Measures out;
  out.step = view.step();
  out.boids = flock.slots.size();
  out.populations.assign(view.scenario().flocks.size(), 0);
  for (const std::uint32_t slot : flock.slots) ++out.populations[static_cast<std::size_t>(view.flock(slot))];
  out.polarisation = polarisation_of(flock);
  out.milling = milling_of(flock);
  out.speed = mean_speed(flock);
  out.turning = mean_turning(flock);
  out.nearest_distance =
      view.dimensions() == 3 ? nearest_distance_of<3>(flock) : nearest_distance_of<2>(flock);
  view.dimensions() == 3 ? measure_links<3>(flock, link_of(flock, link), out)
                         : measure_links<2>(flock, link_of(flock, link), out);
  return out;
}

const std::vector<MeasureColumn>& measure_columns() {
  static const std::vector<MeasureColumn> columns = {
      {"boids", "Boids", "", not_known, not_known,
       [](const Measures& m) { return static_cast<double>(m.boids); }},
      {"polarisation", "Polarisation", "", 0, 1, [](const Measures& m) { return m.polarisation; }},
      {"milling", "Milling", "", 0, 1, [](const Measures& m) { return m.milling; }},
      {"speed", "Mean speed", "length per time", not_known, not_known,
       [](const Measures& m) { return m.speed; }},
      {"turning", "Turning", "degrees per step", not_known, not_known,
       [](const Measures& m) { return m.turning; }},
      {"nearest_distance", "Nearest neighbour", "length", not_known, not_known,
       [](const Measures& m) { return m.nearest_distance; }},
      {"neighbours", "Neighbours in reach", "", not_known, not_known,
       [](const Measures& m) { return m.neighbours; }},
      {"clusters", "Clusters", "", not_known, not_known,
       [](const Measures& m) { return static_cast<double>(m.clusters); }},
      {"largest_cluster", "Share in the largest cluster", "", 0, 1,
       [](const Measures& m) { return m.largest_cluster; }},
  };
  return columns;
}

std::string measures_header(const ScenarioDef& scenario) {
  std::string out = "step";
  for (const MeasureColumn& column : measure_columns()) out += say(",", column.name);
  if (scenario.flocks.size() < 2) return out;
  for (const FlockDef& flock : scenario.flocks) out += say(",population.", flock.name);
  return out;
}

std::string measures_line(const Measures& measures) {
  std::string out = say(measures.step);
  for (const MeasureColumn& column : measure_columns()) {
    out += ",";
    const double value = column.value(measures);
    if (std::isnan(value)) continue;
    char buffer[64];
    out.append(buffer,
               std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 9).ptr);
  }
  if (measures.populations.size() < 2) return out;
  for (const std::size_t population : measures.populations) out += say(",", population);
  return out;
}

}  // namespace sturnus
