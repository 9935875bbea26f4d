// What one visit leaves for the next: that the legend was folded away, and that the hint was seen.
#pragma once

#include <string>

namespace studio {

struct Memory {
  bool legend = true;  ///< unfolded
  bool hint = true;    ///< not yet seen to its end

  friend bool operator==(const Memory&, const Memory&) = default;
};

/// Where it is kept: sturnus/studio.txt under $XDG_STATE_HOME or ~/.local/state; empty without a home.
std::string memory_path();
/// No file, or one that can't be read, is a first visit.
Memory recall(const std::string& path);
/// What can't be written is forgotten.
void remember(const std::string& path, const Memory& memory);

}  // namespace studio
