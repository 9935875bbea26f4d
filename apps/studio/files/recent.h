// Files that were opened lately, kept from one visit to the next.
#pragma once

#include <string>
#include <vector>

namespace studio {

constexpr std::size_t most_recent_files = 12;

/// Where the list is kept: sturnus/recent.txt under $XDG_STATE_HOME or ~/.local/state; empty without a home.
std::string recent_list_path();
/// Newest first; those that are gone are left out. No list is an empty one.
std::vector<std::string> recent_files(const std::string& list);
/// Puts a file in front. What can't be written is forgotten.
void remember_file(const std::string& list, const std::string& file);

}  // namespace studio
