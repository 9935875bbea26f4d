// References in double of what makes a world live: hunters, food and targets, after CS 184 (S4-10 to S4-13,
// S4-23) and VUW CGRA 354 (S2-19 to S2-23).
#pragma once

#include <optional>

#include "reference.h"

namespace reference {

/// One that is looked at or that steers.
struct Mover {
  Vec position, velocity;
};

/// From one place to another, by the nearest image where `size`, the space's, is not zero.
Vec offset(Vec from, Vec to, Vec size);

enum class Form { heading, seek, arrive, orbit, linear };

/// Where a hunter goes: `aim` is where it looks for its prey.
struct HuntRule {
  enum class Aim { heading, seek, constant, distance, intercept };
  Aim aim = Aim::heading;
  double time = 0;       ///< constant
  double factor = 0;     ///< distance, and intercept where there is no catching
  double max_speed = 1;  ///< the hunter's
};

/// The smallest positive T with |o + v T| = s T, if any, by the school's formula.
std::optional<double> catching_time(Vec o, Vec v, double s);

/// The term of a hunter that goes for those prey, at these offsets.
Vec hunt(const HuntRule& rule, Vec own_velocity, const std::vector<Mover>& prey_at_offsets);

/// Who is hunted next, of prey in view at those distances by their numbers: whom one keeps and whom one
/// takes.
struct Sighted {
  std::size_t number;
  double distance;
};
std::optional<std::size_t> focus(std::optional<std::size_t> held, const std::vector<Sighted>& in_view);

/// The pull of the food within the radius, at these offsets.
Vec feed(Form form, double radius, double max_speed, Vec own_velocity, const std::vector<Vec>& offsets);

struct TargetRule {
  bool repels = false;
  Form form = Form::heading;
  double weight = 1, radius = 0, slowing = 1;
  Vec offset;
};

/// The sum of the targets' pulls; those of form "heading" are averaged by kind.
Vec targets(const std::vector<TargetRule>& all, double max_speed, Vec own_velocity);

}  // namespace reference
