// What the gallery remembers between frames.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "panels/thumbnails.h"

namespace studio {

/// A shipped scenario as people read it.
struct Exhibit {
  std::string name, group, title, about;
  std::vector<std::string> try_this;
};
const std::vector<Exhibit>& exhibits();
/// Whether every word of the search is found in its name, group, title or text, in either case of letters.
bool is_found(const Exhibit& exhibit, const std::string& search);

struct GalleryState {
  std::array<char, 64> search{};
  std::array<char, 160> file_name{};  ///< under which things are saved; empty: a name is made
  std::string looked_at;              ///< the exhibit that was clicked last
  bool was_open = false;
  std::vector<std::string> recent;  ///< files, read when the gallery opens
  Thumbnails thumbnails;
};

}  // namespace studio
