// Arrows, rings, fields of view and the legend of one boid's terms.
#include "observe/vectors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "base/root.h"
#include "base/text.h"

namespace sturnus {
namespace {

Rgba blend(Rgba from, Rgba to, float part) {
  const auto one = [part](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(static_cast<float>(a) * (1 - part) + static_cast<float>(b) * part +
                                     0.5f);
  };
  return {one(from.r, to.r), one(from.g, to.g), one(from.b, to.b), from.a};
}

// The three terms that nearly all flocks have keep their colours; others take the next in turn.
std::vector<Rgba> term_colours(const Explanation& told, const SceneColours& colours) {
  std::vector<Rgba> out;
  std::size_t next = 3;
  for (const ExplainedTerm& term : told.terms) {
    std::size_t place = 0;
    if (term.kind == "alignment") {
      place = 1;
    } else if (term.kind == "cohesion") {
      place = 2;
    } else if (term.kind != "separation") {
      place = next++;
    }
    out.push_back(colours.terms[place < 3 ? place : 3 + (place - 3) % (colours.terms.size() - 3)]);
  }
  return out;
}

// Whether a term has anything to show.
bool is_shown(const ExplainedTerm& term) {
  return term.neighbours.has_value() || length(Vec<3>{term.weighted}) > 0;
}

// Of the terms that count a neighbour, the one that looks least far.
std::size_t nearest_term(const Explanation& told, const ExplainedNeighbour& neighbour) {
  return *std::min_element(neighbour.terms.begin(), neighbour.terms.end(), [&](std::size_t a, std::size_t b) {
    return told.terms[a].radius < told.terms[b].radius;
  });
}

std::unordered_map<std::uint64_t, Rgba> neighbour_colours(const Explanation& told,
                                                          const SceneColours& colours) {
  const std::vector<Rgba> of_terms = term_colours(told, colours);
  std::unordered_map<std::uint64_t, Rgba> out;
  for (const ExplainedNeighbour& neighbour : told.neighbours)
    out.emplace(neighbour.id, of_terms[nearest_term(told, neighbour)]);
  return out;
}

Segment line(const Vec<3>& from, const Vec<3>& to, Rgba colour, float width, float alpha) {
  return {from, to, colour, width, alpha, alpha, Layer::below};
}

// The picture of one reach around the boid.
class Reach {
 public:
  Reach(const Explanation& told, Rgba colour, float radius, double field_of_view, DrawList& list)
      : centre_{told.position},
        heading_{told.heading},
        colour_(colour),
        radius_(radius),
        half_(field_of_view / 2 * (pi / 180)),
        list_(list) {}

  void add(int dimensions) {
    const bool sees_all = half_ >= pi || heading_ == Vec<3>{};
    if (sees_all || dimensions == 3)
      list_.rings.push_back({centre_, radius_, with_alpha(colour_, 0.8f), 1.5f, Layer::below});
    if (sees_all) return;
    dimensions == 3 ? add_cone() : add_arc();
  }

 private:
  // At an angle from the heading, in the plane or towards `aside`.
  Vec<3> at(double angle, const Vec<3>& aside) const {
    return centre_ + heading_ * (radius_ * static_cast<float>(std::cos(angle))) +
           aside * (radius_ * static_cast<float>(std::sin(angle)));
  }

  // What is seen as an arc with its two edges.
  void add_arc() {
    const Vec<3> left{{-heading_[1], heading_[0], 0}};
    constexpr int pieces = 96;
    Vec<3> last = at(-half_, left);
    list_.segments.push_back(line(centre_, last, colour_, 1.2f, 0.7f));
    for (int i = 1; i <= pieces; ++i) {
      const Vec<3> next = at(half_ * (2.0 * i / pieces - 1), left);
      list_.segments.push_back(line(last, next, colour_, 1.5f, 0.8f));
      last = next;
    }
    list_.segments.push_back(line(last, centre_, colour_, 1.2f, 0.7f));
  }

  // The edge of sight on the sphere, and lines to it.
  void add_cone() {
    Vec<3> other{};
    other[std::abs(heading_[0]) < 0.7f ? 0 : 1] = 1;
    const Vec<3> u = unit(other - heading_ * dot(heading_, other));
    const Vec<3> w{{heading_[1] * u[2] - heading_[2] * u[1], heading_[2] * u[0] - heading_[0] * u[2],
                    heading_[0] * u[1] - heading_[1] * u[0]}};
    constexpr int pieces = 64;
    for (int i = 0; i < pieces; ++i) {
      const Vec<3> from = at(half_, around(u, w, i, pieces));
      list_.segments.push_back(line(from, at(half_, around(u, w, i + 1, pieces)), colour_, 1.2f, 0.7f));
      if (i % 8 == 0) list_.segments.push_back(line(centre_, from, colour_, 1.0f, 0.35f));
    }
  }
  static Vec<3> around(const Vec<3>& u, const Vec<3>& w, int i, int pieces) {
    const double angle = 2 * pi * i / pieces;
    return u * static_cast<float>(std::cos(angle)) + w * static_cast<float>(std::sin(angle));
  }

  Vec<3> centre_, heading_;
  Rgba colour_;
  float radius_;
  double half_;
  DrawList& list_;
};

// Whether a term looks just as far as another begins to: one line is enough.
bool ends_somewhere(const Explanation& told, float inner) {
  return std::any_of(told.terms.begin(), told.terms.end(), [inner](const ExplainedTerm& term) {
    return term.neighbours && std::abs(term.radius - inner) <= 1e-5f * inner;
  });
}

// Terms that look equally far get lines beside one another.
void add_reaches(const Explanation& told, const std::vector<Rgba>& of_terms, DrawList& list) {
  for (std::size_t t = 0; t < told.terms.size(); ++t) {
    const ExplainedTerm& term = told.terms[t];
    if (!term.neighbours || !std::isfinite(term.radius) || !(term.radius > 0)) continue;
    const auto is_alike = [&](const ExplainedTerm& other) {
      return other.neighbours && other.radius == term.radius;
    };
    const auto alike =
        std::count_if(told.terms.begin(), told.terms.begin() + static_cast<std::ptrdiff_t>(t), is_alike);
    const float inward = 1 - 0.015f * static_cast<float>(alike);
    Reach(told, of_terms[t], term.radius * inward, term.field_of_view, list).add(told.dimensions);
    if (term.inner > 0 && !ends_somewhere(told, term.inner))
      Reach(told, of_terms[t], term.inner, term.field_of_view, list).add(told.dimensions);
  }
}

// Who is seen over the seam of a wrapped space stands where the boid sees them.
void add_ghosts(const View& view, const Explanation& told, const SceneColours& colours, DrawList& list) {
  if (view.scenario().space.boundary.kind != BoundaryKind::wrap) return;
  const auto of_neighbours = neighbour_colours(told, colours);
  std::unordered_map<std::uint64_t, Vec<3>> seen;
  for (const ExplainedNeighbour& neighbour : told.neighbours)
    seen.emplace(neighbour.id, Vec<3>{told.position} + Vec<3>{neighbour.offset});
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    const auto found = seen.find(view.id(slot));
    if (found == seen.end()) continue;
    const Vec<3> apart = found->second - Vec<3>{view.position(slot)};
    const auto& flock = view.scenario().flocks[static_cast<std::size_t>(view.flock(slot))];
    const auto size = static_cast<float>(flock.size);
    const Vec<3> offset = found->second - Vec<3>{told.position};
    if (!(dot(apart, apart) > dot(offset, offset) * 1e-6f + size * size)) continue;
    list.glyphs.push_back({found->second, Vec<3>{view.velocity(slot)}, size,
                           blend(of_neighbours.at(view.id(slot)), colours.surface, 0.5f),
                           kind_of(flock, view.dimensions())});
  }
}

float longest_of(const Explanation& told) {
  float longest = std::max(length(Vec<3>{told.acceleration}), length(Vec<3>{told.boundary}));
  for (const ExplainedTerm& term : told.terms) longest = std::max(longest, length(Vec<3>{term.weighted}));
  return longest;
}

void add_arrow(const Explanation& told, const std::array<float, 3>& vector, float scale, Rgba colour,
               float width, DrawList& list) {
  const Vec<3> from{told.position};
  if (Vec<3>{vector} == Vec<3>{}) return;
  list.arrows.push_back({from, from + Vec<3>{vector} * scale, colour, width});
}

bool holds(const Framing& frame, const std::array<float, 3>& at, int dimensions) {
  for (int axis = 0; axis < dimensions; ++axis) {
    const float place = at[static_cast<std::size_t>(axis)];
    if (place < frame.low[axis] || place > frame.high[axis]) return false;
  }
  return true;
}

// Three digits are plenty beside an arrow.
std::string short_number(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
}

}  // namespace

std::optional<std::uint64_t> boid_in_the_middle(const View& view) {
  const Framing frame = framing_of(view);
  const Vec<3> middle = (frame.low + frame.high) * 0.5f;
  std::optional<std::uint64_t> best;
  float least = 0;
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    if (view.quarantined(slot)) continue;
    const Vec<3> apart = Vec<3>{view.position(slot)} - middle;
    const float squared = dot(apart, apart);
    if (best && (squared > least || (squared == least && view.id(slot) > *best))) continue;
    best = view.id(slot);
    least = squared;
  }
  return best;
}

std::vector<Rgba> vector_colours(const View& view, const Explanation& told, const SceneColours& colours,
                                 const std::optional<Framing>& only) {
  const auto of_neighbours = neighbour_colours(told, colours);
  std::vector<Rgba> out(view.size(), blend(colours.outline, colours.text, 0.15f));
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    if (only && !holds(*only, view.position(slot), view.dimensions())) out[slot].a = 0;
    if (view.id(slot) == told.id) out[slot] = colours.text;
    const auto found = of_neighbours.find(view.id(slot));
    if (found != of_neighbours.end()) out[slot] = found->second;
  }
  return out;
}

void add_vectors(const View& view, const Explanation& told, const SceneColours& colours, float longest,
                 DrawList& list) {
  const std::vector<Rgba> of_terms = term_colours(told, colours);
  add_reaches(told, of_terms, list);
  add_ghosts(view, told, colours, list);
  const float most = longest_of(told);
  if (!(most > 0)) return;
  const float scale = longest / most;
  add_arrow(told, told.acceleration, scale, colours.text, 4.5f, list);
  add_arrow(told, told.boundary, scale, blend(colours.outline, colours.text, 0.5f), 2.5f, list);
  for (std::size_t t = 0; t < told.terms.size(); ++t) {
    const ExplainedTerm& term = told.terms[t];
    const Vec<3> from{told.position};
    // What was asked for and not granted is a thin line beyond the arrow.
    if (term.granted != term.weighted) {
      list.segments.push_back(line(from + Vec<3>{term.granted} * scale, from + Vec<3>{term.weighted} * scale,
                                   of_terms[t], 1.5f, 0.5f));
      list.segments.back().layer = Layer::above;
    }
    add_arrow(told, term.granted, scale, of_terms[t], 2.5f, list);
  }
}

void add_halo(const View& view, const Explanation& told, const SceneColours& colours, DrawList& list) {
  const auto& flock = view.scenario().flocks[static_cast<std::size_t>(told.flock)];
  const float radius = (told.dimensions == 3 ? 0.6f : 0.9f) * static_cast<float>(flock.size);
  list.rings.push_back({Vec<3>{told.position}, radius, with_alpha(colours.text, 0.7f), 1.2f, Layer::above});
}

void add_legend(const Explanation& told, const SceneColours& colours, DrawList& list) {
  Label label;
  label.position = Vec<3>{{1, 0, 0}};
  label.on_screen = true;
  label.offset_x = -22;
  label.offset_y = 34;
  label.size = 13;
  label.align = Align::right;
  label.plate = true;
  const auto add = [&](std::string text, Rgba colour) {
    label.text = std::move(text);
    label.colour = colour;
    list.labels.push_back(label);
    label.offset_y += 21;
  };
  const std::vector<Rgba> of_terms = term_colours(told, colours);
  add(say("what boid ", told.id, " of ", told.flock_name, " feels"), with_alpha(colours.text, 0.65f));
  for (std::size_t t = 0; t < told.terms.size(); ++t) {
    const ExplainedTerm& term = told.terms[t];
    if (!is_shown(term)) continue;
    const std::string counted = term.neighbours ? say(" · ", *term.neighbours, " counted") : "";
    add(say(term.name, " ", short_number(length(Vec<3>{term.granted})), counted, "  ■"), of_terms[t]);
  }
  if (Vec<3>{told.boundary} != Vec<3>{}) {
    add(say("boundary ", short_number(length(Vec<3>{told.boundary})), "  ■"),
        blend(colours.outline, colours.text, 0.5f));
  }
  add(say("acceleration ", short_number(length(Vec<3>{told.acceleration})), "  ■"), colours.text);
}

std::optional<Framing> framing_of(const Explanation& told) {
  float reach = 0;
  for (const ExplainedTerm& term : told.terms) {
    if (term.neighbours && std::isfinite(term.radius)) reach = std::max(reach, term.radius);
  }
  if (!(reach > 0)) return {};
  Framing out;
  for (int axis = 0; axis < told.dimensions; ++axis) {
    const float at = told.position[static_cast<std::size_t>(axis)];
    out.low[axis] = at - 1.08f * reach;
    out.high[axis] = at + 1.08f * reach;
  }
  return out;
}

}  // namespace sturnus
