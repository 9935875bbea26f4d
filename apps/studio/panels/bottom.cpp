// The timeline and, unfolded, the plots below it.
#include "panels/panels.h"
#include "panels/plots.h"
#include "panels/widgets.h"

namespace studio {

void show_bottom(Desk& desk) {
  gather_samples(desk);
  if (begin_panel("bottom", desk.layout.bottom, ImGuiWindowFlags_NoScrollbar)) {
    const bool is_short = ImGui::GetContentRegionAvail().x < 42 * ImGui::GetFontSize();
    show_timeline(desk, is_short);
    ImGui::SameLine();
    show_plot_chips(desk, is_short);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
    const bool is_open = desk.open.bottom;
    if (button(desk, "bottom.fold", is_open ? "\u25be" : "\u25b4", is_open ? "Fold the plots away" : "Plots"))
      desk.open.bottom = !is_open;
    if (is_open) show_plots(desk);
  }
  end_panel();
}

}  // namespace studio
