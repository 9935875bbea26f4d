// Named sets of the three main terms.
#include <cmath>

#include "panels/inspector.h"
#include "panels/values.h"
#include "panels/widgets.h"

namespace studio {
namespace {

// Weights and radii as multiples of what the scenario has.
struct Preset {
  const char* name;
  const char* text;
  double separation, alignment, cohesion;  // weights
  double near, far;                        // radii: of separation, and of the other two
};

constexpr Preset presets[] = {
    {"as is", "The scenario's own weights and radii", 1, 1, 1, 1, 1},
    {"loose", "Wide apart, still of one mind", 1.5, 1, 0.5, 1.6, 1.2},
    {"tight", "A dense ball", 0.7, 1, 2.5, 0.7, 1.2},
    {"school", "Strongly aligned, as fish are", 1, 2.5, 1.2, 1, 1},
    {"swarm", "Together but in every direction, as midges are", 1, 0.05, 2.5, 1, 1.4},
};

void scale(Desk& desk, const std::string& path, double factor, std::uint64_t gesture) {
  const auto found = desk.inspector.baseline.find(path);
  if (found == desk.inspector.baseline.end()) return;
  const sturnus::Value value = sturnus::parse_value(found->second);
  const auto* number = std::get_if<double>(&value.held);
  if (number == nullptr || !std::isfinite(*number)) return;
  desk.set(path, sturnus::number_text(*number * factor), gesture);
}

void apply(Desk& desk, const std::string& flock, const Preset& preset) {
  const std::uint64_t gesture = desk.next_gesture++;
  const std::string base = "flock." + flock + ".";
  scale(desk, base + "separation.weight", preset.separation, gesture);
  scale(desk, base + "alignment.weight", preset.alignment, gesture);
  scale(desk, base + "cohesion.weight", preset.cohesion, gesture);
  scale(desk, base + "separation.radius", preset.near, gesture);
  scale(desk, base + "alignment.radius", preset.far, gesture);
  scale(desk, base + "cohesion.radius", preset.far, gesture);
}

}  // namespace

void show_presets(Desk& desk, std::size_t flock) {
  const std::string name = desk.scenario().flocks[flock].name;
  bool is_first = true;
  for (const Preset& preset : presets) {
    if (!is_first) ImGui::SameLine(0, 4);
    is_first = false;
    if (button(desk, "inspector.flock." + name + ".preset." + preset.name, preset.name, preset.text))
      apply(desk, name, preset);
  }
}

}  // namespace studio
