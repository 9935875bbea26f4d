// Named sets of the three main terms.
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

void scale(Desk& desk, const std::string& flock, const char* kind, const char* key, double factor,
           std::uint64_t gesture) {
  const auto& baseline = desk.inspector.baseline;
  for (const std::string& path : paths_of_rows(baseline, flock, kind, key))
    if (const auto text = scaled(baseline.at(path), factor)) desk.set(path, *text, gesture);
}

void apply(Desk& desk, const std::string& flock, const Preset& preset) {
  const std::uint64_t gesture = desk.next_gesture++;
  scale(desk, flock, "separation", "weight", preset.separation, gesture);
  scale(desk, flock, "alignment", "weight", preset.alignment, gesture);
  scale(desk, flock, "cohesion", "weight", preset.cohesion, gesture);
  scale(desk, flock, "separation", "radius", preset.near, gesture);
  scale(desk, flock, "alignment", "radius", preset.far, gesture);
  scale(desk, flock, "cohesion", "radius", preset.far, gesture);
}

}  // namespace

void show_presets(Desk& desk, std::size_t flock) {
  const std::string name = desk.scenario().flocks[flock].name;
  bool is_first = true;
  for (const Preset& preset : presets) {
    const float width = ImGui::CalcTextSize(preset.name).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    if (!is_first && ImGui::GetItemRectMax().x + 4 + width <= right) ImGui::SameLine(0, 4);
    is_first = false;
    if (button(desk, "inspector.flock." + name + ".preset." + preset.name, preset.name, preset.text))
      apply(desk, name, preset);
  }
}

}  // namespace studio
