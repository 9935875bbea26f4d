// Hunters, food and targets as the documents tell them.
#include "living.h"

#include <algorithm>

namespace reference {
namespace {

Vec unit(Vec v) {
  const double size = length(v);
  return size > 0 ? v / size : Vec{};
}

double nearest(double o, double size) {
  return size > 0 ? o - size * std::round(o / size) : o;
}

// Where the prey at the mover's place will be, as seen from the hunter.
Vec foreseen(const HuntRule& rule, const Mover& prey) {
  using Aim = HuntRule::Aim;
  const double by_distance = rule.factor * length(prey.position);
  double time = 0;
  if (rule.aim == Aim::constant) time = rule.time;
  if (rule.aim == Aim::distance) time = by_distance;
  if (rule.aim == Aim::intercept)
    time = catching_time(prey.position, prey.velocity, rule.max_speed).value_or(by_distance);
  return prey.position + time * prey.velocity;
}

// A desired velocity or direction turned into a force.
Vec pull(Form form, Vec toward, double distance, double slowing, double max_speed, Vec velocity) {
  switch (form) {
    case Form::heading:
      return unit(toward) - unit(velocity);
    case Form::seek:
      return max_speed * unit(toward) - velocity;
    case Form::arrive:
      return max_speed * std::min(1.0, distance / slowing) * unit(toward) - velocity;
    case Form::orbit:
      return max_speed * unit(toward);
    case Form::linear:
      return toward;
  }
  return {};
}

}  // namespace

Vec offset(Vec from, Vec to, Vec size) {
  const Vec o = to - from;
  return {nearest(o.x, size.x), nearest(o.y, size.y), nearest(o.z, size.z)};
}

std::optional<double> catching_time(Vec o, Vec v, double s) {
  const long double a = dot(v, v) - s * s, b = 2 * dot(o, v), c = dot(o, o);
  const long double discriminant = b * b - 4 * a * c;
  if (a == 0 || discriminant < 0) return {};
  std::optional<double> least;
  for (const long double sign : {-1.0L, 1.0L}) {
    const auto time = static_cast<double>((-b + sign * std::sqrt(discriminant)) / (2 * a));
    if (time > 0 && (!least || time < *least)) least = time;
  }
  return least;
}

Vec hunt(const HuntRule& rule, Vec own_velocity, const std::vector<Mover>& prey_at_offsets) {
  if (prey_at_offsets.empty()) return {};
  Vec mean;
  for (const Mover& prey : prey_at_offsets)
    mean += unit(foreseen(rule, prey)) / static_cast<double>(prey_at_offsets.size());
  if (rule.aim == HuntRule::Aim::heading) return mean - unit(own_velocity);
  return rule.max_speed * unit(mean) - own_velocity;
}

std::optional<std::size_t> focus(std::optional<std::size_t> held, const std::vector<Sighted>& in_view) {
  if (in_view.empty()) return {};
  const auto is_nearer = [](const Sighted& a, const Sighted& b) { return a.distance < b.distance; };
  const Sighted nearest = *std::min_element(in_view.begin(), in_view.end(), is_nearer);
  for (const Sighted& one : in_view) {
    if (held == one.number && nearest.distance >= 0.5 * one.distance) return held;
  }
  return nearest.number;
}

Vec feed(Form form, double radius, double max_speed, Vec own_velocity, const std::vector<Vec>& offsets) {
  Vec sum;
  int count = 0;
  for (const Vec& o : offsets) {
    if (length(o) > radius) continue;
    sum += form == Form::linear ? o : unit(o);
    ++count;
  }
  if (count == 0) return {};
  const Vec mean = sum / count;
  if (form == Form::heading) return mean - unit(own_velocity);
  return pull(form, mean, length(mean), 1, max_speed, own_velocity);
}

Vec targets(const std::vector<TargetRule>& all, double max_speed, Vec own_velocity) {
  Vec sum, headings[2];
  int counts[2] = {};
  for (const TargetRule& target : all) {
    const double distance = length(target.offset);
    if (distance > target.radius) continue;
    const Vec toward = target.repels ? -1.0 * target.offset : target.offset;
    const Vec felt =
        target.weight * pull(target.form, toward, distance, target.slowing, max_speed, own_velocity);
    if (target.form != Form::heading) {
      sum += felt;
      continue;
    }
    headings[target.repels] += felt;
    ++counts[target.repels];
  }
  for (const int kind : {0, 1}) {
    if (counts[kind] > 0) sum += headings[kind] / counts[kind];
  }
  return sum;
}

}  // namespace reference
