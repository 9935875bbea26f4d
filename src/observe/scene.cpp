// Builds draw lists from views: glyphs, trails, outline, arrows, index cells, a caption.
#include "observe/scene.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "observe/lines.h"
#include "observe/obstacles.h"
#include "scenario/model.h"
#include "scenario/targets.h"

namespace sturnus {
namespace {

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

Rgba colour_from(const std::string& hex) {
  const auto given = colour_of_hex(hex);
  return {to_byte(given[0]), to_byte(given[1]), to_byte(given[2]), 255};
}

Rgba plain_colour(const View& view, std::size_t slot, const SceneColours& colours) {
  const State& state = view.state();
  if (!state.colour[0].empty()) {
    return {to_byte(state.colour[0][slot]), to_byte(state.colour[1][slot]), to_byte(state.colour[2][slot]),
            255};
  }
  const auto flock = static_cast<std::size_t>(view.flock(slot));
  const std::string& start = view.scenario().flocks[flock].colour.start;
  if (start.empty() || start == "random") return colours.flocks[flock % colours.flocks.size()];
  return colour_from(start);
}

void add_outline(const View& view, const SceneColours& colours, DrawList& list) {
  if (!view.scenario().camera.outline) return;
  const Extent extent = extent_of(view.scenario());
  Box box;
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
    box.low[static_cast<int>(axis)] = static_cast<float>(extent.min[axis]);
    box.high[static_cast<int>(axis)] = static_cast<float>(extent.max[axis]);
  }
  box.colour = colours.outline;
  box.fill = colours.surface;
  list.boxes.push_back(box);
}

// A disc in a ring, and how far it is felt.
void add_targets(const View& view, const SceneColours& colours, DrawList& list) {
  const ScenarioDef& scenario = view.scenario();
  if (scenario.targets.empty()) return;
  const Model model = compile(scenario);
  std::vector<std::array<float, 3>> places;
  place_targets(model, view.step(), places);
  const auto size = static_cast<float>(scenario.flocks.front().size);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Rgba colour =
        scenario.targets[i].kind == TargetKind::attract ? colours.attractor : colours.repeller;
    const Vec<3> at{places[i]};
    list.rings.push_back({at, 0.45f * size, colour, 0.0f, Layer::above});
    list.rings.push_back({at, 0.95f * size, colour, 1.5f, Layer::above});
    if (!std::isinf(scenario.targets[i].radius))
      list.rings.push_back({at, model.targets[i].radius, with_alpha(colour, 0.35f), 1.0f, Layer::below});
  }
}

void add_index(const SceneOptions& options, const SceneColours& colours, DrawList& list) {
  for (const auto& corners : options.index_boxes) {
    list.boxes.push_back({Vec<3>{corners[0]}, Vec<3>{corners[1]}, colours.outline, 1.0f, {0, 0, 0, 0}});
  }
}

// Velocities as arrows, a few boid lengths long at full speed.
void add_velocity(const View& view, const FlockDef& flock, std::size_t slot, const SceneColours& colours,
                  DrawList& list) {
  const Vec<3> position{view.position(slot)};
  const Vec<3> velocity{view.velocity(slot)};
  const auto full = static_cast<float>(std::isinf(flock.max_speed) ? 0 : flock.max_speed);
  const float scale = full > 0 ? 3.0f * static_cast<float>(flock.size) / full : 1.0f;
  list.arrows.push_back({position, position + velocity * scale, colours.accent, 1.25f});
}

Rgba mixed(Rgba from, Rgba to, float part) {
  const auto channel = [part](std::uint8_t a, std::uint8_t b) {
    return to_byte((static_cast<float>(a) * (1 - part) + static_cast<float>(b) * part) / 255.0f);
  };
  return {channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b), from.a};
}

// What a hunter's clocks make of its colour.
Rgba shown_by_hunger(const View& view, std::size_t slot, Rgba own, const SceneColours& colours) {
  const Life& life = view.state().life;
  const auto& hunger = view.scenario().flocks[static_cast<std::size_t>(view.flock(slot))].hunger;
  if (!hunger || life.full.empty()) return own;
  if (life.full[slot] > 0) return colours.full;
  const double starved = life.fasting[slot] / hunger->starves_after;
  return mixed(own, colours.starved, static_cast<float>(std::clamp(starved, 0.0, 1.0)));
}

// Green where a jump is ready, grey where not.
void add_tail(const View& view, const FlockDef& flock, std::size_t slot, const SceneColours& colours,
              DrawList& list) {
  const Life& life = view.state().life;
  if (!flock.jump || life.jump.empty()) return;
  const auto size = static_cast<float>(flock.size);
  const bool is_ready = !(life.jump[slot] > 0) && !(life.rest[slot] > 0) && flock.jump->on;
  const bool is_cone = view.dimensions() == 3;  // of which the model begins at the place
  Glyph tail;
  tail.position =
      Vec<3>{view.position(slot)} - unit(Vec<3>{view.velocity(slot)}) * ((is_cone ? 0.06f : 0.44f) * size);
  tail.size = (is_cone ? 0.24f : 0.3f) * size;
  tail.colour = is_ready ? colours.ready : colours.tired;
  tail.kind = is_cone ? GlyphKind::ball : GlyphKind::circle;
  list.glyphs.push_back(tail);
}

void add_food(const View& view, const SceneColours& colours, DrawList& list) {
  const Food& food = view.state().food;
  for (std::size_t i = 0; i < food.size(); ++i) {
    const FoodDef& def = view.scenario().food[food.kind[i]];
    Glyph piece;
    for (std::size_t axis = 0; axis < 3 && !food.position[axis].empty(); ++axis)
      piece.position[static_cast<int>(axis)] = food.position[axis][i];
    piece.size = static_cast<float>(def.size);
    piece.colour = def.colour.empty() ? colours.food : colour_from(def.colour);
    piece.kind = view.dimensions() == 3 ? GlyphKind::ball : GlyphKind::circle;
    list.glyphs.push_back(piece);
  }
}

void add_caption(const View& view, const SceneColours& colours, DrawList& list) {
  const ScenarioDef& scenario = view.scenario();
  Label title;
  title.text = scenario.title.empty() ? scenario.name : scenario.title;
  title.on_screen = true;
  title.offset_x = 22;
  title.offset_y = 34;
  title.size = 17;
  title.colour = colours.text;
  list.labels.push_back(title);
  Label state = title;
  state.text = say(view.size(), " boids · step ", view.step());
  state.offset_y = 56;
  state.size = 13;
  state.colour = with_alpha(colours.text, 0.65f);
  list.labels.push_back(state);
  if (scenario.food.empty()) return;
  state.text = say(view.state().food.size(), " food");
  state.offset_y = 74;
  list.labels.push_back(state);
}

}  // namespace

GlyphKind kind_of(const FlockDef& flock, int dimensions) {
  if (!flock.glyph) return dimensions == 3 ? GlyphKind::cone : GlyphKind::dart;
  switch (*flock.glyph) {
    case GlyphStyle::dart:
      return GlyphKind::dart;
    case GlyphStyle::cone:
      return GlyphKind::cone;
    case GlyphStyle::circle:
      return GlyphKind::circle;
  }
  return GlyphKind::dart;
}

Rgba colour_of(const View& view, std::size_t slot, const SceneColours& colours) {
  return shown_by_hunger(view, slot, plain_colour(view, slot, colours), colours);
}

void Trails::follow(const View& view) {
  std::vector<Piece> pieces;
  std::unordered_map<std::uint64_t, Vec<3>> now;
  const Extent extent = extent_of(view.scenario());
  const bool wraps = view.scenario().space.boundary.kind == BoundaryKind::wrap;
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    const Vec<3> at{view.position(slot)};
    now.emplace(view.id(slot), at);
    const auto before = last_.find(view.id(slot));
    if (before == last_.end()) continue;
    bool over_seam = false;
    for (std::size_t axis = 0; wraps && axis < extent.min.size(); ++axis) {
      const double step =
          std::abs(double{at[static_cast<int>(axis)]} - double{before->second[static_cast<int>(axis)]});
      over_seam = over_seam || step > (extent.max[axis] - extent.min[axis]) / 2;
    }
    if (!over_seam) pieces.push_back({view.id(slot), before->second, at});
  }
  last_ = std::move(now);
  steps_.push_back(std::move(pieces));
  while (steps_.size() > static_cast<std::size_t>(view.scenario().camera.trail)) steps_.pop_front();
}

void Trails::add_to(const View& view, const SceneColours& colours, DrawList& list) const {
  std::unordered_map<std::uint64_t, Rgba> colour;
  for (std::size_t slot = 0; slot < view.size(); ++slot)
    colour.emplace(view.id(slot), colour_of(view, slot, colours));
  const auto age_step = 1.0f / static_cast<float>(std::max<std::size_t>(1, steps_.size()));
  float strength = 0;
  for (const auto& pieces : steps_) {
    for (const Piece& piece : pieces) {
      const auto own = colour.find(piece.id);
      if (own == colour.end()) continue;
      Segment segment{piece.from,  piece.to,         own->second,
                      1.3f,        0.55f * strength, 0.55f * (strength + age_step),
                      Layer::below};
      list.segments.push_back(segment);
    }
    strength += age_step;
  }
}

void make_scene(const View& view, const SceneColours& colours, const SceneOptions& options, DrawList& list) {
  add_outline(view, colours, list);
  add_index(options, colours, list);
  add_lines(view, colours, list);
  add_obstacles(view, colours, list);
  add_targets(view, colours, list);
  add_food(view, colours, list);
  for (std::size_t slot = 0; slot < view.size(); ++slot) {
    const FlockDef& flock = view.scenario().flocks[static_cast<std::size_t>(view.flock(slot))];
    const Rgba colour =
        options.boid_colours.empty() ? colour_of(view, slot, colours) : options.boid_colours[slot];
    if (colour.a == 0) continue;
    list.glyphs.push_back({Vec<3>{view.position(slot)}, Vec<3>{view.velocity(slot)},
                           static_cast<float>(flock.size), colour, kind_of(flock, view.dimensions())});
    add_tail(view, flock, slot, colours, list);
    if (options.velocities) add_velocity(view, flock, slot, colours, list);
  }
  if (options.caption) add_caption(view, colours, list);
}

Framing framing_of(const View& view) {
  Framing out;
  const Extent extent = extent_of(view.scenario());
  const bool fit_flock = view.scenario().camera.fit == CameraFit::flock && view.size() > 0;
  for (std::size_t axis = 0; axis < extent.min.size(); ++axis) {
    const auto a = static_cast<int>(axis);
    out.low[a] = static_cast<float>(extent.min[axis]);
    out.high[a] = static_cast<float>(extent.max[axis]);
    if (!fit_flock) continue;
    // All but the outermost hundredth on either side: a stray does not make the flock small.
    std::vector<float> at(view.state().position[axis]);
    const std::size_t skip = at.size() / 100;
    std::nth_element(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(skip), at.end());
    out.low[a] = at[skip];
    const std::size_t last = at.size() - 1 - skip;
    std::nth_element(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(last), at.end());
    out.high[a] = at[last];
    const float room = 0.06f * (out.high[a] - out.low[a]) + 1e-3f;
    out.low[a] -= room;
    out.high[a] += room;
  }
  if (view.dimensions() == 3) return out;
  const Vec<3> room = (out.high - out.low) * static_cast<float>(view.scenario().camera.room);
  out.low -= room;
  out.high += room;
  return out;
}

}  // namespace sturnus
